#ifndef continua_inference_fit_result_h
#define continua_inference_fit_result_h

#include <continua/inference/data_record.h>
#include <continua/inference/fit_parameter.h>
#include <continua/inference/flat_direction.h>
#include <continua/inference/whiteness_test.h>

#include <deal.II/lac/full_matrix.h>

#include <string>
#include <vector>

namespace Continua
{
/// Where a parameter lies with the stated confidence.
struct ConfidenceInterval
{
  double lower;        ///< [unit]
  double upper;        ///< [unit]
  bool lower_is_bound; ///< the lower end is the bound of the parameter (or none), not a limit by
                       ///< data
  bool upper_is_bound;
};

/// What a fit says of one record.
struct RecordFit
{
  std::vector<double> prediction;     ///< [unit]
  std::vector<double> residuals;      ///< measured - predicted [unit]
  std::vector<double> whitened;       ///< residuals made white by the noise of the fit [1]
  double root_mean_square;            ///< of the residuals [unit]
  WhitenessTest whiteness;            ///< of `whitened`
  NoiseModel noise;                   ///< that the fit used, estimated or given
  bool noise_is_estimated;            ///< standard deviation from the residuals
  unsigned int n_fitted_coefficients; ///< autoregressive ones from the residuals
  /// "white", "autoregressive of order 3", "sandwich over 12 values", "enlarged by 2.1".
  std::string treatment;
};

/// One of several starts.
struct FitStart
{
  std::vector<double> start;     ///< [unit]
  std::vector<double> estimates; ///< [unit]; empty if the model failed at the start
  double misfit;                 ///< [1]
  std::string stop_reason;
};

struct FitResult
{
  std::vector<double> estimates;       ///< [unit]
  std::vector<double> standard_errors; ///< [unit]; NaN at a bound and if held, infinite if not seen
  std::vector<ConfidenceInterval> intervals;
  /// Variance of each coordinate with the treatment of correlated noise (sandwich, enlarged), over
  /// the one without [1].
  std::vector<double> treated_over_plain_variance;
  std::vector<bool> at_bound;
  std::vector<unsigned int>
      free; ///< indices of the parameters that are neither held nor at a bound
  /// Of the coordinates of the free ones; NaN if the derivatives at the end were not found.
  dealii::FullMatrix<double> covariance;
  dealii::FullMatrix<double> correlation; ///< the same [1]

  double misfit; ///< chi-square: sum of the squared whitened residuals, and priors
  unsigned int degrees_of_freedom; ///< values and priors less free parameters
  bool noise_is_known;             ///< all standard deviations given
  /// Of each parameter's standard error, for Student's distribution (error_freedom.h): infinite,
  /// the normal one, where nothing of the noise was estimated.
  std::vector<double> degrees_of_freedom_of_errors;
  /// Of a chi-square at least as large if model and noise are right [1]; NaN with estimated noise.
  double probability_of_misfit;
  bool converged;
  std::string stop_reason;
  unsigned int n_iterations;
  unsigned int n_evaluations;
  unsigned int n_failures;         ///< evaluations that failed and whose step was refused
  std::vector<std::string> notes;  ///< what a reader must know: failures, noise, bounds
  std::vector<std::string> doubts; ///< the notes by which the standard errors are wrong
  std::vector<FlatDirection> flat_directions;
  std::vector<RecordFit> records;
  std::vector<FitStart> starts;
  /// d prediction / d coordinate of each parameter (all but the held ones), whitened, of all
  /// records.
  std::vector<std::vector<double>> whitened_jacobian;
};
} // namespace Continua

#endif
