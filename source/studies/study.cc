#include <continua/studies/study.h>

#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/postprocess/writing_rank.h>
#include <continua/studies/chosen_quantities.h>

#include <filesystem>
#include <set>
#include <utility>

namespace Continua
{
Study::Study(const AnalysisInput &input, std::string section_name)
    : Analysis(input),
      analyses(input.analyses),
      section_name(std::move(section_name)),
      dimension(Continua::n_dimensions(model_of(general.model)))
{
}

std::string Study::title_of_run(const std::string &text) const
{
  return (general.title.empty() ? "" : general.title + ": ") + text;
}

void Study::check_restart(const OutputDirectory &directory) const
{
  const std::string record = directory.file("checkpoint/finished runs");
  // What rank 0 sees holds for all.
  std::error_code ignored;
  if (broadcast(communicator, std::string(std::filesystem::exists(record, ignored) ? "x" : ""))
          .empty())
    throw InputError({directory.path(), 0}, "--restart",
                     "the folder holds a run that is none of a study: it has no record of finished "
                     "runs",
                     "Give the study a folder of its own by --output");
}

void Study::compute(const OutputDirectory &directory, Log &log, Summary &summary)
{
  std::set<unsigned int> checked;
  const std::vector<RunResult> runs =
      RunSeries(analyses, communicator, dimension, command_line, file.input_files(), volume,
                parameters.n_parallel)
          .perform(plan_runs(directory.path()), directory, log,
                   [&](const RunResult &run, const unsigned int number)
                   {
                     const std::optional<unsigned int> group = stating_group(number);
                     if (group && checked.insert(*group).second)
                       check_asked(section_name + "/Quantities", parameters.quantities, run);
                   });

  const std::unique_ptr<StudyReport> report = make_report(runs);
  for (const std::string &line : report->lines())
    log.line(line);
  summary.set_possible(quantities);
  const std::string failed = set_status(summary, runs);
  summary.set("analysis of the runs", parameters.analysis);
  summary.set("model", general.model);
  describe_runs(summary);
  report->add_quantities(summary);
  bool all_passed = true;
  for (const std::string &verdict : summary.check(parameters.expected, all_passed))
    log.line(verdict);
  summary.set("warnings", log.warnings());
  // No rank may end the program before the files are there.
  on_writing_rank(communicator,
                  [&]()
                  {
                    report->write(directory);
                    summary.write(directory.file("summary.json"));
                  });
  if (!failed.empty())
    throw RunError("these runs failed: " + failed);
}
} // namespace Continua
