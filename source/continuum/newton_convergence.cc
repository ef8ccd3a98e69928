#include <continua/continuum/newton_convergence.h>

#include <continua/base/input_error.h>
#include <continua/continuum/step_extremes.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace Continua
{
void NewtonConvergence::take(const ResidualNorms &norms, const double of_cavities)
{
  previous = present;
  ++n_iterates;
  largest_momentum = std::max(largest_momentum, norms.momentum);
  largest_mass = std::max(largest_mass, norms.mass);
  const double tolerance = parameters.tolerance;
  present.norms = norms;
  present.accepted_momentum = std::max(tolerance * largest_momentum, norms.momentum_round_off);
  present.accepted_mass = std::max(tolerance * largest_mass, norms.mass_round_off);
  present.momentum_is_round_off = norms.momentum <= norms.momentum_round_off;
  // What is round-off says nothing of the iteration.
  present.of_momentum = present.momentum_is_round_off ? 0. : norms.momentum / largest_momentum;
  present.of_mass = norms.mass <= norms.mass_round_off ? 0. : norms.mass / largest_mass;
  present.of_cavities = of_cavities;
  present.residual = std::max({present.of_momentum, present.of_mass, of_cavities});
}

ResidualScales NewtonConvergence::scales() const
{
  return {std::max(present.norms.momentum, present.accepted_momentum),
          std::max(present.norms.mass, present.accepted_mass)};
}

bool NewtonConvergence::is_slow() const
{
  return n_iterates > 1 && present.residual > parameters.slowest_rate * previous.residual;
}

bool NewtonConvergence::is_finite() const
{
  // NaN fails the comparison.
  return present.norms.momentum < HUGE_VAL && present.norms.mass < HUGE_VAL &&
         present.of_cavities < HUGE_VAL;
}

bool NewtonConvergence::volume_stays(const bool correction_is_exact) const
{
  return present.momentum_is_round_off && previous.momentum_is_round_off && correction_is_exact &&
         present.norms.mass > 0.5 * previous.norms.mass;
}

bool NewtonConvergence::is_solved(const bool volume_is_round_off) const
{
  return present.norms.momentum <= present.accepted_momentum &&
         (present.norms.mass <= present.accepted_mass || volume_is_round_off) &&
         present.of_cavities <= std::max(parameters.tolerance, ResidualNorms::round_off);
}

void NewtonConvergence::fail(const Problem &problem,
                             const NonlinearSystem &terms,
                             const DistributedVector &momentum,
                             const DistributedVector &mass) const
{
  const bool has_numbers = is_finite();
  const unsigned int iteration = n_iterates - 1;
  // What the input cannot say at a time no shorter step can either.
  if (const std::string reason = reason_not_finite(problem.communicator);
      !has_numbers && !reason.empty())
    throw RunError("Newton's iteration met a residual that is no number" + reason);
  if (has_numbers && present.of_cavities > std::max(present.of_momentum, present.of_mass))
  {
    std::ostringstream text;
    text << "Newton's iteration left the volume of a cavity, or a flow rate, "
         << present.of_cavities << " of it away from the one given after " << iteration
         << " iterations (Newton/Maximum iterations); a smaller time step or a volume or flow rate "
            "that changes more slowly helps";
    throw StepFailure(text.str());
  }
  const bool is_of_momentum =
      has_numbers ? present.of_momentum >= present.of_mass : !(present.norms.momentum < HUGE_VAL);
  std::ostringstream text;
  text << "Newton's iteration ";
  if (has_numbers)
    text << "left " << present.residual << " of the largest residual";
  else
    text << "met a residual that is no number";
  text << " of " << (is_of_momentum ? "momentum" : "volume") << ' '
       << terms.place_of_largest(momentum, mass, is_of_momentum) << ' ';
  if (has_numbers)
    text << "after " << iteration << " iterations (Newton/Maximum iterations)";
  else
    text << "in iteration " << iteration;
  text << "; a smaller time step, loads that begin smoothly or a finer mesh help";
  throw StepFailure(text.str());
}
} // namespace Continua
