#include <continua/case/case_checks.h>

#include <continua/case/deformation_checks.h>
#include <continua/case/liquid_body_checks.h>
#include <continua/case/tangent_checks.h>
#include <continua/finite_volume/cell_wise_checks.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
/// The axis of an axisymmetric model: there and only there the radial velocity is zero by symmetry.
template <int dim>
void check_axis(const Case<dim> &input, ParameterSection root)
{
  for (const auto &cell : input.triangulation->cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary())
      {
        bool on_axis = true;
        for (const unsigned int v : cell->face(f)->vertex_indices())
          on_axis = on_axis && std::abs(cell->face(f)->vertex(v)[1]) < 1e-10 * cell->diameter();
        for (const BoundaryCondition &condition : input.problem.conditions)
          if (condition.boundary_id == cell->face(f)->boundary_id() &&
              condition.region_ids.count(cell->material_id()) > 0)
          {
            ParameterSection section = root.subsection("Boundaries").subsection(condition.name);
            if (on_axis && (condition.normal.kind != BoundaryPart::Kind::velocity ||
                            !condition.normal.is_zero() || condition.outlet != nullptr))
              section.refuse("Type",
                             "on the axis of an axisymmetric model the radial velocity is zero",
                             "Set Type = axis");
            if (!on_axis && condition.type == BoundaryType::axis)
              section.refuse("Type", "this boundary is not on the axis (y = 0)",
                             "Set Type = roller if that is meant");
          }
      }
}

/// What supports a wall belongs to a solid, and to the finite elements.
template <int dim>
void check_supports(const Case<dim> &input, ParameterSection root)
{
  for (const BoundaryCondition &condition : input.problem.conditions)
  {
    if (condition.type != BoundaryType::support)
      continue;
    ParameterSection section = root.subsection("Boundaries").subsection(condition.name);
    if (!condition.is_supported())
      section.refuse("Type", "the support has no stiffness and no damping",
                     "Give 'Normal stiffness' or another one of the four, or set Type = pressure");
    if (input.analysis.has_fields && input.discretisation.is_cell_wise())
      section.refuse("Type", "the cell-wise path has no supports",
                     "Set Discretisation = taylor hood, or Type = pressure");
    for (const unsigned int region : condition.region_ids)
      if (!input.problem.materials[region].is_solid())
        section.refuse(
            "Type",
            "a support holds a solid, and the region '" + input.problem.regions[region] +
                "' is a liquid",
            "Set Region to that of the wall, and give the liquid a condition of its own");
  }
}

template <int dim>
void check_linear_solver(const Case<dim> &input, ParameterSection root)
{
  const DirectSolver solver = input.discretisation.taylor_hood.linear_solver.direct_solver;
  ParameterSection section = root.subsection("Linear solver");
  const bool incompressible =
      std::any_of(input.problem.materials.begin(), input.problem.materials.end(),
                  [&](const Material &material)
                  {
                    return material.is_incompressible() ||
                           (input.analysis.is_steady() && material.shear.branches.empty());
                  });
  if (solver == DirectSolver::cholmod && incompressible)
    section.refuse("Direct solver",
                   "cholmod does not pivot, which an incompressible material needs",
                   "Use automatic or mumps");
  if ((solver == DirectSolver::cholmod || solver == DirectSolver::umfpack) &&
      Utilities::MPI::n_mpi_processes(input.communicator) > 1)
    section.refuse("Direct solver",
                   word_of(direct_solver_words(), solver) + " works on one rank only",
                   "Use automatic or mumps");
  const TaylorHoodParameters &taylor_hood = input.discretisation.taylor_hood;
  if (taylor_hood.linear_solver.velocity_product == VelocityProduct::matrix_free &&
      taylor_hood.space.velocity_degree != 2)
    section.refuse("Velocity product",
                   "matrix-free products are there for Velocity degree = 2 only",
                   "Use automatic or assembled");
  if (taylor_hood.linear_solver.stiff_block == StiffBlock::polynomial_multigrid &&
      taylor_hood.space.velocity_degree != 2)
    section.refuse("Stiff block", "polynomial multigrid is there for Velocity degree = 2 only",
                   "Use automatic or algebraic multigrid");
  if (section.given("Instruction set") &&
      !taylor_hood.linear_solver.is_matrix_free(taylor_hood.space.velocity_degree))
    section.refuse("Instruction set",
                   "products have a stored matrix, since Velocity degree is not 2", "Remove it");
}

