#include <continua/laboratory/nonlinear_wave_theory.h>

#include <continua/base/citations.h>
#include <continua/base/interruption.h>
#include <continua/base/six_digits.h>
#include <continua/base/summary.h>
#include <continua/base/table_writer.h>
#include <continua/laboratory/entries_of_a_body.h>
#include <continua/network/period_search.h>
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
  refuse_entries_of_a_body(root, general,
                           "a network has vessels along lines, and no model of a body",
                           "a network has finite volumes along its vessels");
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
  stations = std::make_unique<NetworkStations>(parameters);
  for (std::size_t s = 0; s < stations->n_stations(); ++s)
  {
    for (const NetworkStations::Field &field : stations->fields(s))
      for (const std::string kind : {"largest ", "smallest ", "mean ", "range of "})
        if (field.has_extremes)
          quantities.add(kind + field.name, stations->name(s));
    quantities.add("time of the largest pressure", stations->name(s));
    if (stations->is_chamber(s))
      for (const char *const name : {"stroke volume", "ejection fraction", "stroke work"})
        quantities.add(name, stations->name(s));
  }
  for (const char *const name : {"steps", "largest error of the volume"})
    quantities.add(name);
  if (parameters.period > 0.)
    for (const char *const name : {"beats", "difference of the last beat"})
      quantities.add(name);
  if (parameters.by_newton)
    for (const char *const name : {"Newton iterations", "beats of Newton's method"})
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
                  std::to_string(parameters.nodes.size()) +
                  (parameters.elements.empty()
                       ? ""
                       : ", elements " + std::to_string(parameters.elements.size())) +
                  ", terminals " + std::to_string(parameters.terminals.size()) + ", cells " +
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
  stations->append_values(network, row);
  for (std::size_t i = 0; i < records.histories.size(); ++i)
    records.histories[i].push_back(row[i + 1]);
  if (table != nullptr)
    table->row(row);
}

bool NonlinearWaveTheory::search(const Network &network,
                                 PeriodSearch &period,
                                 const unsigned int beat,
                                 Log &log,
                                 Records &records) const
{
  if (beat == 1)
    return false;
  const std::string text = "Newton's method after the beat " + std::to_string(beat) +
                           ": what the beat has changed is " + six_digits(records.residual) +
                           " of the ranges; ";
  if (period.n_iterations() > 0 && records.residual <= parameters.tolerance)
  {
    log.detail(text + "the state stays");
    return false;
  }
  const unsigned int n_before = period.n_periods();
  const double volume_before = network.volume();
  const bool moved = period.move();
  records.moved_volume += network.volume() - volume_before;
  records.n_iterations = period.n_iterations();
  records.n_search_beats = period.n_periods();
  log.detail(text + std::to_string(period.n_periods() - n_before) + " beats more" +
             (moved ? "" : ", and the state stays"));
  return moved;
}

void NonlinearWaveTheory::run(Network &network,
                              TableWriter *const table,
                              Log &log,
                              Records &records) const
{
  const bool has_beats = parameters.period > 0.;
  const unsigned int n_intervals = parameters.n_intervals();
  const double length = has_beats ? parameters.period : parameters.end_time;
  const auto advance = [&](const double time)
  {
    SignalWatch::stop_if_asked(communicator,
                               "at " + six_digits(network.time()) + " s of the waves");
    network.advance(time, parameters.courant_number, parameters.largest_step());
  };
  PeriodSearch period(network, advance);
  bool has_moved = false; // before the present beat
  record(network, table, records);
  for (unsigned int beat = 1; beat <= (has_beats ? parameters.most_beats : 1); ++beat)
  {
    const std::clock_t begin = std::clock();
    if (parameters.by_newton)
      period.begin();
    for (unsigned int i = 1; i <= n_intervals; ++i)
    {
      advance((beat - 1) * length + i * length / n_intervals);
      record(network, table, records);
      if (parameters.by_newton)
        period.sample();
      log.progress(network.time(), has_beats ? parameters.most_beats * length : length,
                   network.n_steps());
    }
    records.n_beats = beat;
    if (parameters.by_newton)
      records.residual = period.residual();
    log.detail("processor time of " + std::string(has_beats ? "the beat: " : "the run: ") +
               six_digits(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC) + " s");
    if (has_beats && beat > 1)
    {
      records.difference = 0.;
      std::size_t column = 0;
      for (std::size_t s = 0; s < stations->n_stations(); column += stations->fields(s++).size())
        records.difference = std::fmax(
            records.difference,
            difference_of_beat(records.times, records.histories[column], n_intervals, beat));
      // With Newton's method there must be an iterate, the end of the beat before must have been
      // the start of this one, and this one must have left the state as it was.
      records.is_periodic = records.difference <= parameters.tolerance &&
                            (!parameters.by_newton || (period.n_iterations() > 0 && !has_moved &&
                                                       records.residual <= parameters.tolerance));
      if (records.is_periodic)
        break;
    }
    has_moved = parameters.by_newton && beat < parameters.most_beats &&
                search(network, period, beat, log, records);
  }
  log.end_progress();
  if (!has_beats)
    return;
  const std::string text = "The beat " + std::to_string(records.n_beats) +
                           " differs from the one before by " + six_digits(records.difference) +
                           " of the range of a pressure.";
  // With Newton's method it may be round-off, which differs from machine to machine.
  parameters.by_newton ? log.detail(text) : log.line(text);
}

