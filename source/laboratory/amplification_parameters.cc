#include <continua/laboratory/amplification_parameters.h>

#include <continua/base/joined.h>

#include <algorithm>

namespace Continua
{
void AmplificationParameters::read(ParameterSection section)
{
  const std::vector<std::string> all = choices_of(wave_scheme_words());
  std::vector<std::string> names;
  for (const WaveScheme scheme : schemes)
    names.push_back(word_of(wave_scheme_words(), scheme));
  section.add("Schemes", names,
              "Schemes in time, a list of displacement euler (equation 3.42 of the thesis), "
              "displacement four levels (3.43), velocity euler (3.44 with the trapezoidal rule "
              "2.16), velocity euler implicit (with the implicit update), velocity backward "
              "differencing, velocity backward differencing trapezoidal, velocity crank nicolson.");
  section.add("Courant numbers", courant_numbers, Dimensions::none,
              "Courant numbers c dt/dx: speed of the wave times step over cell.",
              Range::positive());
  section.add("Fewest cells", fewest_cells, "Fewest cells in a wavelength [1].", 2);
  section.add("Most cells", most_cells, "Most cells in a wavelength [1].", 2, 1000);
  section.add("Runs", runs,
              "Whether each amplification is also measured: in a run of a bar that is one "
              "wavelength long and held at both ends, by the cell-wise discretisation.");
  if (names.empty())
    section.refuse("Schemes", "there is no scheme", "Give a list of " + joined(all));
  schemes.clear();
  for (const std::string &name : names)
  {
    if (std::find(all.begin(), all.end(), name) == all.end())
      section.refuse("Schemes", "there is no scheme '" + name + "'",
                     "Give a list of " + joined(all));
    if (std::count(names.begin(), names.end(), name) > 1)
      section.refuse("Schemes", "the scheme '" + name + "' is named twice", "Name each once");
    schemes.push_back(value_of(wave_scheme_words(), name));
  }
  if (courant_numbers.empty())
    section.refuse("Courant numbers", "there is no Courant number", "Give one or more");
  if (fewest_cells > most_cells)
    section.refuse(section.given("Fewest cells") ? "Fewest cells" : "Most cells",
                   "the fewest cells are more than the most",
                   "Give fewest cells (default 2) up to the most (default 25)");
}
} // namespace Continua
