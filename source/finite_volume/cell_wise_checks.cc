#include <continua/finite_volume/cell_wise_checks.h>

#include <cmath>
#include <string>
#include <vector>

namespace Continua
{
namespace
{
/// One spring that never relaxes, and nothing else.
bool is_hookean(const Material &material)
{
  return material.shear.branches.size() == 1 &&
         std::isinf(material.shear.branches.front().relaxation_time) &&
         material.shear.viscosity == 0. && material.compression.bulk_branches().empty();
}

void check_materials(const Problem &problem,
                     const CellWiseParameters &parameters,
                     ParameterSection root)
{
  const Formulation formulation = parameters.formulation;
  const bool longitudinal = parameters.stencil_coefficient == StencilCoefficient::longitudinal;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    const Material &material = problem.materials[region];
    ParameterSection section = root.subsection("Materials").subsection(problem.regions[region]);
    if (!parameters.has_pressure() && !is_hookean(material))
      section.refuse("Type",
                     "the displacement and the velocity form have no stress but that of a Hookean "
                     "solid's displacement",
                     "Set Cell-wise/Formulation = velocity-pressure");
    if (formulation != Formulation::velocity_pressure && material.is_incompressible())
      section.refuse(
          "", "the pressure of an incompressible material does not follow from the motion",
          "Set Cell-wise/Formulation = velocity-pressure, or give it a bulk modulus or a "
          "Poisson's ratio below 0.5");
    if (longitudinal && material.is_solid() && material.is_incompressible())
      root.subsection("Cell-wise")
          .refuse("Stencil coefficient",
                  "the incompressible solid '" + problem.regions[region] +
                      "' has no longitudinal modulus",
                  "Set Stencil coefficient = deviatoric");
  }
}
/// Entries that play no part would be ignored without a word.
void check_entries(const CellWiseParameters &parameters,
                   const bool steady,
                   ParameterSection section)
{
  const auto refuse_given = [&](const std::vector<std::string> &keys, const std::string &problem)
  {
    for (const std::string &key : keys)
      if (section.given(key))
        section.refuse(key, problem, "Remove the entry");
  };
  if (!parameters.has_pressure())
    refuse_given({"Rhie-Chow", "Pressure update", "Pressure at boundaries"},
                 "this Formulation has no pressure among its unknowns");
  if (parameters.formulation != Formulation::velocity_pressure)
    refuse_given(
        {"Rhie-Chow", "Rhie-Chow in time", "Pressure corrections", "Pressure at boundaries as"},
        "only the formulation velocity-pressure has an equation for the pressure");
  if (!parameters.is_segregated())
    refuse_given({"Tolerance", "Maximum corrections", "Pressure corrections", "At the cap",
                  "Residual history", "Pressure at boundaries as", "Velocity at boundaries as"},
                 "Solution = coupled has no loop");
  if (steady)
    refuse_given({"Accumulated term", "Pressure update", "Power operator"},
                 "there are no steps in time in which it would play a part");
}
/// What the cell-wise path has of convection.
void check_cell_wise_convection(const Problem &problem,
                                const CellWiseParameters &parameters,
                                ParameterSection root)
{
  ParameterSection section = root.subsection("Cell-wise");
  if (!problem.convection.is_on)
  {
    if (section.given("Convective interpolation"))
      section.refuse("Convective interpolation", "without convection no flux carries anything",
                     "Remove it, or set Convection = navier stokes");
    return;
  }
  if (parameters.formulation != Formulation::velocity_pressure)
    section.refuse("Formulation",
                   "convection needs the fluxes of the equation for the pressure, which only the "
                   "formulation velocity-pressure has",
                   "Set Formulation = velocity-pressure, or Convection = none");
  if (parameters.pressure_update == PressureUpdate::trapezoidal)
    section.refuse("Pressure update",
                   "convection needs the rate of the pressure at the end of the step, which the "
                   "trapezoidal update does not have (Variant = thesis sets it by itself)",
                   "Set Variant = continua, or Pressure update = as the displacement");
  if (parameters.power_operator != PowerOperator::scheme)
    section.refuse("Power operator", "with convection the ledger has the scheme's own forces",
                   "Set Power operator = scheme");
  ParameterSection flow = root.subsection("Flow");
  for (const char *const key :
       {"Convective term", "Convection stabilisation", "Stabilisation viscosity"})
    if (flow.given(key))
      flow.refuse(key,
                  "the fluxes of the cell-wise path satisfy continuity themselves: skew and "
                  "advective are the same there, and a stabilisation has nothing to do",
                  "Remove the entry, or set Discretisation = taylor hood");
  if (problem.convection.is_explicit())
    flow.refuse("Time treatment", "the cell-wise path has Newton's iteration alone",
                "Set Time treatment = newton, or Discretisation = taylor hood");
  if (root.subsection("Steady").given("Load steps"))
    root.subsection("Steady").refuse("Load steps",
                                     "the cell-wise path has all loads from the start",
                                     "Remove the entry, or set Discretisation = taylor hood");
  ParameterSection newton = root.subsection("Newton");
  for (const char *const key :
       {"Slow iteration", "Tangent products", "Krylov tolerance", "Most Krylov iterations"})
    if (newton.given(key))
      newton.refuse(key,
                    "a slow iteration of the cell-wise path always makes a new factor, without "
                    "GMRES",
                    "Remove the entry, or set Discretisation = taylor hood");
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    if (problem.materials[region].shear.flow_curve)
      root.subsection("Materials")
          .subsection(problem.regions[region])
          .refuse("Type", "the cell-wise path has no viscosity that depends on the rate of shear",
                  "Set Type = newtonian, or Discretisation = taylor hood");
}

/// A mesh that moves.
void check_moving_cells(const Problem &problem,
                        const CellWiseParameters &parameters,
                        ParameterSection root)
{
  ParameterSection section = root.subsection("Cell-wise");
  if (problem.mesh_motion != MeshMotionKind::elastic)
    root.refuse("Mesh motion",
                "the vertices of the cell-wise path move with one factor for the whole run",
                "Set Mesh motion = elastic, or Discretisation = taylor hood");
  if (parameters.formulation != Formulation::velocity_pressure)
    section.refuse("Formulation",
                   "a liquid whose mesh moves needs the fluxes of the equation for the pressure",
                   "Set Formulation = velocity-pressure");
  if (parameters.is_segregated())
    section.refuse("Solution",
                   "the segregated loop keeps its matrices for the whole run, and those of a mesh "
                   "that moves change in each step",
                   "Set Solution = coupled");
  if (!problem.convection.is_on)
    root.refuse("Convection",
                "on the cell-wise path what a face sweeps is a part of the convective fluxes",
                "Set Convection = navier stokes, or Discretisation = taylor hood");
  for (const BoundaryCondition &condition : problem.conditions)
  {
    ParameterSection of_boundary = root.subsection("Boundaries").subsection(condition.name);
    // The vertices have no normal.
    const bool is_cartesian =
        (condition.type == BoundaryType::velocity || condition.type == BoundaryType::fixed) &&
        condition.normal.along_normal.is_zero();
    if (condition.liquid_carries_mesh() && !is_cartesian)
      of_boundary.refuse("Mesh", "the vertices of the mesh need a velocity by Cartesian components",
                         "Set Type = velocity with such components, or give a Mesh velocity");
    if (condition.outlet != nullptr)
      of_boundary.refuse("Type",
                         "on the cell-wise path the flow rate of an outlet is the one through the "
                         "section at rest, and the mesh moves",
                         "Prescribe a pressure, or set Discretisation = taylor hood");
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
  check_entries(parameters, steady, section);
  check_cell_wise_convection(problem, parameters, root);
  if (problem.mesh_moves_between_steps)
    check_moving_cells(problem, parameters, root);
  const Formulation formulation = parameters.formulation;
  if (formulation == Formulation::displacement &&
      parameters.accumulated_term == AccumulatedTerm::inconsistent)
    section.refuse("Accumulated term", "the displacement form accumulates no stress",
                   "Remove the entry, or choose another Formulation");
  if (section.given("Rhie-Chow in time"))
  {
    bool some_fluid = false;
    for (const Material &material : problem.materials)
      some_fluid = some_fluid || material.shear.branches.empty();
    if (!some_fluid || parameters.rhie_chow == RhieChow::none || steady)
      section.refuse("Rhie-Chow in time",
                     "there is no correction by the pressure of a fluid that could go on in time",
                     "Remove the entry");
  }
  const bool force_balance = parameters.boundary_pressure == BoundaryPressure::force_balance;
  if (force_balance && formulation == Formulation::velocity_pressure)
    section.refuse("Pressure at boundaries",
                   "the force balance determines the velocity of the face already: it is one "
                   "equation twice, and the pressure of the face stays undetermined",
                   "Choose another");
  if (formulation == Formulation::velocity_explicit_pressure &&
      section.given("Pressure at boundaries") &&
      parameters.boundary_pressure != BoundaryPressure::momentum &&
      parameters.boundary_pressure != BoundaryPressure::zero_gradient)
    section.refuse("Pressure at boundaries",
                   "the formulation velocity explicit pressure extrapolates it",
                   "Choose momentum or zero gradient, or another Formulation");
  if (steady && parameters.is_segregated())
    section.refuse("Solution", "without steps in time there is none for the loop to go through",
                   "Set Solution = coupled");
}
} // namespace Continua
