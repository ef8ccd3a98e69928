#include <continua/case/loaded_tube_case.h>

#include <continua/case/tube_wave_case.h>
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
                     "a power law has no modulus at rest, on which a strain law could be based",
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
  try
  {
    return (input.problem.finds_unloaded_shape() ? LoadedTube::of_image(of_mesh, pressure)
                                                 : LoadedTube(of_mesh))
        .section_about(pressure, WallTheory::thick);
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
template void check_loaded_tube(const Case<2> &, ParameterSection);
template void check_loaded_tube(const Case<3> &, ParameterSection);
} // namespace Continua
