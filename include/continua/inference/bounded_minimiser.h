#ifndef continua_inference_bounded_minimiser_h
#define continua_inference_bounded_minimiser_h

#include <continua/inference/evaluated_model.h>
#include <continua/inference/fit_options.h>
#include <continua/inference/weighted_residuals.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * The least sum of squares within the bounds, by GSL's trust region and an active set. A parameter
 * that a step carries over its bound is put onto the bound and stays there while the others move;
 * it is let go again if, in the end, the sum of squares would fall inside of the bounds. A trial at
 * which the model fails counts as one with a large sum of squares: GSL refuses the step and tries a
 * shorter one.
 */
class BoundedMinimiser
{
public:
  struct Minimum
  {
    std::vector<double> set; ///< [unit]
    std::vector<double>
        prediction; ///< [unit of each record]; empty if the model failed at the start
    std::vector<std::vector<double>> columns; ///< whitened, of all parameters that are not held
    double misfit;
    std::vector<bool> at_bound;
    bool converged;
    std::string stop_reason;
    unsigned int n_iterations;
  };
  /// `noise_is_known`: if not, standard errors are those of the residuals.
  BoundedMinimiser(const std::vector<FitParameter> &parameters,
                   EvaluatedModel &model,
                   const WeightedResiduals &residuals,
                   const FitOptions &options,
                   bool noise_is_known);
  Minimum minimise(const std::vector<double> &start);

private:
  /// What GSL moves: parameters that are neither held nor at a bound.
  struct Problem;
  /// Until no step is left for the free ones, or one meets its bound (then true).
  bool minimise_free(Minimum &minimum, const std::vector<unsigned int> &free);
  /// Lets go of the parameter at a bound that gains most. False if none does.
  bool release(Minimum &minimum, std::vector<unsigned int> &n_releases) const;
  /// Holds those that start at a bound and would leave the bounds. False if a derivative fails.
  bool hold_at_start(Minimum &minimum);
  /// By how much a step inwards from the bound would make the residuals shorter, per length of its
  /// change of the rows [1].
  double gain_inwards(const Minimum &minimum,
                      const std::vector<double> &rows,
                      unsigned int parameter) const;
  bool set_derivatives(Minimum &minimum, const std::vector<unsigned int> &of);
  double unit_of_error(double misfit, std::size_t n_free) const;

  const std::vector<FitParameter> &parameters;
  EvaluatedModel &model;
  const WeightedResiduals &residuals;
  const FitOptions &options;
  bool noise_is_known;
};
} // namespace Continua

#endif
