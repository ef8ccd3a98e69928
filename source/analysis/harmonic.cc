#include <continua/analysis/harmonic.h>

#include <continua/analysis/free_motions.h>
#include <continua/analysis/harmonic_checks.h>
#include <continua/analysis/wave_number_table.h>
#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/continuum/field_list.h>
#include <continua/linear_algebra/singular_matrix.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
/// From here on a residual is worth a warning.
constexpr double noted_residual = 1e-9;

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
  if (harmonic.response_tolerance > 0. &&
      input.probes.expected_columns(field_names<dim>(input.problem)).empty())
    root.subsection("Harmonic")
        .refuse("Response tolerance", "there is no probe whose response would be known",
                "Add a probe, or remove the entry");
}

template <int dim>
void Harmonic<dim>::name_quantities(const Case<dim> &input, QuantityNames &names)
{
  HarmonicTables<dim>::name_quantities(input, names);
  WaveNumberTable<dim>::name_quantities(input, names);
  names.add("largest residual");
  if (input.harmonic.response_tolerance > 0.)
    names.add("difference at new frequencies");
}

template <int dim>
void Harmonic<dim>::take_loads()
{
  const HarmonicParameters &harmonic = run.input.harmonic;
  const auto turned = [](const HarmonicLoad &load, const double phase)
  {
    HarmonicLoad result;
    result.add(std::polar(1., phase), load);
    return result;
  };
  if (!harmonic.unit_load.empty())
  {
    for (unsigned int c = 0; c < run.input.problem.conditions.size(); ++c)
      if (run.input.problem.conditions[c].name == harmonic.unit_load)
        loads.push_back({harmonic.unit_load, static_cast<int>(c),
                         turned(system->unit_load(c), harmonic.phases[c])});
  }
  else
    for (const HarmonicLoadSource &source : system->sources())
      loads.push_back({source.name, source.condition,
                       turned(system->load_of(source, 0.),
                              source.condition < 0 ? harmonic.body_force_phase
                                                   : harmonic.phases[source.condition])});
  for (const NamedLoad &load : loads)
    total.add(1., load.load);
}

template <int dim>
void Harmonic<dim>::record(const std::size_t number, const HarmonicSolution &solution)
{
  const HarmonicParameters &harmonic = run.input.harmonic;
  const double frequency = harmonic.frequencies[number];
  tables->record(frequency, solution, total);
  const std::vector<double> &wanted = harmonic.field_frequencies;
  if (std::find(wanted.begin(), wanted.end(), frequency) == wanted.end())
    return;
  this->write_fields(solution, number + 1.);
}

template <int dim>
void Harmonic<dim>::solve_range()
{
  const Case<dim> &input = run.input;
  std::vector<Complex> all_s;
  for (const double frequency : input.harmonic.frequencies)
    all_s.emplace_back(0., 2. * numbers::PI * frequency);
  system->solve_at(
      all_s, [this](std::size_t) { return std::vector<HarmonicLoad>{total}; },
      [&](const std::size_t number, const std::vector<HarmonicLoad> &,
          const std::vector<HarmonicSolution> &solutions)
      {
        record(number, solutions[0]);
        if (number + 1 < all_s.size())
          SignalWatch::stop_if_asked(input.communicator,
                                     "after " + std::to_string(number + 1) +
                                         " frequencies; a harmonic analysis begins anew, with "
                                         "--overwrite");
      });
}

template <int dim>
std::vector<std::vector<std::complex<double>>>
Harmonic<dim>::solve_at_frequencies(const std::vector<double> &frequencies)
{
  std::vector<Complex> points;
  points.reserve(frequencies.size());
  for (const double frequency : frequencies)
    points.emplace_back(0., 2. * numbers::PI * frequency);
  std::vector<std::vector<Complex>> values;
  system->solve_at(
      points, [this](std::size_t) { return std::vector<HarmonicLoad>{total}; },
      [&](const std::size_t number, const std::vector<HarmonicLoad> &,
          const std::vector<HarmonicSolution> &solutions)
      {
        known[frequencies[number]] = solutions[0];
        values.push_back(probe_values(*system, run.input.probes, solutions[0]));
      });
  SignalWatch::stop_if_asked(run.input.communicator,
                             "after " + std::to_string(known.size()) +
                                 " frequencies; a harmonic analysis begins anew, with "
                                 "--overwrite");
  return values;
}

