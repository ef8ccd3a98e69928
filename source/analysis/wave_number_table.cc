#include <continua/analysis/wave_number_table.h>

#include <continua/base/six_digits.h>
#include <continua/base/table_writer.h>
#include <continua/base/undefined.h>
#include <continua/case/theory/tube_wave_case.h>
#include <continua/theory/dispersion_curves.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace Continua
{
using namespace dealii;

namespace
{
using Complex = std::complex<double>;

/// The waves of a section are followed from a frequency that is lower than the lowest one by this,
/// where their first guess is good, with so many frequencies on the way.
constexpr double lowest_frequency_ratio = 30.;
constexpr unsigned int n_below_lowest = 18;

/// " at 10 Hz"
std::string of_frequency(const double frequency)
{
  return " at " + six_digits(frequency) + " Hz";
}
} // namespace

std::string name_of_wave(const std::size_t n_waves, const std::size_t wave)
{
  return n_waves == 1 ? "" : "wave " + std::to_string(wave + 1) + " ";
}

template <int dim>
WaveNumberTable<dim>::WaveNumberTable(Run<dim> &run, const std::vector<ProbeResponse> &responses)
    : run(run)
{
  for (const ProbeResponse &response : responses)
    if (response.frequency > 0.)
      rows.push_back(response);
}

template <int dim>
bool WaveNumberTable<dim>::has_enough_stations(const Case<dim> &input, const StationsProbe &probe)
{
  return probe.positions.size() > 2 * input.harmonic.n_waves;
}

template <int dim>
typename WaveNumberTable<dim>::Theory
WaveNumberTable<dim>::theory_of(const StationsProbe &probe) const
{
  Theory theory;
  const std::vector<VesselBranch<dim>> branches = run.input.geometry->branches();
  // Under loads the section is another one.
  if (branches.empty() || run.input.problem.is_nonlinear() ||
      !why_no_tube_of_liquid(run.input).empty())
    return theory;
  const double middle = 0.5 * (probe.positions.front() + probe.positions.back());
  std::set<double> frequencies;
  for (const ProbeResponse &row : rows)
    frequencies.insert(row.frequency);
  const double lowest = *frequencies.begin();
  for (unsigned int k = 1; k <= n_below_lowest; ++k)
    frequencies.insert(lowest * std::pow(lowest_frequency_ratio, -1. * k / n_below_lowest));
  try
  {
    const TubeSection section = tube_section_at(run.input, branches[probe.branch].law, middle);
    // Without any loss families cannot be told apart while they are followed.
    const DispersionCurves curves(section, 1e-6 * 2. * numbers::PI * *frequencies.begin(),
                                  {frequencies.begin(), frequencies.end()});
    std::vector<WaveMode> modes;
    std::vector<std::size_t> kept;
    for (std::size_t m = 0; m < curves.families().size(); ++m)
      for (const auto &[family, name] : {std::pair<ExactDispersion::Family, const char *>{
                                             ExactDispersion::pressure_wave, "pressure wave"},
                                         {ExactDispersion::axial_wave, "axial wave"}})
        if (curves.families()[m] == family)
        {
          kept.push_back(m);
          theory.names.emplace_back(name);
        }
    for (const ProbeResponse &row : rows)
    {
      curves.evaluate(row.frequency, modes);
      for (const std::size_t m : kept)
        theory.propagations[row.frequency].push_back(Complex(0., 1.) * modes[m].wave_number);
    }
  }
  catch (const RunError &error)
  {
    run.log.note("No theory beside the wave numbers of '" + probe.name + "': " + error.what());
    return {};
  }
  return theory;
}

template <int dim>
TravellingWaves WaveNumberTable<dim>::fit(const StationsProbe &probe,
                                          const ProbeResponse &row,
                                          const Theory &theory) const
{
  std::vector<std::vector<Complex>> fields(probe.fields.size());
  for (const std::vector<unsigned int> &columns : probe.columns)
    for (std::size_t f = 0; f < fields.size() && f < columns.size(); ++f)
      fields[f].push_back(row.values[columns[f]]);
  TravellingWavesOptions options;
  options.n_waves = run.input.harmonic.n_waves;
  // Stations may be further apart than half a wave: the theory says which wave is meant.
  if (theory.names.size() >= options.n_waves)
  {
    const std::vector<Complex> &known = theory.propagations.at(row.frequency);
    options.start.assign(known.begin(), known.begin() + options.n_waves);
  }
  return fit_travelling_waves(probe.positions, fields, 2. * numbers::PI * row.frequency, options);
}

template <int dim>
void WaveNumberTable<dim>::write()
{
  header = {"frequency [Hz]"};
  cells.clear();
  for (const ProbeResponse &row : rows)
    cells.push_back({row.frequency});
  for (const StationsProbe &probe : run.input.probes.stations())
    if (!rows.empty() && has_enough_stations(run.input, probe))
      add_columns(probe);
  if (header.size() == 1 || !run.is_writer)
    return;
  TableWriter table(run.directory.file("wave-numbers.csv"), header);
  for (const std::vector<double> &row : cells)
    table.row(row);
  table.flush();
}

template <int dim>
void WaveNumberTable<dim>::add_columns(const StationsProbe &probe)
{
  const unsigned int n_waves = run.input.harmonic.n_waves;
  const Theory theory = theory_of(probe);
  for (unsigned int wave = 0; wave < n_waves; ++wave)
    for (const char *const what : {"speed [m/s]", "speed deviation [m/s]", "attenuation [1/m]",
                                   "attenuation deviation [1/m]"})
      header.push_back(probe.name + ": " + name_of_wave(n_waves, wave) + what);
  header.push_back(probe.name + ": misfit [1]");
  for (const std::string &name : theory.names)
    for (const char *const what : {" by theory, speed [m/s]", " by theory, attenuation [1/m]"})
      header.push_back(probe.name + ": " + name + what);
  bool has_warned = false;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const double frequency = rows[i].frequency;
    const TravellingWaves fitted = fit(probe, rows[i], theory);
    if (!fitted.refusal.empty() && !has_warned)
      run.log.warning("no wave numbers of the stations '" + probe.name + "' at " +
                      six_digits(frequency) + " Hz: " + fitted.refusal);
    has_warned = has_warned || !fitted.refusal.empty();
    for (unsigned int wave = 0; wave < n_waves; ++wave)
      if (wave < fitted.waves.size())
        for (const double value :
             {fitted.waves[wave].speed, fitted.waves[wave].speed_deviation,
              fitted.waves[wave].attenuation, fitted.waves[wave].attenuation_deviation})
          cells[i].push_back(value);
      else
        cells[i].resize(cells[i].size() + 4, undefined);
    cells[i].push_back(fitted.misfit);
    if (!theory.names.empty())
      for (const Complex &g : theory.propagations.at(frequency))
      {
        cells[i].push_back(2. * numbers::PI * frequency / g.imag());
        cells[i].push_back(g.real());
      }
    add_quantities(probe, frequency, fitted);
    all_fits.push_back({probe.name, frequency, fitted});
  }
}

