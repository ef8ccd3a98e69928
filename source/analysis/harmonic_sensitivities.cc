#include <continua/analysis/harmonic_sensitivities.h>

#include <continua/base/atomic_file.h>
#include <continua/base/six_digits.h>
#include <continua/base/text_table.h>
#include <continua/base/undefined.h>
#include <continua/continuum/field_list.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
/// Lines of the table on the screen.
constexpr std::size_t most_lines = 10;
constexpr int digits_shown = 4;
/// Of a response over an entry that it is proportional to [1], [rad].
constexpr double tolerance_of_a_factor = 1e-8;
/// By which the fit of waves is differentiated, of the entry [1].
constexpr double step_of_fit = 1e-3;
/// Columns of the probes whose adjoint solutions are in memory at the same time.
constexpr std::size_t most_at_a_time = 16;

bool is_differentiated(const ProbeColumnName &name, const std::vector<std::string> &asked)
{
  return asked.empty() ||
         std::any_of(asked.begin(), asked.end(),
                     [&name](const std::string &text) { return name.is_meant_by(text); });
}

/// A fit of waves needs all columns of its probe.
template <int dim>
bool is_wholly_differentiated(const Case<dim> &input, const std::string &probe)
{
  const std::vector<ProbeColumnName> columns =
      input.probes.expected_columns(field_names<dim>(input.problem));
  return std::all_of(columns.begin(), columns.end(),
                     [&](const ProbeColumnName &column)
                     {
                       return column.probe != probe ||
                              is_differentiated(column, input.harmonic.sensitivities.probes);
                     });
}

/// "sensitivity of amplitude displacement x to Materials/wall/Density at 10 Hz"
std::string
name_of_sensitivity(const std::string &number, const std::string &entry, const double frequency)
{
  return "sensitivity of " + number + " to " + entry + " at " + six_digits(frequency) + " Hz";
}

/// Whether some entry is not zero, on any rank.
bool is_something(const std::vector<std::complex<double>> &values, const MPI_Comm communicator)
{
  const bool here = std::any_of(values.begin(), values.end(),
                                [](const std::complex<double> &value) { return value != 0.; });
  return Utilities::MPI::max(here ? 1 : 0, communicator) == 1;
}
} // namespace

template <int dim>
HarmonicSensitivities<dim>::HarmonicSensitivities(Run<dim> &run, HarmonicSystem<dim> &system)
    : run(run), system(system)
{
  for (unsigned int column = 0; column < run.input.probes.n_columns(); ++column)
    if (is_differentiated(run.input.probes.name_of(column),
                          run.input.harmonic.sensitivities.probes))
      columns.push_back(column);
  std::vector<std::vector<HarmonicLoad>> loads;
  for (const EntryChange &change : run.input.entry_changes)
    loads.push_back(loads_of(change));
  for (const std::vector<double> DifferenceFormula::*const weights :
       {&DifferenceFormula::weights, &DifferenceFormula::coarser_weights})
    for (std::size_t i = 0; i < n_entries(); ++i)
    {
      const EntryChange &change = run.input.entry_changes[i];
      add_change(change, change.entry.formula.*weights, loads[i]);
    }
  derivatives = system.derivatives(changes);
}

template <int dim>
std::vector<HarmonicLoad> HarmonicSensitivities<dim>::loads_of(const EntryChange &change) const
{
  const HarmonicParameters &harmonic = run.input.harmonic;
  const std::string path = change.entry.entry.path();
  const std::string materials = "Materials/";
  std::vector<HarmonicLoad> result;
  if (path.compare(0, materials.size(), materials) == 0 &&
      run.input.problem.interior.acceleration.empty())
    return result;
  for (std::size_t k = 0; k < change.problems.size(); ++k)
  {
    HarmonicLoad load;
    const HarmonicParameters &phases = change.phases[k];
    if (!harmonic.unit_load.empty())
    {
      for (unsigned int c = 0; c < run.input.problem.conditions.size(); ++c)
        if (run.input.problem.conditions[c].name == harmonic.unit_load)
          load.add(std::polar(1., phases.phases[c]), system.unit_load(c));
    }
    else
    {
      const std::vector<HarmonicLoadSource> sources = system.sources();
      const std::vector<HarmonicLoad> of_sources = system.loads_of(change.problems[k]);
      for (std::size_t l = 0; l < sources.size(); ++l)
        load.add(std::polar(1., sources[l].condition < 0 ? phases.body_force_phase
                                                         : phases.phases[sources[l].condition]),
                 of_sources[l]);
    }
    result.push_back(std::move(load));
  }
  return result;
}

