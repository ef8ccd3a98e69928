#include <continua/analysis/harmonic_checks.h>

#include <continua/continuum/field_list.h>

#include <string>

namespace Continua
{
namespace
{
void check_conditions(const Problem &problem, ParameterSection root, const std::string &remedy)
{
  for (const BoundaryCondition &condition : problem.conditions)
  {
    ParameterSection section = root.subsection("Boundaries").subsection(condition.name);
    if (condition.outlet && condition.outlet->coupling == Outlet::Coupling::flow)
      section.refuse("Coupling",
                     "in the frequency domain the distribution of the velocity over an outlet is "
                     "free",
                     "Set Coupling = pressure, or " + remedy);
    if (condition.profile == FlowProfile::Shape::womersley)
      section.refuse("Profile",
                     "a womersley profile is that of a flow in time; the frequency domain has none "
                     "so far",
                     "Use 'flat', 'parabolic' or 'table', leave it out with Coupling = pressure, "
                     "or " +
                         remedy);
  }
}

/// Refuses what is no amplitude: numbers that are not linear in the motion.
template <int dim>
void check_probes(const Case<dim> &input, ParameterSection root, const std::string &remedy)
{
  for (const ProbeColumnName &column :
       input.probes.expected_columns(field_names<dim>(input.problem)))
  {
    ParameterSection probe = root.subsection("Probes").subsection(column.probe);
    if (probe.given("Sign changes"))
      probe.refuse("Sign changes",
                   "a position where a field changes its sign is not linear in the motion, so that "
                   "it has no amplitude",
                   "Remove the entry, or " + remedy);
    if (column.field == "Q criterion" || column.field.find("magnitude") == 0)
      probe.refuse("Fields",
                   "'" + column.field +
                       "' is not linear in the motion, so that it has no amplitude and no phase",
                   "Ask for components, or " + remedy);
  }
}
} // namespace

void check_no_mean_pressure(const Problem &problem,
                            ParameterSection root,
                            const std::string &remedy)
{
  for (const BoundaryCondition &condition : problem.conditions)
    if (condition.absorbing.has_mean_pressure)
      root.subsection("Boundaries")
          .subsection(condition.name)
          .refuse("Mean pressure",
                  "a harmonic analysis has oscillations alone, and this is a state about which "
                  "they go",
                  "Remove the entry, or " + remedy);
}

void check_no_states(const Problem &problem, ParameterSection root, const std::string &remedy)
{
  check_no_mean_pressure(problem, root, remedy);
  for (const BoundaryCondition &condition : problem.conditions)
    if (condition.outlet && !condition.outlet->initial_states.empty())
      root.subsection("Boundaries")
          .subsection(condition.name)
          .refuse("Initial pressure", "a motion that goes on for ever has no initial state",
                  "Remove the entry, or " + remedy);
}

template <int dim>
void check_harmonic_body(const Case<dim> &input, ParameterSection root, const std::string &remedy)
{
  const Problem &problem = input.problem;
  if (input.discretisation.is_cell_wise())
    root.refuse("Discretisation",
                "the frequency domain needs the symmetric matrices of the finite elements, which "
                "the cell-wise path has not",
                "Set Discretisation = taylor hood, or " + remedy);
  if (problem.deformation == Deformation::finite)
    root.refuse("Deformation", "motion in the frequency domain is linear",
                "Set Deformation = small, or " + remedy);
  if (problem.convection.is_on)
    root.refuse("Convection",
                "motion in the frequency domain is linear, and about a liquid at rest: a stream "
                "would make its matrix unsymmetric",
                "Set Convection = none, or " + remedy);
  check_conditions(problem, root, remedy);
  check_probes(input, root, remedy);
  ParameterSection initial_state = root.subsection("Initial state");
  for (const char *key : {"Velocity", "Displacement", "Pressure", "Type"})
    // A run in time of the same file may look for the mean of a periodic state.
    if (initial_state.given(key) &&
        !(key == std::string("Type") && input.analysis.name == "periodic response"))
      initial_state.refuse(key, "a motion that goes on for ever has no initial state",
                           "Remove the entry, or " + remedy);
  ParameterSection linear_solver = root.subsection("Linear solver");
  const LinearSolverParameters &solver = input.discretisation.taylor_hood.linear_solver;
  if (solver.type == LinearSolverType::iterative)
    linear_solver.refuse("Type",
                         "the frequency domain has an indefinite complex matrix, which is "
                         "solved directly",
                         "Use automatic or direct");
  if (linear_solver.given("Factor precision"))
    linear_solver.refuse("Factor precision", "the complex factor has double precision",
                         "Remove it");
  if (solver.direct_solver != DirectSolver::automatic &&
      solver.direct_solver != DirectSolver::mumps)
    linear_solver.refuse("Direct solver", "the complex factor is that of MUMPS",
                         "Use automatic or mumps");
}

template <int dim>
std::unique_ptr<HarmonicSystem<dim>> harmonic_system_of(Run<dim> &run)
{
  std::unique_ptr<HarmonicSystem<dim>> system = run.solver->harmonic_system();
  if (!system)
    throw RunError("the discretisation '" + run.input.general.discretisation +
                   "' has no frequency domain; set Discretisation = taylor hood");
  run.log.detail("Solver: " + system->solver_name());
  return system;
}

template void check_harmonic_body(const Case<2> &, ParameterSection, const std::string &);
template void check_harmonic_body(const Case<3> &, ParameterSection, const std::string &);
template std::unique_ptr<HarmonicSystem<2>> harmonic_system_of(Run<2> &);
template std::unique_ptr<HarmonicSystem<3>> harmonic_system_of(Run<3> &);
} // namespace Continua
