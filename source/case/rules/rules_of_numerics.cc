#include <continua/case/rules/rule_rows.h>

namespace Continua
{
namespace
{
using FeatureNames = std::vector<std::string>;
} // namespace

std::vector<Rule> rules_of_cells()
{
  const FeatureNames without_pressure = {"displacement form", "velocity form"};
  const FeatureNames without_equation_of_pressure = {"displacement form", "velocity form",
                                                     "explicit pressure form"};
  return {
      {{"network at an end"},
       {"cell-wise"},
       "the cell-wise path has no network at an end",
       "Set Discretisation = taylor hood, or Type = windkessel"},
      {{"support"},
       {"cell-wise"},
       "the cell-wise path has no supports",
       "Set Discretisation = taylor hood, or Type = pressure"},
      {{"set Output/Further fields"},
       {"cell-wise"},
       "the cell-wise path has none of these fields",
       "Leave the entry out, or set Discretisation = taylor hood"},
      {{"material that is no Hookean solid"},
       without_pressure,
       "the displacement and the velocity form have no stress but that of a Hookean solid's "
       "displacement",
       "Set Cell-wise/Formulation = velocity-pressure"},
      {{"incompressible material"},
       without_equation_of_pressure,
       "the pressure of an incompressible material does not follow from the motion",
       "Set Cell-wise/Formulation = velocity-pressure, or give it a bulk modulus or a Poisson's "
       "ratio below 0.5"},
      {{"longitudinal stencil"},
       {"incompressible solid"},
       "an incompressible solid has no longitudinal modulus",
       "Set Stencil coefficient = deviatoric"},
      {{"set Cell-wise/Rhie-Chow", "set Cell-wise/Pressure update",
        "set Cell-wise/Pressure at boundaries"},
       without_pressure,
       "this Formulation has no pressure among its unknowns",
       "Remove the entry"},
      {{"set Cell-wise/Rhie-Chow", "set Cell-wise/Rhie-Chow in time",
        "set Cell-wise/Pressure corrections", "set Cell-wise/Pressure at boundaries as"},
       without_equation_of_pressure,
       "only the formulation velocity-pressure has an equation for the pressure",
       "Remove the entry"},
      {{"set Cell-wise/Tolerance", "set Cell-wise/Maximum corrections",
        "set Cell-wise/Pressure corrections", "set Cell-wise/At the cap",
        "set Cell-wise/Residual history", "set Cell-wise/Pressure at boundaries as",
        "set Cell-wise/Velocity at boundaries as"},
       {"coupled solve"},
       "Solution = coupled has no loop",
       "Remove the entry"},
      {{"set Cell-wise/Accumulated term", "set Cell-wise/Pressure update",
        "set Cell-wise/Power operator"},
       {"steady", "modal"},
       "there are no steps in time in which it would play a part",
       "Remove the entry"},
      {{"set Cell-wise/Convective interpolation"},
       {"no convection"},
       "without convection no flux carries anything",
       "Remove it, or set Convection = navier stokes"},
      {without_equation_of_pressure,
       {"convection"},
       "convection needs the fluxes of the equation for the pressure, which only the formulation "
       "velocity-pressure has",
       "Set Formulation = velocity-pressure, or Convection = none"},
      {{"trapezoidal pressure"},
       {"convection"},
       "convection needs the rate of the pressure at the end of the step, which the trapezoidal "
       "update does not have (Variant = thesis sets it by itself)",
       "Set Variant = continua, or Pressure update = as the displacement"},
      {{"power by the thesis's operators"},
       {"convection"},
       "with convection the ledger has the scheme's own forces",
       "Set Power operator = scheme"},
      {{"set Flow/Convective term", "set Flow/Convection stabilisation",
        "set Flow/Stabilisation viscosity"},
       {"cell-wise"},
       "the fluxes of the cell-wise path satisfy continuity themselves: skew and advective are the "
       "same there, and a stabilisation has nothing to do",
       "Remove the entry, or set Discretisation = taylor hood"},
      {{"set Steady/Load steps"},
       {"cell-wise"},
       "the cell-wise path has all loads from the start",
       "Remove the entry, or set Discretisation = taylor hood"},
      {{"set Newton/Slow iteration", "set Newton/Tangent products", "set Newton/Krylov tolerance",
        "set Newton/Most Krylov iterations"},
       {"cell-wise"},
       "a slow iteration of the cell-wise path always makes a new factor, without GMRES",
       "Remove the entry, or set Discretisation = taylor hood"},
      {{"flow curve"},
       {"cell-wise"},
       "the cell-wise path has no viscosity that depends on the rate of shear",
       "Set Type = newtonian, or Discretisation = taylor hood"},
      {{"inconsistent accumulated term"},
       {"displacement form"},
       "the displacement form accumulates no stress",
       "Remove the entry, or choose another Formulation"},
      {{"force balance of boundaries"},
       {"velocity-pressure form"},
       "the force balance determines the velocity of the face already: it is one equation twice, "
       "and the pressure of the face stays undetermined",
       "Choose another"},
      {{"force balance of boundaries"},
       {"explicit pressure form"},
       "the formulation velocity explicit pressure extrapolates it",
       "Choose momentum or zero gradient, or another Formulation"},
      {{"segregated loop"},
       {"steady", "modal"},
       "without steps in time there is none for the loop to go through",
       "Set Solution = coupled"},
      {{"crank nicolson"},
       {"displacement form"},
       "the displacement form has second derivatives by euler implicit or backward differencing "
       "only",
       "Choose one of them, or another Cell-wise/Formulation"},
      {{"pressure unlike the displacement"},
       {"crank nicolson"},
       "crank nicolson has its own update of the pressure, which this entry is not",
       "Set Pressure update = as the displacement, or choose another Time/Scheme"},
      {{"adaptive steps"},
       {"displacement form by backward differencing"},
       "the displacement form's second derivative over four levels needs them at one distance",
       "Set Scheme = euler implicit, another Cell-wise/Formulation, or Time step control = fixed"}};
}

/// A cell-wise mesh whose vertices move before each step.
std::vector<Rule> rules_of_moving_cells()
{
  const std::string or_taylor_hood = ", or Discretisation = taylor hood";
  return {
      {{"hyperelastic motion of the mesh"},
       {"cell-wise mesh that moves"},
       "the vertices of the cell-wise path move with one factor for the whole run",
       "Set Mesh motion = elastic" + or_taylor_hood},
      {{"displacement form", "velocity form", "explicit pressure form"},
       {"cell-wise mesh that moves"},
       "a liquid whose mesh moves needs the fluxes of the equation for the pressure",
       "Set Formulation = velocity-pressure"},
      {{"segregated loop"},
       {"cell-wise mesh that moves"},
       "the segregated loop keeps its matrices for the whole run, and those of a mesh that moves "
       "change in each step",
       "Set Solution = coupled"},
      {{"no convection"},
       {"cell-wise mesh that moves"},
       "on the cell-wise path what a face sweeps is a part of the convective fluxes",
       "Set Convection = navier stokes" + or_taylor_hood},
      {{"outlet"},
       {"cell-wise mesh that moves"},
       "on the cell-wise path the flow rate of an outlet is the one through the undeformed "
       "section, and the mesh moves",
       "Prescribe a pressure, or set Discretisation = taylor hood"},
      {{"crank nicolson"},
       {"cell-wise mesh that moves"},
       "crank nicolson balances in the middle of a step, and a cell-wise mesh that moves has its "
       "shape at the end",
       "Set Scheme = backward differencing or euler implicit"},
      {{"adaptive mesh"},
       {"cell-wise mesh that moves"},
       "the places of the vertices of a cell-wise mesh that moves are not carried over to another "
       "mesh",
       "Remove the section, or set Discretisation = taylor hood"}};
}

std::vector<Rule> rules_of_solvers()
{
  const FeatureNames nonlinear = {"convection", "finite deformation"};
  return {
      {{"metis"},
       {"adaptive mesh"},
       "the solution on a mesh that metis divides cannot be carried over to another mesh",
       "Set Partitioner = p4est, or Adaptivity/Every n steps = 0, and Cycles = 0 in a steady "
       "analysis"},
      {{"cholmod"},
       nonlinear,
       "cholmod is for symmetric matrices, and convection and finite deformation make the matrix "
       "unsymmetric",
       "Use automatic, umfpack or mumps"},
      {{"set Linear solver/Tolerance"},
       nonlinear,
       "with convection or finite deformation the iterative solver finds corrections of Newton's "
       "iteration, which end at Newton/Krylov tolerance",
       "Remove it"},
      {{"set Newton/Slow iteration", "set Newton/Tangent products",
        "set Newton/Most Krylov iterations"},
       {"iterative solver"},
       "Linear solver/Type = iterative makes no use of it: each iteration has the tangent of its "
       "own state",
       "Remove it, or set Linear solver/Type = direct"},
      {{"set Linear solver/Refinement steps", "set Linear solver/Kept factors"},
       nonlinear,
       "with convection or finite deformation Newton's iteration refines, and keeps one factor",
       "Remove it, or set Convection = none and Deformation = small"},
      {{"set Linear solver/Factor precision"},
       nonlinear,
       "convection and finite deformation make the matrix unsymmetric, whose factor has double "
       "precision",
       "Remove it, or set Convection = none and Deformation = small"},
      {{"cholmod"},
       {"incompressible material", "liquid of a steady flow"},
       "cholmod does not pivot, which an incompressible material needs",
       "Use automatic or mumps"},
      // The readers of the sections Linear solver and Time refuse these with the same sentence.
      {{"cholmod", "umfpack"},
       {"iterative solver"},
       "Type = iterative makes no use of it",
       "Remove it, or set Type = direct or automatic"},
      {{"trapezoidal update"},
       {"crank nicolson"},
       "crank nicolson has its own update of displacement and pressure",
       "Remove the entry, or choose another scheme"},
      {{"cholmod", "umfpack"},
       {"several ranks"},
       "this solver works on one rank only",
       "Use automatic or mumps"},
      {{"matrix-free products"},
       {"velocity degree other than 2"},
       "matrix-free products are there for Velocity degree = 2 only",
       "Use automatic or assembled"},
      {{"polynomial multigrid"},
       {"velocity degree other than 2"},
       "polynomial multigrid is there for Velocity degree = 2 only",
       "Use automatic or algebraic multigrid"}};
}
} // namespace Continua