template <int dim>
void HarmonicSensitivities<dim>::add_change(const EntryChange &change,
                                            const std::vector<double> &weights,
                                            const std::vector<HarmonicLoad> &loads)
{
  ProblemChange result;
  for (std::size_t k = 0; k < weights.size(); ++k)
    if (weights[k] != 0.)
    {
      result.problems.push_back(&change.problems[k]);
      result.weights.push_back(weights[k]);
      if (!loads.empty())
        result.load.add(weights[k], loads[k]);
    }
  for (std::vector<Complex> HarmonicLoad::*const part :
       {&HarmonicLoad::forces, &HarmonicLoad::velocities})
    if (!is_something(result.load.*part, run.input.communicator))
      (result.load.*part).clear();
  changes.push_back(std::move(result));
}

template <int dim>
void HarmonicSensitivities<dim>::take(const std::size_t number,
                                      const double frequency,
                                      const HarmonicSolution &solution,
                                      const std::vector<Complex> &values)
{
  std::map<unsigned int, Response> &responses = taken[frequency];
  for (std::size_t first = 0; first < columns.size(); first += most_at_a_time)
  {
    const std::size_t end = std::min(columns.size(), first + most_at_a_time);
    std::vector<HarmonicFunctional> functionals;
    std::vector<HarmonicLoad> weights;
    for (std::size_t j = first; j < end; ++j)
    {
      functionals.push_back(system.functional(run.input.probes.terms_of(columns[j]), solution.s));
      weights.push_back(functionals.back().weights);
    }
    const std::vector<std::vector<Complex>> all =
        derivatives->evaluate(solution, functionals, system.solve_further(number, weights));
    for (std::size_t j = first; j < end; ++j)
    {
      const std::vector<Complex> &sums = all[j - first];
      const auto middle = sums.begin() + n_entries();
      responses[columns[j]] = {values[columns[j]], {sums.begin(), middle}, {middle, sums.end()}};
    }
  }
}

template <int dim>
std::vector<typename HarmonicSensitivities<dim>::Row> HarmonicSensitivities<dim>::rows() const
{
  std::vector<Row> result;
  for (const auto &[frequency, responses] : taken)
    for (const auto &[column, response] : responses)
    {
      const ProbeColumnName name = run.input.probes.name_of(column);
      const double amplitude = std::abs(response.value);
      for (std::size_t i = 0; i < n_entries(); ++i)
      {
        // d ln Q/dm has the relative change of the amplitude and that of the phase.
        const Complex relative = amplitude > 0. ? response.by_entry[i] / response.value
                                                : Complex(undefined, undefined),
                      error = (response.by_entry[i] - response.by_entry_coarser[i]) / amplitude;
        result.push_back({frequency, name.name, name.label(), name.field,
                          run.input.probes.unit_of(column), i, amplitude,
                          amplitude * relative.real(), relative.imag(),
                          std::abs(entry(i).value() * error), true});
      }
    }
  result.insert(result.end(), of_waves.begin(), of_waves.end());
  return result;
}

template <int dim>
double HarmonicSensitivities<dim>::logarithmic(const Row &row, const double by_entry) const
{
  return entry(row.entry).value() * by_entry / row.amplitude;
}

template <int dim>
void HarmonicSensitivities<dim>::write() const
{
  if (!run.is_writer)
    return;
  std::string text = "frequency [Hz],probe,response,entry,value,unit of the entry,amplitude,unit,"
                     "amplitude by entry [SI],logarithmic sensitivity [1],phase by entry [SI],"
                     "phase by logarithm of entry [rad],error of differences [1]\n";
  for (const Row &row : rows())
  {
    const NumericEntry &of = entry(row.entry);
    text += csv_cell(row.frequency) + "," + csv_cell(row.probe) + "," + csv_cell(row.field) + "," +
            csv_cell(of.path()) + "," + csv_cell(of.value()) + "," + csv_cell(of.unit()) + "," +
            csv_cell(row.amplitude) + "," + csv_cell(row.unit);
    for (const double value : {row.by_entry, logarithmic(row, row.by_entry), row.phase_by_entry,
                               of.value() * row.phase_by_entry, row.error})
      text += "," + csv_cell(value);
    text += "\n";
  }
  write_file_atomically(run.directory.file("sensitivities.csv"), text);
}

