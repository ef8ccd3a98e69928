#include <continua/studies/chosen_quantities.h>

#include <continua/analysis/range_report.h>
#include <continua/base/input_error.h>
#include <continua/base/nearest_name.h>

#include <algorithm>
#include <sstream>

namespace Continua
{
namespace
{
/// Behind the last colon: a probe of several fields is called "PROBE: FIELD" itself.
std::string name_of_label(const std::string &label)
{
  const std::size_t colon = label.rfind(": ");
  return colon == std::string::npos ? label : label.substr(colon + 2);
}

/// Whether a word of Quantities means this one: its label, or its name at whatever probe.
bool matches(const std::string &asked, const std::string &label)
{
  return asked == label || asked == name_of_label(label);
}
} // namespace

std::string label_of(const Quantity &quantity)
{
  return quantity.probe.empty() ? quantity.name : quantity.probe + ": " + quantity.name;
}

const Quantity *find_quantity(const RunResult &run, const std::string &label)
{
  for (const Quantity &quantity : run.quantities)
    if (label_of(quantity) == label)
      return &quantity;
  return nullptr;
}

bool is_of_the_computation(const std::string &name)
{
  static const std::vector<std::string> words = {
      "residual", "error",     "misfit",      "divergence", "difference", "change",
      "changes",  "residuals", "iterations",  "unknowns",   "branches",   "steps",
      "step",     "cells",     "theoretical", "measured",   "corrections"};
  if (is_of_the_range(name))
    return true;
  std::istringstream stream(name);
  for (std::string word; stream >> word;)
    if (std::find(words.begin(), words.end(), word) != words.end())
      return true;
  return false;
}

bool is_chosen(const std::vector<std::string> &all_asked, const std::string &label)
{
  if (all_asked.empty())
    return !is_of_the_computation(name_of_label(label));
  return std::any_of(all_asked.begin(), all_asked.end(),
                     [&label](const std::string &asked) { return matches(asked, label); });
}

void check_asked(const std::string &entry,
                 const std::vector<std::string> &all_asked,
                 const RunResult &run)
{
  for (const std::string &asked : all_asked)
    if (std::none_of(run.quantities.begin(), run.quantities.end(),
                     [&asked](const Quantity &quantity)
                     { return matches(asked, label_of(quantity)); }))
    {
      std::vector<std::string> names;
      for (const Quantity &quantity : run.quantities)
        names.push_back(label_of(quantity));
      const std::string nearest = nearest_name(asked, names);
      throw RunError(entry + ": the run " + run.name + " has no quantity '" + asked + "'" +
                     (nearest.empty() ? "; its summary.json lists those that there are"
                                      : ". Did you mean '" + nearest + "'?"));
    }
}

std::vector<std::string> chosen_labels(const std::vector<std::string> &all_asked,
                                       const std::vector<RunResult> &runs)
{
  std::vector<std::string> result;
  for (const RunResult &run : runs)
    for (const Quantity &quantity : run.quantities)
      if (is_chosen(all_asked, label_of(quantity)) &&
          std::find(result.begin(), result.end(), label_of(quantity)) == result.end())
        result.push_back(label_of(quantity));
  return result;
}
} // namespace Continua
