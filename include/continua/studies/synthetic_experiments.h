#ifndef continua_studies_synthetic_experiments_h
#define continua_studies_synthetic_experiments_h

#include <continua/inference/data_record.h>
#include <continua/inference/fit_options.h>
#include <continua/inference/fit_parameter.h>
#include <continua/inference/fit_result.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * Experiments on the computer (parametric bootstrap; B. Efron, R. J. Tibshirani, An Introduction to
 * the Bootstrap, 1993): predictions for known numbers with noise that is drawn anew each time, and
 * a fit of each. How the estimates scatter, and how often the intervals have the truth, checks what
 * a fit says of its own errors. The fits stay near the truth, where the model is interpolated.
 */
class SyntheticExperiments
{
public:
  /// Of one parameter.
  struct OfParameter
  {
    double mean_error;       ///< of the estimate, over the standard error that was foretold [1]
    double spread;           ///< standard deviation of the estimates over the same [1]
    double coverage;         ///< part of the intervals that have the truth [1]
    unsigned int n_at_bound; ///< experiments in which it is at a bound, and has no interval
  };
  struct Outcome
  {
    std::vector<OfParameter> parameters;
    std::vector<FitResult> fits; ///< of each experiment that has one
    unsigned int n_failed = 0;
    double interpolation_error = 0.; ///< largest one found, over the noise [1]
    unsigned int n_evaluations = 0;  ///< of the model itself
    double seconds = 0.;             ///< [s] of all fits
  };

  /// `truth` [unit]; `standard_errors`, foretold for it, also set the size of the box in which the
  /// model is interpolated [unit]. `records`: as the fits take them, their values do not count.
  /// `noise`: that is drawn, by record.
  SyntheticExperiments(const std::vector<FitParameter> &parameters,
                       const std::vector<double> &truth,
                       const std::vector<double> &standard_errors,
                       const std::vector<DataRecord> &records,
                       const std::vector<NoiseModel> &noise,
                       const FitOptions &options);

  /// Throws RunError if the model fails near the truth.
  Outcome perform(FitModel &model, unsigned int n_experiments, unsigned int seed) const;

private:
  std::vector<FitParameter> parameters;
  std::vector<double> truth, standard_errors, half_widths;
  std::vector<DataRecord> records;
  std::vector<NoiseModel> noise;
  FitOptions options;

  double interpolation_error(FitModel &model, FitModel &interpolated, unsigned int seed) const;
  void summarise(Outcome &outcome) const;
};
} // namespace Continua

#endif
