#include <continua/signal/damped_sine_fit.h>

#include <continua/base/quiet_gsl.h>
#include <continua/base/undefined.h>
#include <continua/signal/gsl_release.h>

#include <deal.II/base/numbers.h>

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace Continua
{
using dealii::numbers::PI;

namespace
{

/// Scaled samples: time from 0 to 1 over the record, values about their average, over their range.
struct Samples
{
  std::vector<double> times, values;
};

/// One component in scaled time: exp(-decay t) (cosine cos(angular t) + sine sin(angular t)).
struct Component
{
  double cosine = 0.;
  double sine = 0.;
  double angular;
  double decay = 0.;
};

struct SineModel
{
  double offset = 0.;
  std::vector<Component> components;
};

using GslVector = std::unique_ptr<gsl_vector, GslRelease<gsl_vector, gsl_vector_free>>;
using GslMatrix = std::unique_ptr<gsl_matrix, GslRelease<gsl_matrix, gsl_matrix_free>>;
using FitWorkspace =
    std::unique_ptr<gsl_multifit_nlinear_workspace,
                    GslRelease<gsl_multifit_nlinear_workspace, gsl_multifit_nlinear_free>>;

/// Every so many-th sample, to leave about `n_wanted` but no less than `per_period` of `n_periods`
/// periods.
Samples thin_out(const Samples &samples,
                 const double n_wanted,
                 const double per_period,
                 const double n_periods)
{
  const double n = samples.times.size();
  const std::size_t stride =
      std::max(1., std::floor(n / std::max(n_wanted, per_period * n_periods)));
  Samples result;
  for (std::size_t i = 0; i < samples.times.size(); i += stride)
  {
    result.times.push_back(samples.times[i]);
    result.values.push_back(samples.values[i]);
  }
  return result;
}

/// The best offset, cosines and sines of `model` for its frequencies and decays, by the normal
/// equations: the sum of the squares that are left, or infinity where the components cannot be told
/// apart.
double solve_linear(const Samples &samples, SineModel &model)
{
  const std::size_t n_columns = 1 + 2 * model.components.size();
  const GslMatrix normal(gsl_matrix_calloc(n_columns, n_columns));
  const GslVector solution(gsl_vector_calloc(n_columns));
  std::vector<double> row(n_columns, 1.);
  std::vector<double> right_side(n_columns, 0.);
  double sum = 0.;
  for (std::size_t i = 0; i < samples.times.size(); ++i)
  {
    for (std::size_t j = 0; j < model.components.size(); ++j)
    {
      const Component &component = model.components[j];
      const double envelope = std::exp(-component.decay * samples.times[i]);
      row[1 + 2 * j] = envelope * std::cos(component.angular * samples.times[i]);
      row[2 + 2 * j] = envelope * std::sin(component.angular * samples.times[i]);
    }
    for (std::size_t a = 0; a < n_columns; ++a)
    {
      right_side[a] += row[a] * samples.values[i];
      for (std::size_t b = 0; b <= a; ++b)
        *gsl_matrix_ptr(normal.get(), a, b) += row[a] * row[b];
    }
    sum += samples.values[i] * samples.values[i];
  }
  for (std::size_t a = 0; a < n_columns; ++a)
    gsl_vector_set(solution.get(), a, right_side[a]);
  if (gsl_linalg_cholesky_decomp1(normal.get()) != GSL_SUCCESS ||
      gsl_linalg_cholesky_svx(normal.get(), solution.get()) != GSL_SUCCESS)
    return std::numeric_limits<double>::infinity();

  model.offset = gsl_vector_get(solution.get(), 0);
  for (std::size_t j = 0; j < model.components.size(); ++j)
  {
    model.components[j].cosine = gsl_vector_get(solution.get(), 1 + 2 * j);
    model.components[j].sine = gsl_vector_get(solution.get(), 2 + 2 * j);
  }
  for (std::size_t a = 0; a < n_columns; ++a)
    sum -= right_side[a] * gsl_vector_get(solution.get(), a);
  return sum;
}

/// Least squares have a local minimum about every 1/(record length) in frequency: looks for the
/// lowest one near the start.
void search_frequencies(const Samples &samples, SineModel &model)
{
  const SineModel start = model;
  double lowest = solve_linear(samples, model);
  for (std::size_t j = 0; j < model.components.size(); ++j)
  {
    const double centre = start.components[j].angular;
    double reach = 0.15 * centre;
    for (std::size_t k = 0; k < model.components.size(); ++k)
      if (k != j)
        reach = std::min(reach, 0.5 * std::abs(start.components[k].angular - centre));
    const double step = 0.25 * 2. * PI;
    const int n_steps = static_cast<int>(reach / step);
    Component best = model.components[j];
    for (int i = -n_steps; i <= n_steps; ++i)
      for (const double decay : {0., 3., 12.})
      {
        model.components[j].angular = centre + i * step;
        model.components[j].decay = decay;
        const double sum = solve_linear(samples, model);
        if (sum < lowest)
        {
          lowest = sum;
          best = model.components[j];
        }
      }
    model.components[j] = best;
  }
  solve_linear(samples, model);
}

int residual(const gsl_vector *parameters, void *data, gsl_vector *result)
{
  const Samples &samples = *static_cast<const Samples *>(data);
  const double *const p = parameters->data;
  const std::size_t n_components = (parameters->size - 1) / 4;
  for (std::size_t i = 0; i < samples.times.size(); ++i)
  {
    const double time = samples.times[i];
    double value = p[0] - samples.values[i];
    for (std::size_t j = 0; j < n_components; ++j)
    {
      const double *const c = p + 1 + 4 * j;
      value +=
          std::exp(-c[3] * time) * (c[0] * std::cos(c[2] * time) + c[1] * std::sin(c[2] * time));
    }
    if (!std::isfinite(value))
      return GSL_EDOM;
    gsl_vector_set(result, i, value);
  }
  return GSL_SUCCESS;
}

int jacobian(const gsl_vector *parameters, void *data, gsl_matrix *result)
{
  const Samples &samples = *static_cast<const Samples *>(data);
  const double *const p = parameters->data;
  const std::size_t n_components = (parameters->size - 1) / 4;
  for (std::size_t i = 0; i < samples.times.size(); ++i)
  {
    const double time = samples.times[i];
    double *const row = gsl_matrix_ptr(result, i, 0);
    row[0] = 1.;
    for (std::size_t j = 0; j < n_components; ++j)
    {
      const double *const c = p + 1 + 4 * j;
      double *const d = row + 1 + 4 * j;
      const double envelope = std::exp(-c[3] * time);
      const double cosine = envelope * std::cos(c[2] * time);
      const double sine = envelope * std::sin(c[2] * time);
      d[0] = cosine;
      d[1] = sine;
      d[2] = time * (c[1] * cosine - c[0] * sine);
      d[3] = -time * (c[0] * cosine + c[1] * sine);
    }
  }
  return GSL_SUCCESS;
}

/// Improves all parameters of `model`; `sum` is the sum of the squares that are left. False if it
/// did not converge.
bool solve_nonlinear(Samples &samples, SineModel &model, double &sum)
{
  const std::size_t n_parameters = 1 + 4 * model.components.size();
  gsl_multifit_nlinear_fdf system{};
  system.f = residual;
  system.df = jacobian;
  system.n = samples.times.size();
  system.p = n_parameters;
  system.params = &samples;

  const GslVector start(gsl_vector_calloc(n_parameters));
  double *const p = start->data;
  p[0] = model.offset;
  for (std::size_t j = 0; j < model.components.size(); ++j)
  {
    p[1 + 4 * j] = model.components[j].cosine;
    p[2 + 4 * j] = model.components[j].sine;
    p[3 + 4 * j] = model.components[j].angular;
    p[4 + 4 * j] = model.components[j].decay;
  }

  const gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
  const FitWorkspace workspace(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, system.n, n_parameters));
  if (!workspace || gsl_multifit_nlinear_init(start.get(), &system, workspace.get()) != GSL_SUCCESS)
    return false;
  int reason = 0;
  const int status =
      gsl_multifit_nlinear_driver(300, 1e-9, 1e-13, 0., nullptr, nullptr, &reason, workspace.get());

  const double *const x = gsl_multifit_nlinear_position(workspace.get())->data;
  const gsl_vector *const difference = gsl_multifit_nlinear_residual(workspace.get());
  gsl_blas_ddot(difference, difference, &sum);
  model.offset = x[0];
  for (std::size_t j = 0; j < model.components.size(); ++j)
    model.components[j] = {x[1 + 4 * j], x[2 + 4 * j], x[3 + 4 * j], x[4 + 4 * j]};
  // At a fit that is exact but for round-off there is no way further down, which is no failure.
  return std::isfinite(sum) && (status == GSL_SUCCESS || sum < 1e-20 * samples.times.size());
}

/// In the units of the record, which starts at `first_time` and is `duration` long.
DampedSine to_damped_sine(Component component,
                          const double scale,
                          const double first_time,
                          const double duration)
{
  if (component.angular < 0.)
  {
    component.angular = -component.angular;
    component.sine = -component.sine;
  }
  DampedSine result;
  const double angular_frequency = component.angular / duration;
  result.frequency = angular_frequency / (2. * PI);
  result.decay_rate = component.decay / duration;
  result.amplitude = scale * std::hypot(component.cosine, component.sine) *
                     std::exp(result.decay_rate * first_time);
  result.phase = std::remainder(
      std::atan2(component.cosine, component.sine) - angular_frequency * first_time, 2. * PI);
  return result;
}
} // namespace

