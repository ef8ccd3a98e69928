#include <continua/studies/sweep_report.h>

#include <continua/base/atomic_file.h>
#include <continua/base/citations.h>
#include <continua/base/text_table.h>
#include <continua/base/undefined.h>
#include <continua/studies/chosen_quantities.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
SweepReport::SweepReport(const std::vector<std::string> &quantities,
                         const std::vector<SweptEntry> &entries,
                         const std::vector<SweptRun> &runs)
    : asked(quantities), entries(entries), runs(runs)
{
  std::vector<RunResult> finished;
  for (const SweptRun &run : runs)
    if (run.failure.empty())
      finished.push_back(run);
  labels = chosen_labels(asked, finished);
  if (labels.empty() && asked.empty())
    for (const RunResult &run : finished)
      for (const Quantity &quantity : run.quantities)
        if (std::find(labels.begin(), labels.end(), label_of(quantity)) == labels.end())
          labels.push_back(label_of(quantity));
  for (const std::string &label : labels)
    for (const RunResult &run : finished)
      if (const Quantity *const quantity = find_quantity(run, label))
      {
        units.push_back(quantity->unit);
        break;
      }
}

double SweepReport::value(const SweptRun &run, const std::string &label) const
{
  const Quantity *const quantity = run.failure.empty() ? find_quantity(run, label) : nullptr;
  return quantity == nullptr ? undefined : quantity->value;
}

std::vector<std::string> SweepReport::columns(const std::vector<SweptEntry> &entries)
{
  std::vector<std::string> result;
  result.reserve(entries.size());
  for (const SweptEntry &entry : entries)
    result.push_back(entry.unit.empty() ? entry.path : with_unit(entry.path, entry.unit));
  return result;
}

std::vector<std::string> SweepReport::lines() const
{
  std::vector<std::vector<std::string>> table = {columns(entries)};
  if (!asked.empty())
    for (std::size_t i = 0; i < labels.size(); ++i)
      table.front().push_back(with_unit(labels[i], units[i]));
  std::vector<std::string> failures;
  for (std::size_t run = 0; run < runs.size(); ++run)
  {
    table.emplace_back();
    for (const SweptEntry &entry : entries)
      table.back().push_back(entry.values[run]);
    if (!asked.empty())
      for (const std::string &label : labels)
      {
        const double number = value(runs[run], label);
        table.back().push_back(std::isnan(number) ? "-" : number_text(number, 6));
      }
    if (!runs[run].failure.empty())
      failures.push_back(runs[run].name + " failed: " + runs[run].failure);
  }
  std::vector<std::string> result = aligned_lines(table);
  result.insert(result.end(), failures.begin(), failures.end());
  if (asked.empty())
    result.push_back(std::to_string(labels.size()) +
                     " quantities of each run stand in sweep.csv; Sweep/Quantities chooses some");
  return result;
}

void SweepReport::add_quantities(Summary &summary) const
{
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    double smallest = undefined, largest = undefined;
    for (const SweptRun &run : runs)
    {
      const double number = value(run, labels[i]);
      if (std::isnan(number))
        continue;
      summary.add({run.values, number, units[i], labels[i]});
      smallest = std::isnan(smallest) ? number : std::min(smallest, number);
      largest = std::isnan(largest) ? number : std::max(largest, number);
    }
    if (std::isnan(smallest))
      continue;
    summary.add({"smallest", smallest, units[i], labels[i]});
    summary.add({"largest", largest, units[i], labels[i]});
  }
  const auto n_failed = std::count_if(runs.begin(), runs.end(),
                                      [](const SweptRun &run) { return !run.failure.empty(); });
  summary.add({"runs", static_cast<double>(runs.size()), "1", ""});
  summary.add({"failed runs", static_cast<double>(n_failed), "1", ""});
}

void SweepReport::name_quantities(const std::vector<std::string> &asked,
                                  const std::string &values,
                                  const QuantityNames &of_run,
                                  QuantityNames &names)
{
  const std::vector<std::string> all = of_run.labels();
  const bool has_chosen =
      std::any_of(all.begin(), all.end(),
                  [&asked](const std::string &label) { return is_chosen(asked, label); });
  for (const std::string &label : all)
    if ((asked.empty() && !has_chosen) || is_chosen(asked, label))
      for (const std::string &name : {values, std::string("smallest"), std::string("largest")})
        names.add(name, label);
  names.add("runs");
  names.add("failed runs");
}

void SweepReport::write(const OutputDirectory &directory) const
{
  write_runs(directory.file("sweep.csv"));
  Citations().write(directory.file("citation.bib"));
}

void SweepReport::write_runs(const std::string &file) const
{
  std::string text = "run";
  for (const std::string &column : columns(entries))
    text += "," + csv_cell(column);
  for (std::size_t i = 0; i < labels.size(); ++i)
    text += "," + csv_cell(with_unit(labels[i], units[i]));
  text += ",wall time [s],failure\n";
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    const SweptRun &run = runs[i];
    text += csv_cell(run.name);
    for (const SweptEntry &entry : entries)
      text += "," + (entry.unit.empty() ? csv_cell(entry.values[i]) : entry.values[i]);
    for (const std::string &label : labels)
      text += "," + csv_cell(value(run, label));
    text += "," + (run.wall_time > 0. ? csv_cell(run.wall_time) : std::string()) + "," +
            csv_cell(run.failure) + "\n";
  }
  write_file_atomically(file, text);
}
} // namespace Continua
