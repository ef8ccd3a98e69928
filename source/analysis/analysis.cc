#include <continua/analysis/analysis.h>

#include <continua/base/input_error.h>
#include <continua/base/version.h>
#include <continua/postprocess/writing_rank.h>

#include <fstream>

namespace Continua
{
Analysis::Analysis(const AnalysisInput &input)
    : file(input.file),
      command_line(input.command_line),
      communicator(input.communicator),
      general(input.general)
{
}

std::vector<std::string> Analysis::plan() const
{
  return {"analysis: " + general.analysis};
}

void Analysis::perform(const OutputDirectory &directory, Log &log, Summary &summary)
{
  log.open(directory.file("log.txt"), command_line.restart);
  if (is_writing_rank(communicator) && !command_line.restart)
  {
    std::ofstream resolved(directory.file("parameters.prm"));
    file.print(resolved, ParameterFile::Style::prm);
    if (!resolved)
      throw RunError("cannot write " + directory.file("parameters.prm"));
  }
  directory.copy_inputs(file.input_files());
  log.line("Continua" + (general.title.empty() ? "" : ": " + general.title));
  log.detail("version " + version() + ", revision " + revision());
  compute(directory, log, summary);
}
} // namespace Continua
