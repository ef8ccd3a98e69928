#include <continua/studies/comparison.h>

#include <continua/base/citations.h>
#include <continua/base/input_error.h>
#include <continua/base/parameter_text.h>
#include <continua/base/units.h>
#include <continua/postprocess/writing_rank.h>
#include <continua/studies/chosen_quantities.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

Comparison::Comparison(const AnalysisInput &input) : Analysis(input), analyses(input.analyses)
{
  parameters.read(file.root());
  dimension = n_dimensions(model_of(general.model));
  if (dimension == 2)
    read_ways<2>();
  else
    read_ways<3>();
  input_files = file.input_files();
}

template <int dim>
void Comparison::read_ways()
{
  // The file alone first: what is wrong with it is not said of one of the ways.
  const CaseUse use = command_line.validate ? CaseUse::check : CaseUse::run;
  const Case<dim> input = analyses.read_case<dim>(file, communicator, use, parameters.analysis);
  volume = GridTools::volume(*input.triangulation);
  const ParameterSection section = file.root().subsection("Comparison");
  for (unsigned int way = 0; way < 2; ++way)
  {
    try
    {
      ways.push_back(read_way<dim>(way));
    }
    catch (const InputError &error)
    {
      section.refuse("Values",
                     "with " + parameters.entry + " = " + parameters.values[way] +
                         " the case is refused: " + error.what(),
                     "");
    }
    if (parameters.refine_time_step && ways[way].time.is_adaptive())
      section.refuse("Refine the time step", "an adaptive time step follows its own error",
                     "Remove the entry, or set Time/Time step control = fixed");
    if (ways[way].refinements + parameters.meshes_of(way).back() > most_refinements)
      section.refuse(way == 0 ? "Meshes" : "Meshes of the second",
                     "with Mesh/Refinements the cells would be divided more than " +
                         std::to_string(most_refinements) + " times",
                     "Give fewer divisions");
  }
  if (folder_name(parameters.name(0)) == folder_name(parameters.name(1)))
    section.refuse("Values", "the folders of the two would have the same name",
                   "Write the values otherwise");
  for (const Way &way : ways)
    way.quantities.refuse_others(section, "Quantities", parameters.quantities);
  QuantityNames of_runs = ways[0].quantities;
  of_runs.add(ways[1].quantities);
  ComparisonReport::name_quantities(parameters, of_runs, quantities);
  quantities.refuse_others(file.root().subsection("Comparison").subsection("Expected"),
                           parameters.expected);
}

template <int dim>
Comparison::Way Comparison::read_way(const unsigned int way) const
{
  Way result;
  result.command_line = command_line;
  result.command_line.restart = false;
  set_entry(result.command_line, "Analysis", parameters.analysis);
  set_entry(result.command_line, parameters.entry, parameters.values[way]);
  ParameterFile file_of_way(command_line.parameter_file, result.command_line.overrides);
  const Case<dim> input =
      analyses.read_case<dim>(file_of_way, communicator, use_of(result.command_line));
  result.identity = file_of_way.identity({"Comparison"});
  result.quantities = input.quantities;
  result.refinements = input.mesh.refinements;
  if (parameters.analysis == "transient")
    result.time = input.time;
  // At best, as displacements at vertices by elements of degree k: 2 k.
  result.orders.highest = 2. * input.discretisation.velocities_per_cell();
  if (parameters.refine_time_step && result.time.scheme == Scheme::euler_implicit)
    result.orders.assumed = 1.;
  return result;
}

