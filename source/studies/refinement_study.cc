#include <continua/studies/refinement_study.h>

#include <continua/base/citations.h>
#include <continua/base/input_error.h>
#include <continua/base/units.h>
#include <continua/postprocess/writing_rank.h>
#include <continua/studies/chosen_quantities.h>

#include <deal.II/grid/grid_tools.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

RefinementStudy::RefinementStudy(const AnalysisInput &input)
    : Analysis(input), analyses(input.analyses)
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
void RefinementStudy::read_ways()
{
  // The file alone first: what is wrong with it is not said of one of the ways.
  const CaseUse use = command_line.validate ? CaseUse::check : CaseUse::run;
  const Case<dim> input = analyses.read_case<dim>(file, communicator, use, parameters.analysis);
  volume = GridTools::volume(*input.triangulation);
  const ParameterSection section = file.root().subsection("Refinement study");
  for (const std::string &name : parameters.ways)
  {
    ways.push_back(read_way<dim>(name));
    check(ways.back(), name, section);
  }
  QuantityNames of_runs;
  for (const Way &way : ways)
    of_runs.add(way.quantities);
  RefinementReport::name_quantities(parameters, of_runs, quantities);
  of_runs.refuse_others(section, "Quantities", parameters.quantities);
  ParameterSection study = file.root().subsection("Refinement study");
  of_runs.refuse_others(study.subsection("Reference"), parameters.references);
  quantities.refuse_others(study.subsection("Expected"), parameters.expected);
}

template <int dim>
RefinementStudy::Way RefinementStudy::read_way(const std::string &name) const
{
  Way result;
  result.command_line = command_line;
  result.command_line.restart = false;
  set_entry(result.command_line, "Analysis", parameters.analysis);
  ParameterFile file_of_way(command_line.parameter_file, result.command_line.overrides);
  const Case<dim> input =
      analyses.read_case<dim>(file_of_way, communicator, use_of(result.command_line));
  result.identity = name + " " + file_of_way.identity({"Refinement study"});
  result.quantities = input.quantities;
  result.refinements = input.mesh.refinements;
  result.adaptation = input.adaptation;
  if (parameters.analysis == "transient")
    result.time = input.time;
  return result;
}

void RefinementStudy::check(const Way &way,
                            const std::string &name,
                            const ParameterSection &section) const
{
  if (name == "uniform" && way.refinements + parameters.cycles > most_refinements)
    section.refuse("Cycles",
                   "with Mesh/Refinements the cells would be divided more than " +
                       std::to_string(most_refinements) + " times",
                   "Give fewer cycles");
  if (parameters.refine_time_step && way.time.is_adaptive())
    section.refuse("Refine the time step", "an adaptive time step follows its own error",
                   "Remove the entry, or set Time/Time step control = fixed");
  if (name == "adaptive" && parameters.analysis == "transient")
  {
    if (way.adaptation.every_n_steps == 0 && way.adaptation.initial_cycles == 0)
      section.refuse("Refinement",
                     "the section Adaptivity does not change the mesh of a run in time",
                     "Set Adaptivity/Every n steps, or Initial cycles");
    if (way.adaptation.maximum_level + parameters.cycles > 25)
      section.refuse("Cycles",
                     "with Adaptivity/Maximum level the cells would be divided more than 25 times",
                     "Give fewer cycles");
  }
}

double RefinementStudy::time_step(const Way &way, const unsigned int cycle) const
{
  return parameters.refine_time_step ? std::ldexp(way.time.time_step, -static_cast<int>(cycle))
                                     : way.time.time_step;
}

