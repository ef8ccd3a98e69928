#include <continua/case/case_checks.h>

#include <continua/analysis/linear_wave_theory.h>
#include <continua/finite_volume/cell_wise_checks.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
template <int dim>
bool is_steady(const Case<dim> &input)
{
  return input.general.analysis == "steady";
}

/// An enclosed incompressible body has a pressure up to a constant only.
template <int dim>
void check_pressure_level(const Case<dim> &input, ParameterSection root)
{
  const bool incompressible =
      std::all_of(input.problem.materials.begin(), input.problem.materials.end(),
                  [&](const Material &material) {
                    return material.inverse_bulk_modulus == 0. ||
                           (is_steady(input) && material.branches.empty());
                  });
  const bool enclosed =
      std::all_of(input.problem.conditions.begin(), input.problem.conditions.end(),
                  [](const BoundaryCondition &condition)
                  { return condition.normal.kind == BoundaryPart::Kind::velocity; });
  if (incompressible && enclosed)
    root.subsection("Boundaries")
        .refuse(
            "",
            "the body is incompressible and the normal velocity is prescribed on all of its "
            "boundary, so that the pressure is determined up to a constant only",
            "Give one boundary a pressure, a traction or 'free', an outlet 'Coupling = pressure', "
            "or the material a bulk modulus");
}

template <int dim>
void refuse_checkpoints(const Case<dim> &input, ParameterSection output)
{
  for (const char *key : {"Checkpoint interval", "Checkpoint at end"})
    if (output.given(key) &&
        (input.output.checkpoint_at_end || input.output.checkpoint_interval > 0.))
      output.refuse(key, "a " + input.general.analysis + " analysis has no checkpoints",
                    "Remove the entry");
}

/// Whether a boundary has a prescribed velocity.
template <int dim>
bool is_held(const Case<dim> &input)
{
  return std::any_of(input.problem.conditions.begin(), input.problem.conditions.end(),
                     [](const BoundaryCondition &condition)
                     {
                       return condition.normal.kind == BoundaryPart::Kind::velocity ||
                              condition.tangential.kind == BoundaryPart::Kind::velocity;
                     });
}

/// Free vibrations are those of elastic solids that give no energy away.
template <int dim>
void check_modal(const Case<dim> &input, ParameterSection root)
{
  for (unsigned int region = 0; region < input.problem.materials.size(); ++region)
  {
    const Material &material = input.problem.materials[region];
    ParameterSection section =
        root.subsection("Materials").subsection(input.problem.regions[region]);
    if (!material.is_solid())
      section.refuse("Type", "a modal analysis is of solids, which a fluid is not",
                     "Use Analysis = transient");
    if (material.relaxes() || material.power_law_modulus > 0.)
      section.refuse("Type",
                     "this solid relaxes, so that its stiffness depends on the frequency and its "
                     "vibrations die away",
                     "Use hookean with the modulus at the frequency in question, or Analysis = "
                     "transient");
  }
  ParameterSection boundaries = root.subsection("Boundaries");
  for (const BoundaryCondition &condition : input.problem.conditions)
    if (condition.type == "absorbing")
      boundaries.subsection(condition.name)
          .refuse("Type", "an end that takes waves up has no vibrations that last",
                  "Use 'free', 'roller' or 'fixed', or Analysis = transient");
  ParameterSection modal = root.subsection("Modal");
  if (input.modal.highest() && !input.discretisation.is_cell_wise())
    modal.refuse("Which",
                 "the highest modes of the finite elements are not sought: with an incompressible "
                 "material they have no bound",
                 "Set Discretisation = cell-wise, or Which = lowest");
  if (!input.modal.highest() && input.modal.shift == 0. && !is_held(input))
    boundaries.refuse("",
                      "nothing holds the body, so that it can move without vibrating: the "
                      "frequency 0 Hz is a mode's",
                      "Make a boundary 'fixed' or 'roller', or give Modal/Shift a frequency, such "
                      "as half of the first mode's");
  ParameterSection linear_solver = root.subsection("Linear solver");
  if (!input.discretisation.is_cell_wise() &&
      input.discretisation.taylor_hood.linear_solver.type == "iterative")
    linear_solver.refuse("Type", "vibrations have an indefinite matrix, which is solved directly",
                         "Use automatic or direct");
  if (input.modal.shift > 0. &&
      input.discretisation.taylor_hood.linear_solver.direct_solver == "cholmod")
    linear_solver.refuse("Direct solver", "cholmod does not pivot, which a shift needs",
                         "Use automatic or mumps");
  refuse_checkpoints(input, root.subsection("Output"));
}

