#include <continua/analysis/periodic_response.h>

#include <continua/analysis/beat_columns.h>
#include <continua/analysis/harmonic_checks.h>
#include <continua/analysis/harmonic_tables.h>
#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/base/parameter_text.h>
#include <continua/base/table_writer.h>
#include <continua/case/periodic_loads.h>
#include <continua/continuum/field_list.h>
#include <continua/linear_algebra/singular_matrix.h>
#include <continua/signal/fourier_transform.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
using Complex = std::complex<double>;

/// Times over a period at which loads are taken, for each harmonic that there may be.
constexpr std::size_t samples_for_a_harmonic = 8;
constexpr std::size_t least_samples = 1024;
/// The mean is that of loads which have grown with exp(s t) since ever, s being this part of the
/// angular frequency of the period. Twice this s takes the first order of it off.
constexpr double growth_of_mean = 1e-4;
/// A load whose mean is below this part of its largest value has none.
constexpr double no_mean = 1e-9;
} // namespace

template <int dim>
void PeriodicResponse<dim>::check(const Case<dim> &input, ParameterSection root)
{
  check_harmonic_body(input, root, "use Analysis = transient");
  for (const BoundaryCondition &condition : input.problem.conditions)
    if (condition.type == BoundaryType::absorbing)
      root.subsection("Boundaries")
          .subsection(condition.name)
          .refuse("Type", "the mean of a periodic state is no wave that leaves an absorbing end",
                  "Use 'resistance' or 'windkessel', or Analysis = transient");
}

template <int dim>
void PeriodicResponse<dim>::name_quantities(const Case<dim> &input, QuantityNames &names)
{
  input.probes.name_quantities(field_names<dim>(input.problem), false, names);
  for (const ProbeColumnName &column :
       input.probes.expected_columns(field_names<dim>(input.problem)))
    for (const BeatColumn &of_beat : beat_columns())
      if (of_beat.member != &BeatValues::difference)
        names.add(beat_quantity_name(of_beat, column.field), column.label());
  names.add("harmonics");
  names.add("largest change by further harmonics");
}

template <int dim>
void PeriodicResponse<dim>::take_loads()
{
  const PeriodicStateParameters &beats = run.input.periodic_state;
  const std::size_t n = next_power_of_two(
      std::max(least_samples,
               samples_for_a_harmonic * run.input.periodic_response.most_harmonics));
  std::vector<double> times;
  // In the middle of the intervals, since a table may jump where a period ends.
  for (std::size_t j = 0; j < n; ++j)
    times.push_back((beats.first_of_loads + (j + 0.5) / n) * beats.period);
  loads = std::make_unique<LoadSamples<dim>>(*system, times, run.input.communicator);
  bool has_mean = false;
  for (std::size_t k = 0; k < loads->n_shapes(); ++k)
  {
    std::vector<Complex> spectrum = fourier_transform(loads->factors(k));
    double largest = 0.;
    for (const double factor : loads->factors(k))
      largest = std::max(largest, std::abs(factor));
    for (std::size_t harmonic = 0; harmonic < spectrum.size(); ++harmonic)
      spectrum[harmonic] *= (harmonic == 0 ? 1. : 2.) / n *
                            std::polar(1., -numbers::PI * static_cast<double>(harmonic) / n);
    if (std::abs(spectrum[0]) <= no_mean * largest)
      spectrum[0] = 0.;
    has_mean = has_mean || spectrum[0] != 0.;
    load_sizes.resize(spectrum.size(), 0.);
    for (std::size_t harmonic = 0; harmonic < spectrum.size(); ++harmonic)
      load_sizes[harmonic] += std::abs(spectrum[harmonic]) / largest;
    spectra.push_back(spectrum);
  }
  for (unsigned int region = 0; has_mean && region < run.input.problem.materials.size(); ++region)
  {
    const Material &material = run.input.problem.materials[region];
    if (material.is_solid() &&
        (material.has_power_law() || material.long_term_shear_modulus() == 0.))
      throw RunError("the region '" + run.input.problem.regions[region] +
                     "' creeps for ever under the mean of the loads, so that there is no periodic "
                     "state. Use a law with a long-term modulus, or loads without a mean.");
  }
}

template <int dim>
HarmonicLoad PeriodicResponse<dim>::load_of(const unsigned int harmonic) const
{
  std::vector<Complex> factors;
  factors.reserve(spectra.size());
  for (const std::vector<Complex> &spectrum : spectra)
    factors.push_back(spectrum[harmonic]);
  return loads->sum(factors);
}

template <int dim>
std::vector<Complex> PeriodicResponse<dim>::means()
{
  const HarmonicLoad load = load_of(0);
  const bool has_mean = std::any_of(spectra.begin(), spectra.end(),
                                    [](const std::vector<Complex> &row) { return row[0] != 0.; });
  if (!has_mean)
    return std::vector<Complex>(run.input.probes.n_columns());
  std::vector<Complex> result;
  for (const double part : {1., 2.})
  {
    const double s = part * growth_of_mean * 2. * numbers::PI / run.input.periodic_state.period;
    system->factor(s);
    const std::vector<Complex> values =
        probe_values(*system, run.input.probes, system->solve({load})[0]);
    if (result.empty())
      result.assign(values.size(), 0.);
    for (std::size_t i = 0; i < values.size(); ++i)
      result[i] += (part == 1. ? 2. : -1.) * values[i].real();
  }
  return result;
}

