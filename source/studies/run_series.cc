#include <continua/studies/run_series.h>

#include <continua/base/atomic_file.h>
#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/base/parameter_text.h>
#include <continua/base/quoted_name.h>
#include <continua/base/rank_agreement.h>
#include <continua/base/version.h>
#include <continua/postprocess/writing_rank.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
/// The path of an override "Section/Key=value", without blanks that do not count.
std::string path_of(const std::string &override_text)
{
  std::vector<std::string> names;
  for (const std::string &part :
       split_unquoted(override_text.substr(0, find_unquoted(override_text, "=")), '/'))
    names.push_back(without_quotes(collapse_blanks(part)));
  return join_path(names);
}

/// As a shell reads it back.
std::string quoted(const std::string &text)
{
  std::string result = "'";
  for (const char letter : text)
    result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return result + "'";
}

std::string text_of(const CommandLine &command_line)
{
  std::string text = "continua " + quoted(command_line.parameter_file);
  for (const std::string &entry : command_line.overrides)
    text += (entry.find('=') == std::string::npos ? " --unset " : " --set ") + quoted(entry);
  return text + " --output " + quoted(command_line.output_directory);
}

/// What tells this program from others: of one revision there may be several, changed and not
/// committed.
std::string program_identity(const MPI_Comm communicator)
{
  const std::filesystem::path file = std::filesystem::canonical("/proc/self/exe");
  std::ostringstream text;
  text << version() << " " << revision() << " of "
       << std::filesystem::last_write_time(file).time_since_epoch().count() << ", "
       << std::filesystem::file_size(file) << " bytes";
  // Nodes may have copies of other times.
  return broadcast(communicator, text.str());
}

/// The file as rank 0 sees it, on all ranks; empty if it cannot be read.
std::string content_of(const std::string &file, const MPI_Comm communicator)
{
  std::string content;
  if (Utilities::MPI::this_mpi_process(communicator) == 0)
  {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    content = text.str();
  }
  return broadcast(communicator, content);
}
} // namespace

std::string folder_name(const std::string &text)
{
  std::string name;
  for (const unsigned char letter : text)
    if (std::isalnum(letter) != 0)
      name += static_cast<char>(std::tolower(letter));
    else if (!name.empty() && name.back() != '-')
      name += '-';
  return name;
}

void set_entry(CommandLine &command_line, const std::string &path, const std::string &value)
{
  std::vector<std::string> &all = command_line.overrides;
  const std::string text = path + "=" + value;
  all.erase(std::remove_if(all.begin(), all.end(),
                           [&text](const std::string &other)
                           { return path_of(other) == path_of(text); }),
            all.end());
  all.push_back(text);
}

RunSeries::RunSeries(const AnalysisTable &analyses,
                     const MPI_Comm communicator,
                     const unsigned int dimension,
                     const CommandLine &command_line,
                     const std::vector<std::string> &input_files,
                     const double volume)
    : analyses(analyses),
      communicator(communicator),
      dimension(dimension),
      command_line(command_line),
      input_files(input_files),
      volume(volume)
{
}

std::string RunSeries::identity(const PlannedRun &plan) const
{
  std::ostringstream text;
  text << plan.name << " case " << plan.identity << " ranks "
       << Utilities::MPI::n_mpi_processes(communicator) << " program "
       << program_identity(communicator);
  return text.str();
}

