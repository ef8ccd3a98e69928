#include <continua/base/quantity_names.h>

#include <continua/base/nearest_name.h>

#include <algorithm>

namespace Continua
{
namespace
{
std::string joined_label(std::string probe, const std::string &name)
{
  return probe.empty() ? name : probe.append(": ").append(name);
}
} // namespace

void QuantityNames::add(const std::string &name, const std::string &probe)
{
  names.emplace(probe, name);
}

void QuantityNames::add(const QuantityNames &other)
{
  names.insert(other.names.begin(), other.names.end());
}

bool QuantityNames::has(const std::string &name, const std::string &probe) const
{
  return names.count({probe, name}) > 0;
}

bool QuantityNames::any_has(const std::string &name) const
{
  return std::any_of(names.begin(), names.end(),
                     [&name](const std::pair<std::string, std::string> &entry)
                     { return entry.second == name; });
}

std::vector<std::string> QuantityNames::labels() const
{
  std::vector<std::string> result;
  for (const auto &[probe, name] : names)
    result.push_back(joined_label(probe, name));
  std::sort(result.begin(), result.end());
  return result;
}

void QuantityNames::refuse(const ParameterSection &section,
                           const std::string &key,
                           const std::string &asked) const
{
  // Where the probe is left out, the name alone is what is misspelt.
  std::vector<std::string> candidates = labels();
  for (const auto &entry : names)
    candidates.push_back(entry.second);
  const std::string nearest = nearest_name(asked, candidates);
  section.refuse(key, "no run of this file states the quantity '" + asked + "'",
                 nearest.empty() ? "The section summary.json of doc/output.md lists the quantities"
                                 : "Did you mean '" + nearest + "'?");
}

bool QuantityNames::states(const ExpectedValue &expected) const
{
  return expected.probe.empty() ? any_has(expected.name) : has(expected.name, expected.probe);
}

void QuantityNames::refuse_others(const ParameterSection &section,
                                  const std::string &key,
                                  const std::vector<std::string> &asked) const
{
  const std::vector<std::string> known = labels();
  for (const std::string &label : asked)
    if (!any_has(label) && !std::binary_search(known.begin(), known.end(), label))
      refuse(section, key, label);
}

void QuantityNames::refuse_others(const ParameterSection &section,
                                  const std::vector<ExpectedValue> &expected) const
{
  for (const ExpectedValue &value : expected)
    if (!states(value))
      refuse(section, value.key, joined_label(value.probe, value.name));
}
} // namespace Continua
