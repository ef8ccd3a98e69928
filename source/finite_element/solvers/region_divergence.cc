#include <continua/finite_element/solvers/region_divergence.h>
#include <continua/linear_algebra/matrix_product.h>

namespace Continua
{
template <int dim>
RegionDivergence<dim>::RegionDivergence(const Space<dim> &space,
                                        const std::vector<RegionOperators> &operators,
                                        const BoundaryConstraints<dim> &constraints)
    : operators(operators),
      constraints(constraints),
      velocity_work(space.velocity_vector()),
      pressure_work(space.pressure_vector())
{
}

template <int dim>
void RegionDivergence<dim>::multiply(DistributedVector &target,
                                     const DistributedVector &source) const
{
  velocity_work.equ(1., source);
  constraints.expand_free(velocity_work);
  target = 0.;
  for (const RegionOperators &region : operators)
  {
    Continua::multiply(region.divergence, pressure_work, velocity_work);
    target.add(1., pressure_work);
  }
}

template <int dim>
void RegionDivergence<dim>::multiply_transposed(DistributedVector &target,
                                                const DistributedVector &source) const
{
  target = 0.;
  for (const RegionOperators &region : operators)
  {
    Continua::multiply_transposed(region.divergence, velocity_work, source);
    target.add(1., velocity_work);
  }
  constraints.restrict_to_free(target);
}

template class RegionDivergence<2>;
template class RegionDivergence<3>;
} // namespace Continua
