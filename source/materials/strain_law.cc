#include <continua/materials/strain_law.h>

#include <stdexcept>

namespace Continua
{
void StrainLaw::set_mean_stress(const PointStrain &,
                                double &,
                                dealii::SymmetricTensor<2, 3> &) const
{
  throw std::logic_error("this law has no mean stress of its own");
}
} // namespace Continua
