#include <continua/base/quantity_names.h>

#include <continua/base/nearest_name.h>
#include <continua/base/parameter_file.h>
#include <continua/base/parameter_text.h>
#include <continua/base/unit_scale.h>

#include <algorithm>

namespace Continua
{
namespace
{
std::string joined_label(std::string probe, const std::string &name)
{
  return probe.empty() ? name : probe.append(": ").append(name);
}

std::string problem_of_quantity(const std::string &asked)
{
  return "no run of this file states the quantity '" + asked + "'";
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

std::string QuantityNames::remedy(const std::string &asked) const
{
  // Where the probe is left out, the name alone is what is misspelt.
  std::vector<std::string> candidates = labels();
  for (const auto &entry : names)
    candidates.push_back(entry.second);
  const std::string nearest = nearest_name(asked, candidates);
  return nearest.empty() ? "The section summary.json of doc/output.md lists the quantities"
                         : "Did you mean '" + nearest + "'?";
}

bool QuantityNames::states(const ExpectedValue &expected) const
{
  ExpectedValue copy = expected;
  return find(copy);
}

bool QuantityNames::find(ExpectedValue &expected) const
{
  if (expected.probe.empty())
    return any_has(expected.name);
  for (const std::string &probe : {expected.probe, with_value_in_si(expected.probe)})
    if (has(expected.name, probe))
    {
      expected.probe = probe;
      return true;
    }
  return false;
}

void QuantityNames::refuse_unknown(const ParameterSection &section,
                                   const std::string &key,
                                   std::vector<std::string> &asked) const
{
  const std::vector<std::string> known = labels();
  const auto is_known = [&](const std::string &label)
  { return any_has(label) || std::binary_search(known.begin(), known.end(), label); };
  for (std::string &label : asked)
  {
    const std::string in_si = with_value_in_si(label);
    if (!is_known(label) && is_known(in_si))
      label = in_si;
    if (!is_known(label))
      section.refuse(key, problem_of_quantity(label), remedy(label));
  }
}

void QuantityNames::refuse_unknown(const ParameterSection &section,
                                   std::vector<ExpectedValue> &expected) const
{
  for (ExpectedValue &value : expected)
    if (!find(value))
    {
      const std::string asked = joined_label(value.probe, value.name);
      section.refuse(value.key, problem_of_quantity(asked), remedy(asked));
    }
}

void QuantityNames::refuse_unknown(ParameterFile &file,
                                   const ParameterSection &section,
                                   std::vector<ExpectedValue> &expected) const
{
  for (ExpectedValue &value : expected)
  {
    if (find(value))
      continue;
    const std::string path = section.path() + "/" + join_path({value.key});
    value.excluded_by = file.changes_that_exclude(path);
    const std::string asked = joined_label(value.probe, value.name);
    if (value.excluded_by.empty())
      throw ImpossibleQuantity(section.origin(value.key), path, problem_of_quantity(asked),
                               remedy(asked));
  }
}
} // namespace Continua
