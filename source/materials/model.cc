#include <continua/materials/model.h>

#include <algorithm>

namespace Continua
{
const std::vector<std::string> &model_names()
{
  static const std::vector<std::string> names = {"plane strain", "plane stress", "axisymmetric",
                                                 "three-dimensional"};
  return names;
}

Model model_of(const std::string &name)
{
  const auto &names = model_names();
  return static_cast<Model>(std::find(names.begin(), names.end(), name) - names.begin());
}

unsigned int n_dimensions(const Model model)
{
  return model == Model::three_dimensional ? 3 : 2;
}
} // namespace Continua
