#include <continua/case/rules/rule_rows.h>

namespace Continua
{
std::vector<Rule> rules_of_convection()
{
  const std::string or_convection = "Remove it, or set Convection = navier stokes";
  return {
      {{"load steps"},
       {"linear equations"},
       "without convection and finite deformation the equations are linear: one solve has all "
       "loads",
       "Remove it, or set Convection = navier stokes or Deformation = finite"},
      {{"subsection Flow"},
       {"no convection"},
       "without convection nothing uses the section",
       or_convection},
      {{"subsection Newton"},
       {"linear equations"},
       "without convection nothing uses the section",
       or_convection + ", or Deformation = finite"},
      {{"flow curve"},
       {"no convection"},
       "a viscosity that depends on the rate of shear is not linear, and belongs to Newton's "
       "iteration",
       "Set Convection = navier stokes, or Type = newtonian"},
      {{"set Materials/<region>/Volume exponent", "set Materials/<region>/Reference pressure"},
       {"no convection"},
       "without convection the equation of state is linear",
       or_convection},
      {{"set Boundaries/<name>/Inflow pressure"},
       {"no convection"},
       "without convection both pressures are the same",
       or_convection},
      {{"convection"},
       {"plane stress"},
       "plane stress is for solids, which are not convected",
       "Set Convection = none, or another Model"},
      {{"convection"}, {"modal"}, "vibrations are linear", "Set Convection = none"},
      {{"maxwell liquid"},
       {"convection"},
       "a Maxwell liquid counts as a solid, whose motion is small: it would not be convected",
       "Use 'newtonian', or set Convection = none"},
      {{"convection"},
       {"no liquid"},
       "no region is a fluid, and solids are not convected",
       "Set Convection = none"},
      {{"trapezoidal update"},
       {"convection"},
       "convection needs the rate of the pressure at the end of the step, which the trapezoidal "
       "update does not have",
       "Set Update = implicit"},
      {{"outlet that holds the flow rate"},
       {"convection on a mesh that stays"},
       "an outlet that holds the flow rate does not work with convection",
       "Set Coupling = pressure, or Convection = none"},
      {{"supg"},
       {"flow curve"},
       "supg needs the residual inside a cell, which it does not have for a viscosity that follows "
       "the rate of shear",
       "Set Convection stabilisation = grad-div, or Type = newtonian"}};
}

std::vector<Rule> rules_of_explicit_convection()
{
  const std::string newton = "set Time treatment = newton";
  return {
      {{"explicit convection"},
       {"cell-wise"},
       "the cell-wise path has Newton's iteration alone",
       "Set Time treatment = newton, or Discretisation = taylor hood"},
      {{"explicit convection"},
       {"steady"},
       "explicit convection is that of time steps, which this analysis does not make",
       "Remove the entry"},
      {{"explicit convection"},
       {"finite deformation of a solid", "mesh that moves"},
       "explicit convection keeps one matrix, which a mesh that moves and a solid in finite "
       "deformation change",
       "Set Deformation = small, or " + newton},
      {{"explicit convection"},
       {"supg"},
       "explicit convection keeps one matrix, which supg changes with the flow",
       "Set Convection stabilisation = grad-div with a Stabilisation viscosity, or " + newton},
      {{"explicit convection"},
       {"grad-div by the local speed"},
       "explicit convection keeps one matrix, which grad-div by the local speed changes with the "
       "flow",
       "Set Stabilisation viscosity, such as 0.15 times density, speed and size of the cells, or "
       "Convection stabilisation = none"},
      {{"explicit convection"},
       {"flow curve"},
       "explicit convection keeps one matrix, which a viscosity that depends on the rate of shear "
       "changes",
       "Set Type = newtonian, or " + newton},
      {{"explicit convection"},
       {"compressible liquid"},
       "explicit convection is there for incompressible liquids, whose density stays",
       "Set Incompressible = true, or " + newton},
      {{"set Newton/Slowest rate", "set Newton/Slow iteration", "set Newton/Tangent products",
        "set Newton/Most Krylov iterations"},
       {"explicit convection in all steps"},
       "with Flow/Time treatment = explicit a step is linear",
       "Remove it, or " + newton},
      {{"set Newton/Krylov tolerance"},
       {"explicit convection with a factor"},
       "with Flow/Time treatment = explicit a step is linear",
       "Remove it, or " + newton}};
}
} // namespace Continua
