#include <continua/analysis/run.h>

#include <continua/analysis/refinement_indicator.h>
#include <continua/base/interruption.h>
#include <continua/base/memory_limit.h>
#include <continua/base/version.h>
#include <continua/case/before_the_run/cost_of_case.h>
#include <continua/continuum/field_list.h>
#include <continua/mesh/gmsh_geometry.h>
#include <continua/mesh/kept_corners.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>
#include <utility>

namespace Continua
{
using namespace dealii;

template <int dim>
Run<dim>::Run(Case<dim> &input,
              const ParameterFile &file,
              const CommandLine &command_line,
              const OutputDirectory &directory,
              Log &log,
              Summary &summary)
    : input(input),
      file(file),
      command_line(command_line),
      directory(directory),
      log(log),
      summary(summary),
      is_writer(Utilities::MPI::this_mpi_process(input.communicator) == 0)
{
  summary.set_possible(input.quantities);
  describe_run();
}

template <int dim>
void Run<dim>::describe_run()
{
  summary.set("model", input.general.model);
  summary.set("discretisation", input.general.discretisation);
  if (input.problem.deformation == Deformation::finite)
  {
    summary.set("deformation", word_of(deformation_words(), input.problem.deformation));
    report_strain_laws();
  }
  summary.set("libraries", library_versions());
  if (!input.problem.regions.empty())
    summary.set("regions", input.problem.regions); // in the order of material_id
  input.power_laws.report_tables(log, summary);
  if (input.analysis.has_fields)
  {
    for (const std::string &line : cost_of(input))
      log.note(line);
    const CostEstimate estimate(cost_input(input));
    summary.set("estimated memory [bytes]", estimate.memory);
    summary.set("estimated time on one core [s]", estimate.time);
  }
  if (blas_is_reference())
    log.warning("the BLAS linked is the slow reference implementation: factorisation takes 3 to 7 "
                "times as long as "
                "with OpenBLAS (Debian: apt-get install libopenblas0-pthread)");
}

template <int dim>
void Run<dim>::report_strain_laws()
{
  for (std::size_t region = 0; region < input.problem.regions.size(); ++region)
  {
    const Material &material = input.problem.materials[region];
    if (!material.shear.relaxes())
      continue;
    const auto n_branches =
        std::count_if(material.shear.branches.begin(), material.shear.branches.end(),
                      [](const Branch &branch) { return !std::isinf(branch.relaxation_time); });
    log.line(input.problem.regions[region] + ": " + material.strain_law_parameters.type +
             " by the long-term modulus, with " + std::to_string(n_branches) + " neo-Hookean " +
             (n_branches == 1 ? "branch that relaxes" : "branches that relax"));
  }
}

template <int dim>
void Run<dim>::initialise(const std::function<void()> &make_mesh)
{
  const InterruptibleSetUp set_up(command_line.restart
                                      ? "the checkpoint stands, go on with --restart"
                                      : "nothing is computed yet, begin anew with --overwrite");
  log.memory_use().mark("coarse mesh and case");
  {
    SectionTimer::Scope scope(log.timer(), "mesh");
    if (dynamic_cast<const GmshGeometry<dim> *>(input.geometry.get()) != nullptr &&
        (input.mesh.refinements > 0 || input.adaptation.changes_mesh()))
      if (const std::string text = warning_of(kept_corners<dim>(
              *input.triangulation, input.problem.regions, input.problem.boundaries));
          !text.empty())
        log.warning(text);
    if (make_mesh)
      make_mesh();
    else
      refine(*input.triangulation, input.mesh.refinements);
  }
  log.memory_use().mark("mesh");
  InterruptibleSetUp::end_of_phase(input.communicator, "the mesh");
  input.power_laws.report_series(log, summary);
  input.absorbing_ends.report(log, summary);
  solver = make_solver<dim>(*input.triangulation, input.problem, input.discretisation, log);
  solver->initialise();
  input.probes.attach(*solver, input.problem.model, input.problem.mesh_moves);
  log.memory_use().mark("state and probes");
  InterruptibleSetUp::end_of_phase(input.communicator, "the initial state");

  const SolverSizes sizes = solver->sizes();
  std::ostringstream text;
  text << "Mesh: " << sizes.n_cells << " cells; unknowns:";
  for (const auto &dofs : sizes.n_dofs)
    text << ' ' << dofs.first << ' ' << dofs.second;
  log.line(text.str());
  if (Utilities::MPI::n_mpi_processes(input.communicator) > 1)
  {
    const PartitionQuality quality = measure_partition(*input.triangulation);
    std::ostringstream partition;
    partition << "Divided by " << word_of(partitioner_words(), input.mesh.partition.partitioner)
              << ": " << quality.n_cut_faces
              << " faces between ranks, most work of a rank over the mean " << quality.imbalance;
    log.detail(partition.str());
    if (quality.n_idle_ranks > 0)
      // To the error stream: what stands on the screen does not depend on the ranks.
      log.note("warning: " + std::to_string(quality.n_idle_ranks) + " of " +
               std::to_string(Utilities::MPI::n_mpi_processes(input.communicator)) +
               " ranks have no cells and only wait; take fewer ranks, or more cells");
  }
  for (const std::string &key : input.discretisation.citations())
    citations.add(key);
  citations.add(word_of(partitioner_words(), input.mesh.partition.partitioner));
  citations.add("trilinos");
}

template <int dim>
bool Run<dim>::flag(const double time)
{
  return flag_cells(dynamic_cast<parallel::distributed::Triangulation<dim> &>(*input.triangulation),
                    refinement_indicator(input, *solver, time), input.adaptation);
}

template <int dim>
bool Run<dim>::adapt(const double time)
{
  SectionTimer::Scope scope(log.timer(), "adapt mesh");
  log.memory_use().mark("steps and output");
  const AdaptationParameters &adaptation = input.adaptation;
  const unsigned int most_changes =
      adaptation.is_geometric() ? std::max(1u, adaptation.maximum_level - adaptation.minimum_level)
                                : 1;
  bool changed = false;
  for (unsigned int change = 0; change < most_changes && flag(time); ++change)
  {
    solver->prepare_refinement();
    input.triangulation->execute_coarsening_and_refinement();
    log.memory_use().mark("mesh");
    solver->transfer();
    changed = true;
  }
  return changed;
}

template <int dim>
bool Run<dim>::adapt_before_start()
{
  SectionTimer::Scope scope(log.timer(), "adapt mesh");
  if (!flag(0.))
    return false;
  input.triangulation->execute_coarsening_and_refinement();
  solver->initialise();
  return true;
}

template <int dim>
void Run<dim>::finish(const unsigned int n_steps, const double time)
{
  {
    // Fits of modes to long records take longer than many a run.
    SectionTimer::Scope scope(log.timer(), "results of probes");
    for (const std::string &text : input.probes.finish(summary))
      log.warning(text);
  }
  if (!input.error_norms.empty())
    input.error_norms.finish(*solver, time, input.problem.model, summary);
  summary.set("steps", static_cast<double>(n_steps));

  for (const std::string &key : input.expected_of_other_analyses)
    log.line("check: " + key + ": left out, since Analysis = " + input.general.analysis +
             " does not state it");
  bool all_passed = true;
  for (const std::string &verdict : summary.check(input.expected, all_passed))
    log.line(verdict);
  write_summary("finished");
}

template <int dim>
void Run<dim>::name_quantities(const Case<dim> &input, QuantityNames &names)
{
  const Problem &problem = input.problem;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    if (problem.materials[region].has_power_law())
      names.add("Prony fit error", problem.regions[region]);
  for (const BoundaryCondition &condition : problem.conditions)
    if (condition.type == BoundaryType::absorbing)
      names.add("absorbing end fit error", condition.name);
  input.probes.name_quantities(field_names<dim>(problem), input.analysis.is_steady(), names);
  input.error_norms.name_quantities(names);
}

template <int dim>
void Run<dim>::fail(const std::string &reason)
{
  summary.set("failure", reason);
  write_summary("failed");
}

template <int dim>
void Run<dim>::interrupt(const std::string &reason)
{
  summary.set("interruption", reason);
  write_summary("interrupted");
}

template <int dim>
void Run<dim>::write_summary(const std::string &status)
{
  summary.set("status", status);
  if (solver)
  {
    const SolverSizes sizes = solver->sizes();
    summary.set("cells", static_cast<double>(sizes.n_cells));
    std::map<std::string, double> dofs;
    for (const auto &entry : sizes.n_dofs)
      dofs[entry.first] = entry.second;
    summary.set("degrees of freedom", dofs);
    summary.set("linear solver", sizes.linear_solver);
    if (!sizes.reason_of_linear_solver.empty())
      summary.set("reason of linear solver", sizes.reason_of_linear_solver);
    summary.set("factor entries", sizes.factor_entries);
    summary.set("factor memory [bytes]", sizes.factor_memory);
    for (const auto &[name, key] : {std::pair("CHOLMOD", "cholmod"), std::pair("MUMPS", "mumps")})
      if (sizes.linear_solver.find(name) != std::string::npos)
        citations.add(key);
  }
  summary.set("wall time [s]", log.wall_times());
  log.memory_use().mark("steps and output");
  if (memory_held() > 0.)
    summary.set("memory of the first rank by part [bytes]",
                std::map<std::string, double>(log.memory_use().parts().begin(),
                                              log.memory_use().parts().end()));
  // Of this rank: the others may have failed.
  summary.set("peak memory of the first rank [bytes]", peak_memory());
  summary.set("warnings", log.warnings());
  log.timing_summary();
  log.memory_summary();
  report_output_share();
  if (is_writer)
  {
    summary.write(directory.file("summary.json"));
    citations.write(directory.file("citation.bib"));
  }
}

template <int dim>
void Run<dim>::report_output_share()
{
  const std::map<std::string, double> times = log.wall_times();
  std::map<std::string, double> shares;
  double sum = 0.;
  for (const char *const section : {"probes", "fields", "checkpoint"})
    if (const auto found = times.find(section); found != times.end())
      sum += shares[section] = found->second / times.at("total");
  shares["sum"] = sum;
  summary.set("share of output in the wall time [1]", shares);
  std::ostringstream text;
  text << "Output and checkpoints took " << std::setprecision(3) << 100. * sum
       << " % of the wall time";
  log.detail(text.str());
}

template class Run<2>;
template class Run<3>;
} // namespace Continua
