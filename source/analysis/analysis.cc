#include <continua/analysis/analysis.h>

#include <continua/analysis/answer.h>
#include <continua/base/atomic_file.h>
#include <continua/base/duration_text.h>
#include <continua/base/input_error.h>
#include <continua/base/version.h>
#include <continua/postprocess/writing_rank.h>

#include <deal.II/base/mpi.h>

#include <sstream>

namespace Continua
{
CaseUse use_of(const CommandLine &command_line)
{
  if (command_line.validate || !command_line.print_parameters.empty())
    return CaseUse::check;
  return command_line.restart ? CaseUse::restart : CaseUse::run;
}

Analysis::Analysis(const AnalysisInput &input)
    : file(input.file),
      command_line(input.command_line),
      communicator(input.communicator),
      general(input.general)
{
}

std::vector<std::string> Analysis::outline() const
{
  return {"analysis: " + general.analysis};
}

void Analysis::write_mesh(const std::string & /*mesh_file*/)
{
  throw InputError({"command line", 0}, "--mesh",
                   "Analysis = " + general.analysis + " has no mesh, or several",
                   "Write --set Analysis=transient, steady or modal for the mesh of its case");
}

void Analysis::perform(const OutputDirectory &directory, Log &log, Summary &summary)
{
  on_writing_rank(communicator,
                  [&]()
                  {
                    log.open(directory.file("log.txt"), command_line.restart);
                    if (command_line.restart)
                      return;
                    std::ostringstream resolved;
                    file.print(resolved, ParameterFile::Style::prm,
                               OutputDirectory::names_of_copies(file.input_files()));
                    write_file_atomically(directory.file("parameters.prm"), resolved.str());
                  });
  if (!directory.warning().empty())
    log.warning(directory.warning());
  directory.copy_inputs(file.input_files());
  log.line("Continua" + (general.title.empty() ? "" : ": " + general.title));
  for (const std::string &note : file.text().notes())
    log.line(note);
  log.detail("version " + version() + ", revision " + revision());
  describe(summary);
  compute(directory, log, summary);
  if (!has_own_table())
    for (const std::string &text : answer_lines(summary))
      log.note(text);
  log.note("Wall time " + duration_text(log.wall_times().at("total")) + "; results in " +
           directory.path());
}

void Analysis::describe(Summary &summary) const
{
  summary.set("title", general.title);
  summary.set("status", "running");
  summary.set("version", version());
  summary.set("revision", revision());
  summary.set("revision has uncommitted changes", revision_is_dirty() ? 1. : 0.);
  summary.set("command line", command_line.text);
  summary.set("parameter file", command_line.parameter_file);
  summary.set("analysis", general.analysis);
  summary.set("ranks", static_cast<double>(dealii::Utilities::MPI::n_mpi_processes(communicator)));
}
} // namespace Continua
