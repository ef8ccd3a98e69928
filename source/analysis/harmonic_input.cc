// What Harmonic asks of its input.

#include <continua/analysis/harmonic.h>

#include <continua/analysis/free_motions.h>
#include <continua/analysis/harmonic_checks.h>
#include <continua/analysis/response_errors.h>
#include <continua/base/nearest_name.h>
#include <continua/continuum/field_list.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
bool is_given(const BoundaryCondition &condition)
{
  return !condition.normal.is_zero() || !condition.tangential.is_zero() ||
         (condition.free_flow && !condition.free_flow->rate.is_zero()) ||
         (condition.outlet && !condition.outlet->pressure_behind.is_zero());
}

/// Of a motion about a state at rest under the loads of the file. Throws InputError.
template <int dim>
void check_motion_about_state(const Case<dim> &input, ParameterSection root)
{
  ParameterSection harmonic = root.subsection("Harmonic");
  if (input.harmonic.unit_load.empty())
    harmonic.refuse("Unit load at",
                    "in finite deformation the loads of the file are those of the state at rest, "
                    "about which the motion is small, and none of them oscillates",
                    "Give the name of the boundary whose pressure oscillates, or set Deformation = "
                    "small");
  if (!input.harmonic.field_frequencies.empty())
    harmonic.refuse("Field frequencies",
                    "about a state in finite deformation no fields of the motion are written",
                    "Remove the entry, and give probes");
}

/// At 0 Hz the body is at rest. Throws InputError.
template <int dim>
void check_other_rules(const Case<dim> &input, ParameterSection root)
{
  ParameterSection harmonic = root.subsection("Harmonic");
  const Problem &problem = input.problem;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    const Material &material = problem.materials[region];
    const std::string name = "the region '" + problem.regions[region] + "' ";
    if (!material.is_solid())
      harmonic.refuse("Frequencies",
                      name + "is a liquid, which has no displacement at rest: 0 Hz has no answer",
                      "Use Analysis = steady for 0 Hz, or a low frequency");
    if (material.has_power_law() || material.long_term_shear_modulus() == 0. ||
        std::isinf(material.long_term_inverse_bulk_modulus()))
      harmonic.refuse("Frequencies", name + "creeps for ever under a load of 0 Hz",
                      "Leave 0 out, or use a law with a long-term modulus");
  }
  for (const BoundaryCondition &condition : problem.conditions)
    for (const BoundaryPart *part : {&condition.normal, &condition.tangential})
      if (part->kind == BoundaryPart::Kind::velocity && !part->is_zero())
        root.subsection("Boundaries")
            .subsection(condition.name)
            .refuse("", "a solid at rest cannot have a prescribed velocity",
                    "Prescribe zero, or leave 0 out of Harmonic/Frequencies");
  refuse_free_motions(input, root, ", so that 0 Hz has no answer",
                      "; or leave 0 out of Harmonic/Frequencies");
}

template <int dim>
void check_unit_load(const Case<dim> &input, ParameterSection root)
{
  const std::string &name = input.harmonic.unit_load;
  ParameterSection harmonic = root.subsection("Harmonic");
  const auto found =
      std::find_if(input.problem.conditions.begin(), input.problem.conditions.end(),
                   [&name](const BoundaryCondition &condition) { return condition.name == name; });
  if (found == input.problem.conditions.end())
    harmonic.refuse("Unit load at", "there is no boundary condition '" + name + "'",
                    "Give the name of a subsection of Boundaries");
  if (found->normal.kind != BoundaryPart::Kind::traction)
    harmonic.refuse("Unit load at",
                    "the velocity along the normal is given at '" + name + "', not the pressure",
                    input.problem.is_nonlinear()
                        ? "Give the name of a boundary with a pressure or an outlet"
                        : "Leave the entry out, and give that boundary the velocity or flow rate "
                          "1");
}

/// Refuses a Phase of nothing.
template <int dim>
void check_phases(const Case<dim> &input, ParameterSection root, const bool has_body_force)
{
  const std::string &unit_load = input.harmonic.unit_load;
  const auto check_one = [&](const ParameterSection &section, const bool is_loaded)
  {
    if (is_loaded || !section.given("Phase"))
      return;
    section.refuse("Phase",
                   unit_load.empty()
                       ? "there is no load here that could be ahead"
                       : "the one load is that of Harmonic/Unit load at, '" + unit_load + "'",
                   unit_load.empty() ? "Remove the entry, or give a load" : "Remove the entry");
  };
  for (const BoundaryCondition &condition : input.problem.conditions)
    check_one(root.subsection("Boundaries").subsection(condition.name),
              unit_load.empty() ? is_given(condition) : condition.name == unit_load);
  check_one(root.subsection("Body force"), unit_load.empty() && has_body_force);
}

