#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/base/misfit.h>
#include <continua/base/parameter_text.h>
#include <continua/base/quoted_name.h>
#include <continua/postprocess/probes.h>

#include <continua/postprocess/writing_rank.h>
#include <continua/signal/last_periods.h>
#include <continua/signal/signal_analysis.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace Continua
{
namespace
{
/// The first row of probes.csv.
std::vector<std::string> header(const std::vector<std::string> &column_names)
{
  std::vector<std::string> names = {"time [s]"};
  names.insert(names.end(), column_names.begin(), column_names.end());
  return names;
}

/// Of a probe [bytes]: with what stands around it in the name of a file, below the limit of 255.
constexpr std::size_t longest_name = 200;
} // namespace

template <int dim>
Probes<dim>::Probes(const MPI_Comm communicator)
    : communicator(communicator), run_table(communicator)
{
}

template <int dim>
void Probes<dim>::read(ParameterSection section,
                       const std::vector<std::string> &boundaries,
                       const std::vector<std::string> &regions,
                       const std::vector<VesselBranch<dim>> &branches,
                       const std::vector<NamedInterface> &interfaces)
{
  for (const std::string &name : section.subsections())
  {
    const ParameterSection child = section.subsection(name);
    if (name.find('/') != std::string::npos)
      child.refuse("", "the name of a probe has a '/', which files cannot have in their names",
                   "Call it otherwise");
    if (collapse_blanks(name) != name && without_quotes(name) == name)
      child.refuse("", "the name of a probe has blanks at an end, or several together",
                   "Write it without them");
    if (name.size() > longest_name)
      child.refuse("",
                   "the name of a probe has " + std::to_string(name.size()) +
                       " bytes, and files are named after it, whose names end at 255",
                   "Give it a name of " + std::to_string(longest_name) + " bytes or less");
    probes.emplace_back(child, boundaries, regions, branches, interfaces);
    const Stations<dim> &stations = probes.back().stations;
    if (stations.given())
      stations_probes.push_back(
          {child, name, stations.positions(), stations.fields(), stations.branch(),
           stations.pair_distance(), stations.pair_offset(), stations.direction(),
           std::vector<std::vector<unsigned int>>(stations.positions().size())});
  }
}

template <int dim>
void Probes<dim>::check(const dealii::Triangulation<dim> &coarse_mesh,
                        const std::vector<FieldComponent> &fields,
                        const std::set<std::pair<unsigned int, unsigned int>> &boundary_regions)
{
  for (ProbeEntries<dim> &probe : probes)
    probe.check(coarse_mesh, fields, boundary_regions);
  std::set<std::string> names;
  for (const ProbeEntries<dim> &probe : probes)
    for (const ProbeColumnName &column : columns_of(probe, fields))
      if (const std::string name = column.name + ": " + column.field; !names.insert(name).second)
        probe.section.refuse("",
                             "two columns of probes.csv would have the name '" + name +
                                 "', this one and that of another probe, station or field",
                             "Rename this probe, or record the field once");
}

template <int dim>
void Probes<dim>::check_limits(const std::vector<BoundaryCondition> &conditions,
                               const ProbeLimits &limits,
                               const std::vector<FieldComponent> &fields) const
{
  for (const ProbeEntries<dim> &probe : probes)
    probe.check_limits(conditions, limits, fields);
}

template <int dim>
bool Probes<dim>::asks_for_averages(const std::vector<FieldComponent> &fields) const
{
  return std::any_of(probes.begin(), probes.end(),
                     [&fields](const ProbeEntries<dim> &probe)
                     { return probe.asks_for_averages(fields); });
}

template <int dim>
void Probes<dim>::attach(ContinuumSolver<dim> &continuum_solver,
                         const Model model,
                         const bool mesh_moves)
{
  solver = &continuum_solver;
  for (unsigned int p = 0; p < probes.size(); ++p)
    if (probes[p].stations.given())
      attach_stations(p, model, mesh_moves);
    else
      attach_fields(p, model);
}

template <int dim>
typename Probes<dim>::Terms
Probes<dim>::add_to_solver(const ProbeEntries<dim> &probe,
                           const std::vector<std::pair<ProbeRequest<dim>, double>> &requests)
{
  using Place = typename ProbeEntries<dim>::Place;
  Terms terms;
  try
  {
    for (const auto &[request, factor] : requests)
      terms.emplace_back(solver->add_probe(request), factor);
    return terms;
  }
  catch (const std::invalid_argument &error)
  {
    const std::map<Place, std::string> remedies = {
        {Place::point, "Give a point of the undeformed body, in the Region if there is one"},
        {Place::boundary,
         "Give a boundary on which the field exists, next to the Region if there is one"},
        {Place::interface, "Give two regions that meet"},
        {Place::section, "Give a position at which the plane cuts the body, or the Region"},
        {Place::volume, "Give a region that meets another one, or leave 'volume change' out"},
        {Place::stations, "Give positions inside the tube"}};
    probe.section.refuse(word_of(ProbeEntries<dim>::place_words(), probe.place), error.what(),
                         remedies.at(probe.place));
  }
}

template <int dim>
void Probes<dim>::attach_fields(const unsigned int p, const Model model)
{
  const std::vector<typename ProbeEntries<dim>::Recorded> recorded =
      probes[p].recorded(solver->fields(), model);
  for (const auto &entry : recorded)
    columns.push_back({p,
                       probes[p].section.name(),
                       entry.field,
                       recorded.size() == 1,
                       add_to_solver(probes[p], entry.terms),
                       {},
                       {},
                       {}});
}

template <int dim>
void Probes<dim>::attach_stations(const unsigned int p, const Model model, const bool mesh_moves)
{
  const ProbeEntries<dim> &probe = probes[p];
  const Stations<dim> &stations = probe.stations;
  StationsProbe &entry = *std::find_if(stations_probes.begin(), stations_probes.end(),
                                       [&probe](const StationsProbe &other)
                                       { return other.name == probe.section.name(); });
  for (const typename Stations<dim>::Column &column : stations.columns())
  {
    entry.columns[column.station].push_back(n_columns());
    columns.push_back({p,
                       entry.name + " " + stations.label(column.station),
                       column.field,
                       entry.fields.size() == 1,
                       add_to_solver(probe, column.terms),
                       {},
                       column.line,
                       {}});
    // In axisymmetry the middles of sections stay on the axis.
    for (const auto &of_component : column.movements)
      if (mesh_moves && (model != Model::axisymmetric || columns.back().movements.empty()))
        columns.back().movements.push_back(add_to_solver(probe, of_component));
  }
}

template <int dim>
std::vector<std::string> Probes<dim>::column_names() const
{
  std::vector<std::string> names;
  for (const Column &column : columns)
    names.push_back(column.name + ": " + column.field.name + " [" + column.field.unit + "]");
  return names;
}

template <int dim>
void Probes<dim>::open(const std::string &file)
{
  if (columns.empty())
    return;
  run_table.open(file, header(column_names()));
}

template <int dim>
void Probes<dim>::open(const std::string &file, const double restart_time)
{
  if (columns.empty())
    return;
  run_table.resume(file, header(column_names()), restart_time);
  on_writing_rank(communicator, [&]() { read_history(file); });
  record_times = broadcast(communicator, record_times);
  for (Column &column : columns)
    column.values = broadcast(communicator, column.values);
}

template <int dim>
void Probes<dim>::read_history(const std::string &file)
{
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw RunError("cannot continue '" + file + "': it cannot be read");
  std::string line;
  std::getline(stream, line); // the header, which the table writer has checked
  while (std::getline(stream, line))
  {
    const char *begin = line.data();
    const char *const end = begin + line.size();
    for (unsigned int i = 0; i <= columns.size(); ++i)
    {
      double value = 0.;
      const std::from_chars_result result = std::from_chars(begin, end, value);
      const bool complete =
          i < columns.size() ? result.ptr != end && *result.ptr == ',' : result.ptr == end;
      if (result.ec != std::errc() || !complete)
        throw RunError("cannot continue '" + file + "': the row '" + line + "' is damaged");
      (i == 0 ? record_times : columns[i - 1].values).push_back(value);
      begin = result.ptr + 1;
    }
  }
  if (stream.bad())
    throw RunError("cannot continue '" + file + "': it cannot be read");
}

template <int dim>
std::vector<double> Probes<dim>::present_values()
{
  if (columns.empty())
    return {};
  solver->evaluate_probes(solver_values);
  std::vector<double> values;
  for (const Column &column : columns)
  {
    dealii::Tensor<1, dim> present = column.line;
    for (unsigned int c = 0; c < column.movements.size(); ++c)
      present[c] += sum_of(column.movements[c]);
    const double value = sum_of(column.terms);
    values.push_back(column.movements.empty() ? value
                                              : value * column.line.norm() / present.norm());
  }
  return values;
}

template <int dim>
double Probes<dim>::sum_of(const Terms &terms) const
{
  double sum = 0.;
  for (const auto &[number, factor] : terms)
    sum += factor * solver_values[number];
  return sum;
}

template <int dim>
void Probes<dim>::record(const double time)
{
  if (!columns.empty())
    record(time, present_values());
}

template <int dim>
void Probes<dim>::record(const double time, const std::vector<double> &values)
{
  if (columns.empty())
    return;
  record_times.push_back(time);
  row.assign(1, time);
  row.insert(row.end(), values.begin(), values.end());
  for (unsigned int i = 0; i < columns.size(); ++i)
    columns[i].values.push_back(values[i]);
  run_table.row(row);
}

template <int dim>
void Probes<dim>::add_quantities(const Column &column,
                                 Summary &summary,
                                 std::vector<std::string> &warnings) const
{
  const ProbeEntries<dim> &probe = probes[column.probe];
  const std::string &field = column.field.name;
  const std::string &unit = column.field.unit;
  const std::string label = column.name + (column.alone ? std::string() : ": " + field);
  const auto add = [&](const std::string &name, const double value, const std::string &unit_of_it)
  {
    if (!std::isnan(value))
      summary.add({name, value, unit_of_it, label});
  };
  const auto add_or_say_why = [&](const std::string &name, const double value,
                                  const std::string &unit_of_it, const std::string &reason)
  {
    add(name, value, unit_of_it);
    if (std::isnan(value))
      summary.add_absence(name, label, reason);
  };

  // A position that is not there at some times has no history to look at.
  const bool is_whole = std::none_of(column.values.begin(), column.values.end(),
                                     [](const double value) { return std::isnan(value); });
  if (record_times.size() > 1 && is_whole)
  {
    const SignalAnalysis signal = analyse_signal(record_times, column.values);
    add("maximum " + field, signal.maximum, unit);
    add("time of maximum " + field, signal.time_of_maximum, "s");
    add("minimum " + field, signal.minimum, unit);
    add("time of minimum " + field, signal.time_of_minimum, "s");
    const char *const no_maximum =
        "the history does not rise and fall again by a twentieth of its range";
    add_or_say_why("first maximum " + field, signal.first_maximum, unit, no_maximum);
    add_or_say_why("time of first maximum " + field, signal.time_of_first_maximum, "s", no_maximum);
    add("mean " + field, signal.mean, unit);
    add_or_say_why("frequency", signal.frequency_zero_crossings, "Hz",
                   "the history does not go up through its mean twice");
    const char *const no_fit = "no damped oscillation of which the history holds a period explains "
                               "half of its variance";
    add_or_say_why("frequency of the fit", signal.frequency_fit, "Hz", no_fit);
    add_or_say_why("decay per oscillation", signal.decay_per_oscillation_fit, "1", no_fit);
    add_or_say_why("fit residual", signal.fit_residual, "1", no_fit);
  }
  add("final " + field, column.values.back(), unit);

  if (probe.last_periods > 0)
  {
    const LastPeriods periods =
        analyse_last_periods(record_times, column.values, probe.last_periods);
    const std::string of_periods = " of the last periods";
    add("mean " + field + of_periods, periods.mean, unit);
    add("middle " + field + of_periods, periods.middle, unit);
    add("amplitude " + field + of_periods, periods.amplitude, unit);
    add("frequency" + of_periods, periods.frequency, "Hz");
    add("change of amplitude" + of_periods, periods.change_of_amplitude, "1");
    if (std::isnan(periods.frequency))
    {
      const std::string reason =
          "does not end with " + std::to_string(probe.last_periods) +
          (probe.last_periods == 1 ? " period" : " periods of about one length");
      warnings.push_back("the history of " + field + " of the probe '" + column.name + "' " +
                         reason);
      for (const std::string &name : {"mean " + field, "middle " + field, "amplitude " + field,
                                      std::string("frequency"), std::string("change of amplitude")})
        summary.add_absence(name + of_periods, label, "the history " + reason);
    }
  }
  if (probe.modes.empty())
    return;
  // An offset, and four numbers a mode.
  const bool enough = is_whole && record_times.size() > 1 + 4 * probe.modes.size();
  const DampedSineFit fit =
      enough ? fit_damped_sines(record_times, column.values, probe.modes) : DampedSineFit();
  if (!enough || !fit.converged)
  {
    warnings.push_back("the modes could not be fitted to " + field + " of the probe '" +
                       column.name +
                       "': " + (enough ? "the fit did not converge" : "it has too few rows"));
    return;
  }
  for (unsigned int m = 0; m < fit.components.size(); ++m)
  {
    const DampedSine &mode = fit.components[m];
    const std::string name = "mode " + std::to_string(m + 1);
    add(name + " frequency", mode.frequency, "Hz");
    add(name + " decay per oscillation", std::exp(-mode.decay_rate / mode.frequency), "1");
    add(name + " amplitude", mode.amplitude, unit);
  }
  if (const std::string warning =
          misfit_warning("Probes: the modes of " + field + " of the probe '" + column.name + "'",
                         fit.residual, "root of the mean square, of the first mode's amplitude",
                         "Give more Modes, or a longer history");
      !warning.empty())
    warnings.push_back(warning);
  add("modes offset", fit.offset, unit);
  add("modes residual", fit.residual, "1");
}

template <int dim>
void Probes<dim>::flush_to_disk()
{
  run_table.flush_to_disk();
}

template <int dim>
std::optional<WrittenTable> Probes<dim>::table() const
{
  return run_table.written();
}

template <int dim>
void Probes<dim>::flush()
{
  run_table.flush();
}

template <int dim>
std::vector<std::string> Probes<dim>::finish(Summary &summary)
{
  flush();
  std::vector<std::string> warnings;
  if (!record_times.empty())
    for (const Column &column : columns)
      if (probes[column.probe].signal_analysis)
        add_quantities(column, summary, warnings);
  return warnings;
}

template <int dim>
ProbeColumnName Probes<dim>::name_of(const unsigned int column) const
{
  const Column &of = columns[column];
  return {probes[of.probe].section.name(), of.name, of.field.name, of.alone};
}

template <int dim>
std::vector<ProbeColumnName>
Probes<dim>::expected_columns(const std::vector<FieldComponent> &fields) const
{
  std::vector<ProbeColumnName> all;
  for (const ProbeEntries<dim> &probe : probes)
    for (const ProbeColumnName &column : columns_of(probe, fields))
      all.push_back(column);
  return all;
}

template <int dim>
std::vector<ProbeColumnName>
Probes<dim>::columns_of(const ProbeEntries<dim> &probe,
                        const std::vector<FieldComponent> &fields) const
{
  // As attach() makes them.
  const std::string &name = probe.section.name();
  std::vector<ProbeColumnName> result;
  if (probe.stations.given())
    for (const typename Stations<dim>::Column &column : probe.stations.columns())
      result.push_back({name, name + " " + probe.stations.label(column.station), column.field.name,
                        probe.stations.fields().size() == 1});
  else
    for (const auto &entry : probe.recorded(fields, Model::plane_strain))
      result.push_back({name, name, entry.field.name, true});
  if (!probe.stations.given() && result.size() > 1)
    for (ProbeColumnName &column : result)
      column.alone = false;
  return result;
}

template <int dim>
void Probes<dim>::name_quantities(const std::vector<FieldComponent> &fields,
                                  const bool is_steady,
                                  QuantityNames &names) const
{
  for (const ProbeEntries<dim> &probe : probes)
  {
    if (!probe.signal_analysis)
      continue;
    for (const ProbeColumnName &column : columns_of(probe, fields))
    {
      const std::string &field = column.field, label = column.label();
      names.add("final " + field, label);
      if (is_steady)
        continue;
      for (const char *const what : {"maximum ", "time of maximum ", "minimum ", "time of minimum ",
                                     "first maximum ", "time of first maximum ", "mean "})
        names.add(what + field, label);
      for (const char *const what :
           {"frequency", "frequency of the fit", "decay per oscillation", "fit residual"})
        names.add(what, label);
      for (std::size_t m = 1; m <= probe.modes.size(); ++m)
        for (const char *const what : {" frequency", " decay per oscillation", " amplitude"})
          names.add("mode " + std::to_string(m) + what, label);
      if (probe.last_periods > 0)
      {
        for (const char *const what : {"mean ", "middle ", "amplitude "})
          names.add(what + field + " of the last periods", label);
        names.add("frequency of the last periods", label);
        if (probe.last_periods > 1)
          names.add("change of amplitude of the last periods", label);
      }
      if (!probe.modes.empty())
      {
        names.add("modes offset", label);
        names.add("modes residual", label);
      }
    }
  }
}

template class Probes<2>;
template class Probes<3>;
} // namespace Continua
