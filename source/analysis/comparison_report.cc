#include <continua/analysis/comparison_report.h>

#include <continua/base/atomic_file.h>
#include <continua/base/input_error.h>
#include <continua/base/nearest_name.h>
#include <continua/base/units.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>

namespace Continua
{
namespace
{
using Verdict = ComparisonReport::Verdict;
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
/// Of the largest value of its unit: what solvers and sums leave in digits.
constexpr double round_off_share = 1e-10;

std::string label_of(const Quantity &quantity)
{
  return quantity.probe.empty() ? quantity.name : quantity.probe + ": " + quantity.name;
}

/// Whether a word of Quantities means this one: its label, or its name at whatever probe.
bool matches(const std::string &asked, const Quantity &quantity)
{
  return asked == label_of(quantity) || asked == quantity.name;
}

const Quantity *find(const ComparedRun &run, const std::string &label)
{
  for (const Quantity &quantity : run.quantities)
    if (label_of(quantity) == label)
      return &quantity;
  return nullptr;
}

std::string with_unit(const ComparisonReport::Row &row)
{
  return row.label + (row.unit.empty() || row.unit == "1" ? "" : " [" + row.unit + "]");
}

std::string number(const double value, const int n_digits)
{
  std::ostringstream text;
  text << std::setprecision(n_digits) << value;
  return text.str();
}

const char *verdict_name(const Verdict verdict)
{
  return verdict == Verdict::agree ? "agree" : verdict == Verdict::differ ? "differ" : "not judged";
}

/// Lines of a table whose columns are as wide as their widest cell; the first column to the left.
std::vector<std::string> aligned(const std::vector<std::vector<std::string>> &rows)
{
  std::vector<std::size_t> widths;
  for (const auto &row : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      if (i == widths.size())
        widths.push_back(0);
      widths[i] = std::max(widths[i], row[i].size());
    }
  std::vector<std::string> lines;
  for (const auto &row : rows)
  {
    std::ostringstream text;
    for (std::size_t i = 0; i < row.size(); ++i)
      text << (i == 0 ? "" : "  ") << (i == 0 ? std::left : std::right)
           << std::setw(static_cast<int>(widths[i])) << row[i];
    std::string line = text.str();
    line.erase(line.find_last_not_of(' ') + 1);
    lines.push_back(line);
  }
  return lines;
}

/// A text in a csv file (RFC 4180).
std::string cell(const std::string &text)
{
  std::string result = "\"";
  for (const char letter : text)
    result += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return result + '"';
}

/// A number in a csv file; nothing where there is none.
std::string cell(const double value)
{
  return std::isfinite(value) ? shortest_number(value) : "";
}
} // namespace

ComparisonReport::ComparisonReport(const ComparisonParameters &parameters,
                                   const std::vector<ConvergenceOrders> &orders,
                                   const std::vector<ComparedRun> &runs)
    : parameters(parameters), orders(orders), runs(runs)
{
  std::map<std::string, double> largest; // by unit
  for (const std::string &label : labels())
  {
    Row row;
    row.label = label;
    unsigned int n_values[2] = {0, 0};
    for (unsigned int way = 0; way < 2; ++way)
      for (const unsigned int mesh : parameters.meshes_of(way))
      {
        const ComparedRun *const found = run(way, mesh);
        const Quantity *const quantity = found == nullptr ? nullptr : find(*found, label);
        row.values[way].push_back(quantity == nullptr ? undefined : quantity->value);
        if (quantity != nullptr)
        {
          row.unit = quantity->unit;
          ++n_values[way];
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

bool ComparisonReport::is_of_the_computation(const std::string &name)
{
  static const std::vector<std::string> words = {
      "residual",   "error",    "misfit", "divergence", "difference",  "change",   "residuals",
      "iterations", "branches", "steps",  "cells",      "theoretical", "measured", "corrections"};
  std::istringstream stream(name);
  for (std::string word; stream >> word;)
    if (std::find(words.begin(), words.end(), word) != words.end())
      return true;
  return false;
}

void ComparisonReport::check_asked(const ComparisonParameters &parameters, const ComparedRun &run)
{
  for (const std::string &asked : parameters.quantities)
    if (std::none_of(run.quantities.begin(), run.quantities.end(),
                     [&asked](const Quantity &quantity) { return matches(asked, quantity); }))
    {
      std::vector<std::string> names;
      for (const Quantity &quantity : run.quantities)
        names.push_back(label_of(quantity));
      const std::string nearest = nearest_name(asked, names);
      throw RunError("Comparison/Quantities: the run " + run.name + " has no quantity '" + asked +
                     "'" +
                     (nearest.empty() ? "; its summary.json lists those that there are"
                                      : ". Did you mean '" + nearest + "'?"));
    }
}

const ComparedRun *ComparisonReport::run(const unsigned int way, const unsigned int mesh) const
{
  for (const ComparedRun &candidate : runs)
    if (candidate.way == way && candidate.mesh == mesh && candidate.failure.empty())
      return &candidate;
  return nullptr;
}

std::vector<std::string> ComparisonReport::labels() const
{
  const auto counts = [this](const Quantity &quantity)
  {
    if (parameters.quantities.empty())
      return !is_of_the_computation(quantity.name);
    return std::any_of(parameters.quantities.begin(), parameters.quantities.end(),
                       [&quantity](const std::string &asked) { return matches(asked, quantity); });
  };
  std::vector<std::string> result;
  for (const ComparedRun &run : runs)
    for (const Quantity &quantity : run.quantities)
      if (counts(quantity) &&
          std::find(result.begin(), result.end(), label_of(quantity)) == result.end())
        result.push_back(label_of(quantity));
  return result;
}

void ComparisonReport::compare(Row &row) const
{
  for (unsigned int way = 0; way < 2; ++way)
  {
    std::vector<double> sizes, values;
    for (unsigned int i = 0; i < row.values[way].size(); ++i)
      if (!std::isnan(row.values[way][i]))
      {
        const double size = run(way, parameters.meshes_of(way)[i])->cell_size;
        // An adaptive mesh may end with as many cells as the one before.
        if (!sizes.empty() && size >= sizes.back())
          continue;
        sizes.push_back(size);
        values.push_back(row.values[way][i]);
      }
    row.convergence.emplace_back(sizes, values, orders[way], row.round_off);
  }
  const GridConvergence &first = row.convergence[0], &second = row.convergence[1];
  row.difference = second.limit - first.limit;
  const double floor =
      parameters.floor * std::max(std::abs(first.limit), std::abs(second.limit)) + row.round_off;
  const double errors = first.estimated_error + second.estimated_error + floor;
  row.over_errors = errors > 0. ? std::abs(row.difference) / errors : 0.;
  row.verdict = std::isnan(row.difference)                ? Verdict::not_judged
                : row.over_errors <= parameters.tolerance ? Verdict::agree
                                                          : Verdict::differ;
  if (std::isnan(row.difference))
    row.over_errors = undefined;
}

std::vector<std::string> ComparisonReport::lines() const
{
  std::vector<std::vector<std::string>> table = {{"run", "cells", "unknowns", "steps"}};
  std::vector<std::string> failures;
  for (const ComparedRun &run : runs)
    if (run.failure.empty())
      table.push_back(
          {run.name, number(run.n_cells, 15), number(run.n_dofs, 15), number(run.n_steps, 15)});
    else
      failures.push_back(run.name + " failed: " + run.failure);
  std::vector<std::string> result = aligned(table);
  result.insert(result.end(), failures.begin(), failures.end());
  if (!all_rows.empty())
  {
    std::vector<std::string> header = {"quantity"};
    for (unsigned int way = 0; way < 2; ++way)
      for (const std::string &text :
           {parameters.name(way), std::string("error"), std::string("order")})
        header.push_back(text);
    header.insert(header.end(), {"difference", "verdict"});
    table = {header};
    for (const Row &row : all_rows)
    {
      std::vector<std::string> line = {with_unit(row)};
      // Round-off is not the same on every machine.
      const auto rounded = [&row](const double value, const int n_digits)
      {
        return std::isnan(value) ? "-"
                                 : number(std::abs(value) <= row.round_off ? 0. : value, n_digits);
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
    const std::vector<std::string> lines = aligned(table);
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
    for (unsigned int way = 0; way < 2; ++way)
    {
      const std::string name = parameters.name(way) + " ";
      add(name + "finest", row.values[way].back(), row.unit);
      add(name + "extrapolated", row.convergence[way].limit, row.unit);
      add(name + "estimated error", row.convergence[way].estimated_error, row.unit);
      add(name + "order", row.convergence[way].order, "1");
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
           runs.begin(), runs.end(), [](const ComparedRun &run) { return !run.failure.empty(); })),
       "1", ""});
}

void ComparisonReport::write_quantities(const std::string &file) const
{
  std::string text = cell("quantity [unit]");
  for (unsigned int way = 0; way < 2; ++way)
  {
    const std::string name = parameters.name(way) + ", ";
    for (const unsigned int mesh : parameters.meshes_of(way))
      text += "," + cell(name + "mesh " + std::to_string(mesh));
    for (const char *what : {"extrapolated", "estimated error", "order [1]", "sequence"})
      text += "," + cell(name + what);
  }
  text += ",\"difference\",\"difference over errors [1]\",\"verdict\"\n";
  for (const Row &row : all_rows)
  {
    text += cell(with_unit(row));
    for (unsigned int way = 0; way < 2; ++way)
    {
      const GridConvergence &convergence = row.convergence[way];
      for (const double value : row.values[way])
        text += "," + cell(value);
      text += "," + cell(convergence.limit) + "," + cell(convergence.estimated_error) + "," +
              cell(convergence.order) + "," + cell(convergence.description());
    }
    text += "," + cell(row.difference) + "," + cell(row.over_errors) + "," +
            cell(verdict_name(row.verdict)) + "\n";
  }
  write_file_atomically(file, text);
}

void ComparisonReport::write_runs(const std::string &file) const
{
  std::string text = "run,way,mesh [1],cells [1],cell size [m],time step [s],steps [1],unknowns "
                     "[1],wall time [s],failure\n";
  for (const ComparedRun &run : runs)
  {
    text += cell(run.name) + "," + cell(parameters.name(run.way)) + "," + std::to_string(run.mesh);
    for (const double value :
         {run.n_cells, run.cell_size, run.time_step, run.n_steps, run.n_dofs, run.wall_time})
      text += "," + (value > 0. ? cell(value) : std::string());
    text += "," + cell(run.failure) + "\n";
  }
  write_file_atomically(file, text);
}
} // namespace Continua
