#include <continua/analysis/linear_wave_theory.h>

#include <continua/analysis/dispersion_table.h>
#include <continua/analysis/loaded_tube_report.h>
#include <continua/analysis/stream_report.h>
#include <continua/analysis/wave_report.h>
#include <continua/base/interruption.h>
#include <continua/case/measured_waves.h>
#include <continua/case/theory/loaded_tube_case.h>
#include <continua/case/theory/nonlinear_wave_case.h>
#include <continua/case/theory/station_waves.h>
#include <continua/case/theory/tube_wave_case.h>
#include <continua/postprocess/writing_rank.h>
#include <continua/signal/beats.h>
#include <continua/signal/energy_frequency.h>
#include <continua/theory/korteweg.h>
#include <continua/vessel/tube_law.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
namespace
{
using Histories = WaveReport::Histories;

Histories
simulated_histories(const StationsProbe &probe,
                    const std::vector<std::vector<unsigned int>> &columns,
                    const std::function<const std::vector<double> &(unsigned int)> &values)
{
  Histories histories(probe.positions.size());
  for (unsigned int s = 0; s < histories.size(); ++s)
    for (const unsigned int column : columns[s])
      histories[s].push_back(values(column));
  return histories;
}

constexpr unsigned int n_samples_of_load = 4096;

/// The frequency [Hz] of the load at the inlet: below it lies 90 % of its energy. 1 Hz if it does
/// not vary.
double load_frequency(const std::function<double(double)> &inlet, const double end_time)
{
  const double frequency =
      inlet ? energy_frequency(samples_of_whole_pulse(inlet, end_time, n_samples_of_load),
                               end_time / n_samples_of_load)
            : 0.;
  return frequency > 0. ? frequency : 1.;
}

/// Of the load at the inlet; none if it is not known.
Beats beats_of(const std::function<double(double)> &inlet, const double end_time)
{
  std::vector<double> samples;
  for (unsigned int i = 0; inlet && i < n_samples_of_load; ++i)
    samples.push_back(inlet(i * end_time / n_samples_of_load));
  return find_beats(samples);
}

/// rho c/A with Korteweg's speed of a thick wall (about a loaded state of the thin one) at each
/// station, where the wall's modulus depends on frequency that at `frequency` [Hz]; layers of
/// liquid do not count. Empty where there is no tube, or no wave in it.
template <int dim>
std::vector<double>
impedances_of(const Case<dim> &input, const StationsProbe &probe, const double frequency)
{
  std::vector<double> impedances;
  const std::vector<VesselBranch<dim>> branches = input.geometry->branches();
  if (branches.empty())
    return impedances;
  for (const double position : probe.positions)
  {
    TubeSection section = tube_section_at(input, branches[probe.branch].law, position);
    for (std::size_t layer = section.layers.size(); layer-- > 0;)
      if (!section.layers[layer].is_solid())
      {
        section.layers.erase(section.layers.begin() + layer);
        section.layer_thicknesses.erase(section.layer_thicknesses.begin() + layer);
      }
    const bool is_rigid = branches[probe.branch].law.is_rigid();
    if (section.layers.empty() && (!is_rigid || section.fluid.inverse_bulk_modulus() == 0.))
      return {};
    const std::complex<double> omega = 2. * dealii::numbers::PI * frequency;
    const LongWaveTube tube{section.inner_radius, section.wall_thickness(),
                            section.poisson_ratio(omega).real(), section.fluid.density,
                            section.fluid.inverse_bulk_modulus()};
    const double speed =
        korteweg_speed(tube, section.hoop_modulus(omega),
                       section.tethered ? Anchoring::throughout : Anchoring::expansion_joints,
                       is_about_loaded_state(input) ? WallTheory::thin : WallTheory::thick)
            .real();
    impedances.push_back(
        characteristic_impedance(section.fluid.density, speed,
                                 dealii::numbers::PI * section.inner_radius * section.inner_radius)
            .real());
  }
  return impedances;
}
} // namespace

template <int dim>
void LinearWaveTheory<dim>::check(const Case<dim> &input, ParameterSection root)
{
  TubeWaveCase wave_case;
  const std::string problem = make_tube_wave_case(input, wave_case);
  if (!problem.empty())
    root.refuse("Analysis", "linear wave theory does not cover this case: " + problem,
                "Use a 'tube' with a pressure or flow-rate inlet, or another analysis");
  if (input.probes.stations().empty())
    root.subsection("Probes").refuse("", "linear wave theory has no station to speak of",
                                     "Add a probe with Stations and Fields");
  if (!input.error_norms.empty())
    root.subsection("Exact solution")
        .refuse("", "linear wave theory has no fields to compare with", "Remove the section");
  if (input.time.is_adaptive())
    root.subsection("Time").refuse(
        "Time step control", "linear wave theory makes no steps in time",
        "Remove the entry: Time step is the interval of the theory's table");
  check_nonlinear_waves(input, root);
  StreamReport<dim>::check(input, root);
}

