#include <continua/analysis/rest_search.h>

#include <continua/analysis/free_motions.h>
#include <continua/base/input_error.h>
#include <continua/base/interruption.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
template <int dim>
RestSearch<dim>::RestSearch(Run<dim> &run, const Sink &sink, const std::string &interrupted)
    : run(run), sink(sink), interrupted(interrupted)
{
}

template <int dim>
void RestSearch<dim>::check(const Case<dim> &input,
                            ParameterSection root,
                            const std::string &remedy)
{
  const std::vector<Material> &materials = input.problem.materials;
  // A power law relaxes for ever.
  for (unsigned int region = 0; region < materials.size(); ++region)
    if (materials[region].has_power_law())
      root.subsection("Materials")
          .subsection(input.problem.regions[region])
          .refuse("Type",
                  "the stress of a power law relaxes to zero, so that it has no state at rest",
                  "Use a law with a long-term modulus, or " + remedy);
  for (unsigned int region = 0; region < materials.size(); ++region)
    if (!materials[region].shear.branches.empty() &&
        (materials[region].long_term_shear_modulus() == 0. ||
         std::isinf(materials[region].long_term_inverse_bulk_modulus())))
      root.subsection("Materials")
          .subsection(input.problem.regions[region])
          .refuse("Type",
                  "the stress of this solid relaxes to zero, so that it has no state at rest",
                  "Use a law with a long-term modulus, or " + remedy);
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
                      "Prescribe zero, or " + remedy);
      }
  refuse_free_motions(input, root, "", "; or " + remedy);
  if (std::none_of(input.problem.conditions.begin(), input.problem.conditions.end(),
                   [](const BoundaryCondition &condition)
                   {
                     return condition.normal.kind == BoundaryPart::Kind::velocity ||
                            condition.tangential.kind == BoundaryPart::Kind::velocity;
                   }) &&
      std::none_of(materials.begin(), materials.end(),
                   [](const Material &material) { return material.is_solid(); }))
    root.subsection("Boundaries")
        .refuse("", "nothing holds the liquid: no boundary has a prescribed velocity",
                "Make one boundary 'fixed' or 'roller'");
}

template <int dim>
void RestSearch<dim>::perform(const bool loads_come, const double time)
{
  time_of_loads = time;
  const RestParameters &rest = run.input.rest;
  load_part = loads_come ? 1. / rest.load_steps : 1.;
  load = loads_come && rest.load_steps > 1 ? 0. : 1.;
  const unsigned int few_corrections = run.input.problem.newton.maximum_iterations / 2;
  double largest_velocity = 0., size = rest.time_step, last_size = size, smallest = size,
         largest = size, passed = 0.;
  unsigned int n_corrections = 0;
  for (unsigned int step = 0; step < rest.maximum_steps; ++step)
  {
    // The step that brings the last part of the loads may change little, however far it is from
    // rest.
    const bool had_all_loads = load == 1.;
    const StepReport report = step_of(last_size, size);
    last_size = size;
    passed += size;
    sink(report, passed, size);
    ++n_steps;
    n_corrections += report.corrections;
    smallest = std::min(smallest, size);
    largest = std::max(largest, size);
    largest_velocity = std::max(largest_velocity, report.largest_velocity);
    // A step that Newton's iteration has made shorter than the one asked for changes less, however
    // far it is from rest.
    const double change = report.largest_change * std::max(1., rest.time_step / size);
    if (had_all_loads && change <= rest.tolerance * largest_velocity)
    {
      std::ostringstream text;
      text << (finds_unloaded_shape ? "Found after " : "At rest after ") << step + 1 << " steps";
      if (smallest < largest)
        text << " of " << smallest << " s to " << largest << " s";
      if (n_corrections > 0)
        text << " with " << n_corrections << " corrections";
      if (loads_come && rest.load_steps > 1)
        text << "; the loads came in " << n_load_steps << " of them";
      if (n_halved > 0)
        text << "; " << n_halved << " steps had no solution and were made anew at half their size";
      run.log.line(text.str());
      return;
    }
    if (report.corrections <= few_corrections)
      size *= rest.time_step_growth;
    SignalWatch::stop_if_asked(run.input.communicator, "on the way to rest, after step " +
                                                           std::to_string(step + 1) + "; " +
                                                           interrupted);
  }
  std::ostringstream text;
  text << (finds_unloaded_shape ? "the unloaded shape was not found in "
                                : "the body did not come to rest in ")
       << rest.maximum_steps << " steps of ";
  if (smallest < largest)
    text << smallest << " s to " << largest << " s";
  else
    text << rest.time_step << " s";
  text << "; raise Steady/Maximum steps or Steady/Time step";
  if (run.input.problem.is_nonlinear() && !finds_unloaded_shape)
    text << (run.input.analysis.is_steady()
                 ? ", or find out with Analysis = transient whether the motion becomes steady"
                 : ", or set Initial state/Type = given");
  throw RunError(text.str());
}

template <int dim>
void RestSearch<dim>::find_unloaded_shape(const bool loads_come)
{
  run.log.line("Before the start: the unloaded shape, from which the loads at t = 0 bring the body "
               "to the shape of the mesh");
  finds_unloaded_shape = true;
  run.solver->begin_unloaded_shape();
  perform(loads_come);
  run.solver->keep_unloaded_shape();
}

template <int dim>
StepReport RestSearch<dim>::step_of(const double last_size, double &size)
{
  // However much the step has grown, it may become a 64th of the last one that had a solution. So
  // may the part of the loads.
  const double shortest = std::ldexp(std::min(size, last_size), -most_halvings),
               smallest_part = std::ldexp(1. / run.input.rest.load_steps, -most_halvings);
  for (unsigned int halvings = 0;;)
  {
    Step euler = euler_step(0., size, Update::implicit);
    // Loads are those of one time and pictures those of t = 0, however long it takes.
    euler.balance_time = time_of_loads;
    euler.is_towards_rest = true;
    euler.finds_unloaded_shape = finds_unloaded_shape;
    euler.time = 0.;
    // Round-off of the sum is no part of its own.
    const double next_load = load + load_part < 1. - 1e-12 ? load + load_part : 1.;
    euler.load_factor = next_load;
    try
    {
      const StepReport report = run.solver->advance(euler);
      if (load < 1.)
      {
        load = next_load;
        load_part = std::min(2. * load_part, 1. / run.input.rest.load_steps);
        ++n_load_steps;
      }
      return report;
    }
    catch (const StepFailure &failure)
    {
      std::ostringstream text;
      text << (finds_unloaded_shape ? "on the way to the unloaded shape, step "
                                    : "on the way to rest, step ")
           << n_steps + 1 << " of " << size << " s";
      if (load < 1.)
        text << " with " << next_load << " of the loads";
      text << ": " << failure.what();
      if (load < 1. && load_part > 1.5 * smallest_part)
      {
        run.log.line(text.str() + "; it is made anew with half as much more of the loads");
        load_part *= 0.5;
        continue;
      }
      if (size < 1.5 * shortest)
      {
        text << "; the step was halved " << halvings
             << " times (Steady/Time step, Steady/Time step growth"
             << (load < 1. ? ", Steady/Load steps)" : ")");
        if (finds_unloaded_shape)
          text
              << "; a body of these materials may have no shape from which these loads bring it to "
                 "that of the mesh (Unloaded shape)";
        throw RunError(text.str());
      }
      run.log.line(text.str() + "; it is made anew at half its size");
      size *= 0.5;
      ++halvings;
      ++n_halved;
    }
  }
}

template class RestSearch<2>;
template class RestSearch<3>;
} // namespace Continua
