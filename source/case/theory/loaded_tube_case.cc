#include <continua/case/theory/loaded_tube_case.h>

#include <continua/case/theory/tube_wave_case.h>
#include <continua/vessel/tube_law.h>

#include <stdexcept>

namespace Continua
{
namespace
{
/// Layers that the theory takes.
void check_layers(const Problem &problem, ParameterSection materials)
{
  for (unsigned int region = 1; region < problem.materials.size(); ++region)
  {
    const Material &layer = problem.materials[region];
    ParameterSection section = materials.subsection(problem.regions[region]);
    if (layer.has_power_law())
      section.refuse("Type",
                     "a power law has no long-term modulus, on which a strain law could be based",
                     "Set Type = prony, or Deformation = small");
    if (layer.long_term_shear_modulus() == 0.)
      section.refuse("Type",
                     "'" + layer.type +
                         "' has no spring that holds, and yields to the mean pressure for ever",
                     "Set Type = prony with a small Young's modulus, or Deformation = small");
    if (layer.strain_law->has_own_mean_stress())
      section.refuse("Strain law",
                     "the wall about a loaded state is incompressible in theory, and this law is "
                     "compressible",
                     "Choose another law with Poisson's ratio = 0.5");
    if (!layer.is_incompressible())
      section.refuse("Poisson's ratio", "the wall about a loaded state is incompressible in theory",
                     "Set Poisson's ratio = 0.5");
  }
}

template <int dim>
void check_outside(const Case<dim> &input, ParameterSection boundaries)
{
  for (const BoundaryCondition &condition : input.problem.conditions)
    if (input.problem.boundaries[condition.boundary_id] == "outside")
    {
      ParameterSection section = boundaries.subsection(condition.name);
      if (condition.normal.is_supported() || condition.tangential.is_supported())
        section.refuse("Type", "theory has no support about a loaded state",
                       "Set Type = pressure, Pressure = 0 Pa and Tangential = fixed");
      if (!condition.tangential.is_fixed())
        section.refuse(section.given("Tangential") ? "Tangential" : "Type",
                       "about a loaded state theory has the wall held along its axis",
                       "Set Type = pressure, Pressure = 0 Pa and Tangential = fixed");
    }
}
} // namespace

namespace
{
/// What presses on the outside [Pa].
template <int dim>
double outside_pressure(const Case<dim> &input, const double time)
{
  const double origin[3] = {0., 0., 0.};
  const BoundaryCondition *const outside =
      find_condition(input, "outside", input.problem.regions.size() - 1);
  if (outside == nullptr)
    return 0.;
  const double value = outside->normal.along_normal(origin, time);
  return outside->normal.negative ? value : -value;
}

/// The pressure in all of a branch, the smaller one of both ends [Pa], and the condition that gives
/// it; null where an end has none that is known.
template <int dim>
const BoundaryCondition *smallest_pressure(const Case<dim> &input,
                                           const VesselBranch<dim> &branch,
                                           const double time,
                                           double &pressure)
{
  const double origin[3] = {0., 0., 0.};
  const BoundaryCondition *smallest = nullptr;
  for (const auto &end : branch.ends)
  {
    const BoundaryCondition *const condition = find_condition(input, end.fluid, 0);
    if (condition == nullptr ||
        (condition->type != BoundaryType::pressure && !condition->normal.is_fixed()))
      return nullptr;
    if (condition->type != BoundaryType::pressure)
      continue;
    const double of_end = condition->normal.along_normal(origin, time);
    if (smallest == nullptr || of_end < pressure)
    {
      smallest = condition;
      pressure = of_end;
    }
  }
  pressure -= outside_pressure(input, time);
  return smallest;
}

/// Whether a branch is uniform and keeps its length, free to widen at its ends, and theory knows
/// the steady state of its wall.
template <int dim>
bool is_held_along(const Case<dim> &input, const VesselBranch<dim> &branch)
{
  const Problem &problem = input.problem;
  if (branch.law.is_rigid() || !branch.law.is_uniform() || problem.materials.front().is_solid() ||
      problem.regions.size() != branch.law.layer_fractions().size() + 1)
    return false;
  for (unsigned int region = 1; region < problem.materials.size(); ++region)
  {
    const Material &layer = problem.materials[region];
    if (layer.strain_law == nullptr || layer.strain_law->has_own_mean_stress() ||
        !layer.is_incompressible() || layer.long_term_shear_modulus() == 0.)
      return false;
    for (const auto &end : branch.ends)
      if (const BoundaryCondition *const of_wall = find_condition(input, end.wall, region);
          of_wall == nullptr || !of_wall->normal.is_fixed() || !of_wall->tangential.is_free())
        return false;
  }
  const BoundaryCondition *const outside =
      find_condition(input, "outside", problem.regions.size() - 1);
  return outside != nullptr && !outside->is_supported() &&
         outside->normal.kind == BoundaryPart::Kind::traction;
}
} // namespace

template <int dim>
void check_largest_pressure(const Case<dim> &input, const double time, ParameterSection root)
{
  const Problem &problem = input.problem;
  for (const VesselBranch<dim> &branch : input.geometry->branches())
  {
    double pressure = 0., of_image = 0.;
    const BoundaryCondition *const given =
        is_held_along(input, branch) ? smallest_pressure(input, branch, time, pressure) : nullptr;
    if (given == nullptr)
      continue;
    const TubeSection section = tube_section_of_mesh(input, branch.law, 0.);
    try
    {
      if (problem.finds_unloaded_shape())
      {
        smallest_pressure(input, branch, 0., of_image);
        const LoadedTube tube = LoadedTube::of_image(section, of_image);
        if (time != 0.)
          tube.inner_radius(pressure);
      }
      else
        LoadedTube(section).inner_radius(pressure);
    }
    catch (const std::domain_error &error)
    {
      ParameterSection end = root.subsection("Boundaries").subsection(given->name);
      end.refuse(end.given("Pressure") ? "Pressure" : "",
                 std::string("the tube has no state at rest under this pressure: ") + error.what(),
                 "Give a lower pressure or a stiffer wall; a law that stiffens bears more");
    }
  }
}

template <int dim>
TubeSection loaded_section_at(const Case<dim> &input,
                              const TubeLaw &law,
                              const double z,
                              const double pressure,
                              const ParameterSection &condition,
                              ParameterSection root)
{
  check_layers(input.problem, root.subsection("Materials"));
  check_outside(input, root.subsection("Boundaries"));
  const TubeSection of_mesh = tube_section_of_mesh(input, law, z);
  const double across_wall = pressure - outside_pressure(input, 0.);
  try
  {
    return (input.problem.finds_unloaded_shape() ? LoadedTube::of_image(of_mesh, across_wall)
                                                 : LoadedTube(of_mesh))
        .section_about(across_wall, WallTheory::thick);
  }
  catch (const std::domain_error &error)
  {
    condition.refuse("Mean pressure",
                     std::string("the tube does not bear the mean pressure: ") + error.what(),
                     "Give a lower pressure or a stiffer wall");
  }
}

template <int dim>
void check_loaded_tube(const Case<dim> &input, ParameterSection root)
{
  if (!why_no_tube_of_liquid(input).empty())
    return;
  const std::vector<VesselBranch<dim>> branches = input.geometry->branches();
  if (branches.front().law.is_rigid())
    root.refuse("Deformation", "the tube has no wall that could deform", "Set Deformation = small");
  if (input.problem.convection.is_on)
    root.refuse("Convection", "wave theory is linear", "Set Convection = none");
  if (input.problem.finds_unloaded_shape())
    root.refuse(
        "Unloaded shape", "wave theory inflates the tube from the shape of the mesh",
        "Set Unloaded shape = mesh, and give the radii that the wall has without load (those of "
        "the opened ring beside an Opening angle)");
  ParameterSection theory = root.subsection("Wave theory");
  if (input.wave_theory.level != WaveLevel::womersley)
    theory.refuse(theory.given("Level") ? "Level" : "",
                  "about a loaded state there is only the theory of long waves",
                  "Set Level = womersley, or Deformation = small");
  if (input.wave_theory.stream.mean_velocity > 0.)
    theory.refuse("Mean flow", "about a loaded state theory has the liquid at rest",
                  "Leave the entry out, or set Deformation = small");
  if (!theory.given("Mean pressure"))
    theory.refuse_missing(
        "the entry 'Mean pressure' is missing: with Deformation = finite the waves "
        "run about the state under it",
        "Add 'set Mean pressure = ...', which may be 0 Pa");
  check_layers(input.problem, root.subsection("Materials"));
  check_outside(input, root.subsection("Boundaries"));
  TubeWaveCase wave_case;
  try
  {
    make_tube_wave_case(input, wave_case);
  }
  catch (const std::domain_error &error)
  {
    theory.refuse("Mean pressure",
                  std::string("the tube does not bear the mean pressure: ") + error.what(),
                  "Give a lower pressure or a stiffer wall");
  }
}

template TubeSection loaded_section_at(
    const Case<2> &, const TubeLaw &, double, double, const ParameterSection &, ParameterSection);
template TubeSection loaded_section_at(
    const Case<3> &, const TubeLaw &, double, double, const ParameterSection &, ParameterSection);
template void check_largest_pressure(const Case<2> &, double, ParameterSection);
template void check_largest_pressure(const Case<3> &, double, ParameterSection);
template void check_loaded_tube(const Case<2> &, ParameterSection);
template void check_loaded_tube(const Case<3> &, ParameterSection);
} // namespace Continua