/// The cell-wise path's own entries against the scheme in time.
template <int dim>
void check_cell_wise_scheme(const Case<dim> &input, ParameterSection root)
{
  const CellWiseParameters &parameters = input.discretisation.cell_wise;
  if (input.problem.mesh_moves_between_steps)
  {
    if (input.analysis.motion == Motion::in_time && input.time.scheme == Scheme::crank_nicolson)
      root.subsection("Time").refuse("Scheme",
                                     "crank nicolson balances in the middle of a step, and a "
                                     "cell-wise mesh that moves has its "
                                     "shape at the end",
                                     "Set Scheme = backward differencing or euler implicit");
    if (input.adaptation.changes_mesh())
      root.subsection("Adaptivity")
          .refuse("Indicator",
                  "the places of the vertices of a cell-wise mesh that moves are not carried over "
                  "to another mesh",
                  "Remove the section, or set Discretisation = taylor hood");
    if (root.sets_in_subsection("Exact solution"))
      root.subsection("Exact solution")
          .refuse("", "the error is an integral over the mesh at rest, and the mesh moves",
                  "Remove the section, and compare probes");
  }
  if (input.analysis.motion != Motion::in_time || input.time.scheme != Scheme::crank_nicolson)
    return;
  if (parameters.formulation == Formulation::displacement)
    root.subsection("Time").refuse("Scheme",
                                   "the displacement form has second derivatives by euler implicit "
                                   "or backward differencing only",
                                   "Choose one of them, or another Cell-wise/Formulation");
  if (parameters.has_pressure() && parameters.pressure_update != PressureUpdate::as_displacement)
    root.subsection("Cell-wise")
        .refuse("Pressure update",
                "crank nicolson has its own update of the pressure, which is " +
                    word_of(pressure_update_words(), parameters.pressure_update) + " here",
                "Set Pressure update = as the displacement, or choose another Time/Scheme");
}

/// On a mesh that every rank has whole, deal.II carries a solution over only if every rank has that
/// whole, too, and neither data of cells nor meshes for checkpoints.
template <int dim>
void check_partitioner(const Case<dim> &input, ParameterSection root)
{
  if (!input.mesh.partition.is_metis() || !input.adaptation.changes_mesh())
    return;
  root.subsection("Mesh").refuse(
      "Partitioner",
      "the solution on a mesh that metis divides cannot be carried over to another mesh",
      "Set Partitioner = p4est, or " + std::string(input.analysis.is_steady()
                                                       ? "Adaptivity/Cycles = 0"
                                                       : "Adaptivity/Every n steps = 0"));
}

/// Where the error of a step cannot be estimated.
template <int dim>
void check_time_step_control(const Case<dim> &input, ParameterSection root)
{
  if (!input.time.is_adaptive())
    return;
  ParameterSection section = root.subsection("Time");
  if (input.discretisation.is_cell_wise() &&
      input.discretisation.cell_wise.formulation == Formulation::displacement &&
      input.time.scheme == Scheme::backward_differencing)
    section.refuse("Time step control",
                   "the displacement form's second derivative over four levels needs them at one "
                   "distance",
                   "Set Scheme = euler implicit, another Cell-wise/Formulation, or Time step "
                   "control = fixed");
}

template <int dim>
void refuse_checkpoints(const Case<dim> &input, const ParameterSection &output)
{
  for (const char *key : {"Checkpoint interval", "Checkpoint at end"})
    if (output.given(key) &&
        (input.output.checkpoint_at_end || input.output.checkpoint_interval > 0.))
      output.refuse(key, "a " + input.analysis.name + " analysis has no checkpoints",
                    "Remove the entry");
}

/// Entries that a run without convection does not use.
void refuse_what_convection_uses(const Problem &problem, ParameterSection root)
{
  const std::string remedy = "Remove it, or set Convection = navier stokes";
  for (const char *const name : {"Flow", "Newton"})
    if (root.sets_in_subsection(name) && !(name == std::string("Newton") && problem.is_nonlinear()))
      root.subsection(name).refuse(
          "", "without convection nothing uses the section",
          name == std::string("Newton") ? remedy + ", or Deformation = finite" : remedy);
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    if (problem.materials[region].shear.flow_curve)
      root.subsection("Materials")
          .subsection(problem.regions[region])
          .refuse("Type",
                  "a viscosity that depends on the rate of shear is not linear, and belongs to "
                  "Newton's iteration",
                  "Set Convection = navier stokes, or Type = newtonian");
  for (const std::string &region : problem.regions)
    for (const char *const key : {"Volume exponent", "Reference pressure"})
      if (ParameterSection material = root.subsection("Materials").subsection(region);
          material.given(key))
        material.refuse(key, "without convection the equation of state is linear", remedy);
  for (const BoundaryCondition &condition : problem.conditions)
    if (ParameterSection boundary = root.subsection("Boundaries").subsection(condition.name);
        boundary.given("Inflow pressure"))
      boundary.refuse("Inflow pressure", "without convection both pressures are the same", remedy);
}

