#include <continua/base/atomic_file.h>
#include <continua/base/blas_threads.h>
#include <continua/base/command_line.h>
#include <continua/base/command_server.h>
#include <continua/base/input_error.h>
#include <continua/base/input_file.h>
#include <continua/base/interruption.h>
#include <continua/base/message_passing.h>
#include <continua/base/rank_agreement.h>
#include <continua/base/version.h>
#include <continua/mesh/gmsh_mesher.h>
#include <continua/mesh/gmsh_process.h>
#include <continua/postprocess/writing_rank.h>
#include <continua/program/analyses.h>
#include <continua/program/documentation.h>
#include <continua/program/examples.h>
#include <continua/program/parameter_catalogue.h>
#include <continua/program/parameter_templates.h>
#include <continua/program/rules_page.h>
#include <continua/program/run_report.h>
#include <continua/program/script.h>
#include <continua/program/several_runs.h>
#include <continua/program/unknown_names.h>
#include <continua/studies/run_pool.h>
#include <continua/studies/sweep_command.h>

#include <deal.II/base/mpi.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <vector>

namespace
{
using namespace Continua;

constexpr int status_done = 0;

/// Whether a study has started this process as one of its runs, which make no reports.
bool is_run_of_a_study = false;

ParameterFile::Style style_of(const std::string &name)
{
  if (name == "json")
    return ParameterFile::Style::json;
  return name == "markdown" ? ParameterFile::Style::markdown : ParameterFile::Style::prm;
}

/// "Continua 0.1.0 (revision)" and the libraries, a line each.
std::string version_text()
{
  std::string text = "Continua " + version() + " (" + revision() +
                     (revision_is_dirty() ? ", with uncommitted changes" : "") + ")\n";
  for (const auto &[library, its_version] : library_versions())
    text.append("  ").append(library).append(" ").append(its_version).append("\n");
  return text;
}

/// The analysis that the file asks for. Throws InputError. A misspelt name leaves its entry at the
/// default, with which anything may be wrong: the name is then the mistake to report.
std::unique_ptr<Analysis>
make_analysis(ParameterFile &file, const CommandLine &command_line, const MPI_Comm communicator)
{
  try
  {
    return analyses().make(file, command_line, communicator);
  }
  catch (const InputError &error)
  {
    refuse_unknown_names(file, error);
    throw;
  }
}

/// For what is there to be printed. Throws RunError if it does not arrive, as on a full disk;
/// whoever reads it may have enough of it (| head).
void print_all(const std::string &text)
{
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0)
    return;
  const int error = errno;
  // What is kept of it would fail again as the libraries end, which flush the output, too.
  const int nothing = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nothing >= 0)
    ::dup2(nothing, STDOUT_FILENO);
  if (error != EPIPE)
    throw RunError(std::string("cannot write to the standard output: ") + std::strerror(error));
}

/// Performs the analysis; its folder, which is no longer locked.
std::string perform_in_folder(Analysis &analysis,
                              const ParameterFile &file,
                              const CommandLine &command_line,
                              const MPI_Comm communicator)
{
  // Until here a signal ends the program at once: nothing is written.
  const SignalWatch watch;
  const OutputDirectory directory(command_line.output_directory,
                                  command_line.restart     ? OutputDirectory::Mode::restart
                                  : command_line.overwrite ? OutputDirectory::Mode::overwrite
                                                           : OutputDirectory::Mode::fresh,
                                  communicator, file.input_files());
  // Before anything is written: a checkpoint that cannot be used leaves the folder as it is.
  if (command_line.restart && analysis.has_checkpoints())
    analysis.check_restart(directory);
  Log log(communicator);
  Summary summary;
  analysis.perform(directory, log, summary);
  return directory.path();
}