DampedSineFit fit_damped_sines(const std::vector<double> &times,
                               const std::vector<double> &values,
                               const std::vector<double> &start_frequencies)
{
  if (times.size() != values.size())
    throw std::invalid_argument("a fit needs as many times as values");
  if (start_frequencies.empty() || !std::all_of(start_frequencies.begin(), start_frequencies.end(),
                                                [](const double frequency) {
                                                  return frequency > 0. && std::isfinite(frequency);
                                                }))
    throw std::invalid_argument("a fit needs positive start frequencies");

  const std::size_t n_components = start_frequencies.size();
  DampedSineFit result;
  result.offset = undefined;
  result.residual = undefined;
  result.explained = undefined;
  result.converged = false;
  result.components.assign(n_components, {undefined, undefined, undefined, undefined});
  if (times.size() < 2 * (1 + 4 * n_components) ||
      !std::all_of(values.begin(), values.end(),
                   [](const double value) { return std::isfinite(value); }))
    return result;

  const double duration = times.back() - times.front();
  const double n_periods =
      duration * *std::max_element(start_frequencies.begin(), start_frequencies.end());
  const auto extremes = std::minmax_element(values.begin(), values.end());
  const double scale = *extremes.second - *extremes.first;
  if (!(scale > 0.) || times.size() < 2. * n_periods)
    return result;

  double average = 0.;
  for (const double value : values)
    average += (value - *extremes.first) / values.size();
  average += *extremes.first;
  Samples samples;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    samples.times.push_back((times[i] - times.front()) / duration);
    samples.values.push_back((values[i] - average) / scale);
  }

  SineModel model;
  for (const double frequency : start_frequencies)
  {
    Component component;
    component.angular = 2. * PI * frequency * duration;
    model.components.push_back(component);
  }
  const QuietGsl quiet;
  search_frequencies(thin_out(samples, 2000., 8., n_periods), model);
  samples = thin_out(samples, 20000., 40., n_periods);
  double sum = 0.;
  if (!solve_nonlinear(samples, model, sum))
    return result;

  double variation = 0.;
  for (const double value : samples.values)
    variation += value * value;
  const Component &first = model.components[0];
  result.offset = average + scale * model.offset;
  result.residual = std::sqrt(sum / samples.times.size()) / std::hypot(first.cosine, first.sine);
  result.explained = 1. - sum / variation;
  for (std::size_t j = 0; j < n_components; ++j)
    result.components[j] = to_damped_sine(model.components[j], scale, times.front(), duration);
  result.converged = true;
  return result;
}
} // namespace Continua
