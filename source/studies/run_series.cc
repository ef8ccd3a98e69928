#include <continua/studies/run_series.h>

#include <continua/base/atomic_file.h>
#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/base/parameter_text.h>
#include <continua/base/rank_agreement.h>
#include <continua/base/version.h>
#include <continua/postprocess/writing_rank.h>
#include <continua/studies/run_pool.h>

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

/// What the line of a run begins with.
std::string beginning_of(const std::string &run)
{
  return run + " case ";
}

/// The lines without that of a run.
std::string without_run(const std::string &lines, const std::string &run)
{
  std::istringstream stream(lines);
  std::string kept;
  for (std::string line; std::getline(stream, line);)
    if (line.compare(0, beginning_of(run).size(), beginning_of(run)) != 0)
      kept += line + "\n";
  return kept;
}
} // namespace

RunSeries::RunSeries(const AnalysisTable &analyses,
                     const MPI_Comm communicator,
                     const unsigned int dimension,
                     const CommandLine &command_line,
                     const std::vector<std::string> &input_files,
                     const double volume,
                     const unsigned int n_parallel)
    : analyses(analyses),
      communicator(communicator),
      dimension(dimension),
      command_line(command_line),
      input_files(input_files),
      volume(volume),
      n_parallel(Utilities::MPI::n_mpi_processes(communicator) > 1 ? 1 : n_parallel),
      program(program_identity(communicator))
{
}

std::string RunSeries::identity(const PlannedRun &plan) const
{
  std::ostringstream text;
  text << beginning_of(plan.name) << plan.identity << " ranks "
       << Utilities::MPI::n_mpi_processes(communicator) << " program " << program;
  return text.str();
}

RunSeries::State RunSeries::state_of(const PlannedRun &plan) const
{
  if (!command_line.restart)
    return State::fresh;
  const std::string line = "\n" + identity(plan) + "\n";
  const std::string &folder = plan.command_line.output_directory;
  if (("\n" + finished_runs).find(line) != std::string::npos && has_summary(plan))
    return State::finished;
  // What rank 0 sees holds for all.
  const bool goes_on = ("\n" + begun_runs).find(line) != std::string::npos &&
                       OutputDirectory::has_checkpoint(folder);
  return !broadcast(communicator, std::string(goes_on ? "x" : "")).empty() ? State::begun
                                                                           : State::fresh;
}

void RunSeries::prepare_folders(const std::vector<PlannedRun> &plans,
                                const std::vector<State> &states,
                                const OutputDirectory &directory) const
{
  on_writing_rank(communicator,
                  [&]()
                  {
                    for (const PlannedRun &plan : plans)
                      directory.file_of_case(plan.name + "/");
                  });
  for (std::size_t i = 0; i < plans.size(); ++i)
    if (states[i] == State::fresh)
      OutputDirectory(plans[i].command_line.output_directory,
                      command_line.overwrite || command_line.restart
                          ? OutputDirectory::Mode::overwrite
                          : OutputDirectory::Mode::fresh,
                      communicator, input_files);
}

void RunSeries::note(const PlannedRun &plan, const OutputDirectory &directory, const State state)
{
  // Its folder holds this run alone: nothing that was said before of the folder holds.
  for (std::string *const lines : {&finished_runs, &begun_runs})
    *lines = without_run(*lines, plan.name);
  (state == State::finished ? finished_runs : begun_runs) += identity(plan) + "\n";
  write_records(directory);
}

void RunSeries::write_records(const OutputDirectory &directory) const
{
  on_writing_rank(communicator,
                  [&]()
                  {
                    write_file_atomically(directory.file("checkpoint/finished runs"),
                                          finished_runs);
                    write_file_atomically(directory.file("checkpoint/begun runs"), begun_runs);
                  });
}

PlannedRun RunSeries::in_state(PlannedRun plan, const State state)
{
  plan.command_line.restart = state == State::begun;
  // Its folder is empty, or was emptied.
  plan.command_line.overwrite = false;
  return plan;
}