/// Entries that convection makes no use of.
template <int dim>
void refuse_what_only_linear_runs_use(const Case<dim> &input, ParameterSection root)
{
  const Problem &problem = input.problem;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    for (const char *const key : {"Volume exponent", "Reference pressure"})
      if (ParameterSection material =
              root.subsection("Materials").subsection(problem.regions[region]);
          problem.materials[region].is_incompressible() && material.given(key))
        material.refuse(key, "an incompressible liquid has no such law",
                        "Remove it, or give a Bulk modulus");
  // A body without an initial pressure starts with 0.
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    if (const Material &material = problem.materials[region];
        !material.is_solid() && problem.interior.initial_pressure.empty() &&
        material.volume_law().stiffening(0.) <= 0.)
      root.subsection("Materials")
          .subsection(problem.regions[region])
          .refuse("Reference pressure",
                  "the bulk modulus K + n (p - p0) is not positive at p = 0, with which the liquid "
                  "starts",
                  "Give the pressure as the body has it at rest, mostly 0, or set Initial "
                  "state/Pressure");
  ParameterSection solver = root.subsection("Linear solver");
  for (const char *const key : {"Refinement steps", "Kept factors"})
    if (solver.given(key))
      solver.refuse(key, "with convection Newton's iteration refines, and keeps one factor",
                    "Remove it, or set Convection = none");
  if (solver.given("Factor precision"))
    solver.refuse("Factor precision",
                  "convection makes the matrix unsymmetric, whose factor has double precision",
                  "Remove it, or set Convection = none");
  for (const BoundaryCondition &condition : problem.conditions)
    if (ParameterSection boundary = root.subsection("Boundaries").subsection(condition.name);
        boundary.given("Inflow pressure") &&
        std::all_of(condition.region_ids.begin(), condition.region_ids.end(),
                    [&](const unsigned int region)
                    { return problem.materials[region].is_solid(); }))
      boundary.refuse("Inflow pressure",
                      "the boundary belongs to a solid, into which nothing flows", "Remove it");
}

/// Explicit convection: one matrix serves all steps, so that nothing else may be nonlinear.
template <int dim>
void check_explicit_convection(const Case<dim> &input, ParameterSection root)
{
  const Problem &problem = input.problem;
  if (!problem.convection.is_explicit() || input.discretisation.is_cell_wise())
    return; // check_cell_wise() refuses it there
  ParameterSection flow = root.subsection("Flow");
  const auto refuse = [&flow](const std::string &reason, const std::string &remedy)
  { flow.refuse("Time treatment", "explicit convection " + reason, remedy); };
  const std::string newton = "set Time treatment = newton";
  if (input.analysis.motion != Motion::in_time)
    refuse("is that of time steps, which a " + input.analysis.name + " analysis does not make",
           "Remove the entry");
  if (problem.has_deformed_regions())
    refuse("keeps one matrix, which a mesh that moves and a solid in finite deformation change",
           "Set Deformation = small, or " + newton);
  if (problem.convection.stabilisation == ConvectionStabilisation::supg)
    refuse("keeps one matrix, which supg changes with the flow",
           "Set Convection stabilisation = grad-div with a Stabilisation viscosity, or " + newton);
  if (problem.convection.stabilisation == ConvectionStabilisation::grad_div &&
      problem.convection.stabilisation_viscosity == 0.)
    refuse("keeps one matrix, which grad-div by the local speed changes with the flow",
           "Set Stabilisation viscosity, such as 0.15 times density, speed and size of the cells, "
           "or Convection stabilisation = none");
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    const Material &material = problem.materials[region];
    if (material.is_solid())
      continue;
    const std::string name = " ('" + problem.regions[region] + "')";
    if (material.shear.flow_curve)
      refuse("keeps one matrix, which a viscosity that depends on the rate of shear changes" + name,
             "Set Type = newtonian, or " + newton);
    if (!material.is_incompressible())
      refuse("is there for incompressible liquids, whose density stays" + name,
             "Set Incompressible = true, or " + newton);
  }
  if (problem.interior.starts_at_rest_under_loads)
    return; // Newton's iteration finds that state.
  ParameterSection of_newton = root.subsection("Newton");
  const bool is_iterative =
      input.discretisation.taylor_hood.linear_solver.type == LinearSolverType::iterative;
  for (const char *const key : {"Slowest rate", "Slow iteration", "Tangent products",
                                "Most Krylov iterations", "Krylov tolerance"})
    if (of_newton.given(key) && !(is_iterative && key == std::string("Krylov tolerance")))
      of_newton.refuse(key, "with Flow/Time treatment = explicit a step is linear",
                       "Remove it, or set Time treatment = newton");
}

