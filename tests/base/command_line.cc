// The command line: every option, both ways of giving a value, and what is refused.

#include <continua/base/command_line.h>
#include <continua/base/input_error.h>

#include "../unit_test.h"

#include <vector>

namespace test_of_command_line
{
using namespace Continua;

namespace
{
CommandLine parse(std::vector<const char *> arguments)
{
  arguments.insert(arguments.begin(), "continua");
  return CommandLine::parse(static_cast<int>(arguments.size()), arguments.data());
}

void refused(const std::string &name,
             const std::vector<const char *> &arguments,
             const std::string &pattern)
{
  check::throws<InputError>(
      name, [&arguments]() { parse(arguments); }, pattern);
}
} // namespace

UNIT_TEST(command_line)
{
  const CommandLine plain = parse({"cases/beam 1.prm"});
  check::equal("file", plain.parameter_file, "cases/beam 1.prm");
  check::equal("default folder", plain.output_directory, "output/beam 1");
  check::equal("text", plain.text, "continua 'cases/beam 1.prm'");
  check::is_true("no flag is set", !plain.overwrite && !plain.restart && !plain.validate &&
                                       !plain.version && !plain.help &&
                                       plain.print_parameters.empty() && plain.overrides.empty());

  const CommandLine full = parse({"--set", "Time/End time=1 s", "--overwrite", "--output=results",
                                  "beam.prm", "--set=Title=it's = 2", "--validate"});
  check::is_true("overrides",
                 full.overrides == std::vector<std::string>{"Time/End time=1 s", "Title=it's = 2"});
  check::equal("folder", full.output_directory, "results");
  check::is_true("flags", full.overwrite && full.validate && !full.restart);
  check::equal("quoted text", full.text,
               "continua --set 'Time/End time=1 s' --overwrite --output=results beam.prm "
               "'--set=Title=it'\\''s = 2' --validate");

  check::equal("folder behind a blank", parse({"beam.prm", "--output", "-x/y"}).output_directory,
               "-x/y");
  check::is_true("restart", parse({"beam.prm", "--restart"}).restart);
  check::is_true("version needs no file", parse({"--version"}).version);
  check::is_true("help needs no file", parse({"--help"}).help);
  check::is_true("examples need no file", parse({"--examples"}).examples);
  check::is_true("short help", parse({"-h"}).help);
  check::is_true("commands of a mesh",
                 parse({"beam.prm", "--allow-mesh-commands"}).allow_mesh_commands &&
                     !plain.allow_mesh_commands);
  check::equal("default style", parse({"--print-parameters"}).print_parameters, "prm");
  check::equal("style", parse({"--print-parameters=json"}).print_parameters, "json");
  check::equal("rules", parse({"--print-rules"}).print_rules, "markdown");
  check::equal("style of rules", parse({"--print-rules=json"}).print_rules, "json");
  check::equal("style of a file", parse({"--print-parameters=markdown", "beam.prm"}).parameter_file,
               "beam.prm");

  const CommandLine list = parse({"--new"});
  check::is_true("list of templates", list.new_file && list.template_name.empty() &&
                                          list.parameter_file.empty() &&
                                          list.output_directory.empty());
  const CommandLine printed = parse({"--new=tube"});
  check::equal("template", printed.template_name, "tube");
  check::equal("template that is printed", printed.parameter_file, "");
  const CommandLine written = parse({"--new", "layered channel", "my.prm"});
  check::equal("template of two words", written.template_name, "layered channel");
  check::equal("template that is written", written.parameter_file, "my.prm");
  check::equal("mesh", parse({"a.prm", "--mesh", "b.vtu"}).mesh_file, "b.vtu");

  refused("template with an option", {"--new", "tube", "--set", "Title=a"}, "no other option");
  refused("mesh of another format", {"a.prm", "--mesh", "b.vtk"}, "--mesh b.vtk.*FILE.vtu");
  refused("mesh without a name", {"a.prm", "--mesh"}, "missing.*--mesh FILE.vtu");
  refused("mesh and restart", {"a.prm", "--mesh=b.vtu", "--restart"}, "excludes --restart");
  refused("mesh of nothing", {"--mesh", "b.vtu"}, "parameter file is missing");
  refused("nearest option", {"beam.prm", "--overwite"}, "'--overwite'.*Did you mean --overwrite");
  refused("nearest option with a value", {"beam.prm", "--ouput=x"}, "'--ouput'.*mean --output");
  refused("unlike any option", {"beam.prm", "--qqqqqqqqqq"}, "no such option.*--help lists");
  refused("short option", {"-v"}, "'-v'.*--help");
  refused("no file", {"--overwrite"}, "parameter file is missing.*continua FILE.prm");
  refused("nothing", {}, "parameter file is missing");
  refused("two files with one folder", {"a/b.prm", "b.prm"}, "'b.prm'.*'a/b.prm'.*same folder");
  refused("two files and what is for one", {"a.prm", "b.prm", "--mesh=c.vtu"},
          "'--mesh'.*for one parameter file");
  refused("a template and a further file", {"--new", "tube", "a.prm", "b.prm"},
          "'--new'.*for one parameter file");
  const CommandLine several =
      parse({"a.prm", "--set", "Title=d", "b/c.prm", "--jobs=2", "--restart", "--output", "e f"});
  check::is_true("several files", several.parameter_file == "a.prm" && several.n_jobs == 2 &&
                                      several.further_files == std::vector<std::string>{"b/c.prm"});
  const CommandLine second = several.with_file("b/c.prm");
  check::is_true("one of several", second.restart && second.parameter_file == "b/c.prm" &&
                                       second.further_files.empty() &&
                                       second.output_directory == "e f/c" &&
                                       second.overrides == several.overrides);
  check::is_true("arguments of one of several",
                 several.arguments_with_file("b/c.prm") ==
                     std::vector<std::string>{"continua", "b/c.prm", "--set", "Title=d",
                                              "--restart", "--output", "e f/c"});
  check::equal("folder of one of several",
               parse({"a.prm", "b.prm"}).with_file("b.prm").output_directory, "output/b");
  refused("jobs of one file", {"a.prm", "--jobs", "2"}, "'--jobs'.*mpirun");
  refused("no job", {"a.prm", "b.prm", "--jobs", "0"}, "--jobs 0.*whole number");
  refused("jobs in words", {"a.prm", "b.prm", "--jobs=two"}, "--jobs two.*whole number");
  refused("empty argument", {""}, "empty");
  refused("exclusive options", {"a.prm", "--restart", "--overwrite"},
          "'--overwrite'.*excludes --restart");
  refused("missing value", {"a.prm", "--set"}, "'--set'.*missing.*Section/Key=value");
  refused("option instead of a value", {"a.prm", "--output", "--restart"}, "'--output'.*missing");
  refused("a server beside a file", {"a.prm", "--serve", "socket"}, "'--serve'.*stands alone");
  refused("a server without a socket", {"--serve"}, "'--serve'.*missing.*--serve SOCKET");
  refused("empty folder", {"a.prm", "--output="}, "'--output'.*no name");
  refused("no value in an override", {"a.prm", "--set", "Title"}, "--set Title.*Section/Key=value");
  refused("no key in an override", {"a.prm", "--set", "=1"}, "names no entry");
  check::is_true("what is set and what is taken out, in order",
                 parse({"a.prm", "--unset", "Expected", "--set", "A=1", "--unset=B/C"}).overrides ==
                     std::vector<std::string>{"Expected", "A=1", "B/C"});
  refused("a value taken out", {"a.prm", "--unset", "A=1"}, "--unset A=1.*no.*name.*--unset");
  refused("nothing taken out", {"a.prm", "--unset"}, "'--unset'.*missing");
  refused("unknown style", {"--print-parameters=xml"}, "xml.*prm, json and markdown");
  refused("unknown style of rules", {"--print-rules=prm"}, "prm.*markdown and json");
  refused("rules of a file", {"a.prm", "--print-rules"}, "'--print-rules'.*--validate FILE");
  refused("value of a flag", {"a.prm", "--restart=yes"}, "--restart=yes.*takes no value");
  refused("option given twice", {"a.prm", "--output=b", "--output=c"}, "'--output'.*twice");

  for (const char *const word :
       {"--set", "--unset", "--output", "--overwrite", "--restart", "--validate",
        "--print-parameters", "--version", "--help, -h", "--allow-mesh-commands", "--new", "--mesh",
        "--examples", "--serve", "--jobs", "--print-rules", "0 done", "1 the run failed",
        "2 the input is wrong"})
    check::is_true(std::string("help names ") + word,
                   CommandLine::usage().find(word) != std::string::npos);
}
} // namespace test_of_command_line
