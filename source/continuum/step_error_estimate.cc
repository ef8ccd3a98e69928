#include <continua/continuum/step_error_estimate.h>

#include <cmath>
#include <vector>

namespace Continua
{
namespace
{
/// s^q / q! for q = 1, 2, 3.
double monomial(const unsigned int q, const double s)
{
  return q == 1 ? s : q == 2 ? s * s / 2. : s * s * s / 6.;
}
} // namespace

bool StepErrorEstimate::wants_another_level(const Step &step) const
{
  return step.a2 != 0. && std::abs(step.older_distance - distances[0]) > 1e-9 * distances[0];
}

StepErrorEstimate::Weights StepErrorEstimate::weights_of_level(const double distance) const
{
  const double a = distances[0], b = distances[1], s = distance;
  return {{(s - a) * (s - b) / (a * b), s * (s - b) / (a * (a - b)), s * (s - a) / (b * (b - a))}};
}

void StepErrorEstimate::advance(const Step &step)
{
  const double size = step.size();
  const bool second_order = step.a2 != 0. || step.extrapolate;
  const unsigned int q = second_order ? 3 : 2;
  const Weights places = {{-size, -size - distances[0], -size - distances[1]}};
  known = false;
  double error = 0.;
  if (step.is_start)
  {
    n_levels = 0;
    errors = {};
  }
  else
  {
    // Numbers of y, whose exact value and rate are 0 at the end of the step.
    const auto y = [&](const unsigned int level)
    { return monomial(q, places[level]) + errors[level]; };
    double local_error;
    if (step.extrapolate)
    {
      const double rates = 0.5 * size * monomial(q - 1, -size);
      error = y(0) + rates;
      local_error = monomial(q, -size) + rates;
    }
    else
    {
      double older = y(1);
      if (wants_another_level(step))
      {
        const Weights weights = weights_of_level(step.older_distance);
        older = weights[0] * y(0) + weights[1] * y(1) + weights[2] * y(2);
      }
      error = -(step.a1 * y(0) + step.a2 * older) / step.a0;
      local_error =
          -(step.a1 * monomial(q, -size) + step.a2 * monomial(q, -size - step.older_distance)) /
          step.a0;
    }
    // What the backward Euler step at the start of backward differencing leaves behind falls to a
    // third in each step.
    const unsigned int n_settling = step.a2 != 0. ? 2 : 0;
    known = n_levels >= q + n_settling;
    if (known)
    {
      const double t0 = size, t1 = size + distances[0], t2 = size + distances[1];
      prediction_weights =
          second_order
              ? Weights{{t1 * t2 / ((t1 - t0) * (t2 - t0)), t0 * t2 / ((t0 - t1) * (t2 - t1)),
                         t0 * t1 / ((t0 - t2) * (t1 - t2))}}
              : Weights{{t1 / (t1 - t0), t0 / (t0 - t1), 0.}};
      double difference = error;
      for (unsigned int level = 0; level < q; ++level)
        difference -= prediction_weights[level] * y(level);
      error_over_difference = local_error / difference;
    }
  }
  ++n_levels;
  errors = {{0., errors[0] - error, errors[1] - error}};
  distances = {{size, size + distances[0]}};
}

void StepErrorEstimate::save(ArchiveWriter &archive) const
{
  archive.add("step error estimate",
              std::vector<double>{static_cast<double>(n_levels), distances[0], distances[1],
                                  errors[1], errors[2]});
}

bool StepErrorEstimate::is_in(const ArchiveReader &archive)
{
  return archive.has("step error estimate");
}

void StepErrorEstimate::load(const ArchiveReader &archive)
{
  const std::vector<double> values = archive.values("step error estimate");
  n_levels = static_cast<unsigned int>(values.at(0));
  distances = {{values.at(1), values.at(2)}};
  errors = {{0., values.at(3), values.at(4)}};
}
} // namespace Continua
