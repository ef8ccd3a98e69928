#include <continua/studies/mesh_study.h>

#include <continua/base/units.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

MeshStudy::MeshStudy(const AnalysisInput &input, const Kind &kind)
    : Study(input, kind.section), kind(kind)
{
}

void MeshStudy::read_case(const MeshStudyParameters &of_study)
{
  parameters = of_study;
  set_parameters(parameters);
  if (n_dimensions() == 2)
    read_case_of<2>();
  else
    read_case_of<3>();
}

template <int dim>
void MeshStudy::read_case_of()
{
  const CaseUse use = command_line.validate ? CaseUse::check : CaseUse::run;
  const Case<dim> input = analyses.read_case<dim>(file, communicator, use, parameters.analysis);
  volume = GridTools::volume(*input.triangulation);
}

MeshStudy::Variant
MeshStudy::read_variant(const std::string &name,
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
  if (n_dimensions() == 2)
    read_variant_of<2>(variant);
  else
    read_variant_of<3>(variant);
  return variant;
}

template <int dim>
void MeshStudy::read_variant_of(Variant &variant) const
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

void MeshStudy::check_time_step(const Variant &variant) const
{
  if (parameters.refine_time_step && variant.time.is_adaptive())
    section().refuse("Refine the time step", "an adaptive time step follows its own error",
                     "Remove the entry, or set Time/Time step control = fixed");
}

void MeshStudy::check_divisions(const Variant &variant,
                                const std::string &key,
                                const std::string &remedy) const
{
  if (variant.refinements + variant.meshes.back() > most_refinements)
    section().refuse(key,
                     "with Mesh/Refinements the cells would be divided more than " +
                         std::to_string(most_refinements) + " times",
                     remedy);
}

std::vector<MeshStudy::Place> MeshStudy::places() const
{
  std::vector<Place> result;
  for (unsigned int variant = 0; variant < variants.size(); ++variant)
    for (const unsigned int mesh : variants[variant].meshes)
      result.push_back({variant, mesh});
  std::stable_sort(result.begin(), result.end(),
                   [](const Place &a, const Place &b) { return a.mesh < b.mesh; });
  return result;
}

double MeshStudy::time_step(const Place &place) const
{
  const int n_halvings = parameters.refine_time_step ? static_cast<int>(place.mesh) : 0;
  return std::ldexp(variants[place.variant].time.time_step, -n_halvings);
}

PlannedRun MeshStudy::plan_run(const Place &place, const std::string &output) const
{
  const Variant &variant = variants[place.variant];
  const std::string mesh = std::to_string(place.mesh);
  PlannedRun run;
  run.name = folder_name(variant.name) + "-" + mesh;
  CommandLine &of_run = run.command_line;
  of_run = variant.command_line;
  of_run.output_directory = output + "/" + run.name;
  set_entry(of_run, "Title", title_of_run(variant.name + ", " + kind.mesh + " " + mesh));
  refine_mesh(of_run, variant, place.mesh);
  run.identity = variant.identity + " time step " + shortest_number(time_step(place));
  if (parameters.refine_time_step)
  {
    set_entry(of_run, "Time/Time step", shortest_number(time_step(place)) + " s");
    std::string changes;
    for (const auto &[time, step] : variant.time.changes)
      changes += (changes.empty() ? "" : ", ") + shortest_number(time) +
                 " s : " + shortest_number(std::ldexp(step, -static_cast<int>(place.mesh))) + " s";
    if (!changes.empty())
      set_entry(of_run, "Time/Time step changes", changes);
  }
  return run;
}

std::vector<PlannedRun> MeshStudy::plan_runs(const std::string &output) const
{
  std::vector<PlannedRun> plans;
  for (const Place &place : places())
    plans.push_back(plan_run(place, output));
  return plans;
}

std::optional<unsigned int> MeshStudy::stating_group(const unsigned int run) const
{
  return kind.checks_each ? places()[run].variant : 0;
}

std::unique_ptr<StudyReport> MeshStudy::make_report(const std::vector<RunResult> &runs) const
{
  const std::vector<Place> all = places();
  std::vector<StudiedRun> studied;
  studied.reserve(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i)
    studied.push_back({runs[i], all[i].variant, all[i].mesh, time_step(all[i])});
  return make_report_of(studied);
}

void MeshStudy::describe_runs(Summary &summary) const
{
  std::vector<std::string> names;
  for (const Variant &variant : variants)
    names.push_back(variant.name);
  summary.set(kind.variants, names);
}
} // namespace Continua
