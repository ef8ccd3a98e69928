#include <continua/case/tube_wave_case.h>

#include <continua/theory/korteweg.h>
#include <continua/vessel/tube_law.h>

#include <algorithm>

namespace Continua
{
namespace
{
constexpr double middle_of_inlet[3] = {0., 0., 0.};

template <int dim>
const BoundaryCondition *
find_condition(const Case<dim> &input, const std::string &boundary, const unsigned int region)
{
  for (const BoundaryCondition &condition : input.problem.conditions)
    if (input.problem.boundaries[condition.boundary_id] == boundary &&
        condition.region_ids.count(region) > 0)
      return &condition;
  return nullptr;
}

bool is_fixed(const BoundaryPart &part)
{
  return part.kind == BoundaryPart::Kind::velocity && part.is_zero();
}

/// A pressure or a flow rate that is not zero.
bool is_loaded(const BoundaryCondition &condition)
{
  return (condition.type == BoundaryType::flow_rate || condition.type == BoundaryType::pressure) &&
         !condition.normal.along_normal.is_zero();
}

bool is_free(const BoundaryPart &part)
{
  return part.kind == BoundaryPart::Kind::traction && part.is_zero();
}

/// Pressure is one and flow is conserved at a bifurcation (6.20): the branches' admittances add up.
double impedance_of_branches(const Material &fluid, const WaveTheoryParameters &parameters)
{
  double admittance = 0.;
  for (unsigned int i = 0; i < parameters.branch_diameters.size(); ++i)
  {
    const double radius = 0.5 * parameters.branch_diameters[i];
    const LongWaveTube branch{radius, parameters.branch_wall_thicknesses[i], 0.5, fluid.density,
                              fluid.inverse_bulk_modulus()};
    const Complex speed = korteweg_speed(branch, parameters.branch_youngs_moduli[i],
                                         Anchoring::expansion_joints, WallTheory::thick);
    admittance +=
        1. / characteristic_impedance(fluid.density, speed, dealii::numbers::PI * radius * radius)
                 .real();
  }
  return 1. / admittance;
}

/// One end of the wall, whose layers must all be held alike.
template <int dim>
std::string read_wall_end(const Case<dim> &input, const std::string &boundary, WallEnd &wall_end)
{
  for (unsigned int region = 1; region < input.problem.regions.size(); ++region)
  {
    const BoundaryCondition *condition = find_condition(input, boundary, region);
    if (condition == nullptr)
      return "the mesh has no boundary '" + boundary + "'";
    const bool clamped = is_fixed(condition->normal) && is_fixed(condition->tangential);
    const bool free = is_free(condition->normal) && is_free(condition->tangential);
    const bool absorbing = condition->type == BoundaryType::absorbing;
    const WallEnd present = absorbing ? WallEnd::absorbing
                            : clamped ? WallEnd::clamped
                                      : WallEnd::free;
    if (!absorbing && (condition->outlet || (!clamped && !free)))
      return "the '" + boundary + "' is neither fixed, free nor absorbing";
    if (region > 1 && present != wall_end)
      return "the layers' ends at '" + boundary + "' are held differently";
    wall_end = present;
  }
  return "";
}
} // namespace

template <int dim>
TubeSection tube_section_at(const Case<dim> &input, const TubeLaw &law, const double z)
{
  TubeSection section;
  section.inner_radius = 0.5 * law.inner_diameter(z);
  section.fluid = input.problem.materials[0];
  for (unsigned int layer = 0; layer < law.layer_fractions().size(); ++layer)
  {
    section.layer_thicknesses.push_back(law.layer_fractions()[layer] * law.wall_thickness(z));
    section.layers.push_back(input.problem.materials[layer + 1]);
  }
  const BoundaryCondition *outside =
      find_condition(input, "outside", input.problem.regions.size() - 1);
  section.tethered = outside != nullptr && is_fixed(outside->tangential);
  return section;
}

template <int dim>
std::string make_tube_wave_case(const Case<dim> &input, TubeWaveCase &wave_case)
{
  const std::vector<VesselBranch<dim>> branches = input.geometry->branches();
  if (branches.empty())
    return "the geometry is no 'tube'";
  if (branches.size() > 1)
    return "the vessel divides";
  const TubeLaw &law = branches.front().law;
  if (input.problem.regions.size() != law.layer_fractions().size() + 1)
    return "the tube has painted regions";
  if (input.problem.materials[0].is_solid())
    return "the tube is not full of liquid";
  const InteriorData &interior = input.problem.interior;
  if (!interior.acceleration.empty() || !interior.body_force.empty())
    return "there is a body force";
  if (!interior.initial_velocity.empty() || !interior.initial_displacement.empty() ||
      !interior.initial_pressure.empty())
    return "the initial state is not rest";

  TubeWaveProblem &problem = wave_case.problem;
  problem.level = input.wave_theory.level;
  // A table may vary more than a law does.
  problem.n_computed_sections =
      std::max(input.wave_theory.computed_sections, law.name() == "table" ? 16u : 0u);
  const BoundaryCondition *inlet = find_condition(input, "inlet", 0);
  const BoundaryCondition *outlet = find_condition(input, "outlet", 0);
  if (inlet == nullptr || outlet == nullptr)
    return "the mesh has no 'inlet' or 'outlet'";
  if (is_loaded(*inlet) && is_loaded(*outlet))
    return "both ends are loaded";
  wave_case.from_outlet = is_loaded(*outlet);
  if (wave_case.from_outlet)
    std::swap(inlet, outlet);
  const std::string end = wave_case.from_outlet ? "outlet" : "inlet",
                    far_end = wave_case.from_outlet ? "inlet" : "outlet";
  const Waveform waveform = inlet->normal.along_normal;
  if (inlet->type == BoundaryType::flow_rate)
    problem.inlet = TubeWaveProblem::Inlet::flow_rate;
  else if (inlet->type == BoundaryType::pressure)
    problem.inlet = TubeWaveProblem::Inlet::pressure;
  else
    return "the " + end + "'s Type is '" + word_of(boundary_type_words(), inlet->type) +
           "', not pressure or flow rate";
  if (waveform.depends_on_space())
    return "the " + end + "'s value depends on the place";
  wave_case.inlet = [waveform](const double time) { return waveform(middle_of_inlet, time); };

  if (input.wave_theory.far_end == FarEnd::matched)
    problem.outlet = TubeWaveProblem::Outlet::matched;
  else if (input.wave_theory.far_end == FarEnd::branches)
  {
    problem.outlet = TubeWaveProblem::Outlet::loaded;
    problem.load =
        Impedance::resistance(impedance_of_branches(input.problem.materials[0], input.wave_theory));
  }
  else if (outlet->type == BoundaryType::absorbing)
    problem.outlet = TubeWaveProblem::Outlet::absorbing;
  else if (outlet->outlet)
  {
    if (!outlet->outlet->pressure_behind.is_zero() || !outlet->outlet->initial_states.empty())
      return "the pressure behind the " + far_end + " or in it is not zero at the start";
    problem.outlet = TubeWaveProblem::Outlet::loaded;
    problem.load = outlet->outlet->impedance;
  }
  else if (is_fixed(outlet->normal))
    problem.outlet = TubeWaveProblem::Outlet::closed;
  else if (is_free(outlet->normal))
    problem.outlet = TubeWaveProblem::Outlet::open;
  else
    return "the " + far_end + " is neither closed (fixed) nor open (free, or no pressure)";
  for (const std::string &problem_of_end :
       {read_wall_end(input, "wall " + end + " end", problem.wall_inlet_end),
        read_wall_end(input, "wall " + far_end + " end", problem.wall_outlet_end)})
    if (!problem_of_end.empty())
      return problem_of_end;
  if (problem.wall_inlet_end == WallEnd::absorbing)
    return "the wall's end at the " + end + " absorbs, but not the liquid's";
  if (problem.wall_outlet_end == WallEnd::absorbing &&
      problem.outlet != TubeWaveProblem::Outlet::absorbing)
    return "the wall's end at the " + far_end + " absorbs, but not the liquid's";
  const BoundaryCondition *outside =
      find_condition(input, "outside", input.problem.regions.size() - 1);
  if (outside == nullptr || !is_free(outside->normal) ||
      !(is_free(outside->tangential) || is_fixed(outside->tangential)))
    return "the outside is neither free nor only held axially";

  const unsigned int n_segments = law.is_uniform() ? 1 : input.wave_theory.segments;
  const double length = law.length() / n_segments;
  problem.segments.clear();
  for (unsigned int i = 0; i < n_segments; ++i)
    problem.segments.push_back({length, tube_section_at(input, law, (i + 0.5) * length)});
  if (wave_case.from_outlet)
    std::reverse(problem.segments.begin(), problem.segments.end());
  return "";
}

template TubeSection tube_section_at(const Case<2> &, const TubeLaw &, double);
template TubeSection tube_section_at(const Case<3> &, const TubeLaw &, double);
template std::string make_tube_wave_case(const Case<2> &, TubeWaveCase &);
template std::string make_tube_wave_case(const Case<3> &, TubeWaveCase &);
} // namespace Continua
