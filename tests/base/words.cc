// The words of an enum: there and back, what a file sets, the default, and a word that is none.

#include "../parameter_text.h"

#include <continua/base/words.h>

#include "../unit_test.h"

#include <optional>
#include <sstream>

namespace test_of_words
{
namespace
{
using namespace Continua;

enum class Colour
{
  red,
  dark_green
};

const Words<Colour> colours = {{"red", Colour::red}, {"dark green", Colour::dark_green}};

Colour read(const std::string &text)
{
  ParameterFile file = parameters_of(text);
  ParameterSection section = file.root();
  Colour colour = Colour::dark_green;
  add_choice(section, "Colour", colour, colours, "Of the wall");
  file.refuse_unknown();
  return colour;
}
} // namespace

UNIT_TEST(words)
{
  check::equal("word", word_of(colours, Colour::dark_green), "dark green");
  check::is_true("value", value_of(colours, "red") == Colour::red);
  check::is_true("choices", choices_of(colours) == std::vector<std::string>{"red", "dark green"});
  check::throws<std::logic_error>(
      "no such word", []() { value_of(colours, "green"); }, "no value for the word 'green'");
  check::throws<std::logic_error>(
      "a value without word", []() { word_of(Words<Colour>{}, Colour::red); }, "has no word");

  check::is_true("read", read("set Colour = red\n") == Colour::red);
  check::is_true("default", read("") == Colour::dark_green);
  check::throws<InputError>(
      "unknown", []() { read("set Colour = green\n"); },
      "prm:1: 'Colour': 'green' does not exist.*Give one of: red, dark green");

  // A table may have a word for no value; the manual shows the words in its order.
  const Words<std::optional<Colour>> optional = {
      {"automatic", std::nullopt}, {"red", Colour::red}, {"dark green", Colour::dark_green}};
  ParameterFile file;
  ParameterSection section = file.root();
  std::optional<Colour> colour;
  add_choice(section, "Colour", colour, optional, "Of the wall");
  check::is_true("no value", !colour);
  std::ostringstream printed;
  file.print(printed, ParameterFile::Style::markdown);
  check::is_true("manual", printed.str().find("| `Colour` | `automatic` | automatic, red, dark "
                                              "green | Of the wall |") != std::string::npos);
}
} // namespace test_of_words