template <int dim>
void WaveNumberTable<dim>::add_quantities(const StationsProbe &probe,
                                          const double frequency,
                                          const TravellingWaves &fitted)
{
  const unsigned int n_waves = run.input.harmonic.n_waves;
  const std::vector<double> &listed = run.input.harmonic.listed;
  if (std::find(listed.begin(), listed.end(), frequency) == listed.end())
    return;
  for (unsigned int wave = 0; wave < n_waves; ++wave)
  {
    const std::string name = name_of_wave(n_waves, wave);
    if (wave < fitted.waves.size())
    {
      run.summary.add(
          {name + "speed" + of_frequency(frequency), fitted.waves[wave].speed, "m/s", probe.name});
      run.summary.add({name + "attenuation" + of_frequency(frequency),
                       fitted.waves[wave].attenuation, "1/m", probe.name});
    }
    else
      for (const char *const what : {"speed", "attenuation"})
        run.summary.add_absence(name + what + of_frequency(frequency), probe.name, fitted.refusal);
  }
}

template <int dim>
void WaveNumberTable<dim>::name_quantities(const Case<dim> &input, QuantityNames &names)
{
  for (const StationsProbe &probe : input.probes.stations())
    if (has_enough_stations(input, probe))
      for (const double frequency : input.harmonic.listed)
        for (unsigned int wave = 0; wave < input.harmonic.n_waves; ++wave)
          for (const char *const what : {"speed", "attenuation"})
            names.add(name_of_wave(input.harmonic.n_waves, wave) + what + of_frequency(frequency),
                      probe.name);
}

template class WaveNumberTable<2>;
template class WaveNumberTable<3>;
} // namespace Continua
