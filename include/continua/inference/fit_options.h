#ifndef continua_inference_fit_options_h
#define continua_inference_fit_options_h

#include <continua/inference/autoregressive_model.h>
#include <continua/inference/evaluation.h>

namespace Continua
{
/// What is done about residuals that are correlated in time, of records that have an interval.
enum class CorrelatedNoise
{
  as_given, ///< the noise of the records is taken as it stands
  /// Generalised least squares: the residuals of each record whose noise is given as white get an
  /// autoregressive model (order by a criterion, coefficients by restricted likelihood), the fit is
  /// repeated with it until it no longer changes. What is left correlated then is treated by
  /// `sandwich`.
  autoregressive,
  sandwich, ///< estimates with the noise as given, covariance by Newey and West
  enlarged  ///< covariance times the largest spectral density of the residuals: conservative
};

/// How GSL looks for the next step within the region in which it trusts the linear model.
enum class TrustRegion
{
  levenberg_marquardt,
  geodesic_acceleration, ///< Levenberg-Marquardt with a second-order correction
  dogleg
};

struct FitOptions
{
  /// The fit ends when a further step of Gauss and Newton would be shorter than this many standard
  /// errors [1] ...
  double tolerance = 1e-3;
  /// ... or when no coordinate moved by more than this times its size [1] ...
  double step_tolerance = 1e-10;
  unsigned int largest_n_evaluations = 2000; ///< ... or after this many evaluations, unfinished
  unsigned int n_starts = 1; ///< the given one, and others spread evenly within the bounds
  /// Half the distance of central differences, over 1 on a logarithmic scale, over the value (at
  /// most its size, at least 0.01 of it) on a linear one [1]. With start 0 over the size.
  double difference_step = 1e-3;
  TrustRegion trust_region = TrustRegion::geodesic_acceleration;
  CorrelatedNoise correlated_noise = CorrelatedNoise::autoregressive;
  OrderCriterion order_criterion = OrderCriterion::bayesian;
  double confidence = 0.95; ///< [1] of the intervals
  /// A direction is called flat if one standard error along it, from all data together, moves a
  /// parameter by more than this factor (logarithmic scale), or by more than ln of this factor
  /// times its size (linear) [1].
  double flat_factor = 2.;
  std::vector<Evaluation> known; ///< replayed instead of computed
  EvaluationObserver observer;
};
} // namespace Continua

#endif