/// Where convection has no place, or none so far.
template <int dim>
void check_convection(const Case<dim> &input, ParameterSection root)
{
  const Problem &problem = input.problem;
  ParameterSection steady = root.subsection("Steady");
  if (input.rest.load_steps > 1 && !problem.is_nonlinear())
    steady.refuse("Load steps",
                  "without convection and finite deformation the equations are linear: one solve "
                  "has all loads",
                  "Remove it, or set Convection = navier stokes or Deformation = finite");
  if (input.rest.load_steps > 1 && input.rest.load_steps >= input.rest.maximum_steps)
    steady.refuse("Load steps", "there have to be steps with all loads after the load steps",
                  "Set Maximum steps to more than Load steps");
  ParameterSection materials = root.subsection("Materials");
  if (!problem.convection.is_on)
  {
    refuse_what_convection_uses(problem, root);
    return;
  }
  if (problem.model == Model::plane_stress)
    root.refuse("Convection", "plane stress is for solids, which are not convected",
                "Set Convection = none, or another Model");
  if (input.analysis.is_modal())
    root.refuse("Convection", "vibrations are linear", "Set Convection = none");
  bool has_liquid = false;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    has_liquid = has_liquid || !problem.materials[region].is_solid();
    if (problem.materials[region].type == "maxwell")
      materials.subsection(problem.regions[region])
          .refuse("Type",
                  "a Maxwell liquid counts as a solid, whose motion is small: it would not "
                  "be convected",
                  "Use 'newtonian', or set Convection = none");
  }
  if (!has_liquid)
    root.refuse("Convection", "no region is a fluid, and solids are not convected",
                "Set Convection = none");
  if (input.analysis.motion == Motion::in_time && input.time.update_type() == Update::trapezoidal)
    root.subsection("Time").refuse(
        "Update",
        "convection needs the rate of the pressure at the end of the step, which the "
        "trapezoidal update does not have",
        "Set Update = implicit");
  if (input.discretisation.taylor_hood.linear_solver.direct_solver == DirectSolver::cholmod)
    root.subsection("Linear solver")
        .refuse("Direct solver",
                "cholmod is for symmetric matrices, and convection makes the matrix unsymmetric",
                "Use automatic, umfpack or mumps");
  refuse_what_tangents_leave_idle(input.discretisation.taylor_hood.linear_solver.type, root);
  refuse_what_only_linear_runs_use(input, root);
  check_explicit_convection(input, root);
  if (problem.convection.stabilisation == ConvectionStabilisation::supg)
    for (unsigned int region = 0; region < problem.materials.size(); ++region)
      if (problem.materials[region].shear.flow_curve)
        root.subsection("Flow").refuse(
            "Convection stabilisation",
            "supg needs the residual inside a cell, which it does not have for a viscosity that "
            "follows the rate of shear (region '" +
                problem.regions[region] + "')",
            "Set Convection stabilisation = grad-div, or Type = newtonian");
  for (const BoundaryCondition &condition : problem.conditions)
    if (condition.outlet != nullptr && condition.outlet->coupling == Outlet::Coupling::flow &&
        !input.problem.mesh_moves)
      root.subsection("Boundaries")
          .subsection(condition.name)
          .refuse("Coupling", "an outlet that holds the flow rate does not work with convection",
                  "Set Coupling = pressure, or Convection = none");
}
} // namespace

namespace
{
/// A charge at the start of a search that has none.
template <int dim>
void check_charges(const Case<dim> &input, ParameterSection root)
{
  for (const BoundaryCondition &condition : input.problem.conditions)
    if (ParameterSection section = root.subsection("Boundaries").subsection(condition.name);
        condition.type == BoundaryType::windkessel && section.given("Initial pressure") &&
        input.analysis.is_steady() && !input.problem.finds_unloaded_shape())
      section.refuse("Initial pressure",
                     "a steady flow has no start, and gives the windkessel the charge that it has "
                     "itself",
                     "Remove the entry, or set Analysis = transient");
}
} // namespace

template <int dim>
void check_case(const Case<dim> &input, ParameterSection root)
{
  check_deformation(input, root);
  check_supports(input, root);
  check_charges(input, root);
  input.analysis.check(input, root);
  if (!input.analysis.has_fields)
    return;
  if (!input.analysis.has_checkpoints)
    refuse_checkpoints(input, root.subsection("Output"));
  check_time_step_control(input, root);
  check_partitioner(input, root);
  check_bodies(input, root);
  check_convection(input, root);
  if (input.problem.model == Model::axisymmetric)
    check_axis(input, root);
  if (input.discretisation.is_cell_wise())
  {
    check_cell_wise(input.problem, input.discretisation.cell_wise,
                    input.analysis.motion != Motion::in_time, root);
    check_cell_wise_scheme(input, root);
  }
  else
    check_linear_solver(input, root);
}

template void check_case(const Case<2> &, ParameterSection);
template void check_case(const Case<3> &, ParameterSection);
} // namespace Continua