void RefinementStudy::refine(CommandLine &of_run,
                             const unsigned int way,
                             const unsigned int cycle) const
{
  const AdaptationParameters &adaptation = ways[way].adaptation;
  const bool transient = parameters.analysis == "transient";
  if (parameters.ways[way] == "uniform")
  {
    set_entry(of_run, "Mesh/Refinements", std::to_string(ways[way].refinements + cycle));
    if (transient)
    {
      set_entry(of_run, "Adaptivity/Every n steps", "0");
      set_entry(of_run, "Adaptivity/Initial cycles", "0");
    }
    else if (parameters.analysis == "steady")
      set_entry(of_run, "Adaptivity/Cycles", "0");
  }
  else if (transient)
  {
    set_entry(of_run, "Adaptivity/Maximum level", std::to_string(adaptation.maximum_level + cycle));
    if (adaptation.initial_cycles > 0)
      set_entry(of_run, "Adaptivity/Initial cycles",
                std::to_string(adaptation.initial_cycles + cycle));
    // The mesh changes at the same times.
    if (parameters.refine_time_step)
      set_entry(of_run, "Adaptivity/Every n steps",
                std::to_string(adaptation.every_n_steps << cycle));
  }
  else
    set_entry(of_run, "Adaptivity/Cycles", std::to_string(cycle));
  if (parameters.refine_time_step)
  {
    set_entry(of_run, "Time/Time step", shortest_number(time_step(ways[way], cycle)) + " s");
    std::string changes;
    for (const auto &[time, step] : ways[way].time.changes)
      changes += (changes.empty() ? "" : ", ") + shortest_number(time) +
                 " s : " + shortest_number(std::ldexp(step, -static_cast<int>(cycle))) + " s";
    if (!changes.empty())
      set_entry(of_run, "Time/Time step changes", changes);
  }
}

PlannedRun RefinementStudy::plan_run(const unsigned int way,
                                     const unsigned int cycle,
                                     const std::string &output) const
{
  PlannedRun result;
  result.name = parameters.ways[way] + "-" + std::to_string(cycle);
  result.command_line = ways[way].command_line;
  set_entry(result.command_line, "Title",
            (general.title.empty() ? "" : general.title + ": ") + parameters.ways[way] +
                ", cycle " + std::to_string(cycle));
  refine(result.command_line, way, cycle);
  result.command_line.output_directory = output + "/" + result.name;
  result.identity =
      ways[way].identity + " time step " + shortest_number(time_step(ways[way], cycle));
  return result;
}

void RefinementStudy::compute(const OutputDirectory &directory, Log &log, Summary &summary)
{
  // Cycle by cycle, so that what fails or is misspelt shows early.
  std::vector<PlannedRun> plans;
  std::vector<StudiedRun> runs;
  for (unsigned int cycle = 0; cycle <= parameters.cycles; ++cycle)
    for (unsigned int way = 0; way < ways.size(); ++way)
    {
      plans.push_back(plan_run(way, cycle, directory.path()));
      runs.emplace_back();
      runs.back().way = way;
      runs.back().cycle = cycle;
      runs.back().time_step = parameters.analysis == "transient" ? time_step(ways[way], cycle) : 0.;
    }
  bool asked_known = false;
  const std::vector<RunResult> results =
      RunSeries(analyses, communicator, dimension, command_line, input_files, volume)
          .perform(plans, directory, log,
                   [&](const RunResult &run, unsigned int)
                   {
                     if (!asked_known)
                       check_asked("Refinement study/Quantities", parameters.quantities, run);
                     asked_known = true;
                   });
  for (unsigned int i = 0; i < runs.size(); ++i)
    static_cast<RunResult &>(runs[i]) = results[i];

  const RefinementReport study(parameters, dimension, runs);
  for (const std::string &line : study.lines())
    log.line(line);
  summary.set_possible(quantities);
  const std::string failed = set_status(summary, results);
  summary.set("analysis of the runs", parameters.analysis);
  summary.set("model", general.model);
  summary.set("refinement", parameters.ways);
  study.add_quantities(summary);
  bool all_passed = true;
  for (const std::string &verdict : summary.check(parameters.expected, all_passed))
    log.line(verdict);
  summary.set("warnings", log.warnings());
  // No rank may end the program before the files are there.
  on_writing_rank(communicator,
                  [&]()
                  {
                    study.write(directory.file("refinement.csv"));
                    summary.write(directory.file("summary.json"));
                    Citations().write(directory.file("citation.bib"));
                  });
  if (!failed.empty())
    throw RunError("these runs failed: " + failed);
}
} // namespace Continua