/// Reads what the file asks for and performs it; --print-parameters and --validate only read.
void perform_file(const CommandLine &of_user, const MPI_Comm communicator)
{
  const CommandLine command_line = with_sweeps(of_user);
  const bool is_writer = is_writing_rank(communicator);
  ParameterFile file(command_line.parameter_file, command_line.overrides);
  const ParameterText::Section &given = file.text().root();
  if (given.entries.empty() && given.sections.empty())
    throw InputError(given.origin, "", "the parameter file is empty: it sets nothing",
                     "Begin with one of the shipped files of parameter_files");
  require_same_input(file, communicator);
  if (!command_line.mesh_file.empty())
    require_folder_of(command_line.mesh_file);
  if (command_line.allow_mesh_commands)
    allow_mesh_commands();
  const std::unique_ptr<Analysis> analysis = make_analysis(file, command_line, communicator);
  if (!command_line.print_parameters.empty())
  {
    std::ostringstream text;
    file.print(text, style_of(command_line.print_parameters));
    if (is_writer)
      print_all(text.str());
    return;
  }
  if (command_line.validate)
  {
    const std::vector<std::string> outline = analysis->outline();
    if (!is_writer)
      return;
    std::string text = printable(command_line.parameter_file) + ": valid\n";
    for (const std::string &line : outline)
      text += "  " + printable(line) + "\n";
    print_all(text);
    return;
  }
  if (!command_line.mesh_file.empty())
  {
    analysis->write_mesh(command_line.mesh_file);
    print_all(printable(command_line.mesh_file) + ": written\n");
    return;
  }
  const std::string folder = perform_in_folder(*analysis, file, command_line, communicator);
  if (!is_run_of_a_study && asks_for_report(file))
    make_report(folder, communicator);
}

/// --new: lists the templates, prints one, or writes it with the files that it reads.
void perform_new(const CommandLine &command_line)
{
  std::ostringstream text;
  if (command_line.template_name.empty())
    print_templates(text);
  else if (command_line.parameter_file.empty())
    print_template(command_line.template_name, text, std::cerr);
  else
  {
    const std::vector<std::string> written =
        write_template(command_line.template_name, command_line.parameter_file);
    for (const std::string &file : written)
      text << printable(file) << ": written\n";
    text << "Run it: continua " << printable(written.front()) << "\n";
  }
  print_all(text.str());
}

int refuse(const InputError &error)
{
  RankAgreement::print_error(error.what(), exit_status_of_wrong_input);
  return exit_status_of_wrong_input;
}

/// Several files are checked; a wrong one does not keep those behind it from being checked.
int validate_files(const CommandLine &command_line, const MPI_Comm communicator)
{
  std::vector<std::string> files = command_line.further_files;
  files.insert(files.begin(), command_line.parameter_file);
  int status = status_done;
  for (const std::string &file : files)
    try
    {
      perform_file(command_line.with_file(file), communicator);
    }
    catch (const InputError &error)
    {
      status = refuse(error);
    }
    catch (...)
    {
      if (is_writing_rank(communicator))
        std::cerr << "the check of " << printable(file) << " failed:" << std::endl;
      throw;
    }
  return status;
}

int perform(const CommandLine &command_line, const MPI_Comm communicator)
{
  const bool is_writer = is_writing_rank(communicator);
  if (command_line.help || command_line.version)
  {
    if (is_writer)
      print_all(command_line.help ? CommandLine::usage() : version_text());
  }
  else if (command_line.examples)
  {
    std::ostringstream text;
    print_examples(text, examples_folder());
    if (is_writer)
      print_all(text.str());
  }
  else if (!command_line.print_rules.empty())
  {
    std::ostringstream text;
    print_rules(text, style_of(command_line.print_rules));
    if (is_writer)
      print_all(text.str());
  }
  else if (command_line.new_file)
  {
    if (is_writer)
      perform_new(command_line);
  }
  else if (command_line.parameter_file.empty())
  {
    std::ostringstream text;
    print_documentation(text, style_of(command_line.print_parameters));
    if (is_writer)
      print_all(text.str());
  }
  else if (!command_line.further_files.empty() && command_line.validate)
    return validate_files(command_line, communicator);
  else if (!command_line.further_files.empty())
    throw InputError({"command line", 0}, command_line.further_files.front(),
                     "there are several parameter files, and a launcher of MPI has started this "
                     "process as one of its ranks",
                     "Give each file a launcher of its own (mpirun -n N continua FILE.prm), or "
                     "leave the launcher out: each file is then run on one rank");
  else
    perform_file(command_line, communicator);
  return status_done;
}

