#include <continua/finite_volume/cell_wise_checks.h>

#include <algorithm>

namespace Continua
{
void check_cell_wise(const Problem &problem,
                     const CellWiseParameters &parameters,
                     const bool steady,
                     ParameterSection root)
{
  ParameterSection section = root.subsection("Cell-wise");
  for (const BoundaryCondition &condition : problem.conditions)
  {
    // The vertices have no normal.
    const bool is_cartesian =
        (condition.type == BoundaryType::velocity || condition.type == BoundaryType::fixed) &&
        condition.normal.along_normal.is_zero();
    if (problem.mesh_moves_between_steps && condition.liquid_carries_mesh() && !is_cartesian)
      root.subsection("Boundaries")
          .subsection(condition.name)
          .refuse("Mesh", "the vertices of the mesh need a velocity by Cartesian components",
                  "Set Type = velocity with such components, or give a Mesh velocity");
  }
  const bool has_fluid =
      std::any_of(problem.materials.begin(), problem.materials.end(),
                  [](const Material &material) { return material.shear.branches.empty(); });
  if (section.given("Rhie-Chow in time") &&
      (!has_fluid || parameters.rhie_chow == RhieChow::none || steady))
    section.refuse("Rhie-Chow in time",
                   "there is no correction by the pressure of a fluid that could go on in time",
                   "Remove the entry");
  if (parameters.formulation == Formulation::velocity_explicit_pressure &&
      section.given("Pressure at boundaries") &&
      parameters.boundary_pressure != BoundaryPressure::momentum &&
      parameters.boundary_pressure != BoundaryPressure::zero_gradient)
    section.refuse("Pressure at boundaries",
                   "the formulation velocity explicit pressure extrapolates it",
                   "Choose momentum or zero gradient, or another Formulation");
}
} // namespace Continua