/// A state at rest needs something that holds the body, and has no use for what moves it.
template <int dim>
void check_steady(const Case<dim> &input, ParameterSection root)
{
  const std::vector<Material> &materials = input.problem.materials;
  const bool has_solid =
      std::any_of(materials.begin(), materials.end(),
                  [](const Material &material) { return !material.branches.empty(); });
  for (unsigned int region = 0; region < materials.size(); ++region)
    if (!materials[region].branches.empty() &&
        (materials[region].long_term_shear_modulus() == 0. ||
         std::isinf(materials[region].long_term_inverse_bulk_modulus())))
      root.subsection("Materials")
          .subsection(input.problem.regions[region])
          .refuse("Type",
                  "the stress of this solid relaxes to zero, so that it has no state at rest",
                  "Use a law with a long-term modulus, or Analysis = transient");
  for (const BoundaryCondition &condition : input.problem.conditions)
    for (const BoundaryPart *part : {&condition.normal, &condition.tangential})
      if (part->kind == BoundaryPart::Kind::velocity)
      {
        const bool touches_solid = std::any_of(
            condition.region_ids.begin(), condition.region_ids.end(),
            [&](const unsigned int region) { return !materials[region].branches.empty(); });
        if (touches_solid && !part->is_zero())
          root.subsection("Boundaries")
              .subsection(condition.name)
              .refuse("", "a solid at rest cannot have a prescribed velocity",
                      "Prescribe zero, or use Analysis = transient");
      }
  if (!is_held(input))
    root.subsection("Boundaries")
        .refuse("", "nothing holds the body: no boundary has a prescribed velocity",
                "Make one boundary 'fixed' or 'roller'");
  ParameterSection initial_state = root.subsection("Initial state");
  for (const char *key : {"Velocity", "Displacement", "Pressure"})
    if (has_solid && initial_state.given(key))
      initial_state.refuse(key, "a steady analysis has no initial state",
                           "Remove the entry, or use Analysis = transient");
  refuse_checkpoints(input, root.subsection("Output"));
}

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
            if (!on_axis && condition.type == "axis")
              section.refuse("Type", "this boundary is not on the axis (y = 0)",
                             "Set Type = roller if that is meant");
          }
      }
}

template <int dim>
void check_linear_solver(const Case<dim> &input, ParameterSection root)
{
  const std::string &type = input.discretisation.taylor_hood.linear_solver.direct_solver;
  ParameterSection section = root.subsection("Linear solver");
  const bool incompressible =
      std::any_of(input.problem.materials.begin(), input.problem.materials.end(),
                  [&](const Material &material) {
                    return material.inverse_bulk_modulus == 0. ||
                           (is_steady(input) && material.branches.empty());
                  });
  if (type == "cholmod" && incompressible)
    section.refuse("Direct solver",
                   "cholmod does not pivot, which an incompressible material needs",
                   "Use automatic or mumps");
  if ((type == "cholmod" || type == "umfpack") &&
      Utilities::MPI::n_mpi_processes(input.communicator) > 1)
    section.refuse("Direct solver", type + " works on one rank only", "Use automatic or mumps");
}
/// The cell-wise path's own entries against the scheme in time.
template <int dim>
void check_cell_wise_scheme(const Case<dim> &input, ParameterSection root)
{
  const CellWiseParameters &parameters = input.discretisation.cell_wise;
  if (is_steady(input) || input.general.analysis == "modal" ||
      input.time.scheme_type() != Scheme::crank_nicolson)
    return;
  if (parameters.formulation_type() == Formulation::displacement)
    root.subsection("Time").refuse("Scheme",
                                   "the displacement form has second derivatives by euler implicit "
                                   "or backward differencing only",
                                   "Choose one of them, or another Cell-wise/Formulation");
  if (parameters.has_pressure() && parameters.pressure_update != "as the displacement")
    root.subsection("Cell-wise")
        .refuse("Pressure update",
                "crank nicolson has its own update of the pressure, which is " +
                    parameters.pressure_update + " here",
                "Set Pressure update = as the displacement, or choose another Time/Scheme");
}
} // namespace

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
      "Set Partitioner = p4est, or " +
          std::string(is_steady(input) ? "Adaptivity/Cycles = 0" : "Adaptivity/Every n steps = 0"));
}

/// A power law relaxes for ever.
template <int dim>
void check_power_laws(const Case<dim> &input, ParameterSection root)
{
  for (unsigned int region = 0; region < input.problem.materials.size(); ++region)
    if (is_steady(input) && input.problem.materials[region].power_law_modulus > 0.)
      root.subsection("Materials")
          .subsection(input.problem.regions[region])
          .refuse("Type",
                  "the stress of a power law relaxes to zero, so that it has no state at rest",
                  "Use a law with a long-term modulus, or Analysis = transient");
}

/// Where the error of a step cannot be estimated, or there are no steps.
template <int dim>
void check_time_step_control(const Case<dim> &input, ParameterSection root)
{
  if (!input.time.is_adaptive())
    return;
  ParameterSection section = root.subsection("Time");
  if (input.general.analysis == "linear wave theory")
    section.refuse("Time step control", "linear wave theory makes no steps in time",
                   "Remove the entry: Time step is the interval of the theory's table");
  if (input.discretisation.is_cell_wise() &&
      input.discretisation.cell_wise.formulation_type() == Formulation::displacement &&
      input.time.scheme_type() == Scheme::backward_differencing)
    section.refuse("Time step control",
                   "the displacement form's second derivative over four levels needs them at one "
                   "distance",
                   "Set Scheme = euler implicit, another Cell-wise/Formulation, or Time step "
                   "control = fixed");
}

template <int dim>
void check_case(const Case<dim> &input, ParameterSection root)
{
  LinearWaveTheory<dim>::check(input, root);
  check_time_step_control(input, root);
  // Wave theory has no fields.
  if (input.general.analysis == "linear wave theory")
    return;
  check_power_laws(input, root);
  check_partitioner(input, root);
  check_pressure_level(input, root);
  if (is_steady(input))
    check_steady(input, root);
  if (input.general.analysis == "modal")
    check_modal(input, root);
  if (input.problem.model == Model::axisymmetric)
    check_axis(input, root);
  if (input.discretisation.is_cell_wise())
  {
    check_cell_wise(input.problem, input.discretisation.cell_wise,
                    is_steady(input) || input.general.analysis == "modal", root);
    check_cell_wise_scheme(input, root);
  }
  else
    check_linear_solver(input, root);
}

template void check_case(const Case<2> &, ParameterSection);
template void check_case(const Case<3> &, ParameterSection);
} // namespace Continua
