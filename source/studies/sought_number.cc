#include <continua/studies/sought_number.h>

#include <continua/base/quoted_name.h>

#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
/// The key of an entry, and of one in a probe; else empty.
std::string key_in_probe(const std::string &path, std::string &probe)
{
  const std::vector<std::string> names = split_unquoted(path, '/');
  if (names.size() != 3 || names.front() != "Probes")
    return "";
  probe = without_quotes(names[1]);
  return names[2];
}

/// The number of an entry of the section, or `otherwise` where there is none.
double number_of(const ParameterSection &section,
                 const std::string &key,
                 const std::string &text,
                 const NumericEntry &entry,
                 const double otherwise)
{
  if (text.empty())
    return otherwise;
  try
  {
    return parse_quantity(text, entry.dimension());
  }
  catch (const std::invalid_argument &error)
  {
    section.refuse(key, error.what(),
                   "Give a number with a unit of '" + entry.path() +
                       "': " + usual_units(entry.dimension()));
  }
}

void check_bounds(const ParameterSection &section, const NumericEntry &entry, const FitParameter &p)
{
  if (p.lower > p.upper)
    section.refuse("Lower", "the lower bound lies above the upper one", "Exchange them");
  for (const auto &[key, bound] : {std::pair("Lower", p.lower), std::pair("Upper", p.upper)})
    if (std::isfinite(bound) && (bound < entry.range().lower || bound > entry.range().upper))
      section.refuse(key, "'" + entry.path() + "' does not accept such a number",
                     "Give a bound within what the entry accepts");
  const bool is_given = section.given("Start");
  const std::string key = is_given ? "Start" : "Entry";
  if (std::isnan(p.start))
    section.refuse(key, "'" + entry.path() + "' has no value in the file", "Give a Start");
  if (p.start < p.lower || p.start > p.upper || !entry.accepts(p.start))
    section.refuse(key,
                   std::string(is_given ? "the start" : "the entry's value, which is the start,") +
                       " lies outside of the bounds",
                   "Give a Start between Lower and Upper");
}

void check_scale(const ParameterSection &section, const FitParameter &p)
{
  if (p.scale == FitParameter::Scale::logarithmic && (p.lower < 0. || p.start <= 0.))
    section.refuse("Scale", "a logarithmic scale is for positive numbers",
                   "Give a Start and bounds above 0, or set Scale = linear");
  if (p.scale == FitParameter::Scale::logarithmic && p.prior && p.prior->mean <= 0.)
    section.refuse("Prior mean", "a logarithmic scale is for positive numbers",
                   "Give a positive mean, or set Scale = linear");
  if (p.prior && p.prior->standard_deviation <= 0.)
    section.refuse("Prior standard deviation", "it is not positive", "Give a positive number");
  const bool has_bounds = std::isfinite(p.lower) && std::isfinite(p.upper);
  if (p.scale == FitParameter::Scale::linear && p.start == 0. && !has_bounds && !p.prior)
    section.refuse(section.given("Start") ? "Start" : "Entry",
                   "the start is 0, and nothing says how large the number may be",
                   "Give Lower and Upper");
}
} // namespace

std::string SoughtEntry::clock_of() const
{
  std::string probe;
  return key_in_probe(entry.path_of_entry(), probe) == "Measured shift" ? probe : "";
}

SoughtEntry
find_sought_entry(const ParameterFile &file, ParameterSection section, const SoughtNumber &number)
{
  SoughtEntry result{NumericEntry(file, number.entry, section, "Entry"), {}};
  const NumericEntry &entry = result.entry;
  std::string probe;
  const std::string key = key_in_probe(entry.path_of_entry(), probe);
  if (entry.is_integer())
    section.refuse("Entry", "'" + entry.path() + "' is a whole number, which no fit can find",
                   "Give the path of a number with decimals");
  for (const char *const place :
       {"Identification/", "Output/", "Expected/", "Time/", "Sweep/", "Comparison/",
        "Refinement study/", "Wave theory/Spectral tolerance", "Wave theory/Highest frequency"})
    if (entry.path().compare(0, std::string(place).size(), place) == 0)
      section.refuse("Entry", "'" + entry.path() + "' is no number of the model",
                     "Seek a number of the body, its materials, boundaries or stations");
  if (key == "Measured factors" || key == "Measured period")
    section.refuse("Entry", "'" + entry.path() + "' changes the data, and not what is predicted",
                   "Seek a number of the model, or 'Measured shift'");
  FitParameter &p = result.parameter;
  p.name = number.name;
  p.unit = entry.unit();
  p.scale = number.scale;
  p.lower = number_of(section, "Lower", number.lower, entry, entry.range().lower);
  p.upper = number_of(section, "Upper", number.upper, entry, entry.range().upper);
  p.start = number_of(section, "Start", number.start, entry, entry.value());
  if (number.prior_mean.empty() != number.prior_standard_deviation.empty())
    section.refuse(number.prior_mean.empty() ? "Prior standard deviation" : "Prior mean",
                   "a prior has a mean and a standard deviation", "Give both, or none");
  if (!number.prior_mean.empty())
    p.prior = Prior{
        number_of(section, "Prior mean", number.prior_mean, entry, 0.),
        number_of(section, "Prior standard deviation", number.prior_standard_deviation, entry, 0.)};
  check_bounds(section, entry, p);
  check_scale(section, p);
  if (!result.clock_of().empty() && !(std::isfinite(p.lower) && std::isfinite(p.upper)))
    section.refuse("Entry", "the shift of a clock needs bounds, which say what rows count",
                   "Give Lower and Upper");
  return result;
}
} // namespace Continua