template <int dim>
void HarmonicSensitivities<dim>::add_waves(const StationsProbe &probe, const WaveFit &fit)
{
  const auto found = taken.find(fit.frequency);
  if (found == taken.end() || fit.waves.waves.empty())
    return;
  const std::map<unsigned int, Response> &responses = found->second;
  for (const std::vector<unsigned int> &of_station : probe.columns)
    for (const unsigned int column : of_station)
      if (responses.count(column) == 0)
        return;
  TravellingWavesOptions options;
  options.n_waves = run.input.harmonic.n_waves;
  for (const TravellingWave &wave : fit.waves.waves)
    options.start.push_back(wave.propagation);
  // The waves where the entry has changed by that part of itself.
  const auto changed = [&](const std::size_t i, const double part)
  {
    std::vector<std::vector<Complex>> fields(probe.fields.size());
    for (const std::vector<unsigned int> &of_station : probe.columns)
      for (std::size_t f = 0; f < fields.size() && f < of_station.size(); ++f)
      {
        const Response &response = responses.at(of_station[f]);
        fields[f].push_back(response.value + part * entry(i).value() * response.by_entry[i]);
      }
    return fit_travelling_waves(probe.positions, fields, 2. * numbers::PI * fit.frequency, options);
  };
  for (std::size_t i = 0; i < n_entries(); ++i)
  {
    const TravellingWaves less = changed(i, -step_of_fit), more = changed(i, step_of_fit),
                          half_less = changed(i, -0.5 * step_of_fit),
                          half_more = changed(i, 0.5 * step_of_fit);
    if (std::min({less.waves.size(), more.waves.size(), half_less.waves.size(),
                  half_more.waves.size()}) < fit.waves.waves.size())
      continue;
    for (std::size_t w = 0; w < fit.waves.waves.size(); ++w)
      for (const auto &[what, unit, number] :
           {std::tuple("speed", "m/s", &TravellingWave::speed),
            std::tuple("attenuation", "1/m", &TravellingWave::attenuation)})
      {
        const double value = fit.waves.waves[w].*number, step = step_of_fit * entry(i).value();
        const double coarse = (more.waves[w].*number - less.waves[w].*number) / (2. * step),
                     fine = (half_more.waves[w].*number - half_less.waves[w].*number) / step;
        of_waves.push_back({fit.frequency, probe.name, probe.name,
                            name_of_wave(options.n_waves, w) + what, unit, i, value, fine,
                            undefined, std::abs((fine - coarse) * entry(i).value() / value),
                            false});
      }
  }
}

template <int dim>
void HarmonicSensitivities<dim>::finish(const std::vector<WaveFit> &fits)
{
  for (const WaveFit &fit : fits)
    for (const StationsProbe &probe : run.input.probes.stations())
      if (probe.name == fit.probe)
        add_waves(probe, fit);
  write();
  const std::vector<double> &listed = run.input.harmonic.listed;
  double largest_error = 0.;
  const std::vector<Row> all = rows();
  for (const Row &row : all)
  {
    if (std::isfinite(row.error))
      largest_error = std::max(largest_error, row.error);
    if (std::find(listed.begin(), listed.end(), row.frequency) == listed.end() ||
        !std::isfinite(logarithmic(row, row.by_entry)))
      continue;
    const std::string path = entry(row.entry).path();
    run.summary.add({name_of_sensitivity((row.is_amplitude ? "amplitude " : "") + row.field, path,
                                         row.frequency),
                     logarithmic(row, row.by_entry), "1", row.label});
    if (row.is_amplitude)
      run.summary.add({name_of_sensitivity("phase " + row.field, path, row.frequency),
                       entry(row.entry).value() * row.phase_by_entry, "rad", row.label});
  }
  run.summary.add({"largest error of differences of sensitivities", largest_error, "1", ""});
  show_largest(all);
}

