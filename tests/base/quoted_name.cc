#include <continua/base/parameter_file.h>
#include <continua/base/parameter_text.h>
#include <continua/base/quoted_name.h>

#include "../unit_test.h"

#include <fstream>
#include <sstream>

namespace test_of_quoted_name
{
using namespace Continua;

namespace
{
/// Names as drawing and segmentation programs make them.
const std::vector<std::string> names = {
    "wall#1", "Wand/innen", "a, b",  "a=b",  " wall ",   "a  b",      "5\" pipe", "\"in\"", "\"",
    "back\\", "(",          "plain", "a: b", "wall (1)", "a \"b\" c", "#",        "x\ty"};

struct Read
{
  std::vector<std::string> sections, list;
  std::string key_value, file;
};

Read read(const std::string &text, const std::vector<std::string> &overrides, std::string &printed)
{
  std::ofstream("q.prm") << text;
  ParameterFile file("q.prm", overrides);
  Read result;
  ParameterSection root = file.root();
  result.sections = root.subsection("Materials").subsections();
  for (const std::string &name : result.sections)
    root.subsection("Materials").subsection(name).add("Type", result.key_value, "");
  root.subsection("Regions").add_free_entries("");
  root.add("List", result.list, "");
  std::ostringstream stream;
  file.print(stream, ParameterFile::Style::prm);
  printed = stream.str();
  return result;
}
} // namespace

UNIT_TEST(quoted_name)
{
  for (const std::string &name : names)
  {
    for (const char *const special : {"", "#", "#,", "#=/"})
      check::equal("read back: " + name, without_quotes(quoted_name(name, special)), name);

    // As a section, in a list, as a key, on the command line, and once more from what is printed.
    const std::string text = "set List = first, " + quoted_name(name, "#,(") +
                             " # a comment\nsubsection Materials\nsubsection " +
                             quoted_name(name, "#") +
                             " # a comment\nset Type = x\nend\nend\nsubsection Regions\nset " +
                             quoted_name(name, "#=") + " = y # a comment\nend\n";
    const std::vector<std::string> overrides = {"Materials/" + quoted_name(name, "#/=") +
                                                "/Type = z"};
    std::string printed, again;
    const Read once = read(text, overrides, printed);
    check::is_true("section", once.sections == std::vector<std::string>{name});
    check::is_true("list", once.list == std::vector<std::string>({"first", name}));
    check::equal("command line", once.key_value, "z");
    const Read twice = read(printed, {}, again);
    check::is_true("printed", twice.sections == once.sections && twice.list == once.list &&
                                  twice.key_value == "z" && printed == again);
  }
  check::equal("a path", join_path({"Materials", "Wand/innen", "Density"}),
               "Materials/\"Wand/innen\"/Density");
  check::equal("a plain name", quoted_name("wall 1", "#,"), "wall 1");
  check::equal("a quote within a word", without_quotes("5\" pipe, 3\" pipe"), "5\" pipe, 3\" pipe");
  check::equal("a quote that nothing closes", without_quotes("a \"b"), "a \"b");
  check::absolute("a comment with quotes", find_unquoted("set X = 3 # say \"a # b\"", "#"), 10.,
                  0.);
}
} // namespace test_of_quoted_name