std::vector<RunResult> RunSeries::perform(const std::vector<PlannedRun> &plans,
                                          const OutputDirectory &directory,
                                          Log &log,
                                          const Finished &finished)
{
  if (command_line.restart && finished_runs.empty() && begun_runs.empty())
  {
    finished_runs = content_of(directory.file("checkpoint/finished runs"), communicator);
    begun_runs = content_of(directory.file("checkpoint/begun runs"), communicator);
  }
  std::vector<State> states;
  states.reserve(plans.size());
  for (const PlannedRun &plan : plans)
    states.push_back(state_of(plan));
  // Before the first run, since a folder may be refused.
  prepare_folders(plans, states, directory);
  // From now on there is something to restart from, if only from the first run.
  write_records(directory);

  std::vector<RunResult> runs(plans.size());
  std::vector<bool> has_ended(plans.size(), false);
  std::size_t n_told = 0;
  // In the order of the plans, which no machine changes.
  const auto tell = [&]()
  {
    for (; n_told < plans.size() && has_ended[n_told]; ++n_told)
    {
      const RunResult &run = runs[n_told];
      log.line(run.name + (!run.failure.empty()                ? ": failed"
                           : states[n_told] == State::finished ? ": was finished before"
                                                               : ": finished"));
      if (!run.failure.empty())
        continue;
      std::ostringstream detail;
      detail << run.name << " took " << run.wall_time << " s";
      log.detail(detail.str());
      finished(run, static_cast<unsigned int>(n_told));
    }
  };
  const auto end =
      [&](const unsigned int number, const Summary &summary, const std::string &failure)
  {
    runs[number] = result(plans[number], summary);
    runs[number].failure = failure;
    has_ended[number] = true;
    if (failure.empty() && states[number] != State::finished)
      note(plans[number], directory, State::finished);
    tell();
  };
  const auto end_in_folder = [&](const unsigned int number, std::string failure)
  {
    const Summary summary = summary_in_folder(plans[number], failure);
    end(number, summary, failure);
  };
  std::vector<PlannedRun> to_perform;
  std::vector<unsigned int> numbers; // of these
  for (unsigned int i = 0; i < plans.size(); ++i)
    if (states[i] == State::finished)
      end_in_folder(i, "");
    else
    {
      to_perform.push_back(in_state(plans[i], states[i]));
      numbers.push_back(i);
    }
  const auto begin = [&](const unsigned int i)
  { note(plans[numbers[i]], directory, State::begun); };
  if (n_parallel > 1 && to_perform.size() > 1)
    RunPool(n_parallel)
        .perform(
            to_perform, begin,
            [&](const unsigned int i, const std::string &failure)
            { end_in_folder(numbers[i], failure); },
            [&](const unsigned int i, const std::string &failure)
            {
              log.warning(to_perform[i].name +
                          " is tried again, alone, when the others have ended: " + failure);
            });
  else
    for (unsigned int i = 0; i < to_perform.size(); ++i)
    {
      SignalWatch::stop_if_asked(communicator, among_runs);
      begin(i);
      Summary summary;
      const std::string failure = perform(to_perform[i], summary);
      end(numbers[i], summary, failure);
    }
  return runs;
}

std::string RunSeries::perform(const PlannedRun &plan, Summary &summary) const
{
  CommandLine of_run = plan.command_line;
  of_run.text = text_of(of_run);
  try
  {
    const OutputDirectory directory(of_run.output_directory,
                                    of_run.restart ? OutputDirectory::Mode::restart
                                                   : OutputDirectory::Mode::fresh,
                                    communicator, input_files);
    ParameterFile file(of_run.parameter_file, of_run.overrides);
    const std::unique_ptr<Analysis> analysis = analyses.make(file, of_run, communicator);
    if (of_run.restart && analysis->has_checkpoints())
      analysis->check_restart(directory);
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
    const std::string reason = collapse_blanks(text_of_failure(error));
    return reason.empty() ? "unknown reason" : reason;
  }
  return "";
}

Summary RunSeries::summary_in_folder(const PlannedRun &plan, std::string &failure) const
{
  const std::string text =
      content_of(plan.command_line.output_directory + "/summary.json", communicator);
  try
  {
    if (!text.empty())
      return Summary::read(text);
    if (failure.empty())
      failure = "its summary.json is missing";
  }
  catch (const std::exception &error)
  {
    if (failure.empty())
      failure = "its summary.json cannot be read: " + collapse_blanks(error.what());
  }
  // A run that failed early has none.
  return Summary();
}

bool RunSeries::has_summary(const PlannedRun &plan) const
{
  std::string failure;
  summary_in_folder(plan, failure);
  return failure.empty();
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
