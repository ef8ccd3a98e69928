#include <continua/studies/comparison_report.h>

#include <continua/base/atomic_file.h>
#include <continua/base/citations.h>
#include <continua/base/text_table.h>
#include <continua/base/undefined.h>
#include <continua/studies/chosen_quantities.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Continua
{
namespace
{
using Verdict = ComparisonReport::Verdict;

const char *verdict_name(const Verdict verdict)
{
  return verdict == Verdict::agree ? "agree" : verdict == Verdict::differ ? "differ" : "not judged";
}

} // namespace

ComparisonReport::ComparisonReport(const ComparisonParameters &parameters,
                                   const std::vector<ConvergenceOrders> &orders,
                                   const std::vector<StudiedRun> &runs)
    : parameters(parameters), orders(orders), runs(runs)
{
  std::map<std::string, double> largest; // by unit
  for (const std::string &label :
       chosen_labels(parameters.quantities, std::vector<RunResult>(runs.begin(), runs.end())))
  {
    Row row;
    row.label = label;
    unsigned int n_values[2] = {0, 0};
    for (unsigned int variant = 0; variant < 2; ++variant)
      for (const unsigned int mesh : parameters.meshes_of(variant))
      {
        const StudiedRun *const found = run(variant, mesh);
        const Quantity *const quantity = found == nullptr ? nullptr : find_quantity(*found, label);
        row.values[variant].push_back(quantity == nullptr ? undefined : quantity->value);
        if (quantity != nullptr)
        {
          row.unit = quantity->unit;
          ++n_values[variant];
        }
      }
    if (n_values[0] > 1 || n_values[1] > 1)
      all_rows.push_back(row);
    else
      left_out.push_back(label);
    for (const std::vector<double> &values : row.values)
      for (const double value : values)
        if (std::isfinite(value))
          largest[row.unit] = std::max(largest[row.unit], std::abs(value));
  }
  for (Row &row : all_rows)
  {
    row.round_off = round_off_share * largest[row.unit];
    compare(row);
  }
}

const StudiedRun *ComparisonReport::run(const unsigned int variant, const unsigned int mesh) const
{
  for (const StudiedRun &candidate : runs)
    if (candidate.variant == variant && candidate.mesh == mesh && candidate.failure.empty())
      return &candidate;
  return nullptr;
}

void ComparisonReport::compare(Row &row) const
{
  for (unsigned int variant = 0; variant < 2; ++variant)
  {
    std::vector<double> sizes, values;
    for (unsigned int i = 0; i < row.values[variant].size(); ++i)
      if (!std::isnan(row.values[variant][i]))
      {
        const double size = run(variant, parameters.meshes_of(variant)[i])->cell_size;
        // An adaptive mesh may end with as many cells as the one before.
        if (!sizes.empty() && size >= sizes.back())
          continue;
        sizes.push_back(size);
        values.push_back(row.values[variant][i]);
      }
    row.convergence.emplace_back(sizes, values, orders[variant], row.round_off);
  }
  const GridConvergence &first = row.convergence[0], &second = row.convergence[1];
  row.difference = second.limit - first.limit;
  const double floor =
      parameters.floor * std::max(std::abs(first.limit), std::abs(second.limit)) + row.round_off;
  const double errors = first.estimated_error + second.estimated_error + floor;
  row.over_errors = errors > 0. ? std::abs(row.difference) / errors : 0.;
  // Limits that are known no better than this say nothing by being within their errors.
  const double largest_limit = std::max(std::abs(first.limit), std::abs(second.limit));
  const bool are_unknown = errors > row.round_off + parameters.floor * largest_limit &&
                           first.estimated_error + second.estimated_error >
                               parameters.largest_error * largest_limit + row.round_off;
  row.verdict = std::isnan(row.difference) || are_unknown ? Verdict::not_judged
                : row.over_errors <= parameters.tolerance ? Verdict::agree
                                                          : Verdict::differ;
  if (std::isnan(row.difference))
    row.over_errors = undefined;
}

std::vector<std::string> ComparisonReport::lines() const
{
  std::vector<std::vector<std::string>> table = {{"run", "cells", "unknowns", "steps"}};
  std::vector<std::string> failures;
  for (const StudiedRun &run : runs)
    if (run.failure.empty())
      table.push_back({run.name, number_text(run.n_cells, 15), number_text(run.n_dofs, 15),
                       number_text(run.n_steps, 15)});
    else
      failures.push_back(run.name + " failed: " + run.failure);
  std::vector<std::string> result = aligned_lines(table);
  result.insert(result.end(), failures.begin(), failures.end());
  if (!all_rows.empty())
  {
    std::vector<std::string> header = {"quantity"};
    for (unsigned int variant = 0; variant < 2; ++variant)
      for (const std::string &text :
           {parameters.name(variant), std::string("error"), std::string("order")})
        header.push_back(text);
    header.insert(header.end(), {"difference", "verdict"});
    table = {header};
    for (const Row &row : all_rows)
    {
      std::vector<std::string> line = {with_unit(row.label, row.unit)};
      // Round-off is not the same on every machine.
      const auto rounded = [&row](const double value, const int n_digits)
      {
        return std::isnan(value)
                   ? "-"
                   : number_text(std::abs(value) <= row.round_off ? 0. : value, n_digits);
      };
      for (const GridConvergence &convergence : row.convergence)
      {
        line.push_back(rounded(convergence.limit, 6));
        line.push_back(convergence.estimated_error <= row.round_off
                           ? "round-off"
                           : rounded(convergence.estimated_error, 2));
        line.push_back(convergence.description());
      }
      line.push_back(rounded(row.difference, 2));
      line.push_back(verdict_name(row.verdict));
      table.push_back(line);
    }
    const std::vector<std::string> lines = aligned_lines(table);
    result.insert(result.end(), lines.begin(), lines.end());
  }
  if (!left_out.empty())
  {
    std::string text = "Not compared, since neither has it on two meshes:";
    for (const std::string &label : left_out)
      text += (label == left_out.front() ? " " : ", ") + label;
    result.push_back(text);
  }
  return result;
}

void ComparisonReport::add_quantities(Summary &summary) const
{
  unsigned int n_verdicts[3] = {0, 0, 0};
  for (const Row &row : all_rows)
  {
    ++n_verdicts[static_cast<int>(row.verdict)];
    const auto add = [&](const std::string &name, const double value, const std::string &unit)
    {
      if (std::isfinite(value))
        summary.add({name, value, unit, row.label});
    };
    for (unsigned int variant = 0; variant < 2; ++variant)
    {
      const std::string name = parameters.name(variant) + " ";
      add(name + "finest", row.values[variant].back(), row.unit);
      add(name + "extrapolated", row.convergence[variant].limit, row.unit);
      add(name + "estimated error", row.convergence[variant].estimated_error, row.unit);
      add(name + "order", row.convergence[variant].order, "1");
    }
    add("difference", row.difference, row.unit);
    if (row.convergence[0].limit != 0.)
      add("relative difference", row.difference / std::abs(row.convergence[0].limit), "1");
    add("difference over errors", row.over_errors, "1");
    if (row.verdict != Verdict::not_judged)
      add("agree", row.verdict == Verdict::agree ? 1. : 0., "1");
  }
  summary.add({"quantities compared", static_cast<double>(all_rows.size()), "1", ""});
  for (const Verdict verdict : {Verdict::agree, Verdict::differ, Verdict::not_judged})
    summary.add({std::string(verdict == Verdict::not_judged ? "quantities " : "quantities that ") +
                     verdict_name(verdict),
                 static_cast<double>(n_verdicts[static_cast<int>(verdict)]), "1", ""});
  summary.add(
      {"failed runs",
       static_cast<double>(std::count_if(
           runs.begin(), runs.end(), [](const StudiedRun &run) { return !run.failure.empty(); })),
       "1", ""});
}

void ComparisonReport::name_quantities(const ComparisonParameters &parameters,
                                       const QuantityNames &of_runs,
                                       QuantityNames &names)
{
  for (const std::string &label : of_runs.labels())
  {
    for (unsigned int variant = 0; variant < 2; ++variant)
      for (const char *const name : {" finest", " extrapolated", " estimated error", " order"})
        names.add(parameters.name(variant) + name, label);
    for (const char *const name :
         {"difference", "relative difference", "difference over errors", "agree"})
      names.add(name, label);
  }
  for (const char *const name : {"quantities compared", "quantities that agree",
                                 "quantities that differ", "quantities not judged", "failed runs"})
    names.add(name);
}

void ComparisonReport::write(const OutputDirectory &directory) const
{
  write_quantities(directory.file("comparison.csv"));
  write_runs(directory.file("runs.csv"));
  Citations citations;
  citations.add("roache1994");
  citations.add("celik2008");
  citations.write(directory.file("citation.bib"));
}

void ComparisonReport::write_quantities(const std::string &file) const
{
  std::string text = csv_cell("quantity [unit]");
  for (unsigned int variant = 0; variant < 2; ++variant)
  {
    const std::string name = parameters.name(variant) + ", ";
    for (const unsigned int mesh : parameters.meshes_of(variant))
      text += "," + csv_cell(name + "mesh " + std::to_string(mesh));
    for (const char *what : {"extrapolated", "estimated error", "order [1]", "sequence"})
      text += "," + csv_cell(name + what);
  }
  text += ",\"difference\",\"difference over errors [1]\",\"verdict\"\n";
  for (const Row &row : all_rows)
  {
    text += csv_cell(with_unit(row.label, row.unit));
    for (unsigned int variant = 0; variant < 2; ++variant)
    {
      const GridConvergence &convergence = row.convergence[variant];
      for (const double value : row.values[variant])
        text += "," + csv_cell(value);
      text += "," + csv_cell(convergence.limit) + "," + csv_cell(convergence.estimated_error) +
              "," + csv_cell(convergence.order) + "," + csv_cell(convergence.description());
    }
    text += "," + csv_cell(row.difference) + "," + csv_cell(row.over_errors) + "," +
            csv_cell(verdict_name(row.verdict)) + "\n";
  }
  write_file_atomically(file, text);
}

void ComparisonReport::write_runs(const std::string &file) const
{
  std::string text = "run,way,mesh [1],cells [1],cell size [m],time step [s],steps [1],unknowns "
                     "[1],wall time [s],failure\n";
  for (const StudiedRun &run : runs)
  {
    text += csv_cell(run.name) + "," + csv_cell(parameters.name(run.variant)) + "," +
            std::to_string(run.mesh);
    for (const double value :
         {run.n_cells, run.cell_size, run.time_step, run.n_steps, run.n_dofs, run.wall_time})
      text += "," + (value > 0. ? csv_cell(value) : std::string());
    text += "," + csv_cell(run.failure) + "\n";
  }
  write_file_atomically(file, text);
}
} // namespace Continua
