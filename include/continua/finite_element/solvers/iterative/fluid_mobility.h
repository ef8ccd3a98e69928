#ifndef continua_finite_element_solvers_iterative_fluid_mobility_h
#define continua_finite_element_solvers_iterative_fluid_mobility_h

#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/solvers/iterative/step_preconditioner.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/linear_algebra/velocity_operator.h>

#include <vector>

namespace Continua
{
/**
 * Lowers the mobility D [s/kg] of the velocities outside the stiff block to that of a viscous fluid
 * between walls at rest. Where viscosity acts over the whole section of a vessel within a step, not
 * its inertia but the friction at the walls resists a pressure that changes along the vessel. Such
 * a pressure moves the fluid as a uniform force does: with the lumped mass M 1 of unit density
 * [m^3] and w the velocity under a force of 1 N/m^3 in each direction [m^4/(N s)],
 *
 *   A w = M 1 at these velocities, w = 0 at the stiff ones,   D_i = w_i/M_ii.
 *
 * In a step that is short against the viscosity D stays one over the inertia. D is never above
 * that, and never below 1/A_ii. Without inertia it gives the stiff velocities a D, too.
 * `velocity`: A. `made` has its inverse. Collective.
 *
 * w is wanted to a hundredth, since it is a part of a preconditioner.
 */
template <int dim>
void add_friction(const Space<dim> &space,
                  const std::vector<RegionOperators> &operators,
                  const BoundaryConstraints<dim> &constraints,
                  const VelocityOperator &velocity,
                  const StepPreconditioner<dim> &made,
                  DistributedVector &mobility);
} // namespace Continua

#endif
