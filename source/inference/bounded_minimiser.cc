#include <continua/inference/bounded_minimiser.h>

#include <continua/base/quiet_gsl.h>
#include <continua/base/six_digits.h>
#include <continua/inference/least_squares_factor.h>
#include <continua/inference/model_derivatives.h>
#include <continua/signal/gsl_release.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace Continua
{
namespace
{
using TrustRegionWorkspace =
    std::unique_ptr<gsl_multifit_nlinear_workspace,
                    GslRelease<gsl_multifit_nlinear_workspace, gsl_multifit_nlinear_free>>;

const gsl_multifit_nlinear_trs *method_of(const TrustRegion trust_region)
{
  switch (trust_region)
  {
  case TrustRegion::geodesic_acceleration:
    return gsl_multifit_nlinear_trs_lmaccel;
  case TrustRegion::dogleg:
    return gsl_multifit_nlinear_trs_dogleg;
  case TrustRegion::levenberg_marquardt:
    break;
  }
  return gsl_multifit_nlinear_trs_lm;
}

double squared(const std::vector<double> &rows)
{
  return std::inner_product(rows.begin(), rows.end(), rows.begin(), 0.);
}

std::vector<double> to_std(const gsl_vector *vector)
{
  std::vector<double> result(vector->size);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = gsl_vector_get(vector, i);
  return result;
}

/// Whether a search ends, and why; an empty reason: it goes on.
struct EndOfSearch
{
  bool converged;
  std::string reason;
};

/// `unit`: of a standard error, in the rows.
EndOfSearch end_of_search(const gsl_multifit_nlinear_workspace &workspace,
                          const int status,
                          const double unit,
                          const unsigned int n_evaluations,
                          const FitOptions &options)
{
  std::vector<std::vector<double>> columns(workspace.J->size2,
                                           std::vector<double>(workspace.J->size1));
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (std::size_t i = 0; i < columns[k].size(); ++i)
      columns[k][i] = gsl_matrix_get(workspace.J, i, k);
  const LeastSquaresFactor factor(columns);
  const std::vector<double> rows = to_std(workspace.f);
  const double remaining = factor.length_in_range(rows);
  if (remaining <= options.tolerance * unit)
    return {true, "a further step would move no parameter by more than " +
                      six_digits(options.tolerance) + " standard errors"};
  const std::vector<double> newton_step = factor.solve(rows);
  if (std::all_of(newton_step.begin(), newton_step.end(),
                  [&](const double step) { return std::abs(step) <= options.step_tolerance; }))
    return {true, "a further step would move no parameter by more than " +
                      six_digits(options.step_tolerance) + " of its size"};
  if (status == GSL_ENOPROG)
  {
    const bool is_near = remaining <= 0.1 * unit;
    return {is_near,
            "no shorter step makes the misfit smaller" +
                std::string(is_near ? ", and what is left is below 0.1 standard errors" : "")};
  }
  if (n_evaluations >= options.largest_n_evaluations)
    return {false, "the largest number of evaluations, " +
                       std::to_string(options.largest_n_evaluations) + ", is reached"};
  return {false, ""};
}
} // namespace

/// GSL's variable of a parameter is 1 at the start of a search and changes by 1 with the size of
/// the coordinate, so that the first region of trust is 0.3 sizes wide.
struct BoundedMinimiser::Problem
{
  const BoundedMinimiser &minimiser;
  const std::vector<unsigned int> &free;
  std::vector<double> origin; ///< [unit]
  std::size_t n_rows;
  std::vector<double> accepted; ///< rows of the best set so far
  std::string failure;

  /// Set within the bounds that belongs to GSL's variables.
  std::vector<double> set_of(const gsl_vector *variables) const
  {
    std::vector<double> set = origin;
    for (std::size_t k = 0; k < free.size(); ++k)
    {
      const FitParameter &parameter = minimiser.parameters[free[k]];
      const double change = gsl_vector_get(variables, k) - 1.;
      if (change != 0.)
        set[free[k]] = std::clamp(
            parameter.value(parameter.coordinate(origin[free[k]]) + change * parameter.size()),
            parameter.lower, parameter.upper);
    }
    return set;
  }

  static int rows(const gsl_vector *variables, void *data, gsl_vector *result)
  {
    Problem &problem = *static_cast<Problem *>(data);
    const std::vector<double> set = problem.set_of(variables);
    const FitModel::Prediction prediction = problem.minimiser.model.predict_one(set, "step");
    if (!prediction.failure.empty())
    {
      // Ten times the length of the residuals at hand: GSL refuses the step.
      const double value = 10. * std::sqrt(squared(problem.accepted) / problem.n_rows) + 1.;
      gsl_vector_set_all(result, value);
      return GSL_SUCCESS;
    }
    const std::vector<double> values = problem.minimiser.residuals.rows(set, prediction.values);
    for (std::size_t i = 0; i < values.size(); ++i)
      gsl_vector_set(result, i, values[i]);
    return GSL_SUCCESS;
  }

  static int jacobian(const gsl_vector *variables, void *data, gsl_matrix *result)
  {
    Problem &problem = *static_cast<Problem *>(data);
    const BoundedMinimiser &minimiser = problem.minimiser;
    const std::vector<double> set = problem.set_of(variables);
    const ModelDerivatives derivatives =
        model_derivatives(minimiser.parameters, minimiser.model, set, problem.free,
                          minimiser.options.difference_step);
    if (!derivatives.failure.empty())
    {
      problem.failure = derivatives.failure;
      return GSL_EFAILED;
    }
    for (std::size_t k = 0; k < problem.free.size(); ++k)
    {
      const unsigned int j = problem.free[k];
      const std::vector<double> column = minimiser.residuals.column(j, derivatives.columns[j]);
      for (std::size_t i = 0; i < column.size(); ++i)
        gsl_matrix_set(result, i, k, column[i] * minimiser.parameters[j].size());
    }
    problem.accepted =
        minimiser.residuals.rows(set, minimiser.model.predict_one(set, "step").values);
    return GSL_SUCCESS;
  }
};

BoundedMinimiser::BoundedMinimiser(const std::vector<FitParameter> &parameters,
                                   EvaluatedModel &model,
                                   const WeightedResiduals &residuals,
                                   const FitOptions &options,
                                   const bool noise_is_known)
    : parameters(parameters),
      model(model),
      residuals(residuals),
      options(options),
      noise_is_known(noise_is_known)
{
}

double BoundedMinimiser::unit_of_error(const double misfit, const std::size_t n_free) const
{
  if (noise_is_known || residuals.n_rows() <= n_free)
    return 1.;
  return std::sqrt(misfit / (residuals.n_rows() - n_free));
}

BoundedMinimiser::Minimum BoundedMinimiser::minimise(const std::vector<double> &start)
{
  Minimum minimum;
  minimum.set = start;
  minimum.misfit = std::nan("");
  minimum.at_bound.assign(parameters.size(), false);
  minimum.converged = false;
  minimum.n_iterations = 0;
  const FitModel::Prediction prediction = model.predict_one(start, "start");
  if (!prediction.failure.empty())
  {
    minimum.stop_reason = "the model fails at the start: " + prediction.failure;
    return minimum;
  }
  minimum.prediction = prediction.values;
  minimum.misfit = residuals.misfit(start, prediction.values);

  if (!hold_at_start(minimum))
    return minimum;
  std::vector<unsigned int> n_releases(parameters.size(), 0);
  std::vector<unsigned int> not_held;
  for (unsigned int j = 0; j < parameters.size(); ++j)
    if (!parameters[j].is_held())
      not_held.push_back(j);
  while (true)
  {
    std::vector<unsigned int> free;
    for (const unsigned int j : not_held)
      if (!minimum.at_bound[j])
        free.push_back(j);
    if (free.empty())
    {
      minimum.converged = true;
      minimum.stop_reason = "all parameters are at a bound";
    }
    else if (minimise_free(minimum, free))
      continue;
    if (!set_derivatives(minimum, not_held))
      return minimum;
    if (!minimum.converged || !release(minimum, n_releases))
      return minimum;
  }
}

bool BoundedMinimiser::set_derivatives(Minimum &minimum, const std::vector<unsigned int> &of)
{
  const ModelDerivatives derivatives =
      model_derivatives(parameters, model, minimum.set, of, options.difference_step);
  minimum.columns.assign(parameters.size(), {});
  if (!derivatives.failure.empty())
  {
    minimum.converged = false;
    minimum.stop_reason = derivatives.failure;
    return false;
  }
  for (const unsigned int j : of)
    minimum.columns[j] = residuals.column(j, derivatives.columns[j]);
  return true;
}

double BoundedMinimiser::gain_inwards(const Minimum &minimum,
                                      const std::vector<double> &rows,
                                      const unsigned int parameter) const
{
  const std::vector<double> &column = minimum.columns[parameter];
  const double length = std::sqrt(squared(column));
  if (!(length > 0.))
    return 0.;
  const double slope = std::inner_product(column.begin(), column.end(), rows.begin(), 0.) / length;
  return minimum.set[parameter] <= parameters[parameter].lower ? -slope : slope;
}

bool BoundedMinimiser::hold_at_start(Minimum &minimum)
{
  std::vector<unsigned int> at_bound;
  for (unsigned int j = 0; j < parameters.size(); ++j)
    if (!parameters[j].is_held() &&
        (minimum.set[j] <= parameters[j].lower || minimum.set[j] >= parameters[j].upper))
      at_bound.push_back(j);
  if (at_bound.empty())
    return true;
  if (!set_derivatives(minimum, at_bound))
    return false;
  const std::vector<double> rows = residuals.rows(minimum.set, minimum.prediction);
  for (const unsigned int j : at_bound)
    minimum.at_bound[j] = gain_inwards(minimum, rows, j) <= 0.;
  return true;
}

bool BoundedMinimiser::release(Minimum &minimum, std::vector<unsigned int> &n_releases) const
{
  const std::vector<double> rows = residuals.rows(minimum.set, minimum.prediction);
  double largest = options.tolerance * unit_of_error(minimum.misfit, 0);
  int which = -1;
  for (unsigned int j = 0; j < parameters.size(); ++j)
    if (minimum.at_bound[j] && n_releases[j] < 3)
    {
      const double gain = gain_inwards(minimum, rows, j);
      if (gain > largest)
      {
        largest = gain;
        which = static_cast<int>(j);
      }
    }
  if (which < 0)
    return false;
  minimum.at_bound[which] = false;
  ++n_releases[which];
  return true;
}

bool BoundedMinimiser::minimise_free(Minimum &minimum, const std::vector<unsigned int> &free)
{
  const QuietGsl quiet;
  Problem problem{
      *this, free, minimum.set, residuals.n_rows(), residuals.rows(minimum.set, minimum.prediction),
      ""};
  gsl_multifit_nlinear_fdf functions{};
  functions.f = Problem::rows;
  functions.df = Problem::jacobian;
  functions.n = std::max(problem.n_rows, free.size());
  functions.p = free.size();
  functions.params = &problem;
  gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
  settings.trs = method_of(options.trust_region);
  settings.h_fvv = 0.02;
  const TrustRegionWorkspace workspace(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, functions.n, functions.p));
  std::unique_ptr<gsl_vector, GslRelease<gsl_vector, gsl_vector_free>> start(
      gsl_vector_alloc(free.size()));
  gsl_vector_set_all(start.get(), 1.);

  minimum.converged = false;
  int status = gsl_multifit_nlinear_init(start.get(), &functions, workspace.get());
  while (true)
  {
    if (status != GSL_SUCCESS && status != GSL_ENOPROG)
    {
      minimum.stop_reason =
          problem.failure.empty() ? std::string("GSL: ") + gsl_strerror(status) : problem.failure;
      return false;
    }
    minimum.set = problem.set_of(workspace->x);
    minimum.prediction = model.predict_one(minimum.set, "step").values;
    minimum.misfit = residuals.misfit(minimum.set, minimum.prediction);
    bool meets_bound = false;
    for (std::size_t k = 0; k < free.size(); ++k)
    {
      const FitParameter &parameter = parameters[free[k]];
      // One that starts at its bound is free as long as steps are found.
      const bool is_out =
          (gsl_vector_get(workspace->x, k) != 1. || status == GSL_ENOPROG) &&
          (minimum.set[free[k]] <= parameter.lower || minimum.set[free[k]] >= parameter.upper);
      minimum.at_bound[free[k]] = is_out;
      meets_bound = meets_bound || is_out;
    }
    if (meets_bound)
      return true;

    const EndOfSearch end =
        end_of_search(*workspace, status, unit_of_error(minimum.misfit, free.size()),
                      model.n_evaluations(), options);
    if (!end.reason.empty())
    {
      minimum.converged = end.converged;
      minimum.stop_reason = end.reason;
      return false;
    }
    status = gsl_multifit_nlinear_iterate(workspace.get());
    ++minimum.n_iterations;
  }
}
} // namespace Continua