Comparison::Plan Comparison::plan_run(const unsigned int way,
                                      const unsigned int mesh,
                                      const std::string &output) const
{
  const Way &of_way = ways[way];
  Plan result;
  result.run.name = folder_name(parameters.name(way)) + "-" + std::to_string(mesh);
  result.way = way;
  result.mesh = mesh;
  result.run.command_line = of_way.command_line;
  set_entry(result.run.command_line, "Title",
            (general.title.empty() ? "" : general.title + ": ") + parameters.name(way) + ", mesh " +
                std::to_string(mesh));
  set_entry(result.run.command_line, "Mesh/Refinements", std::to_string(of_way.refinements + mesh));
  const double share = parameters.refine_time_step ? std::ldexp(1., -static_cast<int>(mesh)) : 1.;
  result.time_step = share * of_way.time.time_step;
  if (parameters.refine_time_step)
  {
    set_entry(result.run.command_line, "Time/Time step", shortest_number(result.time_step) + " s");
    std::string changes;
    for (const auto &[time, step] : of_way.time.changes)
      changes += (changes.empty() ? "" : ", ") + shortest_number(time) +
                 " s : " + shortest_number(share * step) + " s";
    if (!changes.empty())
      set_entry(result.run.command_line, "Time/Time step changes", changes);
  }
  result.run.command_line.output_directory = output + "/" + result.run.name;
  result.run.identity = of_way.identity + " time step " + shortest_number(result.time_step);
  return result;
}

std::vector<Comparison::Plan> Comparison::plans(const std::string &output) const
{
  std::vector<Plan> result;
  for (unsigned int way = 0; way < 2; ++way)
    for (const unsigned int mesh : parameters.meshes_of(way))
      result.push_back(plan_run(way, mesh, output));
  std::stable_sort(result.begin(), result.end(),
                   [](const Plan &a, const Plan &b) { return a.mesh < b.mesh; });
  return result;
}

void Comparison::compute(const OutputDirectory &directory, Log &log, Summary &summary)
{
  const std::vector<Plan> all = plans(directory.path());
  std::vector<PlannedRun> planned;
  planned.reserve(all.size());
  for (const Plan &plan : all)
    planned.push_back(plan.run);
  bool asked_known[2] = {false, false};
  const std::vector<RunResult> results =
      RunSeries(analyses, communicator, dimension, command_line, input_files, volume)
          .perform(planned, directory, log,
                   [&](const RunResult &run, const unsigned int number)
                   {
                     if (!asked_known[all[number].way])
                       check_asked("Comparison/Quantities", parameters.quantities, run);
                     asked_known[all[number].way] = true;
                   });
  std::vector<ComparedRun> runs;
  for (unsigned int i = 0; i < all.size(); ++i)
  {
    runs.emplace_back();
    static_cast<RunResult &>(runs.back()) = results[i];
    runs.back().way = all[i].way;
    runs.back().mesh = all[i].mesh;
    runs.back().time_step = all[i].time_step;
  }
  report(runs, results, directory, log, summary);
}

void Comparison::report(const std::vector<ComparedRun> &runs,
                        const std::vector<RunResult> &results,
                        const OutputDirectory &directory,
                        Log &log,
                        Summary &summary) const
{
  const ComparisonReport comparison(parameters, {ways[0].orders, ways[1].orders}, runs);
  for (const std::string &line : comparison.lines())
    log.line(line);
  summary.set_possible(quantities);
  const std::string failed = set_status(summary, results);
  summary.set("analysis of the runs", parameters.analysis);
  summary.set("model", general.model);
  summary.set("compared", std::vector<std::string>{parameters.name(0), parameters.name(1)});
  comparison.add_quantities(summary);
  bool all_passed = true;
  for (const std::string &verdict : summary.check(parameters.expected, all_passed))
    log.line(verdict);
  summary.set("warnings", log.warnings());
  // No rank may end the program before the files are there.
  on_writing_rank(communicator,
                  [&]()
                  {
                    comparison.write_quantities(directory.file("comparison.csv"));
                    comparison.write_runs(directory.file("runs.csv"));
                    summary.write(directory.file("summary.json"));
                    Citations citations;
                    citations.add("roache1994");
                    citations.add("celik2008");
                    citations.write(directory.file("citation.bib"));
                  });
  if (!failed.empty())
    throw RunError("these runs failed: " + failed);
}
} // namespace Continua
