#ifndef continua_finite_element_products_supports_h
#define continua_finite_element_products_supports_h

#include <continua/boundary/boundary_condition.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/space/space.h>

#include <vector>

namespace Continua
{
/// Assembles the matrices of what supports the regions, over the undeformed boundaries:
/// RegionOperators::support_stiffness and support_damping. Collective.
template <int dim>
void assemble_supports(const Space<dim> &space,
                       const std::vector<BoundaryCondition> &conditions,
                       std::vector<RegionOperators> &operators);
} // namespace Continua

#endif