/// Of the probes whose responses are differentiated.
template <int dim>
void check_sensitivities(const Case<dim> &input, const ParameterSection &section)
{
  if (input.problem.is_nonlinear())
    section.refuse("Entries",
                   "in finite deformation an entry changes the state about which the motion is "
                   "small, too, and no derivative knows of that",
                   "Remove the section, or set Deformation = small");
  const std::vector<ProbeColumnName> columns =
      input.probes.expected_columns(field_names<dim>(input.problem));
  if (columns.empty())
    section.refuse("Entries", "there is no probe whose response could be differentiated",
                   "Add a probe, or remove the section");
  for (const std::string &name : input.harmonic.sensitivities.probes)
    if (std::none_of(columns.begin(), columns.end(),
                     [&name](const ProbeColumnName &column) { return column.is_meant_by(name); }))
    {
      std::vector<std::string> names;
      for (const ProbeColumnName &column : columns)
        names.push_back(column.probe);
      const std::string nearest = nearest_name(name, names);
      section.refuse("Probes", "there is no probe '" + name + "'",
                     nearest.empty() ? "Give the name of a subsection of Probes"
                                     : "Did you mean '" + nearest + "'?");
    }
}

/// The elements of the next degree have to exist, and to have a response.
template <int dim>
void check_error_estimate(const Case<dim> &input, const ParameterSection &section)
{
  if (input.problem.is_nonlinear())
    section.refuse("Estimate errors",
                   "in finite deformation the state about which the motion is small has an error, "
                   "too",
                   "Remove the entry, and compare meshes; or set Deformation = small");
  if (input.discretisation.taylor_hood.space.velocity_degree == ResponseErrors<dim>::highest_degree)
    section.refuse("Estimate errors", "there are no elements of the next degree",
                   "Set a lower 'Velocity degree' in Finite element");
  if (input.probes.expected_columns(field_names<dim>(input.problem)).empty())
    section.refuse("Estimate errors", "there is no probe whose response has an error",
                   "Add a probe, or remove the entry");
}
} // namespace

template <int dim>
void Harmonic<dim>::check(const Case<dim> &input, ParameterSection root)
{
  if (input.problem.is_nonlinear())
  {
    check_loaded_state(input, root, remedy_of_harmonic);
    check_motion_about_state(input, root);
  }
  else
    check_no_states(input.problem, root, remedy_of_harmonic);
  check_harmonic_probes(input, root, remedy_of_harmonic);
  const HarmonicParameters &harmonic = input.harmonic;
  const InteriorData &interior = input.problem.interior;
  if (input.problem.is_nonlinear())
    check_no_loads_of_state_in_time(input, root, remedy_of_harmonic);
  else
    check_no_loads_in_time(input, root,
                           "a load of a harmonic analysis is an amplitude, and this one depends on "
                           "t",
                           std::string("Give its amplitude, and a Phase if it has one, or ") +
                               remedy_of_harmonic);
  bool has_body_force = false;
  for (const std::vector<Waveform> *const force : {&interior.body_force, &interior.acceleration})
    for (const Waveform &component : *force)
      has_body_force = has_body_force || !component.is_zero();
  const bool is_loaded = has_body_force || std::any_of(input.problem.conditions.begin(),
                                                       input.problem.conditions.end(), is_given);
  if (!harmonic.unit_load.empty())
    check_unit_load(input, root);
  else if (!is_loaded)
    root.subsection("Boundaries")
        .refuse("", "no boundary has a load, and there is no body force, so that nothing moves",
                "Give an amplitude, such as Pressure = 1 Pa, or set Harmonic/Unit load at");
  check_phases(input, root, has_body_force);
  if (harmonic.frequencies.front() == 0.)
    check_other_rules(input, root);
  if (harmonic.sensitivities.is_on)
    check_sensitivities(input, root.subsection("Harmonic").subsection("Sensitivities"));
  if (harmonic.estimates_errors)
    check_error_estimate(input, root.subsection("Harmonic"));
  if (harmonic.response_tolerance > 0. &&
      input.probes.expected_columns(field_names<dim>(input.problem)).empty())
    root.subsection("Harmonic")
        .refuse("Response tolerance", "there is no probe whose response would be known",
                "Add a probe, or remove the entry");
}

template void Harmonic<2>::check(const Case<2> &, ParameterSection);
template void Harmonic<3>::check(const Case<3> &, ParameterSection);
} // namespace Continua