template <int dim>
void HarmonicSensitivities<dim>::show_largest(const std::vector<Row> &all) const
{
  // The only load would fill the table with ones.
  std::vector<bool> is_common_factor(n_entries(), true);
  for (const Row &row : all)
    if (row.is_amplitude && std::isfinite(row.by_entry))
    {
      const double value = entry(row.entry).value();
      const bool is_factor =
          std::abs(logarithmic(row, row.by_entry) - 1.) < tolerance_of_a_factor &&
          std::abs(value * row.phase_by_entry) < tolerance_of_a_factor;
      is_common_factor[row.entry] = is_common_factor[row.entry] && is_factor;
    }
  for (std::size_t i = 0; i < n_entries(); ++i)
    if (is_common_factor[i] && !all.empty())
      run.log.note("Each response is proportional to " + entry(i).path());
  // Of each response and entry the frequency at which it is largest.
  std::map<std::pair<std::string, std::size_t>, const Row *> largest;
  for (const Row &row : all)
  {
    const double size = std::abs(logarithmic(row, row.by_entry));
    if (!std::isfinite(size) || is_common_factor[row.entry])
      continue;
    const Row *&kept = largest[{row.probe + ": " + row.field, row.entry}];
    if (kept == nullptr || size > std::abs(logarithmic(*kept, kept->by_entry)))
      kept = &row;
  }
  std::vector<const Row *> order;
  for (const auto &[name, row] : largest)
    order.push_back(row);
  std::stable_sort(
      order.begin(), order.end(),
      [this](const Row *const a, const Row *const b)
      { return std::abs(logarithmic(*a, a->by_entry)) > std::abs(logarithmic(*b, b->by_entry)); });
  if (order.empty())
    return;
  const std::size_t n_shown = std::min(order.size(), most_lines);
  std::vector<std::vector<std::string>> table = {
      {"largest sensitivities, for 1 % of the entry", "frequency", "amplitude", "phase"}};
  for (std::size_t i = 0; i < n_shown; ++i)
  {
    const Row &row = *order[i];
    const double phase = entry(row.entry).value() * row.phase_by_entry;
    table.push_back(
        {"  " + row.probe + ": " + row.field + ", by " + entry(row.entry).path(),
         six_digits(row.frequency) + " Hz",
         number_text(logarithmic(row, row.by_entry), digits_shown) + " %",
         std::isfinite(phase) ? number_text(0.01 * phase, digits_shown) + " rad" : "-"});
  }
  for (const std::string &line : aligned_lines(table))
    run.log.note(line);
  if (n_shown < order.size())
    run.log.note("  and " + std::to_string(order.size() - n_shown) + " more in sensitivities.csv");
}

template <int dim>
void HarmonicSensitivities<dim>::name_quantities(const Case<dim> &input, QuantityNames &names)
{
  if (!input.harmonic.sensitivities.is_on)
    return;
  names.add("largest error of differences of sensitivities");
  for (const EntryChange &change : input.entry_changes)
    for (const double frequency : input.harmonic.listed)
    {
      const std::string path = change.entry.entry.path();
      for (const ProbeColumnName &name :
           input.probes.expected_columns(field_names<dim>(input.problem)))
        if (is_differentiated(name, input.harmonic.sensitivities.probes))
          for (const char *const number : {"amplitude ", "phase "})
            names.add(name_of_sensitivity(number + name.field, path, frequency), name.label());
      for (const StationsProbe &probe : input.probes.stations())
      {
        if (!WaveNumberTable<dim>::has_enough_stations(input, probe) ||
            !is_wholly_differentiated(input, probe.name))
          continue;
        for (unsigned int wave = 0; wave < input.harmonic.n_waves; ++wave)
          for (const char *const what : {"speed", "attenuation"})
            names.add(name_of_sensitivity(name_of_wave(input.harmonic.n_waves, wave) + what, path,
                                          frequency),
                      probe.name);
      }
    }
}

template class HarmonicSensitivities<2>;
template class HarmonicSensitivities<3>;
} // namespace Continua