std::vector<RunResult>
RunSeries::perform(const std::vector<PlannedRun> &plans,
                   const OutputDirectory &directory,
                   Log &log,
                   const std::function<void(const RunResult &, unsigned int)> &finished_run) const
{
  // The checkpoint of a series: a line for each run that is finished.
  const std::string checkpoint = directory.file("checkpoint/finished runs");
  std::string finished =
      command_line.restart ? content_of(checkpoint, communicator) : std::string();
  const auto is_finished = [&](const PlannedRun &plan)
  {
    return ("\n" + finished).find("\n" + identity(plan) + "\n") != std::string::npos &&
           !content_of(plan.command_line.output_directory + "/summary.json", communicator).empty();
  };

  // Before the first run, since a folder may be refused.
  on_writing_rank(communicator,
                  [&]()
                  {
                    for (const PlannedRun &plan : plans)
                      directory.file_of_case(plan.name + "/");
                  });
  std::vector<std::unique_ptr<OutputDirectory>> folders;
  folders.reserve(plans.size());
  for (const PlannedRun &plan : plans)
    folders.push_back(is_finished(plan) ? nullptr
                                        : std::make_unique<OutputDirectory>(
                                              plan.command_line.output_directory,
                                              command_line.overwrite || command_line.restart
                                                  ? OutputDirectory::Mode::overwrite
                                                  : OutputDirectory::Mode::fresh,
                                              communicator, input_files));
  // From now on there is something to restart from, if only from the first run.
  on_writing_rank(communicator, [&]() { write_file_atomically(checkpoint, finished); });
  std::vector<RunResult> runs;
  for (unsigned int i = 0; i < plans.size(); ++i)
  {
    Summary summary;
    std::string failure;
    if (folders[i] == nullptr)
      summary = summary_in_folder(plans[i]);
    else
      failure = perform(plans[i], *folders[i], summary);
    runs.push_back(result(plans[i], summary));
    RunResult &run = runs.back();
    run.failure = failure;
    log.line(run.name + (!failure.empty()        ? ": failed"
                         : folders[i] == nullptr ? ": was finished before"
                                                 : ": finished"));
    if (!failure.empty())
      continue;
    std::ostringstream detail;
    detail << run.name << " took " << run.wall_time << " s";
    log.detail(detail.str());
    finished_run(run, i);
    if (folders[i] != nullptr)
      finished += identity(plans[i]) + "\n";
    on_writing_rank(communicator, [&]() { write_file_atomically(checkpoint, finished); });
  }
  return runs;
}

std::string
RunSeries::perform(const PlannedRun &plan, const OutputDirectory &directory, Summary &summary) const
{
  CommandLine of_run = plan.command_line;
  of_run.text = text_of(of_run);
  try
  {
    ParameterFile file(of_run.parameter_file, of_run.overrides);
    const std::unique_ptr<Analysis> analysis = analyses.make(file, of_run, communicator);
    Log log(communicator, false);
    analysis->perform(directory, log, summary);
  }
  catch (const Interrupted &)
  {
    // The runs that are finished stand in the checkpoint: --restart goes on with this one.
    throw;
  }
  catch (const std::exception &error)
  {
    // One rank alone cannot go on to the next run.
    RankAgreement::wait_for_all(text_of_failure(error), exit_status_of_failure);
    const std::string reason = collapse_blanks(error.what());
    return reason.empty() ? "unknown reason" : reason;
  }
  return "";
}

Summary RunSeries::summary_in_folder(const PlannedRun &plan) const
{
  return Summary::read(
      content_of(plan.command_line.output_directory + "/summary.json", communicator));
}

RunResult RunSeries::result(const PlannedRun &plan, const Summary &summary) const
{
  double n_dofs = 0.;
  for (const auto &[field, number] : summary.numbers_of("degrees of freedom"))
    n_dofs += number;
  // Ranks have their own wall times, and quantities of waves are known to rank 0 alone.
  std::vector<double> numbers = {
      summary.number_of("cells"), n_dofs, summary.numbers_of("wall time [s]")["total"],
      summary.number_of("steps"),
      summary.number_of("linear iterations") + summary.number_of("corrections")};
  const std::size_t n_numbers = numbers.size();
  std::vector<std::string> names;
  for (const Quantity &quantity : summary.quantities())
    if (std::isfinite(quantity.value))
    {
      numbers.push_back(quantity.value);
      names.insert(names.end(), {quantity.name, quantity.unit, quantity.probe});
    }
  numbers = broadcast(communicator, numbers);
  names = broadcast(communicator, names);

  RunResult run;
  run.name = plan.name;
  run.n_cells = numbers[0];
  run.n_dofs = numbers[1];
  run.wall_time = numbers[2];
  run.n_steps = numbers[3];
  run.iterations = numbers[4];
  run.cell_size = run.n_cells > 0. ? std::pow(volume / run.n_cells, 1. / dimension) : 0.;
  for (std::size_t i = n_numbers; i < numbers.size(); ++i)
  {
    const std::size_t name = 3 * (i - n_numbers);
    run.quantities.push_back({names[name], numbers[i], names[name + 1], names[name + 2]});
  }
  return run;
}

std::string set_status(Summary &summary, const std::vector<RunResult> &runs)
{
  summary.set("status", "finished");
  std::string failed, reasons;
  for (const RunResult &run : runs)
    if (!run.failure.empty())
    {
      failed += (failed.empty() ? "" : ", ") + run.name;
      reasons += (reasons.empty() ? "" : "; ") + run.name + ": " + run.failure;
    }
  if (!failed.empty())
  {
    summary.set("status", "failed");
    summary.set("failure", reasons);
  }
  return failed;
}
} // namespace Continua
