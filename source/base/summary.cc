#include <continua/base/atomic_file.h>
#include <continua/base/joined.h>
#include <continua/base/nearest_name.h>
#include <continua/base/summary.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace Continua
{
using Json = nlohmann::ordered_json;

namespace
{
/// A quantity that the results cannot carry.
struct Absence
{
  std::string name, probe, reason;
};
} // namespace

struct Summary::Implementation
{
  Json entries = Json::object();
  std::vector<Quantity> quantities;
  std::vector<Absence> absences;
  std::optional<QuantityNames> possible;
  Json checks = Json::array();
};

namespace
{
/// 800 cells are written as 800, not 800.0.
Json number(const double value)
{
  constexpr double exact = 9007199254740992.; // 2^53: up to here a double counts
  if (std::abs(value) < exact && value == std::floor(value))
    return static_cast<long long>(value);
  return value;
}

std::string format(const double value, const int n_digits)
{
  std::ostringstream text;
  text.precision(n_digits);
  text << value;
  return text.str();
}

std::string label(const std::string &name, const std::string &probe)
{
  return probe.empty() ? name : name + " (" + probe + ")";
}

double factor_to_si(const std::string &unit, Dimension &dimension)
{
  dimension = Dimensions::none;
  return unit.empty() || unit == "1" ? 1. : unit_factor(unit, dimension);
}

/// "3.3624 Hz" as written.
std::string text_of_value(const ExpectedValue &expected)
{
  if (!expected.value_text.empty())
    return expected.value_text;
  return format(expected.value, 6) + (expected.unit.empty() ? "" : " " + expected.unit);
}

std::string text_of_tolerance(const ExpectedValue &expected)
{
  return expected.tolerance_text.empty() ? format(expected.tolerance, 6) : expected.tolerance_text;
}

std::string criterion(const ExpectedValue &expected)
{
  if (expected.upper_bound)
    return "< " + text_of_value(expected);
  if (expected.lower_bound)
    return "> " + text_of_value(expected);
  return text_of_value(expected) + " +- " + text_of_tolerance(expected);
}

bool passes(const ExpectedValue &expected, const double value)
{
  if (!std::isfinite(value))
    return false;
  if (expected.upper_bound)
    return value < expected.value;
  if (expected.lower_bound)
    return value > expected.value;
  return std::abs(value - expected.value) <= expected.tolerance;
}

std::string text_of_success(const ExpectedValue &expected)
{
  if (expected.upper_bound)
    return "below " + text_of_value(expected);
  if (expected.lower_bound)
    return "above " + text_of_value(expected);
  return "within " + text_of_tolerance(expected) + " of " + text_of_value(expected);
}

std::string text_of_failure(const ExpectedValue &expected, const double value)
{
  const std::string unit = expected.unit.empty() ? "" : " " + expected.unit;
  if (!std::isfinite(value))
    return "FAILED: the value is not a finite number (expected " + criterion(expected) + ")";
  const std::string value_text = format(value, 6) + unit;
  if (expected.upper_bound)
    return "FAILED: " + value_text + " is not below " + text_of_value(expected);
  if (expected.lower_bound)
    return "FAILED: " + value_text + " is not above " + text_of_value(expected);

  const double deviation = std::abs(value - expected.value);
  // Two digits say enough unless they hide on which side of the tolerance the value is.
  const int n_digits = deviation < 1.1 * expected.tolerance ? 5 : 2;
  std::string deviation_text;
  if (expected.value == 0.)
    deviation_text = format(deviation, n_digits) + unit;
  else
  {
    const double percent = 100. * deviation / std::abs(expected.value);
    deviation_text = (percent >= 100. && percent < 1e6 ? std::to_string(std::lround(percent))
                                                       : format(percent, n_digits)) +
                     " %";
  }
  return "FAILED: " + value_text + " is " + deviation_text + " off " + criterion(expected);
}

/// What became of one expected value.
struct Verdict
{
  std::string text;
  std::string probe;
  double value = std::nan(""); ///< in the unit of the expected value
  bool passed = false;
};

Verdict judge(const ExpectedValue &expected,
              const std::vector<Quantity> &quantities,
              const std::vector<Absence> &absences)
{
  Verdict verdict;
  verdict.probe = expected.probe;
  std::vector<const Quantity *> matches;
  std::vector<std::string> all, probes;
  for (const Quantity &quantity : quantities)
  {
    all.push_back(label(quantity.name, quantity.probe));
    if (quantity.name == expected.name &&
        (expected.probe.empty() || quantity.probe == expected.probe))
    {
      matches.push_back(&quantity);
      probes.push_back(quantity.probe.empty() ? "the run as a whole" : quantity.probe);
    }
  }
  if (matches.empty())
  {
    for (const Absence &absence : absences)
      if (absence.name == expected.name &&
          (expected.probe.empty() || absence.probe == expected.probe))
      {
        verdict.probe = absence.probe;
        verdict.text = "FAILED: absent: " + absence.reason;
        return verdict;
      }
    // A run with many probes has hundreds.
    constexpr std::size_t most_listed = 30;
    const std::string near = nearest_name(label(expected.name, expected.probe), all);
    verdict.text = "FAILED: the run has no such quantity (" +
                   (all.size() <= most_listed
                        ? "it has " + (all.empty() ? std::string("none") : joined(all))
                        : (near.empty() ? std::string() : "the nearest of them is " + near + "; ") +
                              "summary.json lists all") +
                   ")";
    return verdict;
  }
  if (matches.size() > 1)
  {
    verdict.text = "FAILED: several probes have it (" + joined(probes) +
                   "); name one: 'PROBE: " + expected.name + "'";
    return verdict;
  }

  const Quantity &quantity = *matches.front();
  verdict.probe = quantity.probe;
  Dimension dimension, expected_dimension;
  const double factor = factor_to_si(quantity.unit, dimension);
  const double expected_factor = factor_to_si(expected.unit, expected_dimension);
  if (!expected.unit.empty() && !(dimension == expected_dimension))
  {
    verdict.text = "FAILED: the quantity is in " + quantity.unit + ", not in " + expected.unit;
    return verdict;
  }
  // Where no unit is written, the value is in the quantity's own.
  verdict.value =
      expected.unit.empty() ? quantity.value : quantity.value * factor / expected_factor;
  verdict.passed = passes(expected, verdict.value);
  verdict.text =
      verdict.passed ? text_of_success(expected) : text_of_failure(expected, verdict.value);
  return verdict;
}
} // namespace

Summary::Summary() : implementation(std::make_unique<Implementation>()) {}

Summary::~Summary() = default;

Summary::Summary(Summary &&) noexcept = default;

Summary &Summary::operator=(Summary &&) noexcept = default;

void Summary::set(const std::string &key, const std::string &value)
{
  implementation->entries[key] = value;
}

void Summary::set_flag(const std::string &key, const bool value)
{
  implementation->entries[key] = value;
}

void Summary::set(const std::string &key, const double value)
{
  implementation->entries[key] = number(value);
}

void Summary::set(const std::string &key, const std::map<std::string, double> &values)
{
  Json object = Json::object();
  for (const auto &[name, value] : values)
    object[name] = number(value);
  implementation->entries[key] = object;
}

void Summary::set(const std::string &key, const std::map<std::string, std::string> &values)
{
  Json object = Json::object();
  for (const auto &[name, value] : values)
    object[name] = value;
  implementation->entries[key] = object;
}

void Summary::set(const std::string &key, const std::vector<std::string> &values)
{
  implementation->entries[key] = values;
}

void Summary::set(const std::string &key, const Columns &columns)
{
  Json object = Json::object();
  for (const auto &[name, values] : columns)
  {
    Json &list = object[name] = Json::array();
    for (const double value : values)
      list.push_back(number(value));
  }
  implementation->entries[key] = object;
}

void Summary::add(const Quantity &quantity)
{
  std::vector<Quantity> &all = implementation->quantities;
  const auto same =
      std::find_if(all.begin(), all.end(),
                   [&quantity](const Quantity &other)
                   { return other.name == quantity.name && other.probe == quantity.probe; });
  if (same == all.end())
    all.push_back(quantity);
  else
    *same = quantity;
}

void Summary::add_absence(const std::string &name,
                          const std::string &probe,
                          const std::string &reason)
{
  implementation->absences.push_back({name, probe, reason});
}

const std::vector<Quantity> &Summary::quantities() const
{
  return implementation->quantities;
}

double Summary::number_of(const std::string &key) const
{
  const auto entry = implementation->entries.find(key);
  return entry != implementation->entries.end() && entry->is_number() ? entry->get<double>() : 0.;
}

std::map<std::string, double> Summary::numbers_of(const std::string &key) const
{
  std::map<std::string, double> values;
  if (const auto entry = implementation->entries.find(key); entry != implementation->entries.end())
    for (const auto &[name, value] : entry->items())
      if (value.is_number())
        values[name] = value.get<double>();
  return values;
}

Summary::Columns Summary::columns_of(const std::string &key) const
{
  Columns columns;
  if (const auto entry = implementation->entries.find(key); entry != implementation->entries.end())
    for (const auto &[name, list] : entry->items())
    {
      columns.emplace_back(name, std::vector<double>());
      for (const Json &value : list)
        columns.back().second.push_back(value.is_number() ? value.get<double>() : std::nan(""));
    }
  return columns;
}

void Summary::set_possible(const QuantityNames &names)
{
  implementation->possible = names;
}

std::vector<std::string> Summary::check(const std::vector<ExpectedValue> &expected,
                                        bool &all_passed)
{
  all_passed = true;
  std::vector<std::string> lines;
  implementation->checks = Json::array();
  for (const ExpectedValue &value : expected)
  {
    Verdict verdict;
    const bool is_compared = value.excluded_by.empty();
    try
    {
      if (is_compared)
        verdict = judge(value, implementation->quantities, implementation->absences);
      else
      {
        verdict.text = "not compared: changed by " + value.excluded_by;
        verdict.probe = value.probe;
      }
    }
    catch (const std::invalid_argument &error)
    {
      // The unit of the square root of a volume, say, is a text that no entry can name.
      verdict.text = std::string("FAILED: ") + error.what();
    }
    all_passed = all_passed && (verdict.passed || !is_compared);
    lines.push_back("check: " + label(value.name, verdict.probe) + ": " + verdict.text);

    Json entry = {{"name", value.name},
                  {"probe", verdict.probe},
                  {"criterion", criterion(value)},
                  {"expected", value.value}};
    if (value.upper_bound || value.lower_bound)
      entry["tolerance"] = nullptr;
    else
      entry["tolerance"] = value.tolerance;
    entry["unit"] = value.unit;
    entry["value"] = verdict.value;
    entry["passed"] = verdict.passed;
    if (!is_compared)
    {
      entry["passed"] = nullptr;
      entry["not compared: changed by"] = value.excluded_by;
    }
    implementation->checks.push_back(entry);
  }
  if (implementation->possible)
    for (const Quantity &quantity : implementation->quantities)
      if (!implementation->possible->has(quantity.name, quantity.probe))
        lines.push_back("mistake of the program, please report: no one announced the quantity " +
                        label(quantity.name, quantity.probe) +
                        ", so that Expected cannot ask for it");
  return lines;
}

std::vector<Summary::Check> Summary::checks() const
{
  std::vector<Check> result;
  for (const Json &check : implementation->checks)
    result.push_back(
        {check.at("name"), check.at("probe"), check.at("criterion"),
         check.at("value").is_number() ? check.at("value").get<double>() : std::nan(""),
         check.at("unit"), check.at("passed").is_boolean() && check.at("passed").get<bool>(),
         check.at("passed").is_boolean()});
  return result;
}

Summary Summary::read(const std::string &text)
{
  Summary summary;
  Json document = Json::parse(text);
  for (const Json &quantity : document.at("quantities"))
    summary.add(
        {quantity.at("name"),
         quantity.at("value").is_number() ? quantity.at("value").get<double>() : std::nan(""),
         quantity.at("unit"), quantity.at("probe")});
  summary.implementation->checks = document.at("checks");
  for (const Json &absence : document.value("absent", Json::array()))
    summary.add_absence(absence.at("name"), absence.at("probe"), absence.at("reason"));
  document.erase("absent");
  document.erase("quantities");
  document.erase("checks");
  summary.implementation->entries = document;
  return summary;
}

void Summary::write(const std::string &file) const
{
  if (dealii::Utilities::MPI::job_supports_mpi() &&
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return;
  Json document = implementation->entries;
  document["quantities"] = Json::array();
  for (const Quantity &quantity : implementation->quantities)
    document["quantities"].push_back({{"name", quantity.name},
                                      {"value", quantity.value},
                                      {"unit", quantity.unit},
                                      {"probe", quantity.probe}});
  for (const Absence &absence : implementation->absences)
    document["absent"].push_back(
        {{"name", absence.name}, {"probe", absence.probe}, {"reason", absence.reason}});
  document["checks"] = implementation->checks;
  // A name that is no UTF-8 must not cost the whole summary.
  write_file_atomically(file, document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}
} // namespace Continua
