#include <continua/continuum/vibration_operator.h>

#include <deal.II/base/exceptions.h>

namespace Continua
{
template <int dim>
void VibrationOperator<dim>::accelerate(const std::vector<double> & /*x*/,
                                        std::vector<double> & /*y*/)
{
  AssertThrow(false, dealii::ExcNotImplemented());
}

template <int dim>
std::size_t VibrationOperator<dim>::n_below_shift() const
{
  AssertThrow(false, dealii::ExcNotImplemented());
  return 0;
}

template class VibrationOperator<2>;
template class VibrationOperator<3>;
} // namespace Continua
