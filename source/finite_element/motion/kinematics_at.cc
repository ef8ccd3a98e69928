#include <continua/finite_element/motion/kinematics_at.h>

namespace Continua
{
using namespace dealii;

template <int dim>
Kinematics kinematics_at(const Space<dim> &space,
                         const FEValuesBase<dim> &values,
                         const unsigned int q,
                         const std::vector<types::global_dof_index> &indices,
                         const DistributedVector &displacement)
{
  Tensor<2, dim> gradient;
  double radial = 0.;
  for (unsigned int i = 0; i < indices.size(); ++i)
  {
    const unsigned int c = space.velocity_element.system_to_component_index(i).first;
    const double entry = displacement(indices[i]);
    gradient[c] += entry * values.shape_grad(i, q);
    if (c == 1)
      radial += entry * values.shape_value(i, q);
  }
  const double hoop = space.is_axisymmetric() ? radial / values.quadrature_point(q)[1] : 0.;
  return Kinematics(whole_gradient<dim>(gradient, hoop));
}

template Kinematics kinematics_at(const Space<2> &,
                                  const FEValuesBase<2> &,
                                  unsigned int,
                                  const std::vector<types::global_dof_index> &,
                                  const DistributedVector &);
template Kinematics kinematics_at(const Space<3> &,
                                  const FEValuesBase<3> &,
                                  unsigned int,
                                  const std::vector<types::global_dof_index> &,
                                  const DistributedVector &);
} // namespace Continua
