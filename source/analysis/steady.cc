#include <continua/analysis/steady.h>

#include <continua/analysis/steady_search.h>
#include <continua/base/interruption.h>
#include <continua/base/table_writer.h>
#include <continua/postprocess/field_writer.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
template <int dim>
void Steady<dim>::check(const Case<dim> &input, ParameterSection root)
{
  SteadySearch<dim>::check(input, root, "use Analysis = transient");
  const std::vector<Material> &materials = input.problem.materials;
  const bool has_solid =
      std::any_of(materials.begin(), materials.end(),
                  [](const Material &material) { return !material.shear.branches.empty(); });
  ParameterSection initial_state = root.subsection("Initial state");
  for (const char *key : {"Velocity", "Displacement", "Pressure"})
    if (has_solid && initial_state.given(key))
      initial_state.refuse(key, "a steady analysis has no initial state",
                           "Remove the entry, or use Analysis = transient");
}

template <int dim>
void Steady<dim>::name_quantities(const Case<dim> &input, QuantityNames &names)
{
  Run<dim>::name_quantities(input, names);
  LoopRecord<dim>::name_quantities(names);
  FlowReport<dim>::name_quantities(input, names);
  RangeReport<dim>::name_quantities(input, names);
}

template <int dim>
void Steady<dim>::perform()
{
  run.initialise();
  flow.start(0., 0.);
  Case<dim> &input = run.input;
  const double time = input.steady.time_of_loads;
  input.probes.open(run.directory.file("probes.csv"));

  std::unique_ptr<TableWriter> table;
  for (unsigned int cycle = 0; cycle <= input.adaptation.cycles; ++cycle)
  {
    if (cycle > 0 && !run.adapt(time))
    {
      run.log.line("No cell is left to refine");
      break;
    }
    solve(cycle == 0);
    const SolverSizes sizes = run.solver->sizes();
    const std::vector<double> probe_values = input.probes.present_values();
    if (input.adaptation.cycles > 0)
    {
      std::ostringstream text;
      text << "Cycle " << cycle << ": " << sizes.n_cells << " cells";
      run.log.line(text.str());
      if (run.is_writer)
      {
        if (!table)
        {
          std::vector<std::string> header = {"cycle [1]", "cells [1]"};
          for (const auto &dofs : sizes.n_dofs)
            header.push_back("unknowns of " + dofs.first + " [1]");
          for (const std::string &name : input.probes.column_names())
            header.push_back(name);
          table = std::make_unique<TableWriter>(run.directory.file("refinement.csv"), header);
        }
        std::vector<double> row = {static_cast<double>(cycle), static_cast<double>(sizes.n_cells)};
        for (const auto &dofs : sizes.n_dofs)
          row.push_back(dofs.second);
        row.insert(row.end(), probe_values.begin(), probe_values.end());
        table->row(row);
        table->flush();
      }
    }
    if (cycle < input.adaptation.cycles)
      SignalWatch::stop_if_asked(input.communicator, "after cycle " + std::to_string(cycle) +
                                                         "; a steady analysis begins anew");
  }
  if (table)
    table->flush();
  input.probes.record(time);
  if (input.output.final_fields)
  {
    FieldWriter<dim> writer(
        input.communicator, run.directory.path(),
        input.output.subdivisions_for(input.discretisation.velocities_per_cell()),
        input.output.higher_order_cells, input.output.files_per_state);
    writer.write(*run.solver, time);
    writer.finish(run.summary);
  }
  loop.finish(run.summary);
  if (n_steps > 0)
    run.summary.set("matrices factored", static_cast<double>(n_factors));
  flow.finish();
  range.take(time);
  range.finish();
  run.finish(n_steps, time);
}

template <int dim>
void Steady<dim>::record_load(const double load)
{
  const std::vector<double> values = run.input.probes.present_values();
  last_load = load;
  if (values.empty() || !run.is_writer)
    return;
  if (!load_table)
  {
    std::vector<std::string> header = {"load [1]"};
    for (const std::string &name : run.input.probes.column_names())
      header.push_back(name);
    load_table = std::make_unique<TableWriter>(run.directory.file("load-steps.csv"), header);
  }
  std::vector<double> row = {load};
  row.insert(row.end(), values.begin(), values.end());
  load_table->row(row);
  load_table->flush();
}

template <int dim>
void Steady<dim>::solve(const bool loads_come)
{
  const double time = run.input.steady.time_of_loads;
  if (run.solver->steady_is_direct())
    run.solver->solve_steady(time);
  else
  {
    // The last row is that of the state at rest, whatever the step with the last part came to.
    const bool has_table = loads_come && run.input.steady.load_steps > 1;
    const SteadySearch<dim> *search = nullptr;
    const auto sink = [&](const StepReport &report, const double passed, double)
    {
      if (has_table && search != nullptr && search->present_load() > last_load &&
          search->present_load() < 1.)
        record_load(search->present_load());
      loop.take(report, passed, run.log);
      flow.take(report, 0.);
      ++n_steps;
      n_factors += report.factors;
    };
    const std::string interrupted = "a steady analysis begins anew";
    const bool finds_unloaded_shape = run.input.problem.finds_unloaded_shape();
    if (finds_unloaded_shape)
      SteadySearch<dim>(run, sink, interrupted).find_unloaded_shape(loads_come);
    using Loads = typename SteadySearch<dim>::Loads;
    SteadySearch<dim> from_loads(run, sink, interrupted);
    search = &from_loads;
    from_loads.perform(finds_unloaded_shape && time != 0.    ? Loads::along_time
                       : !finds_unloaded_shape && loads_come ? Loads::in_parts
                                                             : Loads::present,
                       time);
    if (has_table && last_load > 0.)
      record_load(1.);
  }
}

template class Steady<2>;
template class Steady<3>;
} // namespace Continua
