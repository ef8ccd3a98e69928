#include <continua/time_integration/step.h>

#include <continua/time_integration/linear_relaxation.h>

#include <cmath>

namespace Continua
{
bool Step::branch_is_exponential(const double relaxation_time) const
{
  // A backward Euler or backward differencing update damps a fast branch as it should; only updates
  // that average old and new ring there. Rannacher's half steps are backward Euler: the velocity of
  // a body that is loaded at once is no straight line, and taken for one it would cost a Maxwell
  // body up to half of its elastic jump.
  return (update == Update::trapezoidal || extrapolate) && !std::isinf(relaxation_time) &&
         (update == Update::trapezoidal ? size() : 1. / a0 * 2.) > relaxation_time;
}

BranchCoefficients Step::branch(const double relaxation_time) const
{
  BranchCoefficients result;
  const bool relaxes = !std::isinf(relaxation_time);
  if (finds_steady_state)
  {
    // A branch that relaxes has done so.
    result.velocity = relaxes ? 0. : size();
    result.old = relaxes ? 0. : 1.;
    return result;
  }
  if (branch_is_exponential(relaxation_time))
  {
    // Exact for a velocity that is linear over the step.
    const double tau = relaxation_time;
    const double full = update == Update::trapezoidal ? size() : 2. / a0;
    const LinearRelaxation exact(full, tau);
    result.velocity = exact.of_new;
    if (update == Update::trapezoidal)
    {
      result.old = exact.decay;
      result.velocity_old = exact.of_old;
    }
    else
    {
      // D in the middle is the mean of both ends, with U_new = 2 U - U_old.
      result.old = 0.5 * (1. + exact.decay);
      result.velocity_old = exact.of_old - 0.5 * tau * (1. - exact.decay);
    }
    return result;
  }
  const double rate = relaxes ? 1. / relaxation_time : 0.;
  if (update == Update::trapezoidal)
  {
    const double half = 0.5 * size();
    result.velocity = half / (1. + half * rate);
    result.old = (1. - half * rate) / (1. + half * rate);
    result.velocity_old = result.velocity;
  }
  else
  {
    result.velocity = 1. / (a0 + rate);
    result.old = -a1 * result.velocity;
    result.older = -a2 * result.velocity;
  }
  return result;
}

Step euler_step(const double time_old, const double size, const Update update)
{
  Step step;
  step.time_old = time_old;
  step.time = time_old + size;
  step.duration = size;
  step.balance_time = step.time;
  step.a0 = 1. / size;
  step.a1 = -1. / size;
  step.update = update;
  step.pressure_time = update == Update::trapezoidal ? 0.5 * size : size;
  step.divergence_old = update == Update::trapezoidal;
  return step;
}

Step static_step(const double size, const bool with_inertia)
{
  Step step = euler_step(0., size, Update::implicit);
  if (!with_inertia)
    step.a0 = step.a1 = 0.;
  step.finds_steady_state = true;
  return step;
}

Step backward_differencing_step(const double time_old,
                                const double size,
                                const double size_old,
                                const Update update)
{
  Step step = euler_step(time_old, size, update);
  const double r = size / size_old;
  step.a0 = (1. + 2. * r) / (1. + r) / size;
  step.a1 = -(1. + r) / size;
  step.a2 = r * r / (1. + r) / size;
  step.older_distance = size_old;
  if (update == Update::implicit)
  {
    step.pressure_time = 1. / step.a0;
    step.pressure_old = -step.a1 / step.a0;
    step.pressure_older = -step.a2 / step.a0;
  }
  return step;
}

Step crank_nicolson_step(const double time_old, const double size, const double size_old)
{
  Step step = euler_step(time_old, 0.5 * size, Update::midpoint);
  step.time = time_old + size;
  step.duration = size;
  step.extrapolate = true;
  step.older_distance = size_old;
  return step;
}

Step step_like(const Step &parent, const double time_old, const double size, const double size_old)
{
  Step step;
  if (parent.extrapolate)
    step = crank_nicolson_step(time_old, size, size_old);
  else if (parent.a2 != 0.)
    step = backward_differencing_step(time_old, size, size_old, parent.update);
  else
    step = euler_step(time_old, size, parent.update);
  step.is_start = parent.is_start;
  step.load_factor = parent.load_factor;
  return step;
}

std::array<Step, 2> halves_of(const Step &parent)
{
  const double half = 0.5 * parent.size();
  std::array<Step, 2> halves = {{step_like(parent, parent.time_old, half, parent.older_distance),
                                 step_like(parent, parent.time_old + half, half, half)}};
  halves.back().time = parent.time;
  if (!parent.extrapolate)
    halves.back().balance_time = parent.balance_time;
  return halves;
}
} // namespace Continua
