#include <continua/boundary/flow_rates.h>

#include <continua/mesh/channel_section.h>
#include <continua/mesh/coordinates.h>
#include <continua/mesh/round_section.h>

#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
/// Of the largest flow rate, by which one that repeats may differ after a period.
constexpr double periodic_slack = 1e-6;
constexpr unsigned int n_times_of_period = 64;

template <int dim>
FlowProfile::Section section_of_condition(const std::vector<BoundaryCondition> &conditions,
                                          const BoundaryCondition &condition,
                                          const dealii::Triangulation<dim> &coarse_mesh)
{
  FlowProfile::Section section;
  if constexpr (dim == 2)
    if (condition.is_in_plane)
    {
      std::set<dealii::types::boundary_id> symmetry;
      for (const BoundaryCondition &other : conditions)
        if (other.type == BoundaryType::roller)
          symmetry.insert(other.boundary_id);
      const ChannelSection channel =
          find_channel_section(coarse_mesh, condition.boundary_id, condition.region_ids, symmetry);
      section.radius = channel.half_gap;
      section.fraction = channel.fraction;
      section.centre = coordinates(channel.middle);
      section.is_channel = true;
      section.across = {{channel.direction[0], channel.direction[1], 0.}};
      return section;
    }
  const RoundSection<dim> disc =
      find_round_section(coarse_mesh, condition.boundary_id, condition.region_ids);
  section.radius = disc.radius;
  section.fraction = disc.fraction;
  section.centre = coordinates(disc.centre);
  return section;
}

/// The part of a section that the mesh has; of one that is no disc and no gap all of it.
template <int dim>
double fraction_of_section(const std::vector<BoundaryCondition> &conditions,
                           const BoundaryCondition &condition,
                           const dealii::Triangulation<dim> &coarse_mesh)
{
  try
  {
    return section_of_condition(conditions, condition, coarse_mesh).fraction;
  }
  catch (const std::invalid_argument &)
  {
    return 1.;
  }
}

/// What a womersley profile needs. Throws InputError.
FlowHistory history_of(const BoundaryCondition &condition,
                       const ParameterSection &section,
                       const std::vector<Material> &materials,
                       const FlowRateTimes &times)
{
  if (times.steady)
    section.refuse("Profile", "a steady flow has no womersley profile",
                   "Use 'parabolic', which is what that becomes");
  const Material &liquid = materials[*condition.region_ids.begin()];
  if (condition.region_ids.size() > 1 || liquid.is_solid() || liquid.shear.viscosity <= 0. ||
      liquid.shear.flow_curve)
    section.refuse("Profile", "a womersley profile is for one viscous liquid of constant viscosity",
                   "Use 'flat' or 'parabolic', or name the liquid's 'Region'");
  const FlowHistory history = {liquid.shear.viscosity / liquid.density, times.end_time,
                               times.time_step, condition.past, condition.period};
  if (history.past != FlowPast::periodic)
    return history;
  const Waveform &flow_rate = condition.normal.along_normal;
  const double origin[3] = {0., 0., 0.};
  double largest = 0., difference = 0.;
  for (unsigned int i = 0; i <= n_times_of_period; ++i)
  {
    const double time = history.period * i / n_times_of_period;
    largest = std::max(largest, std::abs(flow_rate(origin, time)));
    // A later period counts as far as the run goes.
    if (i == 0 || time + history.period <= times.end_time)
      difference = std::max(
          difference, std::abs(flow_rate(origin, time + history.period) - flow_rate(origin, time)));
  }
  if (difference > periodic_slack * largest)
    section.refuse("Period", "the flow rate does not repeat itself after this time",
                   "Give the period of the flow rate (with a table: After the table = repeat), or "
                   "set Flow before the start = steady");
  return history;
}
} // namespace

template <int dim>
void set_flow_profiles(std::vector<BoundaryCondition> &conditions,
                       ParameterSection boundaries,
                       const dealii::Triangulation<dim> &coarse_mesh,
                       const std::vector<Material> &materials,
                       const FlowRateTimes &times)
{
  for (BoundaryCondition &condition : conditions)
  {
    if (condition.free_flow)
      condition.free_flow->fraction = fraction_of_section(conditions, condition, coarse_mesh);
    if (!condition.profile)
      continue;
    const ParameterSection section = boundaries.subsection(condition.name);
    FlowProfile::Section of_flow;
    try
    {
      of_flow = section_of_condition(conditions, condition, coarse_mesh);
    }
    catch (const std::invalid_argument &error)
    {
      section.refuse("Type", error.what(),
                     condition.is_in_plane
                         ? "Use 'velocity', or a boundary across a channel"
                         : "Use 'velocity', or a geometry with a round section such as a tube");
    }
    FlowHistory history;
    if (condition.profile == FlowProfile::Shape::womersley)
      history = history_of(condition, section, materials, times);
    if (condition.profile_table)
      condition.profile_table->check(of_flow.radius, of_flow.is_channel);
    condition.normal.flow =
        std::make_shared<const FlowProfile>(*condition.profile, condition.normal.along_normal,
                                            of_flow, history, condition.profile_table);
  }
}

template void set_flow_profiles(std::vector<BoundaryCondition> &,
                                ParameterSection,
                                const dealii::Triangulation<2> &,
                                const std::vector<Material> &,
                                const FlowRateTimes &);
template void set_flow_profiles(std::vector<BoundaryCondition> &,
                                ParameterSection,
                                const dealii::Triangulation<3> &,
                                const std::vector<Material> &,
                                const FlowRateTimes &);
} // namespace Continua
