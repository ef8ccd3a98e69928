#include <continua/inference/profile_likelihood.h>

#include <continua/base/six_digits.h>
#include <continua/inference/bounded_minimiser.h>

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace Continua
{
namespace
{
/// Walks from the estimates to one side, the parameter held and the others fitted anew.
class ProfileWalk
{
public:
  ProfileWalk(const std::vector<FitParameter> &parameters,
              EvaluatedModel &model,
              const WeightedResiduals &residuals,
              const FitOptions &options,
              const FitResult &fit,
              const unsigned int index,
              const double threshold)
      : parameters(parameters),
        model(model),
        residuals(residuals),
        options(options),
        fit(fit),
        index(index),
        threshold(threshold)
  {
  }

  /// `step` [coordinate]: with the sign of the side. Coordinate of the end of the interval;
  /// infinite where the threshold is not reached, with a remark.
  double find_end(double step, const unsigned int n_points)
  {
    const FitParameter &parameter = parameters[index];
    const double centre = parameter.coordinate(fit.estimates[index]);
    const double bound = parameter.coordinate(step > 0. ? parameter.upper : parameter.lower);
    const double target = std::sqrt(threshold);
    double before = centre;
    double root_before = 0.;
    std::vector<double> set = fit.estimates;
    for (unsigned int k = 0; k < 4 * n_points && before != bound; ++k)
    {
      double next = before + step;
      if (step > 0. ? next >= bound : next <= bound)
        next = bound;
      const Profile::Point point = fit_others(set, before, next);
      if (point.estimates.empty())
        return infinite(step, "the model fails at " + text(next) + ": " + model.last_failure());
      points.push_back(point);
      set = point.estimates;
      const double root = std::sqrt(std::max(0., point.misfit));
      if (root >= target)
        return before + (target - root_before) / (root - root_before) * (next - before);
      before = next;
      root_before = root;
      if (k + 1 >= n_points)
        step *= 1.5;
    }
    if (before == bound)
      return infinite(step, "it meets the bound " + text(bound) + " below the threshold");
    return infinite(step, "it stays below the threshold as far as " + text(before));
  }

  std::vector<Profile::Point> points;
  std::vector<std::string> remarks;

private:
  double infinite(const double step, const std::string &remark)
  {
    remarks.push_back(remark);
    return std::copysign(std::numeric_limits<double>::infinity(), step);
  }

  std::string text(const double coordinate) const
  {
    return six_digits(parameters[index].value(coordinate)) + " " + parameters[index].unit;
  }

  /// Others as the linear model of the fit lets them follow a change of the coordinate.
  std::vector<double> predicted(const std::vector<double> &set, const double change) const
  {
    std::vector<double> result = set;
    const auto place = std::find(fit.free.begin(), fit.free.end(), index);
    if (place == fit.free.end())
      return result;
    const unsigned int row = place - fit.free.begin();
    for (unsigned int k = 0; k < fit.free.size(); ++k)
    {
      const unsigned int j = fit.free[k];
      const double slope = fit.covariance(k, row) / fit.covariance(row, row);
      if (j != index && std::isfinite(slope))
        result[j] =
            std::clamp(parameters[j].value(parameters[j].coordinate(set[j]) + slope * change),
                       parameters[j].lower, parameters[j].upper);
    }
    return result;
  }

  Profile::Point fit_others(const std::vector<double> &set, const double before, const double next)
  {
    std::vector<FitParameter> others = parameters;
    FitParameter &parameter = others[index];
    const double value = std::clamp(parameter.value(next), parameter.lower, parameter.upper);
    for (unsigned int j = 0; j < others.size(); ++j)
      others[j].start = set[j];
    parameter.start = parameter.lower = parameter.upper = value;
    for (std::vector<double> start : {predicted(set, next - before), set})
    {
      start[index] = value;
      const BoundedMinimiser::Minimum minimum =
          BoundedMinimiser(others, model, residuals, options, fit.noise_is_known).minimise(start);
      if (!minimum.prediction.empty())
        return {value, residuals.misfit(minimum.set, minimum.prediction) - fit.misfit, minimum.set};
    }
    return {value, std::nan(""), {}};
  }

  const std::vector<FitParameter> &parameters;
  EvaluatedModel &model;
  const WeightedResiduals &residuals;
  const FitOptions &options;
  const FitResult &fit;
  unsigned int index;
  double threshold;
};

double
profile_threshold(const FitResult &fit, const unsigned int parameter, const double confidence)
{
  const double degrees = fit.degrees_of_freedom_of_errors[parameter];
  return fit.treated_over_plain_variance[parameter] *
         (std::isfinite(degrees) ? gsl_cdf_fdist_Pinv(confidence, 1., degrees)
                                 : gsl_cdf_chisq_Pinv(confidence, 1.));
}

/// Of the coordinate, to one side: so that `n_points` reach the end of the interval if the model is
/// linear.
double step_of_profile(const FitParameter &parameter,
                       const FitResult &fit,
                       const unsigned int index,
                       const double side,
                       const unsigned int n_points)
{
  const ConfidenceInterval &interval = fit.intervals[index];
  const double centre = parameter.coordinate(fit.estimates[index]);
  double reach = 0.;
  for (const double end : {interval.lower, interval.upper})
  {
    const double distance = std::abs(parameter.coordinate(end) - centre);
    if (std::isfinite(distance))
      reach = std::max(reach, distance);
  }
  if (!(reach > 0.) || reach > 3. * parameter.size())
    reach = parameter.size();
  return side * reach / std::max(1U, n_points - 1);
}
} // namespace

Profile profile_likelihood(const std::vector<FitParameter> &parameters,
                           const std::vector<DataRecord> &records,
                           FitModel &fit_model,
                           const FitOptions &options,
                           const FitResult &fit,
                           const unsigned int parameter,
                           const unsigned int n_points)
{
  if (fit.intervals.size() != parameters.size() || !std::isfinite(fit.misfit) ||
      std::isnan(fit.degrees_of_freedom_of_errors.at(parameter)))
    throw std::invalid_argument("a profile needs a fit with derivatives");
  std::vector<DataRecord> weighted = records;
  for (std::size_t r = 0; r < records.size(); ++r)
    weighted[r].noise = fit.records.at(r).noise;
  const WeightedResiduals residuals(parameters, weighted);
  EvaluatedModel model(fit_model, residuals.n_values(), options.known, options.observer);
  model.set_misfit([&residuals](const std::vector<double> &set, const std::vector<double> &values)
                   { return residuals.misfit(set, values); });
  Profile profile;
  profile.threshold = profile_threshold(fit, parameter, options.confidence);
  profile.points.push_back({fit.estimates[parameter], 0., fit.estimates});
  if (!fit.converged)
    profile.remark = "the fit has not converged";
  double ends[2];
  for (const int side : {0, 1})
  {
    ProfileWalk walk(parameters, model, residuals, options, fit, parameter, profile.threshold);
    ends[side] = walk.find_end(
        step_of_profile(parameters[parameter], fit, parameter, side == 0 ? -1. : 1., n_points),
        n_points);
    profile.points.insert(profile.points.end(), walk.points.begin(), walk.points.end());
    for (const std::string &remark : walk.remarks)
      profile.remark += (profile.remark.empty() ? "" : "; ") + remark;
  }
  std::sort(profile.points.begin(), profile.points.end(),
            [](const Profile::Point &a, const Profile::Point &b) { return a.value < b.value; });
  const FitParameter &law = parameters[parameter];
  profile.interval = {std::isfinite(ends[0]) ? law.value(ends[0]) : law.lower,
                      std::isfinite(ends[1]) ? law.value(ends[1]) : law.upper,
                      !std::isfinite(ends[0]), !std::isfinite(ends[1])};
  for (const Profile::Point &point : profile.points)
    if (point.misfit < -0.01 * profile.threshold)
    {
      profile.remark += (profile.remark.empty() ? "" : "; ") +
                        ("a smaller misfit was found at " + six_digits(point.value) + " " +
                         law.unit + ": the fit ended in another minimum");
      break;
    }
  return profile;
}
} // namespace Continua
