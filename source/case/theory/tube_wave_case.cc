#include <continua/boundary/boundary_types.h>
#include <continua/case/theory/tube_wave_case.h>

#include <continua/case/theory/loaded_tube_case.h>
#include <continua/theory/korteweg.h>
#include <continua/vessel/tube_law.h>

#include <algorithm>

namespace Continua
{
namespace
{
constexpr double middle_of_inlet[3] = {0., 0., 0.};
const std::string outside_is_held =
    "the outside is neither free nor supported nor only held axially";

/// Of an inlet: its pressure or flow rate.
const Waveform &waveform_of(const BoundaryCondition &condition)
{
  return condition.free_flow ? condition.free_flow->rate : condition.normal.along_normal;
}

/// A pressure or a flow rate that is not zero.
bool is_loaded(const BoundaryCondition &condition)
{
  return (condition.type == BoundaryType::flow_rate || condition.type == BoundaryType::pressure) &&
         !waveform_of(condition).is_zero();
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
} // namespace

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

template <int dim>
std::string read_wall_end(const Case<dim> &input, const std::string &boundary, WallEnd &wall_end)
{
  for (unsigned int region = 1; region < input.problem.regions.size(); ++region)
  {
    const BoundaryCondition *condition = find_condition(input, boundary, region);
    if (condition == nullptr)
      return "the mesh has no boundary '" + boundary + "'";
    const bool clamped = condition->normal.is_fixed() && condition->tangential.is_fixed();
    const BoundaryCondition *const outside =
        find_condition(input, "outside", input.problem.regions.size() - 1);
    // A wall that is held along moves across at a roller as at a free end.
    const bool is_held_along = outside != nullptr && outside->tangential.is_fixed();
    const bool free =
        (condition->normal.is_free() || (is_held_along && condition->normal.is_fixed())) &&
        condition->tangential.is_free();
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

template <int dim>
TubeSection tube_section_at(const Case<dim> &input, const TubeLaw &law, const double z)
{
  const TubeSection section = tube_section_of_mesh(input, law, z);
  return is_about_loaded_state(input)
             ? LoadedTube(section).section_about(input.wave_theory.mean_pressure)
             : section;
}

template <int dim>
TubeSection tube_section_of_mesh(const Case<dim> &input, const TubeLaw &law, const double z)
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
  if (outside != nullptr)
    set_hold(*outside, section);
  return section;
}

void set_hold(const BoundaryCondition &outside, TubeSection &section)
{
  section.tethered = outside.tangential.is_fixed();
  section.radial_stiffness = outside.normal.stiffness;
  section.radial_damping = outside.normal.damping;
  section.axial_stiffness = outside.tangential.stiffness;
  section.axial_damping = outside.tangential.damping;
}

namespace
{
/// Which boundaries end a tube of the theory; empty where the vessel divides.
struct Ends
{
  std::string inlet, wall_inlet, outlet, wall_outlet;
};

/// What the liquid and the wall meet at the far end; or why the theory has no such end.
template <int dim>
std::string read_far_end(const Case<dim> &input, const Ends &ends, TubeWaveProblem &problem)
{
  const BoundaryCondition *const condition = find_condition(input, ends.outlet, 0);
  if (condition == nullptr)
    return "the mesh has no '" + ends.outlet + "'";
  if (input.analysis.is_transient() && input.problem.interior.starts_under_mean_loads)
    return "the run starts under the mean of its loads, and the theory from rest";
  if (input.analysis.is_transient() && input.problem.deformation == Deformation::finite &&
      (input.problem.interior.starts_steady_under_loads || input.problem.finds_unloaded_shape()))
    return "the run starts in a loaded state, and the theory is that of the wall without load";
  if (condition->type == BoundaryType::network)
    return "the " + ends.outlet + " is an end of a network, which the theory does not have";
  if (input.wave_theory.far_end == FarEnd::matched)
    problem.outlet = TubeWaveProblem::Outlet::matched;
  else if (input.wave_theory.far_end == FarEnd::branches)
  {
    problem.outlet = TubeWaveProblem::Outlet::loaded;
    problem.load =
        Impedance::resistance(impedance_of_branches(input.problem.materials[0], input.wave_theory));
  }
  else if (condition->type == BoundaryType::absorbing)
  {
    if (!condition->outlet->pressure_behind.is_zero())
      return "the " + ends.outlet + " has a mean pressure, and the theory starts without one";
    problem.outlet = TubeWaveProblem::Outlet::absorbing;
  }
  else if (condition->outlet)
  {
    if (!condition->outlet->pressure_behind.is_zero() || !condition->outlet->initial_states.empty())
      return "the pressure behind the " + ends.outlet + " or in it is not zero at the start";
    problem.outlet = TubeWaveProblem::Outlet::loaded;
    problem.load = condition->outlet->impedance;
  }
  else if (condition->normal.is_fixed())
    problem.outlet = TubeWaveProblem::Outlet::closed;
  else if (condition->normal.is_free())
    problem.outlet = TubeWaveProblem::Outlet::open;
  else
    return "the " + ends.outlet + " is neither closed (fixed) nor open (free, or no pressure)";
  std::string of_wall = read_wall_end(input, ends.wall_outlet, problem.wall_outlet_end);
  if (!of_wall.empty())
    return of_wall;
  if (problem.wall_outlet_end == WallEnd::absorbing &&
      problem.outlet != TubeWaveProblem::Outlet::absorbing)
    return "the wall's end at the " + ends.outlet + " absorbs, but not the liquid's";
  return "";
}

/// What drives the inlet of the theory.
template <int dim>
std::string read_inlet(const Case<dim> &input, const Ends &ends, TubeWaveCase &wave_case)
{
  TubeWaveProblem &problem = wave_case.problem;
  const BoundaryCondition *const condition = find_condition(input, ends.inlet, 0);
  if (condition == nullptr)
    return "the mesh has no '" + ends.inlet + "'";
  const Waveform waveform = waveform_of(*condition);
  if (condition->type == BoundaryType::flow_rate)
    problem.inlet = TubeWaveProblem::Inlet::flow_rate;
  else if (condition->type == BoundaryType::pressure)
    problem.inlet = TubeWaveProblem::Inlet::pressure;
  else
    return "the " + ends.inlet + "'s Type is '" + word_of(boundary_type_words(), condition->type) +
           "', not pressure or flow rate";
  if (waveform.depends_on_space())
    return "the " + ends.inlet + "'s value depends on the place";
  wave_case.inlet = [waveform](const double time) { return waveform(middle_of_inlet, time); };
  std::string of_wall = read_wall_end(input, ends.wall_inlet, problem.wall_inlet_end);
  if (!of_wall.empty())
    return of_wall;
  if (problem.wall_inlet_end == WallEnd::absorbing)
    return "the wall's end at the " + ends.inlet + " absorbs, but not the liquid's";
  return "";
}

/// The level of theory, and the uniform segments from the inlet of the law to its outlet.
template <int dim>
void set_segments(const Case<dim> &input, const TubeLaw &law, TubeWaveProblem &problem)
{
  problem.level = input.wave_theory.level;
  // A table may vary more than a law does. Sections that are the same are computed once.
  const unsigned int by_law = law.name() == "table" ? 40 : 6;
  problem.n_computed_sections =
      input.wave_theory.computed_sections > 0 ? input.wave_theory.computed_sections : by_law;
  const unsigned int n_segments = law.is_uniform() ? 1 : input.wave_theory.segments;
  const double length = law.length() / n_segments;
  problem.segments.clear();
  for (unsigned int i = 0; i < n_segments; ++i)
    problem.segments.push_back({length, tube_section_at(input, law, (i + 0.5) * length)});
}

/// Whether a boundary has a pressure or a flow rate that is not zero.
template <int dim>
bool is_loaded(const Case<dim> &input, const std::string &boundary)
{
  const BoundaryCondition *const condition = find_condition(input, boundary, 0);
  return condition != nullptr && is_loaded(*condition);
}

} // namespace

template <int dim>
std::string why_no_tube_of_liquid(const Case<dim> &input)
{
  const std::vector<VesselBranch<dim>> branches = input.geometry->branches();
  if (branches.empty())
    return "the geometry is no 'tube'";
  for (const VesselBranch<dim> &branch : branches)
    if (input.problem.regions.size() != branch.law.layer_fractions().size() + 1)
      return "the tube has painted regions";
  if (input.problem.materials[0].is_solid())
    return "the tube is not full of liquid";
  for (std::size_t layer = 1; layer < input.problem.materials.size(); ++layer)
    if (!input.problem.materials[layer].is_solid())
      return "a layer of the wall is a liquid";
  const BoundaryCondition *outside =
      find_condition(input, "outside", input.problem.regions.size() - 1);
  if (branches.front().law.is_rigid())
  {
    if (input.problem.materials[0].inverse_bulk_modulus() == 0.)
      return "an incompressible liquid in a rigid tube carries no wave";
    if (outside == nullptr || !outside->normal.is_fixed() || !outside->tangential.is_fixed())
      return "the tube has no wall, and its outside is not fixed";
  }
  else if (outside == nullptr || outside->outlet ||
           outside->normal.kind != BoundaryPart::Kind::traction || !outside->tangential.is_zero())
    return outside_is_held;
  return "";
}

namespace
{
/// Why the vessel as a whole is not one of the theory; or nothing.
template <int dim>
std::string why_not_covered(const Case<dim> &input, const std::vector<VesselBranch<dim>> &branches)
{
  if (std::string why_not = why_no_tube_of_liquid(input); !why_not.empty())
    return why_not;
  const BoundaryCondition *outside =
      find_condition(input, "outside", input.problem.regions.size() - 1);
  if (!branches.front().law.is_rigid() && !outside->normal.is_zero())
    return outside_is_held;
  if (outside != nullptr && outside->tangential.is_supported() &&
      input.wave_theory.level != WaveLevel::exact)
    return "the outside is supported along the axis, which only Wave theory/Level = exact has";
  const InteriorData &interior = input.problem.interior;
  if (!interior.acceleration.empty() || !interior.body_force.empty())
    return "there is a body force";
  if (!interior.initial_velocity.empty() || !interior.initial_displacement.empty() ||
      !interior.initial_pressure.empty())
    return "the initial state is not rest";
  if (branches.size() > 1)
  {
    // How a wall's axial motion goes on into the branches depends on the junction.
    if (outside == nullptr || !outside->tangential.is_fixed())
      return "the vessel divides, and its wall is not held axially (outside: Tangential = fixed)";
    if (input.wave_theory.far_end == FarEnd::branches)
      return "the vessel divides, and 'Wave theory/Far end' gives it other branches";
  }
  return "";
}
} // namespace

template <int dim>
double direction_of_pulse(const Case<dim> &input, const unsigned int branch)
{
  const std::vector<VesselBranch<dim>> branches = input.geometry->branches();
  const auto loaded_ends = [&](const unsigned int b)
  {
    std::vector<double> places;
    for (const auto &end : branches[b].ends)
      if (is_loaded(input, end.fluid))
        places.push_back(end.position);
    return places;
  };
  const std::vector<double> own = loaded_ends(branch);
  if (!own.empty())
    return std::count(own.begin(), own.end(), 0.) > 0 ? 1. : -1.;
  // From another branch the pulse comes through the point where the vessel divides: the end of the
  // first branch and the beginning of the others.
  for (unsigned int b = 1; branch == 0 && b < branches.size(); ++b)
    if (!loaded_ends(b).empty())
      return -1.;
  return 1.;
}

template <int dim>
std::string make_tube_wave_case(const Case<dim> &input, TubeWaveCase &wave_case)
{
  const std::vector<VesselBranch<dim>> branches = input.geometry->branches();
  std::string why_not = why_not_covered(input, branches);
  if (!why_not.empty())
    return why_not;

  TubeWaveProblem &problem = wave_case.problem;
  set_segments(input, branches.front().law, problem);
  const auto &ends_of_first = branches.front().ends;
  Ends ends{ends_of_first.front().fluid, ends_of_first.front().wall, "", ""};
  if (branches.size() == 1)
  {
    ends.outlet = ends_of_first.back().fluid;
    ends.wall_outlet = ends_of_first.back().wall;
    if (is_loaded(input, ends.inlet) && is_loaded(input, ends.outlet))
      return "both ends are loaded";
    wave_case.from_outlet = is_loaded(input, ends.outlet);
    if (wave_case.from_outlet)
    {
      std::swap(ends.inlet, ends.outlet);
      std::swap(ends.wall_inlet, ends.wall_outlet);
      std::reverse(problem.segments.begin(), problem.segments.end());
    }
    why_not = read_inlet(input, ends, wave_case);
    return why_not.empty() ? read_far_end(input, ends, problem) : why_not;
  }

  // The first branch divides into the others. The walls go over into each other: no moment and no
  // shear force of either is prescribed there.
  problem.outlet = TubeWaveProblem::Outlet::divided;
  problem.wall_outlet_end = WallEnd::free;
  problem.branches.clear();
  why_not = read_inlet(input, ends, wave_case);
  for (unsigned int b = 1; b < branches.size() && why_not.empty(); ++b)
  {
    TubeWaveProblem branch;
    set_segments(input, branches[b].law, branch);
    branch.wall_inlet_end = WallEnd::free;
    const auto &end = branches[b].ends.front();
    if (is_loaded(input, end.fluid))
      return "the vessel divides, and the '" + end.fluid + "' is loaded";
    why_not = read_far_end(input, {"", "", end.fluid, end.wall}, branch);
    problem.branches.push_back(branch);
  }
  return why_not;
}

template std::string read_wall_end(const Case<2> &, const std::string &, WallEnd &);
template std::string read_wall_end(const Case<3> &, const std::string &, WallEnd &);
template double direction_of_pulse(const Case<2> &, unsigned int);
template double direction_of_pulse(const Case<3> &, unsigned int);
template TubeSection tube_section_at(const Case<2> &, const TubeLaw &, double);
template TubeSection tube_section_at(const Case<3> &, const TubeLaw &, double);
template TubeSection tube_section_of_mesh(const Case<2> &, const TubeLaw &, double);
template TubeSection tube_section_of_mesh(const Case<3> &, const TubeLaw &, double);
template std::string why_no_tube_of_liquid(const Case<2> &);
template std::string why_no_tube_of_liquid(const Case<3> &);
template std::string make_tube_wave_case(const Case<2> &, TubeWaveCase &);
template std::string make_tube_wave_case(const Case<3> &, TubeWaveCase &);
template const BoundaryCondition *
find_condition(const Case<2> &, const std::string &, unsigned int);
template const BoundaryCondition *
find_condition(const Case<3> &, const std::string &, unsigned int);
} // namespace Continua
