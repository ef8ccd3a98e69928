#include <continua/studies/refinement_report.h>

#include <continua/base/atomic_file.h>
#include <continua/base/citations.h>
#include <continua/base/input_error.h>
#include <continua/base/text_table.h>
#include <continua/base/undefined.h>
#include <continua/base/units.h>
#include <continua/studies/chosen_quantities.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Continua
{
namespace
{
double quantity_or(const RunResult &run, const std::string &name, const double otherwise)
{
  const Quantity *const quantity = find_quantity(run, name);
  return quantity == nullptr ? otherwise : quantity->value;
}

/// Over the time, where the mesh changes [1].
double mean_cells(const RunResult &run)
{
  return quantity_or(run, "cells (mean)", run.n_cells);
}
double mean_unknowns(const RunResult &run)
{
  return quantity_or(run, "unknowns (mean)", run.n_dofs);
}

/// "1 %", of a relative error.
std::string percent_text(const double level)
{
  return number_text(100. * level, 6) + " %";
}

/// A reference in the unit of the quantity; throws std::invalid_argument.
double in_unit(const ExpectedValue &reference, const std::string &unit)
{
  if (reference.unit.empty())
    return reference.value;
  Dimension given, wanted;
  const double factor = unit_factor(reference.unit, given) / unit_factor(unit, wanted);
  if (!(given == wanted))
    throw std::invalid_argument("'" + reference.unit + "' is no unit of a quantity in '" + unit +
                                "'");
  return factor * reference.value;
}

bool is_of(const ExpectedValue &reference, const std::string &label)
{
  const std::string name =
      reference.probe.empty() ? reference.name : reference.probe + ": " + reference.name;
  const std::string end = ": " + name;
  return label == name || (reference.probe.empty() && label.size() > end.size() &&
                           label.compare(label.size() - end.size(), end.size(), end) == 0);
}
} // namespace

double RefinementReport::Row::scale() const
{
  return std::abs(reference) > round_off ? std::abs(reference) : 1.;
}

double RefinementReport::Curve::unknowns_at(const double error) const
{
  std::vector<unsigned int> known;
  for (unsigned int i = 0; i < errors.size(); ++i)
    if (!std::isnan(errors[i]))
      known.push_back(i);
  std::size_t first = known.size();
  while (first > 0 && errors[known[first - 1]] <= error)
    --first;
  if (first == 0 || first == known.size())
    return undefined;
  const unsigned int above = known[first - 1], below = known[first];
  if (errors[below] == 0.)
    return unknowns[below];
  const double share = std::log(errors[above] / error) / std::log(errors[above] / errors[below]);
  return unknowns[above] * std::pow(unknowns[below] / unknowns[above], share);
}

double RefinementReport::Curve::last_error() const
{
  for (std::size_t i = errors.size(); i > 0; --i)
    if (!std::isnan(errors[i - 1]))
      return errors[i - 1];
  return undefined;
}

double RefinementReport::Curve::last_order() const
{
  for (std::size_t i = errors.size(); i > 0; --i)
    if (!std::isnan(errors[i - 1]))
      return orders[i - 1];
  return undefined;
}

RefinementReport::RefinementReport(const RefinementStudyParameters &parameters,
                                   const unsigned int dimension,
                                   const std::vector<StudiedRun> &runs)
    : parameters(parameters), dimension(dimension), runs(runs)
{
  std::vector<RunResult> finished;
  for (const StudiedRun &run : runs)
    if (run.failure.empty())
      finished.push_back(run);
  std::map<std::string, double> largest; // by unit
  for (const std::string &label : chosen_labels(parameters.quantities, finished))
  {
    Row row;
    row.label = label;
    for (const RunResult &run : finished)
      if (const Quantity *const quantity = find_quantity(run, label))
      {
        row.unit = quantity->unit;
        largest[row.unit] = std::max(largest[row.unit], std::abs(quantity->value));
      }
    all_rows.push_back(row);
  }
  for (const ExpectedValue &reference : parameters.references)
    if (!finished.empty() &&
        std::none_of(all_rows.begin(), all_rows.end(),
                     [&](const Row &row) { return is_of(reference, row.label); }))
      throw RunError("Refinement study/Reference: no run has the quantity '" +
                     (reference.probe.empty() ? "" : reference.probe + ": ") + reference.name +
                     "', or it is not asked for");
  for (Row &row : all_rows)
  {
    row.round_off = round_off_share * largest[row.unit];
    set_reference(row);
    for (unsigned int variant = 0; variant < parameters.variants.size(); ++variant)
      row.curves.push_back(curve(row, variant));
  }
}

void RefinementReport::set_reference(Row &row) const
{
  for (const ExpectedValue &reference : parameters.references)
    if (is_of(reference, row.label))
      try
      {
        row.reference = in_unit(reference, row.unit);
        return;
      }
      catch (const std::invalid_argument &error)
      {
        throw RunError("Refinement study/Reference: " + row.label + ": " + error.what());
      }
  double most = -1.;
  for (const StudiedRun &run : runs)
    if (const Quantity *const quantity =
            run.failure.empty() ? find_quantity(run, row.label) : nullptr)
      if (mean_unknowns(run) > most)
      {
        most = mean_unknowns(run);
        row.reference = quantity->value;
        row.reference_run = run.name;
      }
}

RefinementReport::Curve RefinementReport::curve(const Row &row, const unsigned int variant) const
{
  Curve result;
  for (unsigned int number = 0; number < runs.size(); ++number)
  {
    const StudiedRun &run = runs[number];
    const Quantity *const quantity =
        run.variant == variant && run.failure.empty() ? find_quantity(run, row.label) : nullptr;
    if (quantity == nullptr)
      continue;
    const double error =
        run.name == row.reference_run ? undefined : std::abs(quantity->value - row.reference);
    const double size = parameters.variants[variant] == "uniform"
                            ? run.cell_size
                            : std::pow(mean_unknowns(run), -1. / dimension);
    double order = undefined;
    if (!result.errors.empty() && error > row.round_off && result.errors.back() > row.round_off &&
        size < result.sizes.back())
      order = std::log(result.errors.back() / error) / std::log(result.sizes.back() / size);
    result.runs.push_back(number);
    result.unknowns.push_back(mean_unknowns(run));
    result.sizes.push_back(size);
    result.values.push_back(quantity->value);
    result.errors.push_back(error);
    result.orders.push_back(order);
  }
  return result;
}

double RefinementReport::ratio(const Row &row, const double error) const
{
  if (row.curves.size() < 2)
    return undefined;
  const unsigned int adaptive = parameters.variants[0] == "adaptive" ? 0 : 1;
  return row.curves[adaptive].unknowns_at(error) / row.curves[1 - adaptive].unknowns_at(error);
}

std::vector<std::string> RefinementReport::lines() const
{
  std::vector<std::vector<std::string>> table = {{"run", "cells", "unknowns", "steps"}};
  std::vector<std::string> failures;
  for (const StudiedRun &run : runs)
    if (run.failure.empty())
      table.push_back({run.name, number_text(std::round(mean_cells(run)), 15),
                       number_text(std::round(mean_unknowns(run)), 15),
                       number_text(run.n_steps, 15)});
    else
      failures.push_back(run.name + " failed: " + run.failure);
  std::vector<std::string> result = aligned_lines(table);
  result.insert(result.end(), failures.begin(), failures.end());
  for (const Row &row : all_rows)
  {
    const bool relative = std::abs(row.reference) > row.round_off;
    table = {
        {with_unit(row.label, row.unit), "value", relative ? "relative error" : "error", "order"}};
    for (const Curve &curve : row.curves)
      for (unsigned int i = 0; i < curve.runs.size(); ++i)
      {
        const double value = curve.values[i], error = curve.errors[i], order = curve.orders[i];
        table.push_back({runs[curve.runs[i]].name,
                         number_text(std::abs(value) <= row.round_off ? 0. : value, 6),
                         std::isnan(error)        ? "reference"
                         : error <= row.round_off ? "round-off"
                                                  : number_text(error / row.scale(), 2),
                         std::isnan(order) ? "-" : number_text(order, 2)});
      }
    const std::vector<std::string> lines = aligned_lines(table);
    result.insert(result.end(), lines.begin(), lines.end());
  }
  return result;
}

void RefinementReport::add_quantities(Summary &summary) const
{
  for (const Row &row : all_rows)
  {
    const auto add = [&](const std::string &name, const double value)
    {
      if (std::isfinite(value))
        summary.add({name, value, "1", row.label});
    };
    double equal_error = 0.;
    for (unsigned int variant = 0; variant < row.curves.size(); ++variant)
    {
      const Curve &curve = row.curves[variant];
      const std::string &name = parameters.variants[variant];
      add(name + " error", curve.last_error() / row.scale());
      add(name + " order", curve.last_order());
      for (const double level : parameters.error_levels)
        add(name + " unknowns at " + percent_text(level) + " error",
            curve.unknowns_at(level * row.scale()));
      // Not std::max: NaN stays.
      equal_error = curve.last_error() <= equal_error ? equal_error : curve.last_error();
    }
    for (const double level : parameters.error_levels)
      add("adaptive over uniform unknowns at " + percent_text(level) + " error",
          ratio(row, level * row.scale()));
    if (row.curves.size() > 1 && std::isfinite(ratio(row, equal_error)))
    {
      add("equal error", equal_error / row.scale());
      add("adaptive over uniform unknowns at equal error", ratio(row, equal_error));
    }
  }
  summary.add(
      {"failed runs",
       static_cast<double>(std::count_if(
           runs.begin(), runs.end(), [](const StudiedRun &run) { return !run.failure.empty(); })),
       "1", ""});
}

void RefinementReport::name_quantities(const RefinementStudyParameters &parameters,
                                       const QuantityNames &of_runs,
                                       QuantityNames &names)
{
  const std::string ratio = "adaptive over uniform unknowns at ";
  for (const std::string &label : of_runs.labels())
  {
    for (const std::string &variant : parameters.variants)
    {
      names.add(variant + " error", label);
      names.add(variant + " order", label);
      for (const double level : parameters.error_levels)
        names.add(variant + " unknowns at " + percent_text(level) + " error", label);
    }
    if (parameters.variants.size() < 2)
      continue;
    for (const double level : parameters.error_levels)
      names.add(ratio + percent_text(level) + " error", label);
    names.add("equal error", label);
    names.add(ratio + "equal error", label);
  }
  names.add("failed runs");
}

void RefinementReport::write(const OutputDirectory &directory) const
{
  write_runs(directory.file("refinement.csv"));
  Citations().write(directory.file("citation.bib"));
}

void RefinementReport::write_runs(const std::string &file) const
{
  std::string text =
      "way,cycle [1],run,cells [1],unknowns [1],cell size [m],time step [s],steps [1],iterations "
      "[1],wall time [s],quantity,unit,value,reference,error,relative error [1],order "
      "[1],failure\n";
  const auto run_cells = [&](const StudiedRun &run)
  {
    std::string cells = csv_cell(parameters.variants[run.variant]) + "," +
                        std::to_string(run.mesh) + "," + csv_cell(run.name);
    for (const double value : {mean_cells(run), mean_unknowns(run), run.cell_size, run.time_step,
                               run.n_steps, run.iterations, run.wall_time})
      cells += "," + (value > 0. ? csv_cell(value) : std::string());
    return cells;
  };
  for (const Row &row : all_rows)
    for (const Curve &curve : row.curves)
      for (unsigned int i = 0; i < curve.runs.size(); ++i)
        text += run_cells(runs[curve.runs[i]]) + "," + csv_cell(row.label) + "," +
                csv_cell(row.unit) + "," + csv_cell(curve.values[i]) + "," +
                csv_cell(row.reference) + "," + csv_cell(curve.errors[i]) + "," +
                csv_cell(curve.errors[i] / row.scale()) + "," + csv_cell(curve.orders[i]) + ",\n";
  for (const StudiedRun &run : runs)
    if (!run.failure.empty())
      text += run_cells(run) + ",,,,,,,," + csv_cell(run.failure) + "\n";
  write_file_atomically(file, text);
}
} // namespace Continua
