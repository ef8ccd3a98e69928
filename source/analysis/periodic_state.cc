#include <continua/analysis/periodic_state.h>

#include <continua/analysis/beat_columns.h>
#include <continua/base/parameter_text.h>
#include <continua/base/undefined.h>
#include <continua/base/units.h>
#include <continua/case/periodic_loads.h>
#include <continua/continuum/field_list.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace Continua
{
namespace
{
const char *const difference_in_archive = "difference of the last beat";

/// Columns of the table before those of the probes.
constexpr std::size_t n_first_columns = 3;
} // namespace

template <int dim>
PeriodicState<dim>::PeriodicState(Run<dim> &run)
    : run(run), table_file(run.input.communicator), largest_difference(undefined)
{
}

template <int dim>
void PeriodicState<dim>::find_compared()
{
  for (unsigned int column = 0; column < run.input.probes.n_columns(); ++column)
  {
    const ProbeColumnName name = run.input.probes.name_of(column);
    is_compared.push_back(std::any_of(parameters().probes.begin(), parameters().probes.end(),
                                      [&name](const std::string &text)
                                      { return name.is_meant_by(text); }));
  }
}

template <int dim>
std::vector<std::string> PeriodicState<dim>::header() const
{
  std::vector<std::string> names = {"time [s]", "beat [1]", "largest difference [1]"};
  const Probes<dim> &probes = run.input.probes;
  for (unsigned int column = 0; column < probes.n_columns(); ++column)
    for (const BeatColumn &of_beat : beat_columns())
    {
      const ProbeColumnName name = probes.name_of(column);
      const bool is_difference = of_beat.member == &BeatValues::difference;
      names.push_back(name.name + ": " + name.field + ", " + of_beat.column + " [" +
                      (is_difference ? "1" : probes.unit_of(column)) + "]");
    }
  return names;
}

template <int dim>
void PeriodicState<dim>::open()
{
  if (!parameters().is_on)
    return;
  find_compared();
  table_file.open(run.directory.file("beats.csv"), header());
}

template <int dim>
void PeriodicState<dim>::resume(const double time)
{
  if (!parameters().is_on)
    return;
  find_compared();
  table_file.resume(run.directory.file("beats.csv"), header(), time);
  const auto n_beats = static_cast<std::size_t>(
      std::floor((time + 0.25 * run.input.time.time_step) / parameters().period));
  for (std::size_t beat = 1; beat <= n_beats; ++beat)
    evaluate(beat);
  is_at_end_of_beat = ends_beat(time);
}

template <int dim>
bool PeriodicState<dim>::ends_beat(const double time) const
{
  if (!parameters().is_on)
    return false;
  const double n_beats = std::round(time / parameters().period);
  return n_beats > 0.5 &&
         std::abs(time - n_beats * parameters().period) < 0.25 * run.input.time.time_step;
}

template <int dim>
void PeriodicState<dim>::evaluate(const std::size_t number)
{
  const Probes<dim> &probes = run.input.probes;
  const std::size_t n_intervals = intervals_of_beat(run.input);
  std::vector<double> row = {probes.times().at(number * n_intervals), static_cast<double>(number),
                             undefined};
  largest_difference = undefined;
  place_of_largest.clear();
  // A beat before the loads repeat themselves is compared with none, nor is the one after it.
  const std::size_t first = parameters().first_of_loads + 1;
  bool all_are_known = number > first;
  for (unsigned int column = 0; column < probes.n_columns(); ++column)
  {
    const BeatValues values =
        beat_values(probes.times(), probes.values(column), n_intervals, number,
                    run.input.problem.interior.starts_under_mean_loads);
    for (const BeatColumn &of_beat : beat_columns())
      row.push_back(values.*of_beat.member);
    if (number <= first || !is_compared[column] || !all_are_known)
      continue;
    // A position that is not there at some times has not settled.
    all_are_known = !std::isnan(values.difference);
    if (!all_are_known || !(values.difference <= largest_difference))
    {
      largest_difference = values.difference;
      place_of_largest = probes.name_of(column).label();
    }
  }
  row[2] = largest_difference;
  rows.push_back(row);
  if (settled_at == 0 && has_settled())
    settled_at = number;
}

template <int dim>
std::string PeriodicState<dim>::text_of_difference() const
{
  std::ostringstream text;
  text.precision(3);
  text << "beat " << rows.size() << " differs from the one before by " << largest_difference
       << " of its range (" << place_of_largest << ")";
  return text.str();
}

template <int dim>
void PeriodicState<dim>::add_beat(const double time)
{
  const bool had_settled = settled_at > 0;
  evaluate(rows.size() + 1);
  is_at_end_of_beat = true;
  table_file.row(rows.back());
  if (rows.size() <= parameters().first_of_loads + 1)
    return;
  std::ostringstream text;
  text << "t = " << time << " s: " << text_of_difference();
  run.log.line(text.str());
  if ((!had_settled && has_settled()) || ends_run())
    run.log.line("The beats have settled within " + shortest_number(parameters().tolerance) +
                 (ends_run() ? ": the run ends" : ""));
}

template <int dim>
void PeriodicState<dim>::finish()
{
  if (!parameters().is_on || rows.empty())
    return;
  table_file.flush();
  const Probes<dim> &probes = run.input.probes;
  const auto add = [&](const std::string &name, const double value, const std::string &unit,
                       const std::string &label)
  {
    if (std::isfinite(value))
      run.summary.add({name, value, unit, label});
    else
      run.summary.add_absence(name, label,
                              "no beat under the repeated loads comes before the last one, or the "
                              "position is not there at all times");
  };
  std::size_t place = n_first_columns;
  for (unsigned int column = 0; column < probes.n_columns(); ++column)
    for (const BeatColumn &of_beat : beat_columns())
    {
      const ProbeColumnName name = probes.name_of(column);
      const bool is_difference = of_beat.member == &BeatValues::difference;
      add(beat_quantity_name(of_beat, name.field), rows.back()[place++],
          is_difference ? "1" : probes.unit_of(column), name.label());
    }
  add("beats", rows.size(), "1", "");
  add("largest difference of the last beat", largest_difference, "1", "");
  if (settled_at > 0)
    add("first beat that had settled", settled_at, "1", "");
  else
    run.summary.add_absence("first beat that had settled", "", "no beat had settled");
  Summary::Columns columns;
  const std::vector<std::string> names = header();
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    columns.emplace_back(names[i], std::vector<double>());
    for (const std::vector<double> &row : rows)
      columns.back().second.push_back(row[i]);
  }
  run.summary.set("beats", columns);
  if (has_settled())
    return;
  run.log.warning(
      "the beats have not settled: " +
      (std::isnan(largest_difference) ? "there are too few" : text_of_difference()) +
      ", and Periodic state/Tolerance is " + shortest_number(parameters().tolerance) +
      ". Give a later Time/End time" +
      (run.input.problem.interior.starts_under_mean_loads ? "" : ", or Initial state/Type = mean"));
}

template <int dim>
void PeriodicState<dim>::name_quantities(const Case<dim> &input, QuantityNames &names)
{
  if (!input.periodic_state.is_on)
    return;
  for (const ProbeColumnName &column :
       input.probes.expected_columns(field_names<dim>(input.problem)))
    for (const BeatColumn &of_beat : beat_columns())
      names.add(beat_quantity_name(of_beat, column.field), column.label());
  for (const char *const name :
       {"beats", "largest difference of the last beat", "first beat that had settled"})
    names.add(name);
}

template <int dim>
void PeriodicState<dim>::save(ArchiveWriter &archive, const double time) const
{
  archive.add(difference_in_archive,
              ends_beat(time) && ends_run() ? largest_difference : undefined);
}

template <int dim>
bool PeriodicState<dim>::ended_run(const Case<dim> &input, const ArchiveReader &archive)
{
  return input.periodic_state.is_on && input.periodic_state.stops &&
         archive.value(difference_in_archive) <= input.periodic_state.tolerance;
}

template class PeriodicState<2>;
template class PeriodicState<3>;
} // namespace Continua
