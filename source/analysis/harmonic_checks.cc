#include <continua/analysis/harmonic_checks.h>

#include <continua/analysis/steady_search.h>
#include <continua/continuum/field_list.h>
#include <continua/postprocess/probe_fields.h>

#include <algorithm>
#include <string>

namespace Continua
{
namespace
{
bool is_in_time(const BoundaryCondition &condition)
{
  return condition.normal.depends_on_time() || condition.tangential.depends_on_time() ||
         (condition.free_flow && condition.free_flow->rate.depends_on_time()) ||
         (condition.outlet && condition.outlet->pressure_behind.depends_on_time());
}

/// Of the materials, outlets and steps to a steady state of such a body. Throws InputError.
template <int dim>
void check_loads_of_state(const Case<dim> &input, ParameterSection root, const std::string &remedy)
{
  const Problem &problem = input.problem;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    if (problem.materials[region].has_power_law())
      root.subsection("Materials")
          .subsection(problem.regions[region])
          .refuse("Type",
                  "the stress of this solid relaxes to zero, so that it has no state at rest about "
                  "which the motion could be small",
                  "Use Type = prony with a Young's modulus, set Deformation = small, or " + remedy);
  for (const BoundaryCondition &condition : problem.conditions)
    if (condition.outlet && !condition.outlet->initial_states.empty() &&
        !problem.finds_unloaded_shape())
      root.subsection("Boundaries")
          .subsection(condition.name)
          .refuse("Initial pressure",
                  "the state about which the motion is small lasts, and a charge that drains does "
                  "not",
                  "Remove the entry, and give the 'Pressure behind' the outlet");
  ParameterSection steady = root.subsection("Steady");
  if (steady.given("Time of loads"))
    steady.refuse("Time of loads",
                  "the state about which the motion is small is that under the loads, or under "
                  "their mean, at no time of theirs",
                  "Remove the entry");
}
} // namespace

bool is_linear_in_motion(const std::string &field)
{
  return field != "Q criterion" && field.find("magnitude") != 0 && !is_average(field);
}

template <int dim>
void check_harmonic_probes(const Case<dim> &input,
                           ParameterSection root,
                           const std::string &remedy,
                           const bool has_history)
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
    if (!has_history && !is_linear_in_motion(column.field))
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
void check_loaded_state(const Case<dim> &input, ParameterSection root, const std::string &remedy)
{
  check_loads_of_state(input, root, remedy);
  SteadySearch<dim>::check(input, root, remedy);
  const std::vector<Material> &materials = input.problem.materials;
  for (const BoundaryCondition &condition : input.problem.conditions)
    if (condition.has_unknown_pressure() &&
        std::any_of(condition.region_ids.begin(), condition.region_ids.end(),
                    [&](const unsigned int region) { return materials[region].is_solid(); }))
      root.subsection("Boundaries")
          .subsection(condition.name)
          .refuse("Type",
                  "a motion about a state in finite deformation has no unknown pressure on a solid",
                  "Use 'fixed', 'roller', 'free' or 'pressure' here, or " + remedy);
}

template <int dim>
void check_no_loads_in_time(const Case<dim> &input,
                            ParameterSection root,
                            const std::string &in_time,
                            const std::string &remedy)
{
  const InteriorData &interior = input.problem.interior;
  for (const std::vector<Waveform> *const force : {&interior.body_force, &interior.acceleration})
    for (const Waveform &component : *force)
      if (component.depends_on_time())
        root.subsection("Body force").refuse("", in_time, remedy);
  for (const BoundaryCondition &condition : input.problem.conditions)
    if (is_in_time(condition))
      root.subsection("Boundaries").subsection(condition.name).refuse("", in_time, remedy);
}

template <int dim>
void check_no_loads_of_state_in_time(const Case<dim> &input,
                                     ParameterSection root,
                                     const std::string &remedy)
{
  check_no_loads_in_time(input, root,
                         "the loads are those of the state at rest about which the motion is "
                         "small, and this one depends on t",
                         "Give its value in that state, or " + remedy);
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

template void check_harmonic_probes(const Case<2> &, ParameterSection, const std::string &, bool);
template void check_harmonic_probes(const Case<3> &, ParameterSection, const std::string &, bool);
template void check_loaded_state(const Case<2> &, ParameterSection, const std::string &);
template void check_loaded_state(const Case<3> &, ParameterSection, const std::string &);
template void
check_no_loads_in_time(const Case<2> &, ParameterSection, const std::string &, const std::string &);
template void
check_no_loads_in_time(const Case<3> &, ParameterSection, const std::string &, const std::string &);
template void
check_no_loads_of_state_in_time(const Case<2> &, ParameterSection, const std::string &);
template void
check_no_loads_of_state_in_time(const Case<3> &, ParameterSection, const std::string &);
template std::unique_ptr<HarmonicSystem<2>> harmonic_system_of(Run<2> &);
template std::unique_ptr<HarmonicSystem<3>> harmonic_system_of(Run<3> &);
} // namespace Continua
