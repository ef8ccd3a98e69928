#include <continua/analysis/answer.h>

#include <continua/base/text_table.h>
#include <continua/base/undefined.h>
#include <continua/theory/wave_source.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

namespace Continua
{
namespace
{
using Table = std::vector<std::vector<std::string>>;

/// Of probes that are shown; a run can have hundreds.
constexpr std::size_t most_probes = 12;
/// The answer shows no more beats than these, the last ones.
constexpr std::size_t most_beats = 12;
constexpr int n_digits = 5;
/// A fit of a damped oscillation that is worse says little of a frequency [1].
constexpr double largest_fit_residual = 0.1;

std::string cell(const double value, const std::string &unit = "")
{
  if (!std::isfinite(value))
    return "-";
  return number_text(value, n_digits) + (unit.empty() || unit == "1" ? "" : " " + unit);
}

/// The rest of a text that begins so.
std::optional<std::string> after(const std::string &text, const std::string &beginning)
{
  if (text.compare(0, beginning.size(), beginning) != 0)
    return std::nullopt;
  return text.substr(beginning.size());
}

bool ends_with(const std::string &text, const std::string &end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// A row for each speed of each probe.
Table waves(const std::vector<Quantity> &quantities)
{
  const std::vector<WaveSource> sources = WaveSource::all();
  const std::vector<std::string> names = {"wave speed by phase", "wave speed at half height",
                                          "wave speed of the foot", "wave speed", "attenuation"};
  std::vector<std::string> probes;
  std::map<std::pair<std::string, std::string>, std::vector<double>> values;
  std::map<std::string, std::string> units;
  std::vector<bool> is_there(sources.size(), false);
  for (const Quantity &quantity : quantities)
    for (std::size_t source = 0; source < sources.size(); ++source)
      for (const std::string &name : names)
        if (quantity.name == sources[source].prefix + name)
        {
          if (std::find(probes.begin(), probes.end(), quantity.probe) == probes.end())
            probes.push_back(quantity.probe);
          units[name] = quantity.unit;
          is_there[source] = true;
          values.try_emplace({quantity.probe, name}, sources.size(), undefined)
              .first->second[source] = quantity.value;
        }
  Table table;
  if (probes.empty())
    return table;
  table.push_back({"waves"});
  for (std::size_t source = 0; source < sources.size(); ++source)
    if (is_there[source])
      table.back().push_back(sources[source].name);
  for (const std::string &probe : probes)
    for (const std::string &name : names)
      if (const auto found = values.find({probe, name}); found != values.end())
      {
        table.push_back({std::string("  ").append(probe).append(": ").append(name)});
        for (std::size_t source = 0; source < sources.size(); ++source)
          if (is_there[source])
            table.back().push_back(cell(found->second[source], units[name]));
      }
  return table;
}

/// What the summary has of one field at one probe.
struct History
{
  std::string label, unit;
  double largest = undefined, time_of_largest = undefined, smallest = undefined,
         time_of_smallest = undefined, frequency = undefined, final = undefined;
  bool is_oscillation = false; ///< by its fit; a pulse that comes back is none
};

/// "tip: pressure" of a probe of one field, whose name the quantity has, or of several, whose name
/// the probe's label has.
std::string label(const Quantity &quantity, const std::string &field)
{
  const std::string end = ": " + field;
  const bool has_field =
      quantity.probe.size() > end.size() &&
      quantity.probe.compare(quantity.probe.size() - end.size(), end.size(), end) == 0;
  return has_field ? quantity.probe : quantity.probe + end;
}

std::vector<History> histories(const std::vector<Quantity> &quantities)
{
  const std::vector<std::pair<std::string, double History::*>> members = {
      {"maximum ", &History::largest},
      {"time of maximum ", &History::time_of_largest},
      {"minimum ", &History::smallest},
      {"time of minimum ", &History::time_of_smallest},
      {"final ", &History::final}};
  std::vector<History> result;
  std::map<std::string, std::vector<std::size_t>> of_probe;
  for (const Quantity &quantity : quantities)
  {
    if (quantity.probe.empty())
      continue;
    for (const auto &[name, member] : members)
      if (const std::optional<std::string> field = after(quantity.name, name))
      {
        const std::string text = label(quantity, *field);
        std::size_t i = 0;
        while (i < result.size() && result[i].label != text)
          ++i;
        if (i == result.size())
        {
          result.push_back({text, ""});
          of_probe[quantity.probe].push_back(i);
        }
        result[i].*member = quantity.value;
        if (name.compare(0, 4, "time") != 0)
          result[i].unit = quantity.unit;
      }
  }
  for (const Quantity &quantity : quantities)
    if (const auto found = of_probe.find(quantity.probe);
        found != of_probe.end() && found->second.size() == 1)
    {
      History &history = result[found->second.front()];
      if (quantity.name == "frequency")
        history.frequency = quantity.value;
      if (quantity.name == "fit residual" && quantity.value <= largest_fit_residual)
        history.is_oscillation = true;
    }
  for (History &history : result)
    if (!history.is_oscillation)
      history.frequency = undefined;
  return result;
}

Table probes(const std::vector<Quantity> &quantities)
{
  const std::vector<History> all = histories(quantities);
  bool in_time = false, oscillates = false;
  for (const History &history : all)
  {
    in_time = in_time || std::isfinite(history.largest);
    oscillates = oscillates || std::isfinite(history.frequency);
  }
  Table table;
  if (all.empty())
    return table;
  table.push_back({"probes"});
  if (in_time)
    table.back().insert(table.back().end(), {"largest", "at", "smallest", "at"});
  else
    table.back().push_back("value");
  if (oscillates)
    table.back().push_back("frequency");
  for (std::size_t i = 0; i < all.size() && i < most_probes; ++i)
  {
    const History &history = all[i];
    table.push_back({"  " + history.label});
    if (in_time)
      table.back().insert(table.back().end(),
                          {cell(history.largest, history.unit), cell(history.time_of_largest, "s"),
                           cell(history.smallest, history.unit),
                           cell(history.time_of_smallest, "s")});
    else
      table.back().push_back(cell(history.final, history.unit));
    if (oscillates)
      table.back().push_back(cell(history.frequency, "Hz"));
  }
  if (all.size() > most_probes)
    table.push_back(
        {"  and " + std::to_string(all.size() - most_probes) + " more in summary.json"});
  return table;
}

/// A row for the material of the laboratory and for each harmonic test of it.
Table moduli(const std::vector<Quantity> &quantities)
{
  const std::vector<std::string> names = {"storage modulus", "loss modulus", "tan delta",
                                          "mean modulus"};
  Table table;
  for (const Quantity &quantity : quantities)
    for (std::size_t column = 0; column < names.size(); ++column)
      if (quantity.name == names[column])
      {
        if (column == 0)
        {
          if (table.empty())
            table.push_back({"moduli", "storage", "loss", "tan delta", "mean"});
          table.push_back({"  " + quantity.probe});
        }
        table.back().push_back(cell(quantity.value, quantity.unit));
        // The material itself, which alone has a mean, not one of its tests.
        if (names[column] == "mean modulus")
          table.back().front() += " at the fundamental frequency";
      }
  return table;
}

/// What an analysis without probes and waves has found: of vibrations the frequencies alone.
Table results(const std::vector<Quantity> &all)
{
  std::vector<Quantity> quantities;
  for (const Quantity &quantity : all)
    if (after(quantity.name, "mode ") && ends_with(quantity.name, " frequency"))
      quantities.push_back(quantity);
  if (quantities.empty())
    quantities = all;
  Table table;
  if (quantities.empty())
    return table;
  table.push_back({"results", "value"});
  for (std::size_t i = 0; i < quantities.size() && i < most_probes; ++i)
    table.push_back({"  " + (quantities[i].probe.empty() ? "" : quantities[i].probe + ": ") +
                         quantities[i].name,
                     cell(quantities[i].value, quantities[i].unit)});
  if (quantities.size() > most_probes)
    table.push_back(
        {"  and " + std::to_string(quantities.size() - most_probes) + " more in summary.json"});
  return table;
}

/// A row for each history: what it does in the last beat.
Table last_beat(const std::vector<Quantity> &quantities)
{
  const std::vector<std::vector<std::string>> beginnings = {{"systolic ", "largest "},
                                                            {"diastolic ", "smallest "},
                                                            {"mean "},
                                                            {"pulse ", "range of "},
                                                            {"difference of "}};
  const std::string end = " of the last beat";
  std::vector<std::string> labels;
  std::map<std::string, std::vector<std::string>> cells;
  for (const Quantity &quantity : quantities)
  {
    const std::string &name = quantity.name;
    if (quantity.probe.empty() || name.size() <= end.size() ||
        name.compare(name.size() - end.size(), end.size(), end) != 0)
      continue;
    const std::string rest = name.substr(0, name.size() - end.size());
    for (std::size_t column = 0; column < beginnings.size(); ++column)
      for (const std::string &beginning : beginnings[column])
        if (const std::optional<std::string> field = after(rest, beginning))
        {
          const std::string text = label(quantity, *field);
          if (std::find(labels.begin(), labels.end(), text) == labels.end())
            labels.push_back(text);
          auto &row = cells.try_emplace(text, beginnings.size(), "-").first->second;
          row[column] = cell(quantity.value, quantity.unit);
        }
  }
  Table table;
  if (labels.empty())
    return table;
  table.push_back({"last beat", "largest", "smallest", "mean", "range", "difference"});
  for (std::size_t i = 0; i < labels.size() && i < most_probes; ++i)
  {
    table.push_back({"  " + labels[i]});
    const std::vector<std::string> &row = cells.at(labels[i]);
    table.back().insert(table.back().end(), row.begin(), row.end());
  }
  if (labels.size() > most_probes)
    table.push_back(
        {"  and " + std::to_string(labels.size() - most_probes) + " more in beats.csv"});
  return table;
}

/// A row for each beat: by how much it differs from the one before.
Table beats(const Summary::Columns &columns)
{
  Table table;
  if (columns.size() < 3 || columns[0].second.empty())
    return table;
  const std::size_t n_beats = columns[0].second.size();
  table.push_back({"beats", "end", "largest difference"});
  for (std::size_t i = n_beats > most_beats ? n_beats - most_beats : 0; i < n_beats; ++i)
    table.push_back({"  " + std::to_string(i + 1), cell(columns[0].second[i], "s"),
                     cell(columns[2].second[i])});
  return table;
}

Table checks(const std::vector<Summary::Check> &all)
{
  Table table;
  if (all.empty())
    return table;
  std::size_t n_passed = 0, n_compared = 0;
  for (const Summary::Check &check : all)
  {
    n_passed += check.passed ? 1 : 0;
    n_compared += check.is_compared ? 1 : 0;
  }
  table.push_back(
      {"checks: " + std::to_string(n_passed) + " of " + std::to_string(n_compared) + " passed",
       "value", "expected", ""});
  for (const Summary::Check &check : all)
    table.push_back({"  " + (check.probe.empty() ? "" : check.probe + ": ") + check.name,
                     cell(check.value, check.unit), check.criterion,
                     !check.is_compared ? "not compared"
                     : check.passed     ? "passed"
                                        : "FAILED"});
  return table;
}
} // namespace

std::vector<std::string> answer_lines(const Summary &summary)
{
  std::vector<std::string> lines;
  std::vector<Table> tables = {waves(summary.quantities()), moduli(summary.quantities()),
                               probes(summary.quantities()), last_beat(summary.quantities()),
                               beats(summary.columns_of("beats"))};
  if (std::all_of(tables.begin(), tables.end(), [](const Table &table) { return table.empty(); }))
    tables.push_back(results(summary.quantities()));
  tables.push_back(checks(summary.checks()));
  for (const Table &table : tables)
  {
    const std::vector<std::string> rows = aligned_lines(table);
    lines.insert(lines.end(), rows.begin(), rows.end());
  }
  return lines;
}
} // namespace Continua
