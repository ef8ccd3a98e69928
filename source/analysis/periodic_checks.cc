#include <continua/analysis/periodic_checks.h>

#include <continua/analysis/free_motions.h>
#include <continua/analysis/harmonic_checks.h>
#include <continua/analysis/mean_of_loads.h>
#include <continua/continuum/field_list.h>

#include <algorithm>
#include <string>

namespace Continua
{
namespace
{
/// Some probe whose history decides how many harmonics there are must have harmonics. Throws
/// InputError.
template <int dim>
void check_compared_columns(const Case<dim> &input, ParameterSection root)
{
  bool is_any_meant = false;
  for (const ProbeColumnName &column :
       input.probes.expected_columns(field_names<dim>(input.problem)))
    for (const std::string &text : input.periodic_state.probes)
      if (column.is_meant_by(text))
      {
        if (is_linear_in_motion(column.field))
          return;
        is_any_meant = true;
      }
  // A name that no probe has is refused by check_compared_probes().
  if (!is_any_meant)
    return;
  root.subsection("Periodic state")
      .refuse("Probes",
              "none of these fields is linear in the motion, so that they do not tell how many "
              "harmonics it takes",
              std::string("Give a pressure, a flow rate or a component as well, or ") +
                  remedy_of_harmonic);
}

/// Body forces about a state that change with the shape and in time. Throws InputError.
template <int dim>
void check_following_forces(const Case<dim> &input, ParameterSection root)
{
  const Problem &problem = input.problem;
  const bool has_liquid =
      std::any_of(problem.materials.begin(), problem.materials.end(),
                  [](const Material &material) { return !material.is_solid(); });
  // Where one component depends on the place, all of them are forces of the present place.
  bool is_in_time = false, is_of_place = false;
  for (const std::vector<Waveform> *const force :
       {&problem.interior.body_force, &problem.interior.acceleration})
    for (const Waveform &component : *force)
    {
      is_in_time = is_in_time || component.depends_on_time();
      is_of_place = is_of_place || component.depends_on_space();
    }
  if (is_in_time && (has_liquid || is_of_place))
    root.subsection("Body force")
        .refuse("",
                "about a state in finite deformation a body force in time is possible in "
                "solids alone, and the same at all places",
                std::string("Give its mean, or ") + remedy_of_harmonic);
}
} // namespace

template <int dim>
void check_periodic_response(const Case<dim> &input, ParameterSection root)
{
  check_harmonic_probes(input, root, remedy_of_harmonic, true);
  check_compared_columns(input, root);
  if (input.problem.is_nonlinear())
  {
    check_loaded_state(input, root, remedy_of_harmonic);
    check_following_forces(input, root);
    return;
  }
  check_no_mean_pressure(input.problem, root, remedy_of_harmonic);
  if (!loads_have_mean(input.problem, input.periodic_state))
    return;
  refuse_free_motions(input, root,
                      ", so that the mean of the loads moves it further in every period",
                      "; or take the mean off the loads");
  for (const BoundaryCondition &condition : input.problem.conditions)
    if (condition.type == BoundaryType::absorbing)
      root.subsection("Boundaries")
          .subsection(condition.name)
          .refuse("Type", "the mean of the loads is no wave that leaves an absorbing end",
                  "Use 'resistance' or 'windkessel', loads without a mean, or Analysis = "
                  "transient");
  for (unsigned int region = 0; region < input.problem.materials.size(); ++region)
    if (creeps_for_ever(input.problem.materials[region]))
      root.subsection("Materials")
          .subsection(input.problem.regions[region])
          .refuse("Type",
                  "the solid creeps for ever under the mean of the loads, so that there is no "
                  "periodic state",
                  "Use a law with a long-term modulus, such as prony, or loads without a mean");
}

template void check_periodic_response(const Case<2> &, ParameterSection);
template void check_periodic_response(const Case<3> &, ParameterSection);
} // namespace Continua
