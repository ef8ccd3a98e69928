#include <continua/analysis/periodic_response.h>

#include <continua/analysis/beat_columns.h>
#include <continua/analysis/harmonic_checks.h>
#include <continua/analysis/harmonic_tables.h>
#include <continua/analysis/mean_of_loads.h>
#include <continua/analysis/periodic_checks.h>
#include <continua/analysis/periodic_mean.h>
#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/base/parameter_text.h>
#include <continua/base/table_writer.h>
#include <continua/base/undefined.h>
#include <continua/case/periodic_loads.h>
#include <continua/continuum/field_list.h>
#include <continua/linear_algebra/singular_matrix.h>
#include <continua/postprocess/probe_fields.h>
#include <continua/signal/fourier_transform.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
using Complex = std::complex<double>;

/// Times over a period at which loads are taken, for each harmonic that there may be.
constexpr std::size_t samples_for_a_harmonic = 8;
constexpr std::size_t least_samples = 1024;
} // namespace

template <int dim>
void PeriodicResponse<dim>::check(const Case<dim> &input, ParameterSection root)
{
  check_periodic_response(input, root);
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
  names.add("largest difference of the means");
  names.add("largest imbalance of mean powers");
}

template <int dim>
void PeriodicResponse<dim>::take_loads()
{
  const PeriodicStateParameters &beats = run.input.periodic_state;
  const std::size_t n = next_power_of_two(
      std::max(least_samples, samples_for_a_harmonic * run.input.periodic_response.most_harmonics));
  std::vector<double> times;
  // In the middle of the intervals, since a table may jump where a period ends.
  for (std::size_t j = 0; j < n; ++j)
    times.push_back((beats.first_of_loads + (j + 0.5) / n) * beats.period);
  loads = std::make_unique<LoadSamples<dim>>(*system, times, run.input.communicator);
  bool some_mean = false;
  for (std::size_t k = 0; k < loads->n_shapes(); ++k)
  {
    std::vector<Complex> spectrum = fourier_transform(loads->factors(k));
    double largest = 0.;
    for (const double factor : loads->factors(k))
      largest = std::max(largest, std::abs(factor));
    for (std::size_t harmonic = 0; harmonic < spectrum.size(); ++harmonic)
      spectrum[harmonic] *= (harmonic == 0 ? 1. : 2.) / n *
                            std::polar(1., -numbers::PI * static_cast<double>(harmonic) / n);
    if (std::abs(spectrum[0]) <= no_mean_of_load * largest)
      spectrum[0] = 0.;
    // In finite deformation the state about which the motion is small has the mean.
    some_mean = some_mean || (spectrum[0] != 0. && !run.input.problem.is_nonlinear());
    load_sizes.resize(spectrum.size(), 0.);
    for (std::size_t harmonic = 0; harmonic < spectrum.size(); ++harmonic)
      load_sizes[harmonic] += std::abs(spectrum[harmonic]) / largest;
    spectra.push_back(spectrum);
  }
  for (const BoundaryCondition &condition : run.input.problem.conditions)
    if (some_mean && condition.type == BoundaryType::absorbing)
      throw RunError("the mean of the loads is no wave that leaves the absorbing end '" +
                     condition.name + "'. Use loads without a mean, or another end.");
  for (unsigned int region = 0; some_mean && region < run.input.problem.materials.size(); ++region)
  {
    // Loads of time and place, whose mean the samples alone tell.
    if (creeps_for_ever(run.input.problem.materials[region]))
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
bool PeriodicResponse<dim>::is_linear(const unsigned int column) const
{
  return is_linear_in_motion(run.input.probes.name_of(column).field);
}

template <int dim>
bool PeriodicResponse<dim>::is_compared(const unsigned int column) const
{
  const std::vector<std::string> &names = run.input.periodic_state.probes;
  return is_linear(column) &&
         std::any_of(names.begin(), names.end(),
                     [&](const std::string &text)
                     { return run.input.probes.name_of(column).is_meant_by(text); });
}

template <int dim>
std::vector<Complex> PeriodicResponse<dim>::amplitudes(const unsigned int harmonic)
{
  SignalWatch::stop_if_asked(run.input.communicator,
                             "before harmonic " + std::to_string(harmonic) +
                                 "; a periodic response begins anew, with --overwrite");
  const double frequency = harmonic / run.input.periodic_state.period;
  const HarmonicLoad load = load_of(harmonic);
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
  const HarmonicSolution solution = system->solve({load})[0];
  if (motion)
    motion->add(solution);
  powers->add(solution, load);
  std::vector<Complex> values = probe_values(*system, run.input.probes, solution);
  for (unsigned int column = 0; column < values.size(); ++column)
    if (!is_linear(column))
      values[column] = 0.;
  return values;
}

template <int dim>
std::vector<Complex> PeriodicResponse<dim>::values_of_state()
{
  system->show_sum({});
  const std::vector<double> values = run.input.probes.present_values();
  return {values.begin(), values.end()};
}

template <int dim>
std::vector<std::vector<double>> PeriodicResponse<dim>::values_of_motion(const std::size_t n)
{
  Case<dim> &input = run.input;
  std::vector<std::vector<double>> rows;
  if (!needs_history())
    return rows;
  const double period = input.periodic_state.period;
  for (std::size_t j = 0; j <= n; ++j)
  {
    motion->show(period * j / n);
    if (j == 0)
      run.solver->begin_averages();
    else
      run.solver->add_to_averages(period / n);
    rows.push_back(input.probes.present_values());
  }
  // The averages are those of the whole period.
  for (unsigned int column = 0; column < input.probes.n_columns(); ++column)
    for (std::size_t j = 0; j < n && is_average(input.probes.name_of(column).field); ++j)
      rows[j][column] = rows[n][column];
  return rows;
}

template <int dim>
void PeriodicResponse<dim>::write_history(const PeriodicSeries &series)
{
  Case<dim> &input = run.input;
  const std::size_t n = intervals_of_beat(input);
  const std::vector<std::vector<double>> of_motion = values_of_motion(n);
  input.probes.open(run.directory.file("probes.csv"));
  for (std::size_t j = 0; j <= n; ++j)
  {
    const double time = input.periodic_state.period * j / n;
    std::vector<double> values;
    for (unsigned int column = 0; column < input.probes.n_columns(); ++column)
      values.push_back(is_linear(column) ? series.value(column, time) : of_motion[j][column]);
    input.probes.record(time, values);
  }
  std::vector<std::string> header = {"time [s]", "beat [1]"};
  std::vector<double> row = {input.periodic_state.period, 1.};
  for (unsigned int column = 0; column < input.probes.n_columns(); ++column)
  {
    const ProbeColumnName name = input.probes.name_of(column);
    const BeatValues values = beat_values(input.probes.times(), input.probes.values(column), n, 1);
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
  const std::unique_ptr<TableWriter> table =
      this->complex_table("harmonics.csv", {"harmonic [1]", "frequency [Hz]"});
  if (!table)
    return;
  for (unsigned int harmonic = 0; harmonic <= series.n_harmonics(); ++harmonic)
  {
    std::vector<Complex> values;
    for (unsigned int column = 0; column < run.input.probes.n_columns(); ++column)
      values.push_back(is_linear(column) ? series.amplitude(column, harmonic) : undefined);
    this->add_row(table, {static_cast<double>(harmonic), harmonic / series.period()}, values);
  }
  table->flush();
}

template <int dim>
bool PeriodicResponse<dim>::has_mean() const
{
  return std::any_of(spectra.begin(), spectra.end(),
                     [](const std::vector<Complex> &row) { return row[0] != 0.; });
}

template <int dim>
bool PeriodicResponse<dim>::keeps_fields() const
{
  return run.input.output.field_interval > 0.;
}

template <int dim>
bool PeriodicResponse<dim>::needs_history() const
{
  bool needs = run.input.problem.wall_shear_window.is_kept;
  for (unsigned int column = 0; column < run.input.probes.n_columns(); ++column)
    needs = needs || !is_linear(column);
  return needs;
}

template <int dim>
void PeriodicResponse<dim>::write_period()
{
  const double period = run.input.periodic_state.period, interval = run.input.output.field_interval;
  const auto n = static_cast<std::size_t>(std::max(1., std::round(period / interval)));
  for (std::size_t j = 0; j < n; ++j)
  {
    motion->show(period * j / n);
    this->write_state(period * j / n);
  }
  this->finish_fields();
}

template <int dim>
void PeriodicResponse<dim>::perform()
{
  this->start(mean_over_period);
  Case<dim> &input = run.input;
  {
    SectionTimer::Scope scope(run.log.timer(), "loads");
    take_loads();
  }
  if (keeps_fields() || needs_history())
    motion = std::make_unique<PeriodicMotion<dim>>(*system, input.periodic_state.period);
  powers = std::make_unique<PeriodicPowers<dim>>(run, *system);
  PeriodicSeriesOptions options;
  options.tolerance = input.periodic_response.tolerance;
  options.most_harmonics = input.periodic_response.most_harmonics;
  options.load = load_sizes;
  options.least_harmonics = std::min(options.least_harmonics, options.most_harmonics);
  for (unsigned int column = 0; column < input.probes.n_columns(); ++column)
    options.is_compared.push_back(is_compared(column));
  std::unique_ptr<PeriodicSeries> series;
  PeriodicMean<dim> mean(run, *system);
  {
    SectionTimer::Scope scope(run.log.timer(), "harmonics");
    // The mean is known well enough by the range about it.
    std::vector<std::vector<Complex>> known = {std::vector<Complex>(input.probes.n_columns())};
    const auto harmonic = [&](const unsigned int number)
    {
      if (number == known.size())
        known.push_back(amplitudes(number));
      return known[number];
    };
    series = std::make_unique<PeriodicSeries>(input.periodic_state.period, harmonic, options);
    std::vector<double> ranges;
    for (unsigned int column = 0; column < input.probes.n_columns(); ++column)
    {
      double least = series->value(column, 0.), most = least;
      for (std::size_t j = 1; j < options.n_times; ++j)
      {
        const double value =
            series->value(column, input.periodic_state.period * j / options.n_times);
        least = std::min(least, value);
        most = std::max(most, value);
      }
      ranges.push_back(most - least);
    }
    if (input.problem.is_nonlinear())
      known[0] = values_of_state();
    else if (has_mean())
      known[0] = mean.find(load_of(0), ranges, options.is_compared);
    if (motion)
      motion->set_mean(mean.solutions());
    series = std::make_unique<PeriodicSeries>(input.periodic_state.period, harmonic, options);
  }
  write_history(*series);
  write_harmonics(*series);
  powers->write();
  if (keeps_fields())
    write_period();
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
  if (input.problem.is_nonlinear())
    run.summary.add_absence("largest difference of the means", "",
                            "the mean is the state at rest about which the motion is small");
  else
    run.summary.add({"largest difference of the means", mean.difference(), "1", ""});
  this->finish(input.periodic_state.period);
}

template class PeriodicResponse<2>;
template class PeriodicResponse<3>;
} // namespace Continua