template <int dim>
void LinearWaveTheory<dim>::check_overlay(const Case<dim> &input, ParameterSection root)
{
  TubeWaveCase wave_case;
  const std::string problem = make_tube_wave_case(input, wave_case);
  if (input.wave_theory.overlay_given && !problem.empty())
    root.subsection("Wave theory")
        .refuse("Overlay", "linear wave theory does not cover this case: " + problem,
                "Set Overlay = false");
  if (input.wave_theory.far_end != FarEnd::as_boundary)
    root.subsection("Wave theory")
        .refuse("Far end", "theory beside a run must have the run's own far end",
                "Leave the entry out, or set Analysis = linear wave theory");
  check_nonlinear_waves(input, root);
  if (input.wave_theory.nonlinear && input.probes.stations().empty())
    root.subsection("Wave theory")
        .refuse("Nonlinear", "nonlinear wave theory has no station to speak of",
                "Add a probe with Stations and Fields, or set Nonlinear = false");
}

template <int dim>
void LinearWaveTheory<dim>::name_quantities(const Case<dim> &input, QuantityNames &names)
{
  name_all(input, false, names);
  LoadedTubeReport<dim>::name_quantities(input, names);
  StreamReport<dim>::name_quantities(input, names);
}

template <int dim>
void LinearWaveTheory<dim>::name_quantities_of_comparison(const Case<dim> &input,
                                                          QuantityNames &names)
{
  name_all(input, true, names);
}

template <int dim>
void LinearWaveTheory<dim>::name_all(const Case<dim> &input,
                                     const bool simulated,
                                     QuantityNames &names)
{
  TubeWaveCase wave_case;
  const bool has_theory =
      (!simulated || input.wave_theory.overlay) && make_tube_wave_case(input, wave_case).empty();
  for (const StationsProbe &probe : input.probes.stations())
  {
    std::vector<WaveSource> sources;
    if (simulated)
      sources.push_back(WaveSource::simulated());
    if (has_theory)
      sources.push_back(WaveSource::linear_theory());
    if (input.wave_theory.nonlinear)
      sources.push_back(WaveSource::nonlinear_theory());
    if (input.measured_waves.count(probe.name) > 0)
      sources.push_back(WaveSource::measured());
    // Of the impedances only their presence counts here.
    const bool is_tube = !input.geometry->branches().empty();
    const WaveStations stations{probe.name,
                                probe.positions,
                                probe.fields,
                                {},
                                std::vector<double>(is_tube ? probe.positions.size() : 0, 1.),
                                1.};
    WaveReport::name_quantities(stations, sources, names);
  }
}

template <int dim>
void LinearWaveTheory<dim>::perform()
{
  const double step = run.input.time.time_step, end = run.input.time.end_time;
  std::vector<double> times;
  for (unsigned int i = 0; i * step < end * (1. + 1e-9); ++i)
    times.push_back(std::min(i * step, end));
  report(times, false);
  if (run.input.wave_theory.stream.mean_velocity > 0.)
    run.log.warning(
        "the histories and the dispersion are those of a liquid at rest; with Mean flow "
        "only the speeds on the stream are reported");
  LoadedTubeReport<dim>::add(run);
  StreamReport<dim>::add(run);
  run.finish(0, end);
}

template <int dim>
void LinearWaveTheory<dim>::compare()
{
  if (run.input.probes.stations().empty())
    return;
  // On one rank; what goes wrong there is told on all.
  on_writing_rank(run.input.communicator,
                  [this]()
                  {
                    try
                    {
                      report(run.input.probes.times(), true);
                    }
                    catch (const std::exception &error)
                    {
                      throw RunError(error.what());
                    }
                  });
}

template <int dim>
typename LinearWaveTheory<dim>::OfProbes
LinearWaveTheory<dim>::at_stations(const WaveModel &model,
                                   const TubeWaveCase &wave_case,
                                   const std::vector<double> &times,
                                   const bool simulated)
{
  OfProbes result{model.source(), {}};
  for (const StationsProbe &probe : run.input.probes.stations())
  {
    StationWaves waves = station_waves(probe, model, wave_case, times);
    if (!waves.end.empty())
      run.log.warning("the " + model.source().name + " ends before the run does: " + waves.end);
    result.histories.push_back(std::move(waves.histories));
    // Beside a run only one rank comes here.
    if (!simulated)
      SignalWatch::stop_if_asked(run.input.communicator, "after the waves at the probe '" +
                                                             probe.name +
                                                             "'; begin anew with --overwrite");
  }
  return result;
}

template <int dim>
std::vector<typename LinearWaveTheory<dim>::OfProbes> LinearWaveTheory<dim>::theories(
    const TubeWaveCase &wave_case, const std::vector<double> &times, const bool simulated)
{
  const Case<dim> &input = run.input;
  std::vector<OfProbes> found;
  if (!simulated || input.wave_theory.overlay)
    try
    {
      run.log.note("Computing the waves of the tube by theory; this can take minutes");
      const TubeWaveTheory theory(wave_case.problem, wave_case.inlet, input.time.end_time,
                                  input.wave_theory.spectral_tolerance);
      found.push_back(at_stations(theory, wave_case, times, simulated));
      describe(theory, wave_case);
    }
    catch (const std::exception &error)
    {
      // What was simulated is not lost because theory fails, unless it was asked for.
      if (!simulated || input.wave_theory.overlay_given)
        throw;
      found.clear();
      run.log.warning(std::string("no wave theory beside the run: ") + error.what());
    }
  if (input.wave_theory.nonlinear)
  {
    const std::unique_ptr<NonlinearTubeWaves> theory = make_nonlinear_waves(input, wave_case);
    run.log.detail("Nonlinear wave theory: " + std::to_string(theory->n_cells()) + " cells");
    run.summary.set("cells of the nonlinear wave theory", theory->n_cells() * 1.);
    found.push_back(at_stations(*theory, wave_case, times, simulated));
  }
  return found;
}

