#ifndef continua_finite_element_conditions_flow_shapes_h
#define continua_finite_element_conditions_flow_shapes_h

#include <continua/boundary/boundary_condition.h>
#include <continua/finite_element/space/space.h>

#include <map>
#include <vector>

namespace Continua
{
/**
 * The shapes of a flow profile at the nodes of its boundary, by the owned dof of the x component;
 * nodes at the rim have none. They are those of FlowProfile, corrected by a multiple of the first
 * one so that the flow of the finite-element velocity, its integral over the boundary, has exactly
 * the mean 1 for the first shape and 0 for the others: the interpolated profile carries Q to
 * round-off. Collective.
 */
template <int dim>
std::map<dealii::types::global_dof_index, std::vector<double>>
nodal_flow_shapes(const Space<dim> &space, const BoundaryCondition &condition);
} // namespace Continua

#endif