/// The run failed. What the ranks have of libraries may wait for others at its end.
int fail(const std::string &text, const MPI_Comm communicator)
{
  RankAgreement::print_error(text, exit_status_of_failure);
  if (dealii::Utilities::MPI::n_mpi_processes(communicator) > 1)
    MPI_Abort(communicator, exit_status_of_failure);
  return exit_status_of_failure;
}

/// One command line, from the start of MPI to its end.
int run_command_line(int argc, char **argv)
{
  // Whoever reads the output may go (| head): the rest of it is dropped, and the run goes on. A
  // file may reach the largest size that is allowed: writing it then fails with a reason. The
  // signals are blocked rather than ignored, since libraries set them back to their default.
  sigset_t of_writing;
  sigemptyset(&of_writing);
  sigaddset(&of_writing, SIGPIPE);
  sigaddset(&of_writing, SIGXFSZ);
  pthread_sigmask(SIG_BLOCK, &of_writing, nullptr);
  prepare_message_passing();
  // The arguments are Continua's alone: PETSc takes each that it sees for an option of its own.
  char *program_name[] = {argv[0], nullptr};
  int n_names = 1;
  char **names = program_name;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(n_names, names, 1);
  Continua::limit_blas_threads();
  const MPI_Comm communicator = MPI_COMM_WORLD;
  const bool is_writer = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  const RankAgreement agreement(communicator);
  try
  {
    return perform(CommandLine::parse(argc, argv), communicator);
  }
  catch (const Continua::InputError &error)
  {
    return refuse(error);
  }
  catch (const Continua::Interrupted &interruption)
  {
    // All ranks come here.
    if (is_writer)
      std::cerr << interruption.what() << std::endl;
    return exit_status_of_failure;
  }
  catch (const std::exception &error)
  {
    return fail(text_of_failure(error), communicator);
  }
  catch (...)
  {
    return fail("the run failed by an error without a text. Please report it.", communicator);
  }
}

/// Several files are performed by a process without MPI, which does not survive a copy. Nothing if
/// the command line asks for something else, or is wrong: it is then performed, or refused, as
/// ever.
std::optional<int> perform_several_files(const int argc, const char *const *argv)
{
  CommandLine command_line;
  try
  {
    command_line = CommandLine::parse(argc, argv);
  }
  catch (const Continua::InputError &)
  {
    return {};
  }
  if (command_line.further_files.empty() || command_line.validate || command_line.help ||
      command_line.version || command_line.examples || is_launched_rank())
    return {};
  try
  {
    return SeveralRuns(command_line, run_command_line).perform();
  }
  catch (const Continua::InputError &error)
  {
    return refuse(error);
  }
  catch (const std::exception &error)
  {
    std::cerr << "error: " << printable(error.what()) << std::endl;
    return exit_status_of_failure;
  }
}

/// --serve: performs command lines until none has come for a minute.
int serve(const std::string &socket_file)
{
  constexpr double idle_time = 60.;
  try
  {
    // Every refusal looks at it, and its making takes longer than a refusal.
    parameter_catalogue();
    CommandServer(socket_file, run_command_line).serve(idle_time);
    return status_done;
  }
  catch (const std::exception &error)
  {
    std::cerr << "error: " << printable(error.what()) << std::endl;
    return exit_status_of_wrong_input;
  }
}
} // namespace

int main(int argc, char **argv)
{
  // This program is its own helper: it meshes with gmsh, without MPI.
  if (is_gmsh_process(argc, argv))
    return run_gmsh_process(argc, argv);
  if (argc == 3 && argv[1] == std::string("--serve"))
    return serve(argv[2]);
  std::vector<char *> arguments(argv, argv + argc);
  if (is_run_of_a_pool(arguments))
  {
    is_run_of_a_study = true;
    // What the run states of its command line is what a user would have typed.
    const int n_arguments = static_cast<int>(arguments.size());
    arguments.push_back(nullptr);
    return run_command_line(n_arguments, arguments.data());
  }
  if (const std::optional<int> status = Continua::become_script(argc, argv))
    return *status;
  if (const std::optional<int> status = perform_several_files(argc, argv))
    return *status;
  return run_command_line(argc, argv);
}
