#ifndef continua_boundary_flow_rates_h
#define continua_boundary_flow_rates_h

#include <continua/boundary/boundary_condition.h>
#include <continua/materials/material.h>

#include <deal.II/grid/tria.h>

#include <vector>

namespace Continua
{
/// The time over which a flow rate is prescribed.
struct FlowRateTimes
{
  bool steady = false;
  double end_time = 0.;  ///< [s]
  double time_step = 0.; ///< [s]
};

/**
 * Gives every condition of type `flow rate` the profile over its section, which is found on the
 * coarse mesh: a disc, or in a plane model the gap of a channel. `boundaries` is the section that
 * the conditions were read from. Throws InputError if a section is neither, if a womersley profile
 * has no liquid, no time or no period that it is for, or if a table does not cover the section. A
 * free flow gets the fraction of its section.
 */
template <int dim>
void set_flow_profiles(std::vector<BoundaryCondition> &conditions,
                       ParameterSection boundaries,
                       const dealii::Triangulation<dim> &coarse_mesh,
                       const std::vector<Material> &materials,
                       const FlowRateTimes &times);
} // namespace Continua

#endif