template <int dim>
std::vector<Complex> PeriodicResponse<dim>::amplitudes(const unsigned int harmonic)
{
  SignalWatch::stop_if_asked(run.input.communicator,
                             "before harmonic " + std::to_string(harmonic) +
                                 "; a periodic response begins anew, with --overwrite");
  if (harmonic == 0)
    return means();
  const double frequency = harmonic / run.input.periodic_state.period;
  try
  {
    system->factor({0., 2. * numbers::PI * frequency});
  }
  catch (const SingularMatrix &error)
  {
    throw RunError(std::string(error.what()) + " Harmonic " + std::to_string(harmonic) +
                   " of the period, " + shortest_number(frequency) +
                   " Hz, is the frequency of a mode without damping.");
  }
  return probe_values(*system, run.input.probes, system->solve({load_of(harmonic)})[0]);
}

template <int dim>
void PeriodicResponse<dim>::write_history(const PeriodicSeries &series)
{
  Case<dim> &input = run.input;
  const std::size_t n = intervals_of_beat(input);
  input.probes.open(run.directory.file("probes.csv"));
  for (std::size_t j = 0; j <= n; ++j)
  {
    const double time = input.periodic_state.period * j / n;
    std::vector<double> values;
    for (unsigned int column = 0; column < input.probes.n_columns(); ++column)
      values.push_back(series.value(column, time));
    input.probes.record(time, values);
  }
  std::vector<std::string> header = {"time [s]", "beat [1]"};
  std::vector<double> row = {input.periodic_state.period, 1.};
  for (unsigned int column = 0; column < input.probes.n_columns(); ++column)
  {
    const ProbeColumnName name = input.probes.name_of(column);
    const BeatValues values =
        beat_values(input.probes.times(), input.probes.values(column), n, 1);
    for (const BeatColumn &of_beat : beat_columns())
      if (of_beat.member != &BeatValues::difference)
      {
        const std::string &unit = input.probes.unit_of(column);
        header.push_back(name.name + ": " + name.field + ", " + of_beat.column + " [" + unit + "]");
        row.push_back(values.*of_beat.member);
        run.summary.add(
            {beat_quantity_name(of_beat, name.field), values.*of_beat.member, unit, name.label()});
      }
  }
  if (run.is_writer)
  {
    TableWriter table(run.directory.file("beats.csv"), header);
    table.row(row);
    table.flush();
  }
}

template <int dim>
void PeriodicResponse<dim>::write_harmonics(const PeriodicSeries &series)
{
  if (!run.is_writer)
    return;
  std::vector<std::string> header = {"harmonic [1]", "frequency [Hz]"};
  for (const std::string &name : run.input.probes.column_names())
    for (const char *const part : {"real ", "imaginary "})
      header.push_back(part + name);
  TableWriter table(run.directory.file("harmonics.csv"), header);
  for (unsigned int harmonic = 0; harmonic <= series.n_harmonics(); ++harmonic)
  {
    std::vector<double> row = {static_cast<double>(harmonic), harmonic / series.period()};
    for (unsigned int column = 0; column < run.input.probes.n_columns(); ++column)
    {
      row.push_back(series.amplitude(column, harmonic).real());
      row.push_back(series.amplitude(column, harmonic).imag());
    }
    table.row(row);
  }
  table.flush();
}

template <int dim>
void PeriodicResponse<dim>::perform()
{
  run.initialise();
  Case<dim> &input = run.input;
  system = run.solver->harmonic_system();
  if (!system)
    throw RunError("the discretisation '" + input.general.discretisation +
                   "' has no frequency domain; set Discretisation = taylor hood");
  run.log.detail("Solver: " + system->solver_name());
  {
    SectionTimer::Scope scope(run.log.timer(), "loads");
    take_loads();
  }
  PeriodicSeriesOptions options;
  options.tolerance = input.periodic_response.tolerance;
  options.most_harmonics = input.periodic_response.most_harmonics;
  options.load = load_sizes;
  options.least_harmonics = std::min(options.least_harmonics, options.most_harmonics);
  for (unsigned int column = 0; column < input.probes.n_columns(); ++column)
    options.is_compared.push_back(std::any_of(
        input.periodic_state.probes.begin(), input.periodic_state.probes.end(),
        [&](const std::string &text) { return input.probes.name_of(column).is_meant_by(text); }));
  std::unique_ptr<PeriodicSeries> series;
  {
    SectionTimer::Scope scope(run.log.timer(), "harmonics");
    series = std::make_unique<PeriodicSeries>(
        input.periodic_state.period,
        [this](const unsigned int harmonic) { return amplitudes(harmonic); }, options);
  }
  write_history(*series);
  write_harmonics(*series);
  double largest_change = 0.;
  for (std::size_t column = 0; column < options.is_compared.size(); ++column)
    if (options.is_compared[column])
      largest_change = std::max(largest_change, series->changes()[column]);
  std::ostringstream text;
  text.precision(3);
  text << series->n_harmonics() << " harmonics: further ones change the probes by about "
       << largest_change << " of their range";
  run.log.line(text.str());
  if (!series->has_converged())
    run.log.warning("the harmonics have not settled within Periodic response/Tolerance = " +
                    shortest_number(options.tolerance) + ": give more Most harmonics");
  run.summary.add({"harmonics", static_cast<double>(series->n_harmonics()), "1", ""});
  run.summary.add({"largest change by further harmonics", largest_change, "1", ""});
  run.citations.add("mumps");
  run.finish(0, input.periodic_state.period);
}

template class PeriodicResponse<2>;
template class PeriodicResponse<3>;
} // namespace Continua
