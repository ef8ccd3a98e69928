#include <continua/case/sensitivity_parameters.h>

#include <continua/base/quoted_name.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
/// What the equations of a motion exp(s t) have as factors of matrices that stay.
const std::vector<std::string> &sections_of_coefficients()
{
  static const std::vector<std::string> names = {"Materials", "Boundaries", "Body force"};
  return names;
}

std::string first_name(const std::string &path)
{
  return without_quotes(split_unquoted(path, '/').front());
}
} // namespace

void SensitivityParameters::read(ParameterSection section)
{
  section.add("Entries", entries,
              "Numbers of the materials, the boundaries and the body force, by which the responses "
              "are differentiated: paths such as Materials/wall/Young's modulus, of a list with "
              "the place of the number (Materials/wall/Shear moduli 2); or all - each that the "
              "file sets and that is not 0, but for whole numbers and for entries with a formula. "
              "Empty: no sensitivities.");
  section.add("Probes", probes,
              "Probes whose responses are differentiated, PROBE or PROBE: FIELD. Empty: all.");
  is_on = !entries.empty();
  if (!is_on && section.given("Probes"))
    section.refuse("Probes", "nothing says by which entries the responses are differentiated",
                   "Give 'Entries', or remove the entry");
}

std::vector<SensitivityEntry> SensitivityEntry::find(ParameterFile &file,
                                                     const SensitivityParameters &parameters)
{
  const ParameterSection section = file.root().subsection("Harmonic").subsection("Sensitivities");
  const bool takes_all = parameters.entries == std::vector<std::string>{"all"};
  const std::vector<std::string> paths =
      takes_all ? NumericEntry::paths_given(file, sections_of_coefficients(),
                                            NumericEntry::Kind::quantities)
                : parameters.entries;
  std::vector<SensitivityEntry> result;
  for (const std::string &path : paths)
  {
    NumericEntry entry(file, path, section, "Entries", NumericEntry::Kind::quantities);
    const std::vector<std::string> &possible = sections_of_coefficients();
    if (std::find(possible.begin(), possible.end(), first_name(entry.path())) == possible.end())
      section.refuse("Entries",
                     "'" + entry.path() +
                         "' is no number of a material, a boundary or the body force, which alone "
                         "leave the mesh and the frequencies as they are",
                     "Remove it; compare two runs for it");
    if (entry.is_integer())
      section.refuse("Entries", "'" + entry.path() + "' is a whole number",
                     "Give numbers with decimals");
    if (std::any_of(result.begin(), result.end(),
                    [&entry](const SensitivityEntry &other)
                    { return other.entry.path() == entry.path(); }))
      section.refuse("Entries", "'" + entry.path() + "' is named twice", "Remove one");
    if (entry.value() == 0. || !std::isfinite(entry.value()))
    {
      if (takes_all)
        continue;
      section.refuse("Entries",
                     entry.value() == 0.
                         ? "'" + entry.path() + "' is 0, of which no part is a small change"
                         : "'" + entry.path() + "' has no value",
                     "Give it a number that is not 0, or remove it here");
    }
    try
    {
      const DifferenceFormula formula = DifferenceFormula::at(
          entry.value(), [&entry](const double number) { return entry.accepts(number); });
      result.push_back({entry, formula});
    }
    catch (const std::invalid_argument &error)
    {
      if (!takes_all)
        section.refuse("Entries", "'" + entry.path() + "': " + error.what(), "Remove it");
    }
  }
  if (result.empty())
    section.refuse("Entries", "the file sets no number that is not 0 in them",
                   "Remove the section");
  return result;
}
} // namespace Continua
