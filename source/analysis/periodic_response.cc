#include <continua/analysis/periodic_response.h>

#include <continua/analysis/beat_columns.h>
#include <continua/analysis/free_motions.h>
#include <continua/analysis/harmonic_checks.h>
#include <continua/analysis/harmonic_tables.h>
#include <continua/analysis/mean_of_loads.h>
#include <continua/analysis/periodic_mean.h>
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
  check_harmonic_probes(input, root, "use Analysis = transient");
  check_no_mean_pressure(input.problem, root, "use Analysis = transient");
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
    some_mean = some_mean || spectrum[0] != 0.;
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
bool PeriodicResponse<dim>::is_compared(const unsigned int column) const
{
  const std::vector<std::string> &names = run.input.periodic_state.probes;
  return std::any_of(names.begin(), names.end(),
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
  if (keeps_fields())
    solutions.push_back(solution);
  powers.push_back(system->powers(solution, load));
  double size = 0.;
  for (const auto part : {&HarmonicLoad::forces, &HarmonicLoad::velocities, &HarmonicLoad::ports})
  {
    HarmonicLoad of_part;
    of_part.*part = load.*part;
    size += std::abs(system->power_of(of_part, solution, load));
  }
  sizes_of_powers.push_back(size);
  return probe_values(*system, run.input.probes, solution);
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
      values.push_back(series.amplitude(column, harmonic));
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
void PeriodicResponse<dim>::write_powers()
{
  const Problem &problem = run.input.problem;
  std::vector<std::string> header = {"harmonic [1]", "frequency [Hz]", "given [W]"};
  for (const std::string &region : problem.regions)
    for (const char *kind : {"viscosity", "relaxation", "supports"})
      header.push_back(region + ": " + kind + " [W]");
  for (const unsigned int condition : system->ports())
    header.push_back("taken behind " + problem.conditions[condition].name + " [W]");
  header.emplace_back("residual [W]");
  std::vector<std::vector<double>> rows;
  double scale = 0., residual = 0.;
  for (std::size_t k = 0; k < powers.size(); ++k)
  {
    const HarmonicPowers &of_harmonic = powers[k];
    std::vector<double> row = {k + 1., (k + 1.) / run.input.periodic_state.period,
                               of_harmonic.given()};
    for (const HarmonicPower &region : of_harmonic.regions)
      row.insert(row.end(), {region.viscosity, region.relaxation, region.supports});
    row.insert(row.end(), of_harmonic.ports.begin(), of_harmonic.ports.end());
    row.push_back(of_harmonic.given() - of_harmonic.taken());
    // Without damping nothing is taken.
    scale += sizes_of_powers[k] + std::abs(of_harmonic.taken());
    residual += std::abs(row.back());
    rows.push_back(row);
  }
  run.summary.add(
      {"largest imbalance of mean powers", scale > 0. ? residual / scale : 0., "1", ""});
  if (!run.is_writer)
    return;
  TableWriter table(run.directory.file("mean-power.csv"), header);
  for (const std::vector<double> &row : rows)
    table.row(row);
  table.flush();
}

template <int dim>
void PeriodicResponse<dim>::write_period(const std::vector<WeightedSolution> &mean)
{
  const double period = run.input.periodic_state.period, interval = run.input.output.field_interval;
  const auto n = static_cast<std::size_t>(std::max(1., std::round(period / interval)));
  std::vector<WeightedSolution> parts = mean;
  for (HarmonicSolution &solution : solutions)
    parts.push_back({std::move(solution), 1.});
  solutions.clear();
  const std::size_t n_harmonics = parts.size() - mean.size();
  for (std::size_t j = 0; j < n; ++j)
  {
    for (std::size_t k = 0; k < n_harmonics; ++k)
      parts[mean.size() + k].factor = std::polar(1., 2. * numbers::PI * (k + 1.) * j / n);
    system->show_sum(parts);
    this->write_state(period * j / n);
  }
  this->finish_fields();
}

template <int dim>
void PeriodicResponse<dim>::perform()
{
  this->start();
  Case<dim> &input = run.input;
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
    if (has_mean())
      known[0] = mean.find(load_of(0), ranges, options.is_compared);
    series = std::make_unique<PeriodicSeries>(input.periodic_state.period, harmonic, options);
  }
  write_history(*series);
  write_harmonics(*series);
  write_powers();
  if (keeps_fields())
    write_period(mean.solutions());
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
  run.summary.add({"largest difference of the means", mean.difference(), "1", ""});
  this->finish(input.periodic_state.period);
}

template class PeriodicResponse<2>;
template class PeriodicResponse<3>;
} // namespace Continua
