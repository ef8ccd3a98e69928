#include <continua/analysis/periodic_response.h>

#include <continua/analysis/beat_columns.h>
#include <continua/analysis/free_motions.h>
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
#include <limits>
#include <map>
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
/// The mean is that of loads which have grown with exp(s t) since ever, s being at most this part
/// of the angular frequency of the period, and of the rate of the slowest relaxation. Twice this s
/// takes the first order of it off.
constexpr double growth_of_mean = 1e-4, growth_over_rate = 1e-3;
/// By which s falls where two means differ, and how often.
constexpr double fall_of_growth = 0.1;
constexpr unsigned int most_falls = 5;
/// Of the largest quantity of the same unit, below which a difference of means may be round-off.
constexpr double round_off_of_mean = 1e-7;
/// A load whose mean is below this part of its largest value has none.
constexpr double no_mean = 1e-9;

/// The longest time [s] in which a stress or a windkessel comes to rest; 0: none.
double longest_relaxation(const Problem &problem)
{
  double longest = 0.;
  const auto take = [&longest](const double time)
  {
    if (std::isfinite(time))
      longest = std::max(longest, time);
  };
  for (const Material &material : problem.materials)
  {
    for (const Branch &branch : material.shear.branches)
      take(branch.relaxation_time);
    for (const BulkBranch &branch : material.compression.bulk_branches())
      take(branch.relaxation_time);
  }
  for (const BoundaryCondition &condition : problem.conditions)
    if (condition.outlet)
      for (const Impedance::Term &term : condition.outlet->impedance.terms)
        if (term.rate > 0.)
          take(1. / term.rate);
  return longest;
}

/// Whether it has a mean wherever it acts. What depends on place and time is known by its samples
/// alone.
bool has_mean_everywhere(const Waveform &load, const PeriodicStateParameters &beats)
{
  if (load.is_zero() || (load.depends_on_time() && load.depends_on_space()))
    return false;
  if (!load.depends_on_time())
    return true;
  const double origin[3] = {0., 0., 0.};
  double sum = 0., largest = 0.;
  for (std::size_t j = 0; j < least_samples; ++j)
  {
    const double value =
        load(origin, (beats.first_of_loads + (j + 0.5) / least_samples) * beats.period);
    sum += value / least_samples;
    largest = std::max(largest, std::abs(value));
  }
  return std::abs(sum) > no_mean * largest;
}

bool loads_have_mean(const Problem &problem, const PeriodicStateParameters &beats)
{
  std::vector<Waveform> all = problem.interior.body_force;
  all.insert(all.end(), problem.interior.acceleration.begin(), problem.interior.acceleration.end());
  for (const BoundaryCondition &condition : problem.conditions)
  {
    for (const BoundaryPart *part : {&condition.normal, &condition.tangential})
    {
      all.insert(all.end(), part->vector.begin(), part->vector.end());
      all.push_back(part->along_normal);
    }
    if (condition.free_flow)
      all.push_back(condition.free_flow->rate);
    if (condition.outlet)
      all.push_back(condition.outlet->pressure_behind);
  }
  return std::any_of(all.begin(), all.end(),
                     [&beats](const Waveform &load) { return has_mean_everywhere(load, beats); });
}
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
  if (loads_have_mean(input.problem, input.periodic_state))
    refuse_free_motions(input, root,
                        ", so that the mean of the loads moves it further in every period",
                        "; or take the mean off the loads");
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
std::vector<Complex> PeriodicResponse<dim>::means(const std::vector<double> &ranges)
{
  const HarmonicLoad load = load_of(0);
  const bool has_mean = std::any_of(spectra.begin(), spectra.end(),
                                    [](const std::vector<Complex> &row) { return row[0] != 0.; });
  if (!has_mean)
    return std::vector<Complex>(run.input.probes.n_columns());
  Probes<dim> &probes = run.input.probes;
  const double slowest = longest_relaxation(run.input.problem);
  double s = growth_of_mean * 2. * numbers::PI / run.input.periodic_state.period;
  if (slowest > 0.)
    s = std::min(s, growth_over_rate / slowest);
  const auto values_at = [&](const double growth)
  {
    system->factor(growth);
    return probe_values(*system, probes, system->solve({load})[0]);
  };
  // Of two means without their first order the difference is three times the error of the second.
  double least = std::numeric_limits<double>::infinity();
  std::string worst;
  for (unsigned int fall = 0; fall <= most_falls; ++fall, s *= fall_of_growth)
  {
    const std::vector<Complex> near = values_at(s), middle = values_at(2. * s),
                               far = values_at(4. * s);
    std::vector<Complex> result;
    std::map<std::string, double> largest;
    for (unsigned int i = 0; i < near.size(); ++i)
    {
      result.emplace_back(2. * near[i].real() - middle[i].real());
      double &of_unit = largest[probes.unit_of(i)];
      of_unit = std::max({of_unit, std::abs(result[i].real()), ranges[i]});
    }
    double difference = 0.;
    std::string place;
    for (unsigned int i = 0; i < near.size(); ++i)
    {
      const double other = 2. * middle[i].real() - far[i].real();
      const double scale = std::max(
          {std::abs(result[i].real()), ranges[i], round_off_of_mean * largest[probes.unit_of(i)]});
      const double part =
          scale > 0. ? std::abs(result[i].real() - other) / scale
                     : (std::isfinite(other) ? 0. : std::numeric_limits<double>::infinity());
      if (is_compared(i) && !(part <= difference))
      {
        difference = std::isfinite(part) ? part : std::numeric_limits<double>::max();
        place = probes.name_of(i).label();
      }
    }
    if (difference <= run.input.periodic_response.tolerance)
    {
      difference_of_means = difference;
      return result;
    }
    if (difference < least)
    {
      least = difference;
      worst = place;
    }
  }
  throw RunError("the mean of '" + worst + "' is not known: it differs by " +
                 shortest_number(least) +
                 " of its range or its mean where the loads grow faster, and Periodic "
                 "response/Tolerance is " +
                 shortest_number(run.input.periodic_response.tolerance) +
                 ". A body that the mean of its loads moves or fills in every period has no "
                 "periodic state: give the liquid a way out and hold the solid, or compare other "
                 "probes.");
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
    known[0] = means(ranges);
    series = std::make_unique<PeriodicSeries>(input.periodic_state.period, harmonic, options);
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
  run.summary.add({"largest difference of the means", difference_of_means, "1", ""});
  this->finish(input.periodic_state.period);
}

template class PeriodicResponse<2>;
template class PeriodicResponse<3>;
} // namespace Continua
