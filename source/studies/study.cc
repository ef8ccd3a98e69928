#include <continua/studies/study.h>

#include <continua/base/input_error.h>
#include <continua/base/units.h>
#include <continua/postprocess/writing_rank.h>
#include <continua/studies/chosen_quantities.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace Continua
{
using namespace dealii;

Study::Study(const AnalysisInput &input, Kind kind)
    : Analysis(input),
      analyses(input.analyses),
      kind(std::move(kind)),
      dimension(Continua::n_dimensions(model_of(general.model)))
{
}

void Study::read_case(const StudyParameters &of_study)
{
  parameters = of_study;
  if (dimension == 2)
    read_case_of<2>();
  else
    read_case_of<3>();
  input_files = file.input_files();
}

template <int dim>
void Study::read_case_of()
{
  const CaseUse use = command_line.validate ? CaseUse::check : CaseUse::run;
  const Case<dim> input = analyses.read_case<dim>(file, communicator, use, parameters.analysis);
  volume = GridTools::volume(*input.triangulation);
}

Study::Variant
Study::read_variant(const std::string &name,
                    const std::vector<unsigned int> &meshes,
                    const std::vector<std::pair<std::string, std::string>> &entries) const
{
  Variant variant;
  variant.name = name;
  variant.meshes = meshes;
  variant.command_line = command_line;
  variant.command_line.restart = false;
  set_entry(variant.command_line, "Analysis", parameters.analysis);
  for (const auto &[path, value] : entries)
    set_entry(variant.command_line, path, value);
  if (dimension == 2)
    read_variant_of<2>(variant);
  else
    read_variant_of<3>(variant);
  return variant;
}

template <int dim>
void Study::read_variant_of(Variant &variant) const
{
  ParameterFile file_of_variant(command_line.parameter_file, variant.command_line.overrides);
  const Case<dim> input =
      analyses.read_case<dim>(file_of_variant, communicator, use_of(variant.command_line));
  variant.identity = file_of_variant.identity({kind.section});
  variant.quantities = input.quantities;
  variant.refinements = input.mesh.refinements;
  variant.velocities_per_cell = input.discretisation.velocities_per_cell();
  variant.adaptation = input.adaptation;
  if (parameters.analysis == "transient")
    variant.time = input.time;
}

void Study::check_time_step(const Variant &variant) const
{
  if (parameters.refine_time_step && variant.time.is_adaptive())
    section().refuse("Refine the time step", "an adaptive time step follows its own error",
                     "Remove the entry, or set Time/Time step control = fixed");
}

void Study::check_divisions(const Variant &variant,
                            const std::string &key,
                            const std::string &remedy) const
{
  if (variant.refinements + variant.meshes.back() > most_refinements)
    section().refuse(key,
                     "with Mesh/Refinements the cells would be divided more than " +
                         std::to_string(most_refinements) + " times",
                     remedy);
}

Study::Plan
Study::plan_run(const unsigned int number, const unsigned int mesh, const std::string &output) const
{
  const Variant &variant = variants[number];
  Plan plan;
  plan.variant = number;
  plan.mesh = mesh;
  plan.run.name = folder_name(variant.name) + "-" + std::to_string(mesh);
  CommandLine &of_run = plan.run.command_line;
  of_run = variant.command_line;
  of_run.output_directory = output + "/" + plan.run.name;
  set_entry(of_run, "Title",
            (general.title.empty() ? "" : general.title + ": ") + variant.name + ", " + kind.mesh +
                " " + std::to_string(mesh));
  refine_mesh(of_run, variant, mesh);
  const int n_halvings = parameters.refine_time_step ? static_cast<int>(mesh) : 0;
  plan.time_step = std::ldexp(variant.time.time_step, -n_halvings);
  plan.run.identity = variant.identity + " time step " + shortest_number(plan.time_step);
  if (parameters.refine_time_step)
  {
    set_entry(of_run, "Time/Time step", shortest_number(plan.time_step) + " s");
    std::string changes;
    for (const auto &[time, step] : variant.time.changes)
      changes += (changes.empty() ? "" : ", ") + shortest_number(time) +
                 " s : " + shortest_number(std::ldexp(step, -n_halvings)) + " s";
    if (!changes.empty())
      set_entry(of_run, "Time/Time step changes", changes);
  }
  return plan;
}

std::vector<Study::Plan> Study::plan_runs(const std::string &output) const
{
  std::vector<Plan> plans;
  for (unsigned int variant = 0; variant < variants.size(); ++variant)
    for (const unsigned int mesh : variants[variant].meshes)
      plans.push_back(plan_run(variant, mesh, output));
  std::stable_sort(plans.begin(), plans.end(),
                   [](const Plan &a, const Plan &b) { return a.mesh < b.mesh; });
  return plans;
}

void Study::compute(const OutputDirectory &directory, Log &log, Summary &summary)
{
  const std::vector<Plan> plans = plan_runs(directory.path());
  std::vector<PlannedRun> planned;
  planned.reserve(plans.size());
  for (const Plan &plan : plans)
    planned.push_back(plan.run);
  std::set<unsigned int> checked;
  const std::vector<RunResult> results =
      RunSeries(analyses, communicator, dimension, command_line, input_files, volume)
          .perform(planned, directory, log,
                   [&](const RunResult &run, const unsigned int number)
                   {
                     if (checked.insert(kind.checks_each ? plans[number].variant : 0).second)
                       check_asked(kind.section + "/Quantities", parameters.quantities, run);
                   });
  std::vector<StudiedRun> runs;
  runs.reserve(plans.size());
  for (std::size_t i = 0; i < plans.size(); ++i)
    runs.push_back({results[i], plans[i].variant, plans[i].mesh, plans[i].time_step});

  const std::unique_ptr<StudyReport> report = make_report(runs);
  for (const std::string &line : report->lines())
    log.line(line);
  summary.set_possible(quantities);
  const std::string failed = set_status(summary, results);
  summary.set("analysis of the runs", parameters.analysis);
  summary.set("model", general.model);
  std::vector<std::string> names;
  for (const Variant &variant : variants)
    names.push_back(variant.name);
  summary.set(kind.variants, names);
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
