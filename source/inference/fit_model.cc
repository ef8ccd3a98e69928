#include <continua/inference/fit_model.h>

namespace Continua
{
bool FitModel::derivatives(const std::vector<double> & /*set*/,
                           std::vector<std::vector<double>> & /*by_parameter*/)
{
  return false;
}
} // namespace Continua
