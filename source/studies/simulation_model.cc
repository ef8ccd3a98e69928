#include <continua/studies/simulation_model.h>

#include <continua/base/input_error.h>
#include <continua/base/interpolant.h>
#include <continua/base/table_cells.h>
#include <continua/studies/run_pool.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <utility>

namespace Continua
{
namespace
{
RunColumns read_run_columns(const std::string &file)
{
  RunColumns table;
  std::ifstream stream(file);
  std::string line;
  if (!std::getline(stream, line))
    throw RunError("the run has left no probes.csv");
  table.names = split_into_cells(line, ',');
  table.values.resize(table.names.size());
  while (std::getline(stream, line))
  {
    const std::vector<std::string> cells = split_into_cells(line, ',');
    if (cells.size() != table.names.size())
      throw RunError("a row of probes.csv is not whole");
    for (std::size_t c = 0; c < cells.size(); ++c)
      table.values[c].push_back(std::strtod(cells[c].c_str(), nullptr));
  }
  return table;
}

bool begins_with(const std::string &text, const std::string &beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}

/// Whether the column "stations 0.1 m: pressure [Pa]" is of the field of a station of the probe.
bool is_of(const std::string &column, const std::string &probe, const std::string &field)
{
  const std::string end = " m: " + field + " [";
  const std::size_t place = column.rfind(end);
  return begins_with(column, probe + " ") && place != std::string::npos &&
         column.find_first_not_of("0123456789.+-e", probe.size() + 1) == place;
}
} // namespace

SimulationModel::SimulationModel(const CommandLine &of_file,
                                 const OutputDirectory &directory,
                                 std::vector<ProbeColumns> probes,
                                 const unsigned int n_parallel,
                                 std::string name_of_runs,
                                 const double memory,
                                 std::function<void(const std::string &)> warn,
                                 std::string program)
    : command_line(without_data(of_file)),
      directory(directory),
      probes(std::move(probes)),
      n_parallel(n_parallel),
      name_of_runs(std::move(name_of_runs)),
      memory(memory),
      warn(std::move(warn)),
      program(std::move(program))
{
  command_line.overwrite = true;
  for (const auto &[path, value] :
       {std::pair("Analysis", "transient"), std::pair("Output/Field interval", "0"),
        std::pair("Output/Final fields", "false"), std::pair("Wave theory/Overlay", "false")})
    set_entry(command_line, path, value);
}

SimulationModel::Plan SimulationModel::plan(const Settings &settings)
{
  PlannedRun run;
  run.name = name_of_runs + "-" + std::to_string(++n_runs);
  run.memory = memory;
  run.command_line = command_line;
  directory.file_of_case(run.name + "/");
  run.command_line.output_directory = directory.path() + "/" + run.name;
  for (const auto &[path, value] : settings)
    set_entry(run.command_line, path, value);
  return {run, settings};
}

void SimulationModel::run(const std::vector<Settings> &all)
{
  std::vector<Plan> plans;
  std::vector<Settings> planned;
  for (const Settings &settings : all)
    if (histories.count(settings) == 0 && failures.count(settings) == 0 &&
        std::find(planned.begin(), planned.end(), settings) == planned.end())
    {
      plans.push_back(plan(settings));
      planned.push_back(settings);
    }
  std::vector<PlannedRun> runs;
  runs.reserve(plans.size());
  for (const Plan &planned_run : plans)
    runs.push_back(planned_run.run);
  std::string without_answer;
  RunPool(n_parallel, program)
      .perform(
          runs, [](unsigned int) {},
          [&](const unsigned int number, const std::string &failure)
          {
            const PlannedRun &ended = plans[number].run;
            if (says_nothing_of_input(failure))
              without_answer = ended.name + ": " + failure;
            else if (!failure.empty())
              failures[plans[number].settings] = failure;
            else
            {
              const std::string &folder = ended.command_line.output_directory;
              histories[plans[number].settings] = read_run_columns(folder + "/probes.csv");
              std::filesystem::remove_all(folder);
            }
          },
          [&](const unsigned int number, const std::string &failure)
          {
            warn(plans[number].run.name +
                 " is tried again, alone, when the others have ended: " + failure);
          });
  if (!without_answer.empty())
    throw RunError("the run " + without_answer +
                   ". This says nothing of its numbers, and is not kept: free memory or take a "
                   "coarser mesh, or report a crash; --restart goes on");
}

std::vector<ForwardAnswer> SimulationModel::answers(const std::vector<ForwardQuestion> &questions)
{
  std::vector<Settings> all;
  all.reserve(questions.size());
  for (const ForwardQuestion &question : questions)
    all.push_back(question.settings);
  run(all);
  std::vector<ForwardAnswer> answers;
  for (const ForwardQuestion &question : questions)
  {
    const auto found = histories.find(question.settings);
    answers.push_back(found != histories.end() ? answer(found->second, question)
                                               : ForwardAnswer{{}, failures.at(question.settings)});
  }
  return answers;
}

ForwardAnswer SimulationModel::answer(const RunColumns &table,
                                      const ForwardQuestion &question) const
{
  ForwardAnswer result;
  for (std::size_t p = 0; p < probes.size(); ++p)
  {
    StationHistories of_probe(probes[p].n_stations);
    for (const std::string &field : probes[p].fields)
    {
      // The stations stand in their order.
      std::size_t station = 0;
      for (std::size_t c = 0; c < table.names.size(); ++c)
        if (is_of(table.names[c], probes[p].probe, field) && station < of_probe.size())
        {
          const Interpolant history(table.values.front(), table.values[c],
                                    Interpolant::Kind::cubic);
          of_probe[station].emplace_back();
          for (const double time : question.times[p])
            of_probe[station].back().push_back(history(time));
          ++station;
        }
      if (station != of_probe.size())
        throw RunError("probes.csv of the run lacks a column of '" + probes[p].probe + "'");
    }
    result.histories.push_back(of_probe);
  }
  return result;
}
} // namespace Continua
