#include <continua/boundary/flow_rates.h>

#include <continua/mesh/round_section.h>

#include <stdexcept>

namespace Continua
{
template <int dim>
void set_flow_profiles(std::vector<BoundaryCondition> &conditions,
                       ParameterSection boundaries,
                       const dealii::Triangulation<dim> &coarse_mesh,
                       const std::vector<Material> &materials,
                       const FlowRateTimes &times)
{
  for (BoundaryCondition &condition : conditions)
  {
    if (!condition.profile)
      continue;
    const ParameterSection section = boundaries.subsection(condition.name);
    RoundSection<dim> section_found{};
    try
    {
      section_found = find_round_section(coarse_mesh, condition.boundary_id, condition.region_ids);
    }
    catch (const std::invalid_argument &error)
    {
      section.refuse("Type", error.what(),
                     "Use 'velocity', or a geometry with a round section such as a tube");
    }
    FlowHistory history;
    if (condition.profile == FlowProfile::Shape::womersley)
    {
      if (times.steady)
        section.refuse("Profile", "a steady flow has no womersley profile",
                       "Use 'parabolic', which is what that becomes");
      const Material &liquid = materials[*condition.region_ids.begin()];
      if (condition.region_ids.size() > 1 || liquid.is_solid() || liquid.shear.viscosity <= 0. ||
          liquid.shear.flow_curve)
        section.refuse("Profile",
                       "a womersley profile is for one viscous liquid of constant viscosity",
                       "Use 'flat' or 'parabolic', or name the liquid's 'Region'");
      history = {liquid.shear.viscosity / liquid.density, times.end_time, times.time_step};
    }
    FlowProfile::Disc disc{section_found.radius, section_found.fraction, {{0., 0., 0.}}};
    for (unsigned int d = 0; d < dim; ++d)
      disc.centre[d] = section_found.centre[d];
    condition.normal.flow = std::make_shared<const FlowProfile>(
        *condition.profile, condition.normal.along_normal, disc, history);
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
