#include <continua/base/command_line.h>
#include <continua/base/input_error.h>
#include <continua/base/nearest_name.h>
#include <continua/base/quoted_name.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace Continua
{
namespace
{
struct Option
{
  std::string name;
  enum class Value
  {
    none,
    required,
    optional, ///< only after an equals sign
    next      ///< optional; after an equals sign, or the next argument that is no option
  } value;
};

const std::vector<Option> &options()
{
  static const std::vector<Option> table = {
      {"--set", Option::Value::required},   {"--unset", Option::Value::required},
      {"--sweep", Option::Value::required}, {"--output", Option::Value::required},
      {"--overwrite", Option::Value::none}, {"--restart", Option::Value::none},
      {"--validate", Option::Value::none},  {"--print-parameters", Option::Value::optional},
      {"--version", Option::Value::none},   {"--help", Option::Value::none},
      {"-h", Option::Value::none},          {"--allow-mesh-commands", Option::Value::none},
      {"--new", Option::Value::next},       {"--mesh", Option::Value::required},
      {"--examples", Option::Value::none},  {"--jobs", Option::Value::required},
      {"--serve", Option::Value::required}, {"--print-rules", Option::Value::optional}};
  return table;
}

[[noreturn]] void
refuse(const std::string &argument, const std::string &problem, const std::string &remedy)
{
  throw InputError({"command line", 0}, argument, problem, remedy);
}

const Option &find_option(const std::string &name)
{
  std::vector<std::string> names;
  for (const Option &option : options())
  {
    if (option.name == name)
      return option;
    names.push_back(option.name);
  }
  const std::string nearest = nearest_name(name, names);
  refuse(name, "there is no such option",
         (nearest.empty() ? "" : "Did you mean " + nearest + "? ") + "--help lists the options");
}

/// DIR/NAME for NAME.prm; DIR is output if none is given.
std::string output_of(const std::string &folder, const std::string &parameter_file)
{
  return (folder.empty() ? "output" : folder) + "/" +
         std::filesystem::path(parameter_file).stem().string();
}

/// The argument as a shell reads it back.
std::string shell_quoted(const std::string &argument)
{
  const std::string harmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                               "_-+=./:,@%^";
  if (!argument.empty() && argument.find_first_not_of(harmless) == std::string::npos)
    return argument;
  std::string result = "'";
  for (const char c : argument)
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

void apply(CommandLine &result, const std::string &name, const std::string &value)
{
  if (name == "--serve")
    refuse("--serve", "it stands alone, with the name of a socket that is not there yet",
           "Write continua --serve SOCKET");
  if (name == "--set")
  {
    if (find_unquoted(value, "=") == std::string::npos || value.front() == '=')
      refuse("--set " + value, "this names no entry and value",
             "Write --set \"Section/Key=value\"");
    result.overrides.push_back(value);
  }
  else if (name == "--sweep")
  {
    const std::size_t equals = find_unquoted(value, "=");
    if (equals == std::string::npos || equals == 0 || equals + 1 == value.size())
      refuse("--sweep " + value, "this names no entry and values",
             "Write --sweep \"Section/Key=1 MPa, 2 MPa\" or \"Section/Key=1 MPa to 3 MPa in 5\"");
    result.sweeps.push_back(value);
  }
  else if (name == "--unset")
  {
    if (value.empty() || find_unquoted(value, "=") != std::string::npos)
      refuse(
          "--unset " + value, "this is no name of an entry or section",
          "Write --unset \"Section/Key\" or --unset \"Section\"; a name with a '=' stands between "
          "double quotes");
    result.overrides.push_back(value);
  }
  else if (name == "--output")
  {
    if (value.empty())
      refuse("--output", "the folder has no name", "Write --output DIR");
    result.output_directory = value;
  }
  else if (name == "--jobs")
  {
    const bool is_number = !value.empty() && value.size() < 5 &&
                           value.find_first_not_of("0123456789") == std::string::npos;
    result.n_jobs = is_number ? static_cast<unsigned int>(std::stoul(value)) : 0;
    if (result.n_jobs == 0)
      refuse("--jobs " + value, "this is no number of runs",
             "Write a whole number, as in --jobs 2");
  }
  else if (name == "--print-parameters")
  {
    if (value != "prm" && value != "json" && value != "markdown")
      refuse("--print-parameters=" + value, "there is no such style",
             "The styles are prm, json and markdown");
    result.print_parameters = value;
  }
  else if (name == "--print-rules")
  {
    if (value != "markdown" && value != "json")
      refuse("--print-rules=" + value, "there is no such style",
             "The styles are markdown and json");
    result.print_rules = value;
  }
  else if (name == "--mesh")
  {
    if (std::filesystem::path(value).extension() != ".vtu")
      refuse("--mesh " + value, "the mesh is written in VTK's format .vtu",
             "Write --mesh FILE.vtu");
    result.mesh_file = value;
  }
  else if (name == "--new")
  {
    result.new_file = true;
    result.template_name = value;
  }
  else
  {
    bool &flag = name == "--overwrite"             ? result.overwrite
                 : name == "--restart"             ? result.restart
                 : name == "--validate"            ? result.validate
                 : name == "--examples"            ? result.examples
                 : name == "--version"             ? result.version
                 : name == "--allow-mesh-commands" ? result.allow_mesh_commands
                                                   : result.help;
    flag = true;
  }
}

/// The results of each go into a folder with the name of its file.
void require_folders_of_their_own(const CommandLine &command_line)
{
  std::map<std::string, std::string> file_of_name = {
      {std::filesystem::path(command_line.parameter_file).stem().string(),
       command_line.parameter_file}};
  for (const std::string &file : command_line.further_files)
  {
    const std::string name = std::filesystem::path(file).stem().string();
    const auto [earlier, is_new] = file_of_name.emplace(name, file);
    if (!is_new)
      refuse(file,
             "the results of '" + earlier->second +
                 "' would have the same folder, which is named '" + name + "' after the file",
             "Run one of them by itself, with --output DIR");
  }
}
} // namespace

CommandLine CommandLine::parse(const int argc, const char *const *argv)
{
  CommandLine result;
  std::vector<std::string> arguments(argv, argv + argc);
  std::vector<std::string> seen;
  result.program = arguments.empty() ? "continua" : arguments.front();
  for (std::size_t i = 0; i < arguments.size(); ++i)
    result.text += (i == 0 ? "" : " ") + shell_quoted(arguments[i]);

  for (std::size_t i = 1; i < arguments.size(); ++i)
  {
    const std::string &argument = arguments[i];
    if (argument.empty() || argument[0] != '-')
    {
      if (argument.empty())
        refuse("", "an argument is empty", "Name one parameter file");
      if (result.parameter_file.empty())
        result.parameter_file = argument;
      else
        result.further_files.push_back(argument);
      continue;
    }

    const std::size_t first = i;
    const std::size_t equals = argument.find('=');
    const std::string name = argument.substr(0, equals);
    const Option &option = find_option(name);
    if (option.name != "--set" && option.name != "--unset" && option.name != "--sweep")
    {
      if (std::find(seen.begin(), seen.end(), option.name) != seen.end())
        refuse(option.name, "this option is given twice", "Give it once");
      seen.push_back(option.name);
    }

    std::string value = option.name == "--print-parameters" ? "prm"
                        : option.name == "--print-rules"    ? "markdown"
                                                            : "";
    if (equals != std::string::npos)
    {
      if (option.value == Option::Value::none)
        refuse(argument, "this option takes no value", "Write " + option.name);
      value = argument.substr(equals + 1);
    }
    else if (option.value == Option::Value::required)
    {
      if (i + 1 == arguments.size() || arguments[i + 1].compare(0, 2, "--") == 0)
        refuse(option.name, "its value is missing",
               option.name == "--set"     ? "Write --set \"Section/Key=value\""
               : option.name == "--unset" ? "Write --unset \"Section/Key\""
               : option.name == "--sweep" ? "Write --sweep \"Section/Key=1 MPa, 2 MPa\""
               : option.name == "--mesh"  ? "Write --mesh FILE.vtu"
               : option.name == "--serve" ? "Write continua --serve SOCKET"
               : option.name == "--jobs"  ? "Write --jobs N"
                                          : "Write --output DIR");
      value = arguments[++i];
    }
    else if (option.value == Option::Value::next && i + 1 < arguments.size() &&
             arguments[i + 1].compare(0, 1, "-") != 0)
      value = arguments[++i];
    apply(result, option.name, value);
    if (option.name != "--output" && option.name != "--jobs")
      result.options.insert(result.options.end(),
                            arguments.begin() + static_cast<std::ptrdiff_t>(first),
                            arguments.begin() + static_cast<std::ptrdiff_t>(i + 1));
  }

  for (const char *const other : {"--new", "--mesh", "--print-parameters"})
    if (!result.further_files.empty() && std::find(seen.begin(), seen.end(), other) != seen.end())
      refuse(other, "it is for one parameter file, and there are several", "Name one");
  if (!result.further_files.empty() && !result.validate)
    require_folders_of_their_own(result);
  if (result.further_files.empty() && std::find(seen.begin(), seen.end(), "--jobs") != seen.end())
    refuse("--jobs", "it is for several parameter files, and there is one",
           "Name several, or use mpirun -n N for one run on several ranks");
  if (result.overwrite && result.restart)
    refuse("--overwrite",
           "it excludes --restart: the one removes the checkpoint that the other needs",
           "Give one of the two");
  for (const char *const other : {"--restart", "--validate", "--print-parameters"})
    if (!result.mesh_file.empty() && std::find(seen.begin(), seen.end(), other) != seen.end())
      refuse("--mesh",
             std::string("it excludes ") + other + ": the mesh is written instead of a run",
             "Give one of the two");
  if (result.new_file && seen.size() + result.overrides.size() + result.sweeps.size() > 1)
    refuse("--new", "it writes a first parameter file, and takes no other option",
           "Write continua --new NAME FILE.prm, then continua FILE.prm");
  if (!result.print_rules.empty() && arguments.size() > 2)
    refuse("--print-rules", "it prints the rules for all files, and stands alone",
           "Write continua --print-rules, or continua --validate FILE.prm to check a file");
  if (!result.mesh_file.empty() && result.parameter_file.empty())
    refuse("--mesh", "the parameter file is missing", "Write continua FILE.prm --mesh FILE.vtu");
  if (result.parameter_file.empty() && !result.help && !result.version && !result.new_file &&
      !result.examples && result.print_parameters.empty() && result.print_rules.empty())
    refuse("", "the parameter file is missing",
           "Write continua FILE.prm; continua --new begins one, --help lists the options");
  if (result.output_directory.empty() && !result.parameter_file.empty() && !result.new_file &&
      result.further_files.empty())
    result.output_directory = output_of("", result.parameter_file);
  return result;
}

CommandLine CommandLine::with_file(const std::string &file) const
{
  CommandLine result = *this;
  result.parameter_file = file;
  result.further_files.clear();
  result.output_directory = output_of(output_directory, file);
  return result;
}

std::vector<std::string> CommandLine::arguments_with_file(const std::string &file) const
{
  std::vector<std::string> result = {program, file};
  result.insert(result.end(), options.begin(), options.end());
  result.insert(result.end(), {"--output", output_of(output_directory, file)});
  return result;
}

std::string CommandLine::usage()
{
  return R"(Usage: continua FILE.prm... [OPTION]...
       mpirun -n N continua FILE.prm [OPTION]...
       continua --validate FILE.prm...
       continua --new [NAME [FILE.prm]]
       continua report DIR...
       continua plot DIR...

Runs what the parameter file describes. Several files are run one after the other, each as if alone.

  --new                       lists the templates, one for each geometry and each analysis
  --new NAME [FILE.prm]       prints a template, or writes it to FILE.prm: a file with comments that runs
  --set "Section/Key=value"   sets an entry, over the file; as often as you like
  --unset "Section/Key"       takes out an entry or a section that the file has; as often as you like
  --sweep "Section/Key=1 MPa, 2 MPa"
                              runs the file for each of these values, also of a range (1 MPa to 3 MPa
                              in 5), side by side; several entries: each value with each other one
  --output DIR                the folder of the results (default: output/<name of the file>)
                              of several files: DIR/<name of the file>
  --jobs N                    runs so many of several files at the same time
  --overwrite                 removes the run that the folder holds (its results only)
  --restart                   continues the run that the folder holds from its checkpoint
  --validate                  reads and checks the input, says what would be run, and stops;
                              it also takes several files
  --mesh FILE.vtu             writes the mesh with the names of its regions and boundaries, and stops
  --allow-mesh-commands       lets a .geo file run programs and write files, as gmsh does; without it
                              such a file is refused
  --print-parameters[=STYLE]  prints every entry with value, unit and meaning, and stops;
                              STYLE is prm (default), json or markdown; without FILE the defaults
  --print-rules[=STYLE]       prints which features go with which, and stops; STYLE is markdown (default)
                              or json
  --serve SOCKET              performs the command lines that come through the socket, without starting
                              anew for each: for many short runs (see the manual)
  --examples                  lists the parameter files that came with the program, and where they are
  --version                   prints the version, and the libraries with theirs
  --help, -h                  prints this text

Exit status: 0 done, 1 the run failed, 2 the input is wrong.
)";
}
} // namespace Continua