void NonlinearWaveTheory::add_quantities(const Network &network,
                                         const Records &records,
                                         Summary &summary) const
{
  const unsigned int n_intervals = parameters.n_intervals();
  std::size_t column = 0;
  for (std::size_t s = 0; s < stations->n_stations(); column += stations->fields(s++).size())
  {
    const std::string &name = stations->name(s);
    const std::vector<NetworkStations::Field> &fields = stations->fields(s);
    for (std::size_t f = 0; f < fields.size(); ++f)
    {
      if (!fields[f].has_extremes)
        continue;
      const BeatValues values =
          beat_values(records.times, records.histories[column + f], n_intervals, records.n_beats);
      const std::string field = fields[f].name, unit = fields[f].unit;
      summary.add({"largest " + field, values.largest, unit, name});
      summary.add({"smallest " + field, values.smallest, unit, name});
      summary.add({"mean " + field, values.mean, unit, name});
      summary.add({"range of " + field, values.range, unit, name});
    }
    const std::vector<double> &pressure = records.histories[column];
    const auto begin = pressure.end() - (n_intervals + 1);
    const std::size_t first = begin - pressure.begin(),
                      highest = std::max_element(begin, pressure.end()) - begin;
    const std::vector<double> beat_times(records.times.begin() + first, records.times.end()),
        beat(begin, pressure.end());
    summary.add({"time of the largest pressure",
                 refine_extremum(beat_times, beat, highest).time - beat_times.front(), "s", name});
    if (stations->is_chamber(s))
      add_chamber(s, records.histories[column + 1], records.histories[column + 2], records,
                  summary);
  }
  summary.add({"steps", static_cast<double>(network.n_steps()), "1", ""});
  if (parameters.period > 0.)
  {
    summary.add({"beats", static_cast<double>(records.n_beats), "1", ""});
    if (parameters.by_newton)
    {
      summary.add({"Newton iterations", static_cast<double>(records.n_iterations), "1", ""});
      summary.add(
          {"beats of Newton's method", static_cast<double>(records.n_search_beats), "1", ""});
    }
    summary.add({"difference of the last beat", records.difference, "1", ""});
  }
}

void NonlinearWaveTheory::add_chamber(const std::size_t station,
                                      const std::vector<double> &volume,
                                      const std::vector<double> &work,
                                      const Records &records,
                                      Summary &summary) const
{
  const unsigned int n_intervals = parameters.n_intervals();
  const std::string &name = stations->name(station);
  const BeatValues values = beat_values(records.times, volume, n_intervals, records.n_beats);
  summary.add({"stroke volume", values.range, "m^3", name});
  summary.add({"ejection fraction", values.range / values.largest, "1", name});
  summary.add({"stroke work", work.back() - work[work.size() - 1 - n_intervals], "J", name});
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

void NonlinearWaveTheory::write_elements(const OutputDirectory &directory) const
{
  const std::vector<ElementLaw> elements = parameters.circuit().elements;
  TableWriter table(directory.file("network-elements.csv"), {"from node [1]", "to node [1]"});
  // The elements that the file names; what stores liquid has one node.
  for (std::size_t i = 0; i < parameters.elements.size(); ++i)
    table.row({elements[i].from + 1.,
               elements[i].stores() ? elements[i].from + 1. : elements[i].to + 1.});
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
    if (!parameters.elements.empty())
      write_elements(directory);
    std::vector<std::string> columns = {"time [s]"};
    for (const std::string &column : stations->columns())
      columns.push_back(column);
    table = std::make_unique<TableWriter>(directory.file("probes.csv"), columns);
  }
  std::vector<std::string> names;
  for (const VesselEntries &vessel : parameters.vessels)
    names.push_back(vessel.name);
  summary.set("vessels", names);
  summary.set("nodes", parameters.nodes);
  if (!parameters.elements.empty())
  {
    std::vector<std::string> of_elements, types;
    for (const ElementEntries &element : parameters.elements)
    {
      of_elements.push_back(element.law.name);
      types.push_back(element.type_name());
    }
    summary.set("elements", of_elements);
    summary.set("types of elements", types);
  }
  Records records;
  records.histories.resize(stations->n_columns());
  const auto end_with = [&](const std::string &status, const std::string &key, const char *reason)
  {
    log.end_progress();
    summary.set(key, reason);
    summary.set("status", status);
    std::map<std::string, double> largest;
    std::size_t column = 0;
    for (std::size_t s = 0; s < stations->n_stations(); column += stations->fields(s++).size())
      for (const double pressure : records.histories[column])
      {
        double &of_station = largest[stations->name(s) + ": pressure [Pa]"];
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
  const double volume = network.volume(),
               scale = std::fmax(std::abs(volume), std::abs(volume_at_start)),
               error = volume - volume_at_start - network.inflow() - records.moved_volume;
  summary.add({"largest error of the volume", scale > 0. ? std::abs(error) / scale : 0., "1", ""});
  const bool is_periodic = parameters.period == 0. || records.is_periodic;
  const std::string failure =
      "after " + std::to_string(records.n_beats) +
      " beats there is no periodic state to the tolerance of " + six_digits(parameters.tolerance) +
      ": the last beat differs by " + six_digits(records.difference) +
      (parameters.by_newton
           ? " and has changed the state by " + six_digits(records.residual) + " of its ranges, " +
                 (records.n_iterations == 0 ? "and Newton's method has made no iterate"
                                            : "after " + std::to_string(records.n_iterations) +
                                                  " iterations of Newton's method")
           : "") +
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