template <int dim>
void LinearWaveTheory<dim>::report(const std::vector<double> &times, const bool simulated)
{
  SectionTimer::Scope scope(run.log.timer(), "wave theory");
  const Case<dim> &input = run.input;
  TubeWaveCase wave_case;
  const std::string why_not = make_tube_wave_case(input, wave_case);
  std::vector<OfProbes> of_theories;
  if (why_not.empty())
    of_theories = theories(wave_case, times, simulated);
  else
    run.log.detail("no wave theory: " + why_not);
  const double frequency = load_frequency(wave_case.inlet, input.time.end_time);
  // A run may end before its end time.
  const double end = times.empty() ? input.time.end_time : times.back();
  const Beats beats = beats_of(wave_case.inlet, end);
  const double first_beat_ends = end * beats.second_begins / n_samples_of_load;
  const double period = simulated ? input.periodic_state.period : 0.;
  const double n_beats = period > 0. ? std::floor(end / period * (1. + 1e-9)) : 0.;
  if (n_beats >= 1.)
  {
    std::ostringstream text;
    text << "Pulses, speeds and reflections are those of the last beat, from t = "
         << (n_beats - 1.) * period << " s on, above its start";
    run.log.line(text.str());
  }
  else if (beats.number > 1)
  {
    std::ostringstream text;
    text << "The load has " << beats.number
         << " beats: pulses, speeds and reflections are those of "
         << "the first one, until t = " << first_beat_ends << " s";
    run.log.line(text.str());
  }
  const auto &probes = input.probes.stations();
  for (unsigned int p = 0; p < probes.size(); ++p)
  {
    const StationsProbe &probe = probes[p];
    WaveStations stations{
        probe.name, probe.positions, probe.fields, {}, impedances_of(input, probe, frequency)};
    for (const std::string &field : probe.fields)
      stations.units.push_back(dimension_of_station_field(field).unit());
    if (probe.direction != 0)
      stations.direction = probe.direction;
    else if (!input.geometry->branches().empty())
      stations.direction = direction_of_pulse(input, probe.branch);
    WaveReport report(stations, times);
    if (simulated)
      report.add(WaveSource::simulated(),
                 simulated_histories(probe, probe.columns,
                                     [&](const unsigned int column) -> const std::vector<double> &
                                     { return input.probes.values(column); }));
    for (const OfProbes &theory : of_theories)
      report.add(theory.source, theory.histories[p]);
    const auto measured = input.measured_waves.find(probe.name);
    if (measured != input.measured_waves.end())
      report.add(WaveSource::measured(), measured->second.histories(times));
    if (n_beats >= 1.)
      report.set_beat((n_beats - 1.) * period, n_beats * period);
    else if (beats.number > 1)
      report.set_end_of_first_beat(first_beat_ends);
    const WaveReport::Notes notes = report.add_quantities(run.summary);
    for (const std::string &note : notes.lines)
      run.log.line(note);
    for (const std::string &note : notes.details)
      run.log.detail(note);
    if (run.is_writer)
      report.write(probes.size() == 1 ? run.directory.file("wave.csv")
                                      : run.directory.file_of_case("wave-" + probe.name + ".csv"));
  }
}

template <int dim>
void LinearWaveTheory<dim>::describe(const TubeWaveTheory &theory, const TubeWaveCase &wave_case)
{
  std::ostringstream text;
  text << "Wave theory: " << word_of(wave_level_words(), run.input.wave_theory.level) << ", "
       << wave_case.problem.segments.size()
       << (wave_case.problem.segments.size() == 1 ? " segment" : " segments") << ", up to "
       << theory.highest_frequency() << " Hz, transformed over " << theory.window()
       << " s, of which " << theory.wrap_round() << " wraps round";
  run.log.detail(text.str());
  run.summary.set("wave theory", word_of(wave_level_words(), run.input.wave_theory.level));
  run.citations.add("arb");
  if (!run.is_writer)
    return;
  const double highest = run.input.wave_theory.highest_frequency > 0.
                             ? run.input.wave_theory.highest_frequency
                             : theory.highest_frequency();
  try
  {
    write_dispersion_table(run.directory.file("dispersion.csv"),
                           wave_case.problem.segments.front().section, highest,
                           is_about_loaded_state(run.input));
  }
  catch (const RunError &error)
  {
    run.log.warning(std::string("no dispersion table: ") + error.what());
  }
}

template class LinearWaveTheory<2>;
template class LinearWaveTheory<3>;
} // namespace Continua
