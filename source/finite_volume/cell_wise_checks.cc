#include <continua/finite_volume/cell_wise_checks.h>

#include <cmath>

namespace Continua
{
namespace
{
/// One spring that never relaxes, and nothing else.
bool is_hookean(const Material &material)
{
  return material.branches.size() == 1 && std::isinf(material.branches.front().relaxation_time) &&
         material.viscosity == 0. && material.bulk_branches.empty();
}

void check_materials(const Problem &problem,
                     const CellWiseParameters &parameters,
                     ParameterSection root)
{
  const Formulation formulation = parameters.formulation_type();
  const bool longitudinal = parameters.stencil_coefficient == "longitudinal";
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    const Material &material = problem.materials[region];
    ParameterSection section = root.subsection("Materials").subsection(problem.regions[region]);
    if (!parameters.has_pressure() && !is_hookean(material))
      section.refuse("Type",
                     "the displacement and the velocity form have no stress but that of a Hookean "
                     "solid's displacement",
                     "Set Cell-wise/Formulation = velocity-pressure");
    if (formulation != Formulation::velocity_pressure && material.inverse_bulk_modulus == 0.)
      section.refuse(
          "", "the pressure of an incompressible material does not follow from the motion",
          "Set Cell-wise/Formulation = velocity-pressure, or give it a bulk modulus or a "
          "Poisson's ratio below 0.5");
    if (longitudinal && material.is_solid() && material.inverse_bulk_modulus == 0.)
      root.subsection("Cell-wise")
          .refuse("Stencil coefficient",
                  "the incompressible solid '" + problem.regions[region] +
                      "' has no longitudinal modulus",
                  "Set Stencil coefficient = deviatoric");
  }
}
} // namespace

void check_cell_wise(const Problem &problem,
                     const CellWiseParameters &parameters,
                     const bool steady,
                     ParameterSection root)
{
  ParameterSection section = root.subsection("Cell-wise");
  check_materials(problem, parameters, root);
  for (const BoundaryCondition &condition : problem.conditions)
    if (condition.outlet)
      root.subsection("Boundaries")
          .subsection(condition.name)
          .refuse("Type", "the cell-wise path has no outlets",
                  "Give the boundary a pressure, or set Discretisation = taylor hood");

  const Formulation formulation = parameters.formulation_type();
  if (formulation == Formulation::displacement && parameters.accumulated_term == "inconsistent")
    section.refuse("Accumulated term", "the displacement form accumulates no stress",
                   "Remove the entry, or choose another Formulation");
  if (formulation == Formulation::velocity_pressure && !parameters.is_segregated() &&
      parameters.boundary_pressure_type() == BoundaryPressure::force_balance)
    section.refuse("Pressure at boundaries",
                   "the force balance determines the velocity of the face already, so that the "
                   "coupled equations are singular",
                   "Choose another, or set Solution = segregated");
  if (steady && parameters.is_segregated())
    section.refuse("Solution", "a state at rest has no time step for the loop to go through",
                   "Set Solution = coupled");
}
} // namespace Continua
