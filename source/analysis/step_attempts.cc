#include <continua/analysis/step_attempts.h>

#include <continua/base/input_error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace Continua
{
using namespace dealii;

template <int dim>
StepAttempts<dim>::StepAttempts(TransientProgress<dim> &so_far) : so_far(so_far), run(so_far.run)
{
}

template <int dim>
StepReport StepAttempts<dim>::begin()
{
  find_jumps();
  divided = false;
  if (so_far.time_control.is_adaptive())
    run.solver->keep_state();
  take_next_parts();
  StepReport report = make_part(true);
  // A step in two halves stands: it starts the scheme, and its error is not known.
  while (!stands())
  {
    run.solver->return_to_kept_state();
    take_next_parts();
    report = make_part(true);
  }
  return report;
}

template <int dim>
void StepAttempts<dim>::find_jumps()
{
  if (so_far.time_control.n_steps() == 0 ||
      (run.input.time.scheme == Scheme::euler_implicit && !so_far.time_control.is_adaptive()))
    return;
  SectionTimer::Scope scope(run.log.timer(), "search for jumps");
  const double start = so_far.time_control.time();
  // A jump anywhere in the step: at its end it is the next step's.
  const auto jumps = [&]()
  {
    const double size = so_far.time_control.next_size();
    return run.solver->data_jump(start - 1e-6 * size, start + (1. - 1e-6) * size);
  };
  while (jumps())
    if (so_far.time_control.jump())
    {
      std::ostringstream text;
      text << "A load or prescribed velocity jumps in the step from t = " << start
           << " s: the scheme starts anew";
      run.log.line(text.str());
      return;
    }
}

template <int dim>
void StepAttempts<dim>::take_next_parts()
{
  parts = so_far.time_control.next();
  std::reverse(parts.begin(), parts.end());
}

template <int dim>
StepReport StepAttempts<dim>::make_part(const bool is_first)
{
  const double shortest = std::ldexp(so_far.time_control.last_size(), -most_halvings);
  for (;;)
  {
    part = parts.back();
    parts.pop_back();
    try
    {
      return advance();
    }
    catch (const StepFailure &failure)
    {
      if (is_first && so_far.time_control.is_adaptive())
      {
        // A step without a solution has an error without bound.
        if (so_far.time_control.judge(std::numeric_limits<double>::infinity()))
          throw RunError(std::string(failure.what()) +
                         "; the step has the smallest size (Time/Smallest time step)");
        run.log.detail(std::string(failure.what()) + "; a shorter step takes its place");
        run.solver->return_to_kept_state();
        take_next_parts();
        continue;
      }
      if (part.size() < 1.5 * shortest)
      {
        std::ostringstream text;
        text << failure.what() << "; the step was halved " << most_halvings << " times";
        throw RunError(text.str());
      }
      divide(failure);
    }
  }
}

template <int dim>
void StepAttempts<dim>::divide(const StepFailure &failure)
{
  divided = true;
  const std::array<Step, 2> halves = halves_of(part);
  ++so_far.n_halved;
  std::ostringstream text;
  text << failure.what() << "; it is made in halves of " << halves.front().size() << " s";
  run.log.line(text.str());
  // The formulas of the part after these two know the size of the one before it.
  if (!parts.empty() && parts.back().older_distance != 0.)
  {
    const Step after = parts.back();
    parts.back() = step_like(after, after.time_old, after.size(), halves.back().size());
    parts.back().time = after.time;
    parts.back().balance_time = after.balance_time;
  }
  parts.push_back(halves.back());
  parts.push_back(halves.front());
}

template <int dim>
StepReport StepAttempts<dim>::advance()
{
  const StepReport report = run.solver->advance(part);
  for (const ScheduledRecord<dim> &entry : so_far.records)
    entry.record->attempt(report);
  return report;
}

template <int dim>
bool StepAttempts<dim>::stands()
{
  if (!so_far.time_control.is_adaptive())
    return true;
  const StepError error = run.solver->step_error();
  double scale = so_far.largest_energy;
  const auto relative = [&]()
  { return error.kinetic_energy > 0. ? std::sqrt(error.kinetic_energy / scale) : 0.; };
  // The energy may cost products with all matrices: it is asked for now and then, and where it may
  // save a step.
  if (so_far.time_control.n_steps() % 4 == 0 || relative() > run.input.time.error_tolerance)
  {
    SectionTimer::Scope scope(run.log.timer(), "step error");
    scale = std::max(scale, run.solver->energy().sum());
  }
  const bool accepted =
      so_far.time_control.judge(error.is_known ? std::optional<double>(relative()) : std::nullopt);
  // A step that is undone was never there.
  if (accepted)
    so_far.largest_energy = scale;
  return accepted;
}

template class StepAttempts<2>;
template class StepAttempts<3>;
} // namespace Continua
