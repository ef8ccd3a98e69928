#ifndef continua_finite_element_solvers_region_divergence_h
#define continua_finite_element_solvers_region_divergence_h

#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/divergence_operator.h>

#include <vector>

namespace Continua
{
/// B T of a step's system by the matrices of its regions, and the boundary constraints: without the
/// matrix of assemble_divergence().
template <int dim>
class RegionDivergence : public DivergenceOperator
{
public:
  /// All must outlive it.
  RegionDivergence(const Space<dim> &space,
                   const std::vector<RegionOperators> &operators,
                   const BoundaryConstraints<dim> &constraints);

  void multiply(DistributedVector &target, const DistributedVector &source) const override;
  void multiply_transposed(DistributedVector &target,
                           const DistributedVector &source) const override;

private:
  const std::vector<RegionOperators> &operators;
  const BoundaryConstraints<dim> &constraints;
  mutable DistributedVector velocity_work, pressure_work;
};
} // namespace Continua

#endif
