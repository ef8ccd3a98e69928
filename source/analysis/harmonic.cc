#include <continua/analysis/harmonic.h>

#include <continua/analysis/response_errors.h>
#include <continua/analysis/wave_number_table.h>
#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
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

template <int dim>
void estimate_errors(ResponseErrors<dim> &errors,
                     const std::vector<ProbeResponse> &responses,
                     const std::vector<WaveFit> &fits)
{
  try
  {
    errors.estimate(responses, fits);
  }
  catch (const Interrupted &)
  {
    throw;
  }
  catch (const RunError &error)
  {
    throw RunError(
        std::string("The responses are in the tables, but their errors could not be estimated: ") +
        error.what());
  }
}
} // namespace

template <int dim>
void Harmonic<dim>::name_quantities(const Case<dim> &input, QuantityNames &names)
{
  HarmonicTables<dim>::name_quantities(input, names);
  WaveNumberTable<dim>::name_quantities(input, names);
  HarmonicSensitivities<dim>::name_quantities(input, names);
  ResponseErrors<dim>::name_quantities(input, names);
  names.add("largest residual");
  if (input.harmonic.response_tolerance > 0.)
    names.add("difference at new frequencies");
}

template <int dim>
void Harmonic<dim>::take_loads()
{
  loads = named_loads(run.input, *system);
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
        if (sensitivities)
          sensitivities->take(number, input.harmonic.frequencies[number], solutions[0],
                              tables->recorded().back().values);
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
        if (sensitivities)
          sensitivities->take(number, frequencies[number], solutions[0], values.back());
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
void Harmonic<dim>::solve_all()
{
  try
  {
    if (run.input.harmonic.response_tolerance > 0.)
      solve_refined_range();
    else
      solve_range();
  }
  catch (const RunError &)
  {
    // An interruption is one, too.
    if (sensitivities)
      sensitivities->write();
    throw;
  }
}

template <int dim>
std::string Harmonic<dim>::rows_kept() const
{
  return " The tables keep " + std::to_string(tables->recorded().size()) + " frequencies.";
}

template <int dim>
void Harmonic<dim>::perform()
{
  const Case<dim> &input = run.input;
  std::unique_ptr<ResponseErrors<dim>> errors;
  if (input.harmonic.estimates_errors)
    errors = std::make_unique<ResponseErrors<dim>>(run);
  this->start();
  take_loads();
  tables = std::make_unique<HarmonicTables<dim>>(run, *system, loads);
  if (input.harmonic.sensitivities.is_on)
    sensitivities = std::make_unique<HarmonicSensitivities<dim>>(run, *system);
  try
  {
    SectionTimer::Scope scope(run.log.timer(), "frequencies");
    solve_all();
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
  WaveNumberTable<dim> wave_numbers(run, tables->recorded());
  wave_numbers.write();
  if (sensitivities)
    sensitivities->finish(wave_numbers.fits());
  if (errors)
    estimate_errors(*errors, tables->recorded(), wave_numbers.fits());
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
