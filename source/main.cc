#include <continua/analysis/case_run.h>
#include <continua/analysis/checkpoint.h>
#include <continua/base/command_line.h>
#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/base/version.h>
#include <continua/laboratory/material_laboratory.h>
#include <continua/laboratory/spin_coating_analysis.h>
#include <continua/program/documentation.h>
#include <continua/studies/comparison.h>
#include <continua/studies/refinement_study.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <functional>
#include <iostream>

namespace
{
using namespace Continua;

constexpr int status_done = 0, status_run_failed = 1, status_input_wrong = 2;

ParameterFile::Style style_of(const std::string &name)
{
  if (name == "json")
    return ParameterFile::Style::json;
  return name == "markdown" ? ParameterFile::Style::markdown : ParameterFile::Style::prm;
}

std::string output_path(const CommandLine &command_line)
{
  if (!command_line.output_directory.empty())
    return command_line.output_directory;
  return "output/" + std::filesystem::path(command_line.parameter_file).stem().string();
}

/// What every analysis has around it once its input is read: to print or validate only, or an
/// output folder with the input and a log. `has_checkpoint`: whether a restart goes on from one.
void with_output(ParameterFile &file,
                 const CommandLine &command_line,
                 const MPI_Comm communicator,
                 const std::string &title,
                 const bool has_checkpoint,
                 const std::function<void(const OutputDirectory &, Log &)> &perform)
{
  const bool is_writer = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  if (!command_line.print_parameters.empty())
  {
    if (is_writer)
      file.print(std::cout, style_of(command_line.print_parameters));
    return;
  }
  if (command_line.validate)
  {
    if (is_writer)
      std::cout << command_line.parameter_file << ": valid" << std::endl;
    return;
  }
  const OutputDirectory directory(output_path(command_line),
                                  command_line.restart     ? OutputDirectory::Mode::restart
                                  : command_line.overwrite ? OutputDirectory::Mode::overwrite
                                                           : OutputDirectory::Mode::fresh,
                                  communicator, file.input_files());
  // Before anything is written: a checkpoint that cannot be used leaves the folder as it is.
  if (command_line.restart && has_checkpoint)
    Checkpoint(communicator, directory, file).read();
  Log log(communicator);
  begin_output(file, command_line, communicator, title, directory, log);
  perform(directory, log);
}

template <int dim>
void run_case(ParameterFile &file, const CommandLine &command_line, const MPI_Comm communicator)
{
  Case<dim> input(file, communicator, command_line.restart);
  with_output(file, command_line, communicator, input.general.title,
              input.general.analysis == "transient",
              [&](const OutputDirectory &directory, Log &log)
              { perform_case(input, file, command_line, directory, log); });
}

/// A comparison or a refinement study.
template <typename Series>
void run_series(ParameterFile &file, const CommandLine &command_line, const MPI_Comm communicator)
{
  const Series series(file, command_line, communicator);
  with_output(file, command_line, communicator, series.title(), false,
              [&](const OutputDirectory &directory, Log &log) { series.perform(directory, log); });
}

void run_spin_coating(ParameterFile &file,
                      const CommandLine &command_line,
                      const MPI_Comm communicator)
{
  const SpinCoatingAnalysis analysis(file);
  with_output(file, command_line, communicator, analysis.title(), false,
              [&](const OutputDirectory &directory, Log &log)
              {
                if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
                  analysis.perform(command_line, directory, log);
              });
}

void run_material_laboratory(ParameterFile &file,
                             const CommandLine &command_line,
                             const MPI_Comm communicator)
{
  const MaterialLaboratory laboratory(file);
  with_output(file, command_line, communicator, laboratory.title(), false,
              [&](const OutputDirectory &directory, Log &log)
              { laboratory.perform(command_line, communicator, directory, log); });
}

int run(const CommandLine &command_line, const MPI_Comm communicator)
{
  const bool is_writer = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  if (command_line.help || command_line.version)
  {
    if (is_writer)
      std::cout << (command_line.help ? CommandLine::usage()
                                      : "Continua " + version() + " (" + revision() + ")\n");
    return status_done;
  }
  if (command_line.parameter_file.empty())
  {
    if (is_writer)
      print_documentation(std::cout, style_of(command_line.print_parameters));
    return status_done;
  }
  ParameterFile file(command_line.parameter_file, command_line.overrides);
  GeneralParameters general;
  general.read(file.root());
  if (general.analysis == "spin coating")
    run_spin_coating(file, command_line, communicator);
  else if (general.analysis == "comparison")
    run_series<Comparison>(file, command_line, communicator);
  else if (general.analysis == "refinement study")
    run_series<RefinementStudy>(file, command_line, communicator);
  else if (general.analysis == "material")
    run_material_laboratory(file, command_line, communicator);
  else if (n_dimensions(model_of(general.model)) == 2)
    run_case<2>(file, command_line, communicator);
  else
    run_case<3>(file, command_line, communicator);
  return status_done;
}
} // namespace

int main(int argc, char **argv)
{
  // The arguments are Continua's alone: PETSc takes each that it sees for an option of its own.
  char *program_name[] = {argv[0], nullptr};
  int n_names = 1;
  char **names = program_name;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(n_names, names, 1);
  const MPI_Comm communicator = MPI_COMM_WORLD;
  const bool is_writer = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  try
  {
    return run(CommandLine::parse(argc, argv), communicator);
  }
  catch (const Continua::InputError &error)
  {
    // Every rank reads the same input and finds the same mistake.
    if (is_writer)
      std::cerr << "error: " << error.what() << std::endl;
    return status_input_wrong;
  }
  catch (const Continua::Interrupted &interruption)
  {
    // All ranks come here.
    if (is_writer)
      std::cerr << interruption.what() << std::endl;
    return status_run_failed;
  }
  catch (const std::exception &error)
  {
    std::cerr << "error: " << error.what() << std::endl;
    // The other ranks may be waiting for this one.
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) > 1)
      MPI_Abort(communicator, status_run_failed);
    return status_run_failed;
  }
}
