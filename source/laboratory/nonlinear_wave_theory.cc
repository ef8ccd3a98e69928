#include <continua/laboratory/nonlinear_wave_theory.h>

#include <continua/base/citations.h>
#include <continua/base/interruption.h>
#include <continua/base/six_digits.h>
#include <continua/base/summary.h>
#include <continua/base/table_writer.h>
#include <continua/postprocess/writing_rank.h>
#include <continua/signal/beat_values.h>
#include <continua/signal/first_pulse.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>

namespace Continua
{
namespace
{
constexpr const char *recorded_fields[] = {"pressure", "flow rate", "area"};
constexpr const char *recorded_units[] = {"Pa", "m^3/s", "m^2"};
constexpr unsigned int n_station_fields = 3;

/// Of a pressure over the pressure [1]: a smaller range is no wave, but what is left of one.
constexpr double smallest_range = 1e-8;

/// The largest difference of a pressure [Pa] from that a beat before, over its range.
double difference_of_beat(const std::vector<double> &times,
                          const std::vector<double> &pressure,
                          const unsigned int n_intervals,
                          const unsigned int beat)
{
  const BeatValues values = beat_values(times, pressure, n_intervals, beat);
  const double floor =
      smallest_range * std::fmax(std::abs(values.largest), std::abs(values.smallest));
  if (values.range > floor)
    return values.difference;
  double largest = 0.;
  const std::size_t last = static_cast<std::size_t>(beat) * n_intervals;
  for (std::size_t i = last - n_intervals; i <= last; ++i)
    largest = std::fmax(largest, std::abs(pressure[i] - pressure[i - n_intervals]));
  return largest > 0. ? largest / floor : 0.;
}
} // namespace

NonlinearWaveTheory::NonlinearWaveTheory(const AnalysisInput &input) : Analysis(input)
{
  ParameterSection root = file.root(), section = root.subsection("Network");
  // The defaults stand in every file that --print-parameters writes.
  if (general.model != GeneralParameters().model)
    root.refuse("Model", "a network has vessels along lines, and no model of a body", "Remove it");
  if (general.discretisation != GeneralParameters().discretisation)
    root.refuse("Discretisation", "a network has finite volumes along its vessels", "Remove it");
  parameters.read(section);
  parameters.read_materials(section, root.subsection("Materials"));
  expected = read_expected(root.subsection("Expected"));
  file.refuse_unknown();
  parameters.check(section);
  try
  {
    parameters.make();
  }
  catch (const std::domain_error &error)
  {
    section.refuse("Initial pressure", error.what(),
                   "Give a pressure nearer to the Reference pressure, or a stiffer wall");
  }
  for (const NetworkParameters::Station &station : parameters.stations)
  {
    for (const std::string field : recorded_fields)
      for (const std::string kind : {"largest ", "smallest ", "mean ", "range of "})
        quantities.add(kind + field, station.name);
    quantities.add("time of the largest pressure", station.name);
  }
  for (const char *const name : {"steps", "largest error of the volume"})
    quantities.add(name);
  if (parameters.period > 0.)
    for (const char *const name : {"beats", "difference of the last beat"})
      quantities.add(name);
  quantities.refuse_unknown(file, root.subsection("Expected"), expected);
}

std::vector<std::string> NonlinearWaveTheory::outline() const
{
  std::vector<std::string> lines = Analysis::outline();
  unsigned int n_cells = 0;
  for (const VesselEntries &vessel : parameters.vessels)
    n_cells += parameters.n_cells(vessel);
  lines.push_back("network: vessels " + std::to_string(parameters.vessels.size()) + ", nodes " +
                  std::to_string(parameters.nodes.size()) + ", terminals " +
                  std::to_string(parameters.terminals.size()) + ", cells " +
                  std::to_string(n_cells));
  lines.push_back(parameters.period > 0.
                      ? "beats of " + six_digits(parameters.period) + " s, at most " +
                            std::to_string(parameters.most_beats)
                      : "to " + six_digits(parameters.end_time) + " s");
  const double duration = parameters.period > 0. ? parameters.period : parameters.end_time;
  lines.push_back("a row of probes.csv every " + six_digits(duration / parameters.n_intervals()) +
                  " s");
  return lines;
}

void NonlinearWaveTheory::record(const Network &network,
                                 TableWriter *const table,
                                 Records &records) const
{
  records.times.push_back(network.time());
  std::vector<double> row = {network.time()};
  for (std::size_t s = 0; s < parameters.stations.size(); ++s)
  {
    const NetworkParameters::Station &station = parameters.stations[s];
    const Vessel::Values values = network.vessel(station.vessel_number).values(station.position);
    History &history = records.stations[s];
    history.pressure.push_back(values.pressure);
    history.flow_rate.push_back(values.flow);
    history.area.push_back(values.area);
    row.insert(row.end(), {values.pressure, values.flow, values.area});
  }
  if (table != nullptr)
    table->row(row);
}

void NonlinearWaveTheory::run(Network &network,
                              TableWriter *const table,
                              Log &log,
                              Records &records) const
{
  const bool has_beats = parameters.period > 0.;
  const unsigned int n_intervals = parameters.n_intervals();
  const double length = has_beats ? parameters.period : parameters.end_time;
  record(network, table, records);
  for (unsigned int beat = 1; beat <= (has_beats ? parameters.most_beats : 1); ++beat)
  {
    const std::clock_t begin = std::clock();
    for (unsigned int i = 1; i <= n_intervals; ++i)
    {
      SignalWatch::stop_if_asked(communicator,
                                 "at " + six_digits(network.time()) + " s of the waves");
      network.advance((beat - 1) * length + i * length / n_intervals, parameters.courant_number);
      record(network, table, records);
      log.progress(network.time(), has_beats ? parameters.most_beats * length : length,
                   network.n_steps());
    }
    records.n_beats = beat;
    log.detail("processor time of " + std::string(has_beats ? "the beat: " : "the run: ") +
               six_digits(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC) + " s");
    if (!has_beats || beat == 1)
      continue;
    records.difference = 0.;
    for (const History &history : records.stations)
      records.difference =
          std::fmax(records.difference,
                    difference_of_beat(records.times, history.pressure, n_intervals, beat));
    if (records.difference <= parameters.tolerance)
      break;
  }
  log.end_progress();
  if (!has_beats)
    return;
  log.line("The beat " + std::to_string(records.n_beats) + " differs from the one before by " +
           six_digits(records.difference) + " of the range of a pressure.");
}

void NonlinearWaveTheory::add_quantities(const Network &network,
                                         const Records &records,
                                         Summary &summary) const
{
  const unsigned int n_intervals = parameters.n_intervals();
  for (std::size_t s = 0; s < parameters.stations.size(); ++s)
  {
    const std::string &name = parameters.stations[s].name;
    const History &history = records.stations[s];
    const std::vector<double> *const fields[] = {&history.pressure, &history.flow_rate,
                                                 &history.area};
    for (unsigned int f = 0; f < n_station_fields; ++f)
    {
      const BeatValues values =
          beat_values(records.times, *fields[f], n_intervals, records.n_beats);
      const std::string field = recorded_fields[f], unit = recorded_units[f];
      summary.add({"largest " + field, values.largest, unit, name});
      summary.add({"smallest " + field, values.smallest, unit, name});
      summary.add({"mean " + field, values.mean, unit, name});
      summary.add({"range of " + field, values.range, unit, name});
    }
    const auto begin = history.pressure.end() - (n_intervals + 1);
    const std::size_t first = begin - history.pressure.begin(),
                      highest = std::max_element(begin, history.pressure.end()) - begin;
    const std::vector<double> beat_times(records.times.begin() + first, records.times.end()),
        beat(begin, history.pressure.end());
    summary.add({"time of the largest pressure",
                 refine_extremum(beat_times, beat, highest).time - beat_times.front(), "s", name});
  }
  summary.add({"steps", static_cast<double>(network.n_steps()), "1", ""});
  if (parameters.period > 0.)
  {
    summary.add({"beats", static_cast<double>(records.n_beats), "1", ""});
    summary.add({"difference of the last beat", records.difference, "1", ""});
  }
}

void NonlinearWaveTheory::write_vessels(const OutputDirectory &directory,
                                        const Network &network) const
{
  TableWriter table(directory.file("network-vessels.csv"),
                    {"from node [1]", "to node [1]", "length [m]", "radius at start [m]",
                     "radius at end [m]", "cells [1]"});
  for (unsigned int i = 0; i < network.n_vessels(); ++i)
  {
    const VesselEntries &vessel = parameters.vessels[i];
    const auto number = [this](const std::string &node)
    {
      return std::find(parameters.nodes.begin(), parameters.nodes.end(), node) -
             parameters.nodes.begin() + 1.;
    };
    table.row({number(vessel.from), number(vessel.to), vessel.length, vessel.radius_at_start,
               vessel.radius_at_end, static_cast<double>(network.vessel(i).n_cells())});
  }
  table.flush();
}

void NonlinearWaveTheory::compute(const OutputDirectory &directory, Log &log, Summary &summary)
{
  summary.set_possible(quantities);
  for (const std::string &line : outline())
    log.line(line);
  Network network = parameters.make();
  const double volume_at_start = network.volume();
  std::unique_ptr<TableWriter> table;
  if (is_writing_rank(communicator))
  {
    write_vessels(directory, network);
    std::vector<std::string> columns = {"time [s]"};
    for (const NetworkParameters::Station &station : parameters.stations)
      for (unsigned int f = 0; f < n_station_fields; ++f)
        columns.push_back(station.name + ": " + recorded_fields[f] + " [" + recorded_units[f] +
                          "]");
    table = std::make_unique<TableWriter>(directory.file("probes.csv"), columns);
  }
  std::vector<std::string> names;
  for (const VesselEntries &vessel : parameters.vessels)
    names.push_back(vessel.name);
  summary.set("vessels", names);
  summary.set("nodes", parameters.nodes);
  Records records;
  records.stations.resize(parameters.stations.size());
  const auto end_with = [&](const std::string &status, const std::string &key, const char *reason)
  {
    log.end_progress();
    summary.set(key, reason);
    summary.set("status", status);
    std::map<std::string, double> largest;
    for (std::size_t s = 0; s < records.stations.size(); ++s)
      for (const double pressure : records.stations[s].pressure)
      {
        double &of_station = largest[parameters.stations[s].name + ": pressure [Pa]"];
        of_station = std::fmax(of_station, std::abs(pressure));
      }
    summary.set("largest values", largest);
    if (!table)
      return;
    table->flush();
    summary.write(directory.file("summary.json"));
  };
  try
  {
    run(network, table.get(), log, records);
  }
  catch (const Interrupted &reason)
  {
    end_with("interrupted", "interruption", reason.what());
    throw;
  }
  catch (const StepFailure &reason)
  {
    end_with("failed", "failure", reason.what());
    throw;
  }
  if (table)
    table->flush();
  add_quantities(network, records, summary);
  summary.add({"largest error of the volume",
               std::abs(network.volume() - volume_at_start - network.inflow()) / volume_at_start,
               "1", ""});
  const bool is_periodic = parameters.period == 0. || records.difference <= parameters.tolerance;
  const std::string failure =
      "after " + std::to_string(records.n_beats) +
      " beats there is no periodic state to the tolerance of " + six_digits(parameters.tolerance) +
      ": the last beat differs by " + six_digits(records.difference) +
      ". Raise Network/Most beats or Network/Tolerance, or look for what never repeats itself";
  summary.set("status", is_periodic ? "finished" : "failed");
  if (!is_periodic)
    summary.set("failure", failure);
  bool all_passed = true;
  for (const std::string &verdict : summary.check(expected, all_passed))
    log.line(verdict);
  if (is_writing_rank(communicator))
  {
    summary.write(directory.file("summary.json"));
    Citations().write(directory.file("citation.bib"));
  }
  if (!is_periodic)
    throw RunError(failure);
}
} // namespace Continua
