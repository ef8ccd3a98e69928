#include <continua/studies/comparison_parameters.h>

#include <algorithm>
#include <cctype>

namespace Continua
{
namespace
{
void check_meshes(const ParameterSection &section,
                  const std::string &key,
                  const std::vector<unsigned int> &meshes)
{
  if (meshes.size() < 2)
    section.refuse(key, "a comparison needs two meshes at least, and three to observe an order",
                   "Write for example 'set " + key + " = 0, 1, 2'");
  for (unsigned int i = 1; i < meshes.size(); ++i)
    if (meshes[i] <= meshes[i - 1])
      section.refuse(key, "the meshes do not become finer",
                     "Write for example 'set " + key + " = 0, 1, 2'");
}
} // namespace

void ComparisonParameters::read(ParameterSection root)
{
  ParameterSection section = root.subsection("Comparison");
  section.add_choice("Analysis", analysis, {"automatic", "transient", "steady"},
                     "What the runs do; automatic: transient if the file has a section Time, else "
                     "steady.");
  section.add("Entry", entry,
              "The entry, with its sections (Finite element/Velocity degree), in which the two "
              "ways to compute the case differ.");
  section.add("Values", values, "The two values of this entry.");
  section.add("Meshes", meshes,
              "How often every cell of the file's mesh is divided, for each of the meshes: two or "
              "more, the coarsest first.");
  section.add("Meshes of the second", second_meshes,
              "The same for the second of the values; empty: as for the first.");
  section.add("Refine the time step", refine_time_step,
              "Whether the time step is halved, too, each time the cells are divided.");
  section.add("Quantities", quantities,
              "What is compared, as in Expected (tip: frequency); empty: every quantity that both "
              "have, but those that tell errors or counts.");
  section.add("Tolerance", tolerance, Dimensions::none,
              "Two extrapolated values agree if their difference is at most this times the sum of "
              "their estimated errors.",
              Range::positive());
  section.add("Relative floor", floor, Dimensions::none,
              "Differences below this fraction of the value agree in any case.",
              Range::not_negative());
  section.add("Largest error", largest_error, Dimensions::none,
              "Two extrapolated values are not judged if the sum of their estimated errors is more "
              "than this times the larger of them: the meshes are too coarse for a verdict.",
              Range::positive());
  expected = read_expected(section.subsection("Expected"));

  if (analysis == "automatic")
    analysis = root.has_subsection("Time") ? "transient" : "steady";
  if (entry.empty() || entry.back() == '/')
    section.refuse("Entry", "there is no name of an entry", "Write for example 'Discretisation'");
  if (second_meshes.empty())
    second_meshes = meshes;
  check_meshes(section, "Meshes", meshes);
  check_meshes(section, "Meshes of the second", second_meshes);
  if (values.size() != 2 || values[0] == values[1])
    section.refuse("Values", "two different values are compared",
                   "Write for example 'set Values = taylor hood, cell-wise'");
  if (analysis == "steady" && refine_time_step)
    section.refuse("Refine the time step", "a steady analysis has no time step",
                   "Remove the entry");
}

std::string ComparisonParameters::name(const unsigned int variant) const
{
  const std::string &value = values[variant];
  const bool is_word =
      std::any_of(value.begin(), value.end(),
                  [](const unsigned char letter) { return std::isalpha(letter) != 0; });
  if (is_word)
    return value;
  std::string key = entry.substr(entry.rfind('/') + 1);
  key[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(key[0])));
  return key + " " + value;
}
} // namespace Continua
