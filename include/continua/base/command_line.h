#ifndef continua_base_command_line_h
#define continua_base_command_line_h

#include <string>
#include <vector>

namespace Continua
{
/**
 * What is typed behind the name of the program; usage() has the options. The value of --set,
 * --sweep, --output, --mesh and --new may also follow an equals sign. FILE and options may stand in
 * any order.
 */
struct CommandLine
{
  /// Empty only with --version, --help, --examples, --print-parameters, --print-rules and --new;
  /// with --new the file to write.
  std::string parameter_file;
  std::vector<std::string> further_files; ///< they are run, or checked, too
  unsigned int n_jobs = 1;                ///< of --jobs: so many of several files at the same time
  std::vector<std::string> overrides;     ///< of --set
  std::vector<std::string> sweeps;        ///< of --sweep: "Section/Key=values" each
  std::string output_directory;           ///< default output/<name of the .prm>
  bool overwrite = false;
  bool restart = false;
  bool validate = false;
  bool version = false;
  bool help = false;
  bool examples = false;            ///< the shipped parameter files are listed
  bool allow_mesh_commands = false; ///< a .geo file may run programs and write files
  std::string print_parameters;     ///< empty, prm, json or markdown
  std::string print_rules;          ///< empty, markdown or json
  std::string mesh_file;            ///< of --mesh: the mesh is written instead of a run
  bool new_file = false;            ///< print or write a template instead of a run
  std::string template_name;        ///< of --new; empty: list them
  std::string text; ///< the command line as typed, quoted so that a shell reads it back

  /// Throws InputError for an unknown option (with the nearest one), a missing file, two files
  /// whose results would have one folder, or options that exclude each other.
  static CommandLine parse(int argc, const char *const *argv);
  /// The same for one of several files. The folder of its results is output/NAME for NAME.prm, or
  /// DIR/NAME with --output DIR.
  CommandLine with_file(const std::string &file) const;
  /// Its arguments as typed, the name of the program first, for one of several files: with the
  /// folder of its results, and without --jobs.
  std::vector<std::string> arguments_with_file(const std::string &file) const;
  /// What --help prints, with the exit statuses.
  static std::string usage();

private:
  std::string program;              ///< its name, as typed
  std::vector<std::string> options; ///< with their values, but for --output and --jobs
};
} // namespace Continua

#endif