template <int dim>
void Harmonic<dim>::refine()
{
  const HarmonicParameters &harmonic = run.input.harmonic;
  FrequencyRefinementOptions options;
  options.tolerance = harmonic.response_tolerance;
  options.most_frequencies = harmonic.most_frequencies;
  refinement = std::make_unique<FrequencyRefinement>(
      harmonic.lowest, harmonic.highest, harmonic.is_logarithmic,
      [this](const std::vector<double> &frequencies) { return solve_at_frequencies(frequencies); },
      options);
  std::ostringstream text;
  text << refinement->frequencies().size() << " frequencies from " << harmonic.lowest << " to "
       << harmonic.highest << " Hz: new ones differ from a rational approximation by "
       << refinement->difference_at_checks() << " of the largest response";
  run.log.detail(text.str());
  run.summary.add({"difference at new frequencies", refinement->difference_at_checks(), "1", ""});
  if (!refinement->has_converged())
    run.log.warning("the responses are not known within Harmonic/Response tolerance between the "
                    "frequencies: give a larger Number of frequencies, or a narrower range");
  std::vector<double> listed;
  for (const double frequency : harmonic.frequencies)
    if (known.count(frequency) == 0)
      listed.push_back(frequency);
  solve_at_frequencies(listed);
}

template <int dim>
void Harmonic<dim>::record_known()
{
  HarmonicParameters &harmonic = run.input.harmonic;
  harmonic.frequencies.clear();
  for (const auto &[frequency, solution] : known)
  {
    harmonic.frequencies.push_back(frequency);
    record(harmonic.frequencies.size() - 1, solution);
  }
}

template <int dim>
void Harmonic<dim>::solve_refined_range()
{
  try
  {
    refine();
  }
  catch (const RunError &)
  {
    // An interruption is one, too.
    record_known();
    throw;
  }
  record_known();
  write_interpolated();
}

template <int dim>
void Harmonic<dim>::write_interpolated() const
{
  const HarmonicParameters &harmonic = run.input.harmonic;
  if (!run.is_writer || run.input.probes.n_columns() == 0)
    return;
  const std::unique_ptr<TableWriter> table =
      this->complex_table("interpolated-response.csv", {"frequency [Hz]"});
  constexpr unsigned int n_rows = 401;
  for (unsigned int i = 0; i < n_rows; ++i)
  {
    const double part = i / (n_rows - 1.);
    const double frequency =
        harmonic.is_logarithmic
            ? harmonic.lowest * std::pow(harmonic.highest / harmonic.lowest, part)
            : harmonic.lowest + part * (harmonic.highest - harmonic.lowest);
    std::vector<Complex> values;
    for (unsigned int column = 0; column < run.input.probes.n_columns(); ++column)
      values.push_back(
          refinement->approximation().value(column, {0., 2. * numbers::PI * frequency}));
    this->add_row(table, {frequency}, values);
  }
  table->flush();
}

template <int dim>
std::string Harmonic<dim>::rows_kept() const
{
  return " The tables keep " + std::to_string(tables->recorded().size()) + " frequencies.";
}

template <int dim>
void Harmonic<dim>::perform()
{
  this->start();
  const Case<dim> &input = run.input;
  take_loads();
  tables = std::make_unique<HarmonicTables<dim>>(run, *system, loads);
  try
  {
    SectionTimer::Scope scope(run.log.timer(), "frequencies");
    if (input.harmonic.response_tolerance > 0.)
      solve_refined_range();
    else
      solve_range();
  }
  catch (const SingularMatrix &error)
  {
    throw RunError(error.what() +
                   std::string(" The body can move freely at this frequency: it is that of a mode "
                               "without damping. Give other frequencies, or a material with "
                               "damping.") +
                   rows_kept());
  }
  catch (const Interrupted &)
  {
    throw;
  }
  catch (const RunError &error)
  {
    throw RunError(error.what() + rows_kept());
  }
  if (system->largest_residual() > noted_residual)
  {
    std::ostringstream text;
    text << "the solver leaves " << system->largest_residual()
         << " of the largest force at a node: so many digits fewer are right";
    run.log.warning(text.str());
  }
  tables->finish();
  WaveNumberTable<dim>(run, tables->recorded()).write();
  this->finish_fields();
  std::ostringstream text;
  text << input.harmonic.frequencies.size()
       << (input.harmonic.frequencies.size() == 1 ? " frequency" : " frequencies") << " of "
       << system->n_unknowns() << " unknowns";
  run.log.line(text.str());
  run.summary.set("solver of the frequencies", system->solver_name());
  run.summary.set("frequencies", static_cast<double>(input.harmonic.frequencies.size()));
  run.summary.set("memory of the factors [bytes]", system->factor_memory());
  run.summary.add({"largest residual", system->largest_residual(), "1", ""});
  this->finish(0.);
}

template class Harmonic<2>;
template class Harmonic<3>;
} // namespace Continua
