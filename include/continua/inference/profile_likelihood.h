#ifndef continua_inference_profile_likelihood_h
#define continua_inference_profile_likelihood_h

#include <continua/inference/least_squares_fit.h>

namespace Continua
{
/// Chi-square over one parameter, the others being fitted anew at each point.
struct Profile
{
  struct Point
  {
    double value;                  ///< [unit] of the parameter
    double misfit;                 ///< chi-square above its least value [1]
    std::vector<double> estimates; ///< [unit] of all parameters
  };
  std::vector<Point> points; ///< in the order of the values
  double threshold;          ///< of `misfit` at the ends of the interval [1]
  ConfidenceInterval interval;
  std::string remark; ///< where the profile meets a bound, or stays below the threshold; else empty
};

/**
 * Profile of one parameter around the estimates of a fit, with the noise of this fit: the interval
 * contains what the likelihood ratio does not refuse, chi-square less its least value up to the
 * quantile of chi-square with one degree of freedom (known noise) or of F
 * (estimated noise, whose mean square is 1, with the degrees of freedom of the parameter's error)
 * (Bates and Watts, Nonlinear Regression Analysis, 1988, 6.1). Where the fit treats correlated
 * noise by a sandwich or enlarges errors, the quantile is multiplied by the treated over the plain
 * variance of the parameter. It needs no linear model. The ends are interpolated in the root of
 * chi-square, which is nearly straight. A better minimum that is found on the way is said in the
 * remark. `n_points`: aimed at on either side. Throws std::invalid_argument for a fit without
 * derivatives.
 */
Profile profile_likelihood(const std::vector<FitParameter> &parameters,
                           const std::vector<DataRecord> &records,
                           FitModel &model,
                           const FitOptions &options,
                           const FitResult &fit,
                           unsigned int parameter,
                           unsigned int n_points = 6);
} // namespace Continua

#endif
