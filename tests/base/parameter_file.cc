#include <continua/base/parameter_file.h>

#include "../unit_test.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <tuple>

namespace test_of_parameter_file
{
using namespace Continua;

namespace
{
using Words = std::vector<std::string>;

const std::string directory = "parameter_file_test/";

std::string write(const std::string &name, const std::string &text)
{
  const std::string path = directory + name;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
  std::ofstream(path) << text;
  return path;
}

/// A file with that text.
ParameterFile file(const std::string &text, const Words &overrides = {})
{
  return ParameterFile(write("case.prm", text), overrides);
}

/// Reading the text, and what `declare` does with it, is refused.
void refused(const std::string &name,
             const std::string &text,
             const std::string &pattern,
             const std::function<void(ParameterSection)> &declare = {},
             const Words &overrides = {})
{
  check::throws<InputError>(
      name,
      [&]
      {
        ParameterFile parameters = file(text, overrides);
        if (declare)
          declare(parameters.root());
        parameters.refuse_unknown();
      },
      pattern);
}

void write_here(const std::string &name, const std::string &text)
{
  std::ofstream(name) << text;
}

std::string print(const ParameterFile &parameters, const ParameterFile::Style style)
{
  std::ostringstream out;
  parameters.print(out, style);
  return out.str();
}

bool contains(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

/// One of each kind of entry.
struct Everything
{
  std::string title = "untitled";
  double time_step = 1e-3;
  double end_time = std::numeric_limits<double>::infinity();
  double modulus = 1.2e6;
  double ratio = 0.3;
  std::vector<double> times{0.005, 0.05};
  std::vector<double> stations;
  unsigned int cells = 20;
  bool adaptive = false;
  std::string scheme = "newmark";
  Words fields{"pressure", "flow rate"};
  std::vector<unsigned int> ranks{1, 2};
  std::string table;
  Words regions;

  void read(ParameterSection root)
  {
    root.add("Title", title, "What the run is about");
    ParameterSection time = root.subsection("Time");
    time.add("Time step", time_step, Dimensions::time, "Time step", Range::positive());
    time.add("End time", end_time, Dimensions::time, "End of the run", Range::positive());
    time.add_choice("Scheme", scheme, {"newmark", "crank nicolson"}, "Time integration");
    ParameterSection mesh = root.subsection("Mesh");
    mesh.add("Cells", cells, "Number of cells", 1, 1000);
    mesh.add("Adaptive", adaptive, "Whether the mesh follows the solution");
    mesh.add("Ranks", ranks, "Numbers of ranks", 1);
    ParameterSection probe = root.subsection("Probe");
    probe.add("Fields", fields, "Fields to write");
    probe.add("Stations", stations, Dimensions::length, "Positions");
    probe.add_input_file("Measured", table, "Measured values | a table");
    for (const std::string &name : root.subsection("Materials").subsections())
    {
      regions.push_back(name);
      ParameterSection material = root.subsection("Materials").subsection(name);
      material.add("Young's modulus", modulus, Dimensions::pressure, "Stiffness");
      material.add("Poisson's ratio", ratio, Dimensions::none, "Ratio", {0., 0.5, false, true});
      material.add("Relaxation times", times, Dimensions::time, "Times", Range::positive());
    }
  }
};

const std::string everything = "# a comment\n"
                               "set Title =   Silicone   tube,\tpulse # another\n"
                               "subsection Time\n"
                               "  set Time step = 0.2 ms\n"
                               "  set Scheme=crank nicolson\r\n"
                               "end\n"
                               "subsection   Materials\n"
                               "  subsection upper  wall\n"
                               "    set Young's modulus = 2 MPa\n"
                               "    set Relaxation times = 5, \\  # first\n"
                               "                           50 ms\n"
                               "  end\n"
                               "  subsection fluid\n"
                               "  end\n"
                               "end\n"
                               "subsection Mesh\n"
                               "  set Cells = 40\n"
                               "  set Adaptive = yes\n"
                               "  set Ranks = 3, 4\n"
                               "end\n"
                               "subsection Probe\n"
                               "  set Fields = max(a, b), c = d\n"
                               "  set Stations = 10 cm, 0.3 m, 0\\\n"
                               " .5 mm\n"
                               "  set Measured = tables/measured.csv\n"
                               "end\n"
                               "subsection Time\n"
                               "  set End time = 0.6\n"
                               "end\n";

bool equal(const Everything &a, const Everything &b)
{
  return a.title == b.title && a.time_step == b.time_step && a.end_time == b.end_time &&
         a.modulus == b.modulus && a.ratio == b.ratio && a.times == b.times &&
         a.stations == b.stations && a.cells == b.cells && a.adaptive == b.adaptive &&
         a.scheme == b.scheme && a.fields == b.fields && a.ranks == b.ranks &&
         a.regions == b.regions;
}

void test_values()
{
  write("tables/measured.csv", "1\n");
  ParameterFile parameters = file(everything);
  Everything e;
  e.read(parameters.root());
  parameters.refuse_unknown();
  check::equal("word", e.title, "Silicone tube, pulse");
  check::relative("quantity with unit", e.time_step, 2e-4, 1e-15);
  check::relative("quantity without unit, section opened twice", e.end_time, 0.6, 0.);
  check::equal("choice", e.scheme, "crank nicolson");
  check::is_true("family", e.regions == Words{"upper wall", "fluid"});
  check::relative("key with an apostrophe", e.modulus, 2e6, 1e-15);
  check::relative("default", e.ratio, 0.3, 0.);
  check::relative("one unit for a list", e.times.at(0), 5e-3, 1e-15);
  check::relative("continued line", e.times.at(1), 5e-2, 1e-15);
  check::is_true("integer", e.cells == 40);
  check::is_true("yes", e.adaptive);
  check::is_true("integers", e.ranks == std::vector<unsigned int>{3, 4});
  check::is_true("commas in parentheses", e.fields == Words{"max(a, b)", "c = d"});
  check::relative("a unit for each", e.stations.at(0), 0.1, 1e-15);
  check::is_true("number of stations", e.stations.size() == 3);
  check::equal("input file", e.table, directory + "tables/measured.csv");
  check::is_true("input files",
                 parameters.input_files() ==
                     Words{directory + "case.prm", directory + "tables/measured.csv"});

  const ParameterFile moved = std::move(parameters);
  const std::string printed = print(moved, ParameterFile::Style::prm);
  ParameterFile again(write("elsewhere/again.prm", printed));
  Everything f;
  f.read(again.root());
  again.refuse_unknown();
  check::is_true("printed file reads back", equal(e, f));
  check::is_true("and finds the same input file", std::filesystem::equivalent(e.table, f.table));
  check::equal("and has the same identity", again.identity(), moved.identity());
  check::is_true("printed as the user wrote it", contains(printed, "= 0.2 ms"));
  check::is_true("printed default with unit",
                 contains(printed, "= 0.001 s") || contains(printed, "# default: 0.001 s"));
  check::is_true("what the user did not set is a comment",
                 contains(printed, "\n    # set Young's modulus") &&
                     contains(printed, "\n    set Young's modulus"));
  check::is_true("printed text with unit", contains(printed, "# Time step (number > 0) [s]"));
  check::is_true("printed empty member of a family", contains(printed, "subsection fluid"));
}

void test_empty_values()
{
  ParameterFile parameters = file("subsection Materials\n  subsection wall\n"
                                  "    set Relaxation times =\n  end\nend\n"
                                  "subsection Time\n  set End time =\nend\n"
                                  "subsection Family\n  subsection member\n  end\nend\n");
  const auto read = [](ParameterFile &one, Everything &values)
  {
    values.read(one.root());
    one.root().subsection("Family").subsection("member");
    one.root().subsection("Other family");
    one.refuse_unknown();
  };
  Everything e;
  read(parameters, e);
  check::is_true("a list that the file empties", e.times.empty());
  check::is_true("an empty text leaves 'none' as it is", std::isinf(e.end_time));
  const std::string printed = print(parameters, ParameterFile::Style::prm);
  check::is_true("a section without entries that the file has",
                 contains(printed, "  subsection member\n  end\n"));
  check::is_true("one that it does not have", !contains(printed, "Other family"));
  ParameterFile again(write("empty.prm", printed));
  Everything f;
  read(again, f);
  check::is_true("printed file reads back", equal(e, f));
}

void test_documentation()
{
  ParameterFile parameters;
  Everything e;
  ParameterSection root = parameters.root();
  e.read(root);
  double density = 1000.;
  root.subsection("Materials")
      .add("Density", density, Dimensions::density, "Mass per volume", Range::positive());
  parameters.refuse_unknown();
  const std::string markdown = print(parameters, ParameterFile::Style::markdown);
  check::is_true("markdown section", contains(markdown, "## Time\n"));
  check::is_true(
      "markdown quantity",
      contains(markdown, "| `Density` | `1000 kg/m^3` | number > 0 | Mass per volume [kg/m^3] |"));
  check::is_true("markdown without default",
                 contains(markdown, "| `End time` |  | number > 0 | End of the run [s] |"));
  check::is_true("markdown choice", contains(markdown, "| newmark, crank nicolson |"));
  check::is_true("markdown bar", contains(markdown, "Measured values \\| a table"));
  const std::string json = print(parameters, ParameterFile::Style::json);
  check::is_true(
      "json", contains(json, "\"path\": \"Materials/Density\",\n    \"value\": \"1000 kg/m^3\""));

  // The documentation of an empty file is itself a file with the defaults.
  ParameterFile again(write("defaults.prm", print(parameters, ParameterFile::Style::prm)));
  Everything f;
  f.read(again.root());
  check::is_true("printed defaults read back", equal(f, Everything()));
  check::is_true("an entry printed without a value is not given",
                 !again.root().subsection("Time").given("End time"));
}

void test_includes()
{
  write("common/base.prm", "set Title = base\n"
                           "include deeper/more.prm\n"
                           "subsection Time\n  set Time step = 1 s\n  set End time = 10 s\nend\n");
  write("common/deeper/more.prm", "set Title = more\nsubsection Mesh\n  set Cells = 7\nend\n");
  ParameterFile parameters =
      file("set Title = top\n"
           "subsection Time\n  set Time step = 2 s\nend\n"
           "include common/base.prm\n",
           {"Time/End time = 20 s", "New place/Key of it=a=b", "Mesh/Cells=9"});
  ParameterSection root = parameters.root();
  Everything e;
  e.read(root);
  check::equal("including file holds", e.title, "top");
  check::relative("also in a subsection", e.time_step, 2., 0.);
  check::relative("command line holds", e.end_time, 20., 0.);
  check::is_true("command line holds over an include", e.cells == 9);
  check::is_true("files", parameters.input_files() == Words{directory + "case.prm",
                                                            directory + "common/base.prm",
                                                            directory + "common/deeper/more.prm"});
  std::string word;
  root.subsection("New place").add("Key of it", word, "");
  check::equal("command line makes a section", word, "a=b");
  check::equal("its origin", root.subsection("New place").origin("Key of it").file,
               "command line (--set)");
  parameters.refuse_unknown();
  const Origin origin = root.subsection("Time").origin("Time step");
  check::is_true("line", origin.file == directory + "case.prm" && origin.line == 3);
  check::is_true("origin of a section", root.subsection("Time").origin().line == 2);
  check::is_true("origin of a section not in the file",
                 root.subsection("Probe").origin().line == 0);
  check::is_true("given", root.subsection("Time").given("Time step") && !root.given("Model"));

  // Two files beside each other may agree, or a file above them decides.
  write("one.prm", "set Title = one\nset Same = 1\n");
  write("two.prm", "set Title = two\nset Same = 1\n");
  ParameterFile decided = file("include one.prm\ninclude two.prm\nset Title = three\n");
  std::string title;
  decided.root().add("Title", title, "");
  check::equal("decided above", title, "three");
  refused("undecided", "include one.prm\ninclude two.prm\n",
          "two.prm:1: 'Title': is 'two' here, but 'one' in .*one.prm:1");
  // An include in a subsection belongs to it.
  write("cells.prm", "set Cells = 3\n");
  ParameterFile inside = file("subsection Mesh\n  include cells.prm\nend\n");
  Everything f;
  f.read(inside.root());
  check::is_true("include in a subsection", f.cells == 3);
}

void test_unset()
{
  write("whole.prm", "set Title = whole\nsubsection Mesh\n  set Cells = 7\n  subsection Deep\n"
                     "    set A = 1\n  end\nend\nsubsection Probe\n  set Point = 1\nend\n");
  write("less.prm", "include whole.prm\nunset Title\n");
  ParameterFile taken =
      file("include less.prm\nunset subsection Probe\nsubsection Mesh\n  unset Cells\nend\n");
  const ParameterText &text = taken.text();
  check::is_true("unset in an included file", text.root().entry("Title") == nullptr);
  check::is_true("unset entry", text.find({"Mesh"})->entry("Cells") == nullptr);
  check::equal("what stays", text.find({"Mesh", "Deep"})->entry("A")->value(), "1");
  check::is_true("unset subsection", text.find({"Probe"}) == nullptr);

  // A subsection that the including file fills anew, with a subsection inside that an included
  // file had unset already.
  write("without.prm", "include whole.prm\nsubsection Mesh\n  unset subsection Deep\nend\n");
  ParameterFile anew =
      file("include without.prm\nunset subsection Mesh\nsubsection Mesh\n  set Refine = 2\nend\n");
  const ParameterText::Section *const mesh = anew.text().find({"Mesh"});
  check::is_true("own entries stay", mesh->entry("Refine") != nullptr);
  check::is_true("included ones go", mesh->entry("Cells") == nullptr && mesh->sections.empty());

  // One that the including file opens anew stays, also without entries, so that it is looked at.
  ParameterFile opened = file(
      "include whole.prm\nunset subsection Mesh\nsubsection Mesh\n  subsection Deep\n  end\nend\n"
      "unset subsection Probe\nsubsection Probe\nend\n");
  check::is_true("opened anew", opened.text().find({"Probe"}) != nullptr &&
                                    opened.text().find({"Mesh", "Deep"}) != nullptr);

  // A subsection inside goes with the one around it.
  ParameterFile whole =
      file("include whole.prm\nunset subsection Mesh\nsubsection Mesh\n  set Refine = 2\nend\n");
  check::is_true("subsections inside go, too", whole.text().find({"Mesh"})->sections.empty());

  ParameterFile above = file("include less.prm\nset Title = mine\n", {"Mesh/Cells=3"});
  check::equal("set above an unset", above.text().root().entry("Title")->value(), "mine");
  check::equal("command line", above.text().find({"Mesh"})->entry("Cells")->value(), "3");
  check::is_true("no note", above.text().notes().empty());

  refused("idle unset", "include whole.prm\nsubsection Mesh\n  unset Cell\nend\n",
          "case.prm:3: 'Mesh/Cell': there is nothing to unset");
  refused("idle unset of a subsection", "include whole.prm\nunset subsection Msh\n",
          "case.prm:2: 'Msh': there is nothing to unset");
  refused("unset of its own", "set A = 1\nunset A\n",
          "case.prm:2: 'A': is set and unset in one file; the first is in line 1");
  refused("unset twice", "include whole.prm\nunset Title\nunset Title\n",
          "case.prm:3: 'Title': is unset a second time; the first is in line 2");
  refused("unset with a value", "include whole.prm\nunset Title = 1\n", "has an '='");
  refused("unset of nothing", "unset\n", "case.prm:1: 'unset' has no name");
  refused("unset of no section", "unset subsection\n", "has no name");
  refused("unset beside", "include less.prm\ninclude whole.prm\n",
          "whole.prm:1: 'Title': is 'whole' here, but unset in .*less.prm:2");

  ParameterFile twice = file("set A = 1\n", {"A=2", "B/C=1", " A = 3"});
  check::equal("the last of the command line", twice.text().root().entry("A")->value(), "3");
  check::is_true("its note", twice.text().notes() ==
                                 Words{"the command line sets 'A' to '2' and then to '3'; the last "
                                       "one holds"});
}

/// What the command line takes out of the file.
void test_unset_of_the_command_line()
{
  write("whole.prm", "set Title = whole\nset A = 1\nsubsection Mesh\n  set Cells = 3\n"
                     "  set Order = 2\nend\n");
  const ParameterFile one =
      file("include whole.prm\nset B = 2\n", {"A", "B", "Mesh/Cells", "Mesh/Order=7"});
  const ParameterText::Section &root = one.text().root();
  check::is_true("an entry of an included file", root.entry("A") == nullptr);
  check::is_true("an entry of the file", root.entry("B") == nullptr);
  check::is_true("an entry of a section", one.text().find({"Mesh"})->entry("Cells") == nullptr);
  check::equal("beside one that is set", one.text().find({"Mesh"})->entry("Order")->value(), "7");
  check::equal("an entry that stays", root.entry("Title")->value(), "whole");
  check::equal("changes", one.text().changes(),
               "--unset A, --unset B, --unset Mesh/Cells, --set Mesh/Order=7");

  check::is_true("a section",
                 file("include whole.prm\n", {"Mesh"}).text().find({"Mesh"}) == nullptr);
  const ParameterFile refilled = file("include whole.prm\n", {"Mesh", "Mesh/Cells=9"});
  check::equal("a section with what is set",
               refilled.text().find({"Mesh"})->entry("Cells")->value(), "9");
  check::is_true("a section without the rest",
                 refilled.text().find({"Mesh"})->entry("Order") == nullptr);

  const ParameterFile changed = file("set A = 1\n", {"A", "A=2"});
  check::equal("taken out, then set", changed.text().root().entry("A")->value(), "2");
  check::is_true("its note", changed.text().notes() ==
                                 Words{"the command line takes out 'A' and then sets it to '2'; "
                                       "the last one holds"});
  for (const auto &[name, path, problem] :
       {std::make_tuple("misspelt", "Mesh/Cell", "'Mesh/Cell': there is nothing to unset.*'Cells'"),
        std::make_tuple("a misspelt section", "Msh", "'Msh': there is nothing to unset.*'Mesh'"),
        std::make_tuple("no name", "Mesh/", "has an empty name")})
    check::throws<InputError>(
        std::string("unset of the command line: ") + name,
        [path = path] { file("include whole.prm\n", {path}); }, problem);
}

void test_text_errors()
{
  check::throws<InputError>(
      "missing file", [] { ParameterFile("no such.prm"); },
      "^the parameter file 'no such.prm' does not exist. Check");
  check::throws<InputError>(
      "a directory", [] { ParameterFile("."); }, "is a directory");
  refused("missing include", "\ninclude no.prm\n",
          "case.prm:2: 'include': .*no.prm' does not exist");
  write("loop.prm", "include case.prm\n");
  refused("cyclic include", "include loop.prm\n", "loop.prm:1: 'include': .*includes itself");
  refused("not a line of any kind", "set A = 1\nTime step = 3\n",
          "case.prm:2: 'Time step = 3' cannot be understood. A line is");
  refused("end too many", "end\n", "case.prm:1: this 'end' closes no subsection");
  refused("not closed", "subsection A\nsubsection B\nend\n",
          "case.prm:1: 'A': this subsection is not closed");
  refused("no equals sign", "\n\nset Time step 3\n",
          "case.prm:3: 'set Time step 3' has no '='. Write 'set KEY = VALUE'");
  refused("no key", "set = 3\n", "has no key");
  refused("no section name", "subsection\n", "no name");
  refused("no file name", "include\n", "no file name");
  write("secret.txt", "root:x:0\n");
  refused("an included file is not shown", "include secret.txt\n",
          "secret.txt:1: this line cannot be understood");
  std::string sections, ends;
  for (unsigned int i = 0; i < 30000; ++i)
  {
    sections += "subsection A\n";
    ends += "end\n";
  }
  refused("sections too deep", sections + ends, "case.prm:51: there are more than 50 sections");
  std::string path_of_sections;
  for (unsigned int i = 0; i < 30000; ++i)
    path_of_sections += "A/";
  refused("sections of the command line too deep", "", "command line.*more than 50 sections", {},
          {path_of_sections + "B=1"});
  std::string statements;
  for (unsigned int i = 0; i < 20001; ++i)
    statements += "subsection A\nend\n";
  refused("too many statements", statements,
          "case.prm:40001: there are more than 40000 statements");
  for (unsigned int i = 0; i < 12; ++i)
  {
    const std::string next = "bomb" + std::to_string(i + 1) + ".prm";
    write("bomb" + std::to_string(i) + ".prm", "include " + next + "\ninclude " + next + "\n");
  }
  write("bomb12.prm", "set A = 1\n");
  refused("too many includes", "include bomb0.prm\n",
          "'include': there are more than 1000 includes");
  refused("not UTF-8", "set A = 1\nset Title = \xe4\n", "case.prm:2: the line has the byte 0xe4");
  refused("an override that is not UTF-8", "", "command line.*has the byte 0xe4", {}, {"A=\xe4"});
  refused("carriage returns alone", "set A = 1\rnonsense\r", "case.prm:2: 'nonsense'");
  refused("twice", "subsection A\nset B = 1\nend\nsubsection A\nset B = 1\nend\n",
          "case.prm:5: 'A/B': is set a second time; the first is in line 2");
  refused("command line without key", "", "empty name", {}, {"A/=1"});
  refused("command line with a comment", "", "'#'", {}, {"A=1 # x"});
  refused("line of what follows a continued line", "set A = 1 \\\n 2\nnonsense\n", "case.prm:3:");
}

void test_unknown()
{
  const auto declare = [](ParameterSection root) { Everything().read(root); };
  refused("unknown entry", "subsection Time\nset time stepp = 1\nend\n",
          "case.prm:2: 'Time/time stepp': unknown entry. Did you mean 'Time step'\\?$", declare);
  refused("swapped letters", "set Tilte = 1\n", "'Tilte': unknown entry. Did you mean 'Title'\\?",
          declare);
  refused("unknown section", "subsection Msh\nset A = 1\nend\n",
          "case.prm:1: 'Msh': unknown subsection. Did you mean 'Mesh'\\?$", declare);
  refused("nothing near", "subsection Mesh\nset Colour = 1\nend\n",
          "'Mesh/Colour': unknown entry. There is here 'Cells', 'Adaptive', 'Ranks'", declare);
  refused("sections are listed", "set Colour = 1\n",
          "'Title'; the subsections 'Time', 'Mesh', 'Probe', 'Materials'", declare);
  refused("wrong section", "set End time = 1\n",
          "'End time': unknown entry. There is a 'End time' in 'Time'", declare);
  refused("entry as section", "subsection Title\nend\n", "it is an entry", declare);
  refused("section as entry", "set Mesh = x\n", "it is a subsection", declare);
  refused("all at once", "set Tilte = 1\nsubsection Mesh\nset Cell = 1\nend\nsubsection Tim\nend\n",
          "case.prm:1: [^\n]*\n[^\n]*case.prm:3: [^\n]*\n[^\n]*case.prm:5: [^\n]*$", declare);
  refused("unknown on the command line", "",
          "^command line \\(--set\\): 'Mesh/Cell': unknown entry. Did you mean 'Cells'\\?", declare,
          {"Mesh/Cell=3"});
}

void test_value_errors()
{
  const auto declare = [](ParameterSection root) { Everything().read(root); };
  const auto value = [&](const std::string &name, const std::string &section,
                         const std::string &entry, const std::string &pattern)
  {
    refused(name, "subsection " + section + "\nset " + entry + "\nend\n",
            "case.prm:2: '" + section + "/" + pattern, declare);
  };
  refused("out of range",
          "subsection Materials\nsubsection beam\nset Density = -1450 kg/m^3\nend\nend\n",
          "case.prm:3: 'Materials/beam/Density': -1450 kg/m\\^3 is out of range. Give a value > 0, "
          "with a unit like kg/m\\^3, g/cm\\^3.$",
          [](ParameterSection root)
          {
            double density = 1.;
            root.subsection("Materials")
                .subsection("beam")
                .add("Density", density, Dimensions::density, "", Range::positive());
          });
  value("wrong unit", "Time", "Time step = 3 mm",
        "Time step': '3 mm' has the wrong unit: it is in m, not in s. Give a value > 0, with a "
        "unit like s, ms, min, h");
  value("unknown unit", "Time", "Time step = 3 fortnights",
        "Time step': .*unit 'fortnights' is unknown");
  value("no number", "Time", "Time step = short", "Time step': 'short' is no number");
  value("not a number", "Time", "Time step = nan", "Time step': 'nan' is no finite");
  value("no value", "Time", "Time step =", "Time step': there is no value");
  value("wrong choice", "Time", "Scheme = newmarc",
        "Scheme': 'newmarc' does not exist. Did you mean 'newmark'\\? Give one of: newmark, crank "
        "nicolson");
  value("integer out of range", "Mesh", "Cells = 0",
        "Cells': 0 is out of range. Give a whole number from 1 to 1000");
  value("negative integer", "Mesh", "Cells = -3", "Cells': -3 is out of range");
  value("no integer", "Mesh", "Cells = 2.5", "Cells': '2.5' is no whole number");
  value("no bool", "Mesh", "Adaptive = 1",
        "Adaptive': '1' is neither true nor false. Give true or false");
  value("list of integers", "Mesh", "Ranks = 1, 0", "Ranks': 0 is out of range");
  value("hole in a list", "Probe", "Fields = a,, b",
        "Fields': there is nothing between two commas");
  value("list with a missing unit", "Probe", "Stations = 3 cm, 4",
        "Stations': '4' has no unit, but others");
  value("missing input file", "Probe", "Measured = none.csv",
        "Measured': the file 'parameter_file_test/none.csv' does not exist");
  value("input file is a directory", "Probe", "Measured = .", "Measured': .* is a directory");
  refused("both bounds",
          "subsection Materials\nsubsection a\nset Poisson's ratio = 0.5\nend\nend\n",
          "Poisson's ratio': 0.5 is out of range. Give a value >= 0 and < 0.5", declare);
  refused("renamed", "set Old name = 1\n",
          "case.prm:1: 'Old name': this entry has a new name. Write 'New name'",
          [](ParameterSection root) { root.renamed("Old name", "New name"); });
  refused("refused by the caller", "\nsubsection Time\nend\n",
          "^" + directory + "case.prm:2: 'Time': is too long. Shorten it.$",
          [](ParameterSection root)
          { root.subsection("Time").refuse("", "is too long", "Shorten it"); });
}

/// A printed file opens every section that was read: that says nothing of what the user wants.
void test_empty_sections()
{
  ParameterFile parameters =
      file("subsection Time\nend\nsubsection Mesh\n  set Cells =\nend\n"
           "subsection Materials\n  subsection wall\n  end\n  subsection fluid\n"
           "    set Young's modulus = 1 Pa\n  end\nend\n");
  const ParameterSection root = parameters.root();
  check::is_true("an empty section is opened", root.has_subsection("Time"));
  check::is_true("an empty section sets nothing", !root.sets_in_subsection("Time"));
  check::is_true("an entry without a value sets nothing", !root.sets_in_subsection("Mesh"));
  check::is_true("a section that is not there", !root.sets_in_subsection("Probe"));
  check::is_true("an entry further below", root.sets_in_subsection("Materials"));
}

/// A parameter file cannot hold the path of every file that it can name.
void test_paths_that_no_file_can_hold()
{
  const auto measured_of = [](const std::string &prm)
  {
    ParameterFile parameters(prm);
    Everything read;
    read.read(parameters.root());
    return read.table;
  };
  for (const std::string folder : {"a #1", "two  blanks", "a tab\there", "commas, and; a \\"})
  {
    write(folder + "/t.csv", "1\n");
    write(folder + "/run/input/t.csv", "2\n");
    const std::string prm =
        write(folder + "/case.prm", "subsection Probe\n  set Measured = t.csv\nend\n");
    ParameterFile parameters(prm);
    Everything read;
    read.read(parameters.root());
    const std::filesystem::path there = std::filesystem::current_path() / directory / folder;
    std::ostringstream of_run;
    parameters.print(of_run, ParameterFile::Style::prm, {{there / "t.csv", "input/t.csv"}});
    const std::string printed = write(folder + "/run/parameters.prm", of_run.str());
    const std::string found = measured_of(printed);
    check::is_true(folder.substr(0, 5) + ": what a run prints can be read",
                   std::filesystem::equivalent(found, there / "t.csv") ||
                       std::filesystem::equivalent(found, there / "run/input/t.csv"));
    // On the screen: by the way from here if that can be read, else between quotes.
    const std::string on_screen =
        write("on_screen.prm", print(parameters, ParameterFile::Style::prm));
    check::is_true(folder.substr(0, 5) + ": what the screen has can be read",
                   std::filesystem::equivalent(measured_of(on_screen), there / "t.csv"));
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(there);
    ParameterFile here("case.prm");
    Everything again;
    again.read(here.root());
    write_here("printed.prm", print(here, ParameterFile::Style::prm));
    check::is_true(folder.substr(0, 5) + ": in its folder",
                   std::filesystem::equivalent(measured_of("printed.prm"), "t.csv"));
    std::filesystem::current_path(before);
  }
}

void test_rest()
{
  ParameterFile parameters =
      file("subsection Expected\n  set wave speed = 11 m/s +- 5 %\n  set A = b\nend\n");
  ParameterSection expected = parameters.root().subsection("Expected");
  const auto entries = expected.add_free_entries("A reference value");
  parameters.refuse_unknown();
  check::is_true("free entries", entries.size() == 2 && entries[0].first == "wave speed" &&
                                     entries[0].second == "11 m/s +- 5 %");
  check::equal("path", expected.subsection("x").path(), "Expected/x");
  check::equal("name", expected.name(), "Expected");
  check::is_true("has subsection", parameters.root().has_subsection("Expected") &&
                                       !parameters.root().has_subsection("Probe"));

  const auto identity = [](const std::string &text, const Words &left_out)
  {
    ParameterFile p = file(text);
    Everything e;
    e.read(p.root());
    return p.identity(left_out);
  };
  const std::string ms = identity("subsection Time\nset Time step = 20 ms\nend\n", {});
  check::is_true("identity: the unit does not matter",
                 ms == identity("subsection Time\nset Time step = 0.02\nend\n", {}));
  check::is_true("identity: the value does", ms != identity("", {}));
  check::is_true("identity: an entry left out",
                 identity("set Title = a\n", {"Title"}) == identity("", {"Title"}));
  check::is_true("identity: a section left out",
                 identity("subsection Time\nset Time step = 2\nend\n", {"Time"}) ==
                     identity("", {"Time"}));
  check::is_true("identity: no half names",
                 identity("set Title = a\n", {"Tit"}) != identity("", {"Tit"}));
  // The offset basis of FNV-1a with 64 bit: the hash of nothing.
  check::equal("identity of nothing", ParameterFile().identity(), "cbf29ce484222325");
}
} // namespace

UNIT_TEST(parameter_file)
{
  std::filesystem::remove_all(directory);
  std::filesystem::create_directory(directory);
  test_values();
  test_empty_values();
  test_documentation();
  test_includes();
  test_unset();
  test_unset_of_the_command_line();
  test_text_errors();
  test_unknown();
  test_value_errors();
  test_empty_sections();
  test_paths_that_no_file_can_hold();
  test_rest();
  std::filesystem::remove_all(directory);
}
} // namespace test_of_parameter_file
