#include <continua/analysis/steady_search.h>

#include <continua/analysis/free_motions.h>
#include <continua/base/input_error.h>
#include <continua/base/interruption.h>

#include <deal.II/base/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Continua
{
namespace
{
/// Over the time in which the viscosity of a liquid lets the walls around it give way, or the
/// liquid itself. Vessels that are long and narrow take a multiple of that time. It is also the
/// ratio of the stiffnesses of wall and liquid in the matrix, of which the factor's round-off is.
constexpr double over_viscous_time = 3e7;
/// By which the size of static steps grows where they come no nearer to rest, and how often.
constexpr double static_growth = 1e3;
constexpr unsigned int most_static_growths = 2, most_static_steps = 30;
/// Changes below it [1] may be round-off, of which larger steps make more.
constexpr double least_change_to_grow = 1e-4;
/// Of a static step: changes below it that do not fall any more are what a solve leaves.
constexpr double largest_round_off = 1e-7;

/// Diagonal of the box around the body [m].
template <int dim>
double length_of(const dealii::parallel::TriangulationBase<dim> &triangulation)
{
  dealii::BoundingBox<dim> box;
  bool is_first = true;
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
  {
    if (is_first)
      box = cell->bounding_box();
    else
      box.merge_with(cell->bounding_box());
    is_first = false;
  }
  const auto corners = box.get_boundary_points();
  return corners.first.distance(corners.second);
}
} // namespace

template <int dim>
SteadySearch<dim>::SteadySearch(Run<dim> &run, const Sink &sink, const std::string &interrupted)
    : run(run), sink(sink), interrupted(interrupted)
{
}

template <int dim>
void SteadySearch<dim>::check(const Case<dim> &input,
                              ParameterSection root,
                              const std::string &remedy)
{
  const std::vector<Material> &materials = input.problem.materials;
  for (unsigned int region = 0; region < materials.size(); ++region)
    if (!materials[region].shear.branches.empty() &&
        std::isinf(materials[region].long_term_inverse_bulk_modulus()))
      root.subsection("Materials")
          .subsection(input.problem.regions[region])
          .refuse("Type",
                  "the pressure of this solid relaxes to zero, so that it has no state at rest",
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
void SteadySearch<dim>::perform(const Loads loads, const double time)
{
  time_of_loads = time;
  goes_along_time = loads == Loads::along_time;
  const bool loads_come = loads != Loads::present;
  if (!run.input.problem.is_nonlinear())
  {
    perform_linear();
    return;
  }
  const SteadyParameters &steady = run.input.steady;
  load_part = loads_come ? 1. / steady.load_steps : 1.;
  load = loads_come && steady.load_steps > 1 ? 0. : 1.;
  const unsigned int few_corrections = run.input.problem.newton.maximum_iterations / 2;
  double largest_velocity = 0., size = steady.time_step, last_size = size, smallest = size,
         largest = size, passed = 0.;
  unsigned int n_corrections = 0;
  // After static steps that fail, the body has to come nearer.
  unsigned int next_static = 0;
  for (unsigned int step = 0; step < steady.maximum_steps; ++step)
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
    const double change = report.largest_change * std::max(1., steady.time_step / size);
    const bool is_slow = had_all_loads && change <= steady.tolerance * largest_velocity;
    if (is_slow && step >= next_static && !balance(size))
      next_static = 2 * step + 2;
    else if (is_slow && step >= next_static)
    {
      std::ostringstream text;
      text << (finds_unloaded_shape ? "Found after " : "At rest after ") << step + 1 << " steps";
      if (smallest < largest)
        text << " of " << smallest << " s to " << largest << " s";
      if (n_corrections > 0)
        text << " with " << n_corrections << " corrections";
      if (loads_come && steady.load_steps > 1)
        text << "; the loads came in " << n_load_steps << " of them";
      if (n_shortened > 0)
        text << "; " << n_shortened
             << " steps had no solution and were made anew at a smaller size";
      run.log.line(text.str());
      return;
    }
    // As long as loads come a longer step brings nothing nearer, and beside a liquid of small
    // viscosity its equations become round-off.
    if (report.corrections <= few_corrections && load == 1.)
      size *= steady.time_step_growth;
    SignalWatch::stop_if_asked(run.input.communicator, "on the way to a steady state, after step " +
                                                           std::to_string(step + 1) + "; " +
                                                           interrupted);
  }
  std::ostringstream text;
  text << (finds_unloaded_shape ? "the unloaded shape was not found in "
                                : "the body did not come to rest in ")
       << steady.maximum_steps << " steps of ";
  if (smallest < largest)
    text << smallest << " s to " << largest << " s";
  else
    text << steady.time_step << " s";
  text << "; raise Steady/Maximum steps or Steady/Time step";
  if (run.input.problem.is_nonlinear() && !finds_unloaded_shape)
    text << (run.input.analysis.is_steady()
                 ? ", or find out with Analysis = transient whether the motion becomes steady"
                 : ", or set Initial state/Type = given");
  throw RunError(text.str());
}

template <int dim>
void SteadySearch<dim>::perform_linear()
{
  const CellWiseParameters &cell_wise = run.input.discretisation.cell_wise;
  if (run.input.discretisation.is_cell_wise() && cell_wise.formulation == Formulation::displacement)
  {
    run.solver->solve_steady(time_of_loads);
    return;
  }
  if (!balance(run.input.steady.time_step))
    throw RunError("the body does not come to rest under its loads: each of " +
                   std::to_string(n_static) +
                   " solves of the steady equations has moved it on; a flow that nothing "
                   "resists grows for ever, and so does a body that is filled without an outlet");
  run.log.line("At rest");
  run.log.detail("The steady equations hold after " + std::to_string(n_static) + " solves");
}

template <int dim>
bool SteadySearch<dim>::balance(const double last_size)
{
  const std::vector<Material> &materials = run.input.problem.materials;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double viscosity = 0., density = 0., modulus = infinity, bulk_modulus = infinity;
  bool has_liquid = false, is_inviscid = false;
  for (const Material &material : materials)
    if (material.is_solid())
      modulus = std::min(modulus, material.long_term_shear_modulus());
    else
    {
      has_liquid = true;
      viscosity = std::max(viscosity, material.shear.viscosity);
      density = std::max(density, material.density);
      if (!material.is_incompressible())
        bulk_modulus = std::min(bulk_modulus, 1. / material.inverse_bulk_modulus());
      is_inviscid = is_inviscid || material.shear.viscosity == 0.;
    }
  const bool has_solid = !std::isinf(modulus);
  // A solid alone has the same displacement for any size, an incompressible liquid alone the same
  // velocity.
  double size = 1.;
  if (has_liquid && (has_solid || !std::isinf(bulk_modulus)))
    size = over_viscous_time * viscosity / (has_solid ? modulus : bulk_modulus);
  if (is_inviscid)
    size = std::max(size, static_growth * (has_solid ? length_of<dim>(*run.input.triangulation) *
                                                           std::sqrt(density / modulus)
                                                     : last_size));
  const bool is_one_solve = run.input.problem.is_nonlinear() && !(has_liquid && has_solid);
  n_static = 0;
  unsigned int n_growths = 0, n_corrections = 0;
  double last_change = std::numeric_limits<double>::infinity();
  run.solver->stop_solids();
  while (n_static < most_static_steps)
  {
    Step step = static_step(size, is_inviscid);
    set_loads(step);
    StepReport report;
    try
    {
      report = run.solver->advance(step);
    }
    catch (const StepFailure &failure)
    {
      run.log.detail(std::string("the steady equations, from the state that the steps have come "
                                 "to: ") +
                     failure.what());
      return false;
    }
    sink(report, 0., size);
    ++n_static;
    n_corrections += report.corrections;
    const double change = report.steady_change;
    const bool is_round_off = change < largest_round_off && change > 0.8 * last_change;
    if (is_one_solve || change <= run.input.steady.tolerance || is_round_off)
    {
      run.solver->stop_solids();
      if (n_corrections > 0)
      {
        std::ostringstream text;
        text << "The steady equations hold after " << n_static << " solves with " << n_corrections
             << " corrections";
        run.log.detail(text.str());
      }
      return true;
    }
    if (change > 0.5 * last_change && change > least_change_to_grow &&
        n_growths < most_static_growths)
    {
      size *= static_growth;
      ++n_growths;
    }
    last_change = change;
    SignalWatch::stop_if_asked(run.input.communicator,
                               "on the way to a steady state; " + interrupted);
  }
  return false;
}

template <int dim>
void SteadySearch<dim>::set_loads(Step &step, const double part) const
{
  // All is as at the time of the loads, however long it takes.
  step.balance_time = goes_along_time ? part * time_of_loads : time_of_loads;
  step.load_factor = goes_along_time ? 1. : part;
  step.finds_steady_state = true;
  step.finds_unloaded_shape = finds_unloaded_shape;
  step.time = std::isinf(time_of_loads) ? 0. : time_of_loads;
}

template <int dim>
void SteadySearch<dim>::find_unloaded_shape(const bool loads_come)
{
  run.log.line("Before the start: the unloaded shape, from which the loads at t = 0 bring the body "
               "to the shape of the mesh");
  finds_unloaded_shape = true;
  run.solver->begin_unloaded_shape();
  perform(loads_come ? Loads::in_parts : Loads::present);
  run.solver->keep_unloaded_shape();
}

template <int dim>
StepReport SteadySearch<dim>::step_of(const double last_size, double &size)
{
  // However much the step has grown, it may become a 64th of the last one that had a solution. So
  // may the part of the loads. The first step has none before it: by default it says nothing of the
  // flow's own time, which may be any fraction of it.
  constexpr int most_halvings_of_first = 30;
  const bool finds_first = n_steps == 0 && load == 1. && run.input.steady.finds_first_step;
  const double shortest = std::ldexp(std::min(size, last_size),
                                     finds_first ? -most_halvings_of_first : -most_halvings),
               smallest_part = std::ldexp(1. / run.input.steady.load_steps, -most_halvings);
  for (unsigned int halvings = 0;;)
  {
    Step euler = euler_step(0., size, Update::implicit);
    // Round-off of the sum is no part of its own.
    const double next_load = load + load_part < 1. - 1e-12 ? load + load_part : 1.;
    set_loads(euler, next_load);
    try
    {
      const StepReport report = run.solver->advance(euler);
      if (load < 1.)
      {
        load = next_load;
        load_part = std::min(2. * load_part, 1. / run.input.steady.load_steps);
        ++n_load_steps;
      }
      return report;
    }
    catch (const StepFailure &failure)
    {
      std::ostringstream text;
      text << (finds_unloaded_shape ? "on the way to the unloaded shape, step "
                                    : "on the way to a steady state, step ")
           << n_steps + 1 << " of " << size << " s";
      if (load < 1.)
        text << (goes_along_time ? " under the loads at " : " with ") << next_load
             << (goes_along_time ? " of Steady/Time of loads" : " of the loads");
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
        if (finds_unloaded_shape && run.input.problem.some_mesh_moves())
          text << "; with liquid inside, the iterative solver needs long steps: set Steady/Time "
                  "step "
                  "to 1000 s, or Linear solver/Type = direct";
        throw RunError(text.str());
      }
      run.log.line(text.str() + "; it is made anew at " + (finds_first ? "a quarter of" : "half") +
                   " its size");
      size *= finds_first ? 0.25 : 0.5;
      halvings += finds_first ? 2 : 1;
      ++n_shortened;
    }
  }
}

template class SteadySearch<2>;
template class SteadySearch<3>;
} // namespace Continua
