#include <continua/analysis/harmonic_checks.h>

#include <continua/continuum/field_list.h>

#include <string>

namespace Continua
{
template <int dim>
void check_harmonic_probes(const Case<dim> &input, ParameterSection root, const std::string &remedy)
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
std::unique_ptr<HarmonicSystem<dim>> harmonic_system_of(Run<dim> &run)
{
  std::unique_ptr<HarmonicSystem<dim>> system = run.solver->harmonic_system();
  if (!system)
    throw RunError("the discretisation '" + run.input.general.discretisation +
                   "' has no frequency domain; set Discretisation = taylor hood");
  run.log.detail("Solver: " + system->solver_name());
  return system;
}

template void check_harmonic_probes(const Case<2> &, ParameterSection, const std::string &);
template void check_harmonic_probes(const Case<3> &, ParameterSection, const std::string &);
template std::unique_ptr<HarmonicSystem<2>> harmonic_system_of(Run<2> &);
template std::unique_ptr<HarmonicSystem<3>> harmonic_system_of(Run<3> &);
} // namespace Continua
