#include <continua/analysis/steady.h>

#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/base/table_writer.h>
#include <continua/case/case_checks.h>
#include <continua/postprocess/field_writer.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
template <int dim>
void Steady<dim>::check(const Case<dim> &input, ParameterSection root)
{
  const std::vector<Material> &materials = input.problem.materials;
  // A power law relaxes for ever.
  for (unsigned int region = 0; region < materials.size(); ++region)
    if (materials[region].has_power_law())
      root.subsection("Materials")
          .subsection(input.problem.regions[region])
          .refuse("Type",
                  "the stress of a power law relaxes to zero, so that it has no state at rest",
                  "Use a law with a long-term modulus, or Analysis = transient");
  const bool has_solid =
      std::any_of(materials.begin(), materials.end(),
                  [](const Material &material) { return !material.shear.branches.empty(); });
  for (unsigned int region = 0; region < materials.size(); ++region)
    if (!materials[region].shear.branches.empty() &&
        (materials[region].long_term_shear_modulus() == 0. ||
         std::isinf(materials[region].long_term_inverse_bulk_modulus())))
      root.subsection("Materials")
          .subsection(input.problem.regions[region])
          .refuse("Type",
                  "the stress of this solid relaxes to zero, so that it has no state at rest",
                  "Use a law with a long-term modulus, or Analysis = transient");
  for (const BoundaryCondition &condition : input.problem.conditions)
    for (const BoundaryPart *part : {&condition.normal, &condition.tangential})
      if (part->kind == BoundaryPart::Kind::velocity)
      {
        const bool touches_solid = std::any_of(
            condition.region_ids.begin(), condition.region_ids.end(),
            [&](const unsigned int region) { return !materials[region].shear.branches.empty(); });
        if (touches_solid && !part->is_zero())
          root.subsection("Boundaries")
              .subsection(condition.name)
              .refuse("", "a solid at rest cannot have a prescribed velocity",
                      "Prescribe zero, or use Analysis = transient");
      }
  if (!is_held(input.problem))
    root.subsection("Boundaries")
        .refuse("", "nothing holds the body: no boundary has a prescribed velocity",
                "Make one boundary 'fixed' or 'roller'");
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
}

template <int dim>
void Steady<dim>::perform()
{
  run.initialise();
  flow.start(0., 0.);
  Case<dim> &input = run.input;
  input.probes.open(run.directory.file("probes.csv"));

  std::unique_ptr<TableWriter> table;
  for (unsigned int cycle = 0; cycle <= input.adaptation.cycles; ++cycle)
  {
    if (cycle > 0 && !run.adapt(0.))
    {
      run.log.line("No cell is left to refine");
      break;
    }
    solve();
    const SolverSizes sizes = run.solver->sizes();
    std::vector<double> probe_values;
    run.solver->evaluate_probes(probe_values);
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
  input.probes.record(0.);
  if (input.output.final_fields)
  {
    FieldWriter<dim> writer(
        input.communicator, run.directory.path(),
        input.output.subdivisions_for(input.discretisation.velocities_per_cell()),
        input.output.higher_order_cells, input.output.files_per_state);
    writer.write(*run.solver, 0.);
    writer.finish(run.summary);
  }
  loop.finish(run.summary);
  flow.finish();
  run.finish(n_steps, 0.);
}

template <int dim>
void Steady<dim>::solve()
{
  if (run.solver->steady_is_direct())
    run.solver->solve_steady(0.);
  else
    step_to_rest();
}

template <int dim>
void Steady<dim>::step_to_rest()
{
  const RestParameters &rest = run.input.rest;
  const unsigned int few_corrections = run.input.problem.newton.maximum_iterations / 2;
  double largest_velocity = 0., size = rest.time_step, smallest = size, largest = size, passed = 0.;
  unsigned int n_halved = 0, n_corrections = 0;
  for (unsigned int step = 0; step < rest.maximum_steps; ++step)
  {
    const StepReport report = step_of(size, n_halved);
    passed += size;
    loop.take(report, passed, run.log);
    flow.take(report, 0.);
    ++n_steps;
    n_corrections += report.corrections;
    smallest = std::min(smallest, size);
    largest = std::max(largest, size);
    largest_velocity = std::max(largest_velocity, report.largest_velocity);
    if (report.largest_change <= rest.tolerance * largest_velocity)
    {
      std::ostringstream text;
      text << "At rest after " << step + 1 << " steps";
      if (smallest < largest)
        text << " of " << smallest << " s to " << largest << " s";
      if (n_corrections > 0)
        text << " with " << n_corrections << " corrections";
      if (n_halved > 0)
        text << "; " << n_halved << " steps had no solution and were made anew at half their size";
      run.log.line(text.str());
      return;
    }
    if (report.corrections <= few_corrections)
      size *= rest.time_step_growth;
    SignalWatch::stop_if_asked(run.input.communicator, "on the way to rest, after step " +
                                                           std::to_string(step + 1) +
                                                           "; a steady analysis begins anew");
  }
  std::ostringstream text;
  text << "the body did not come to rest in " << rest.maximum_steps << " steps of ";
  if (smallest < largest)
    text << smallest << " s to " << largest << " s";
  else
    text << rest.time_step << " s";
  text << "; raise Steady/Maximum steps or Steady/Time step";
  if (run.input.problem.convection.is_on)
    text << ", or find out with Analysis = transient whether the flow becomes steady";
  throw RunError(text.str());
}

template <int dim>
StepReport Steady<dim>::step_of(double &size, unsigned int &n_halved)
{
  for (int halvings = 0;; ++halvings)
  {
    Step euler = euler_step(0., size, Update::implicit);
    // Loads and pictures are those of t = 0, however long it takes.
    euler.balance_time = 0.;
    euler.time = 0.;
    try
    {
      return run.solver->advance(euler);
    }
    catch (const StepFailure &failure)
    {
      std::ostringstream text;
      text << "on the way to rest, step " << n_steps + 1 << " of " << size
           << " s: " << failure.what();
      if (halvings == most_halvings)
      {
        text << "; the step was halved " << most_halvings
             << " times (Steady/Time step, Steady/Time step growth)";
        throw RunError(text.str());
      }
      run.log.line(text.str() + "; it is made anew at half its size");
      size *= 0.5;
      ++n_halved;
    }
  }
}

template class Steady<2>;
template class Steady<3>;
} // namespace Continua
