#ifndef continua_inference_expected_errors_h
#define continua_inference_expected_errors_h

#include <continua/inference/data_record.h>
#include <continua/inference/fit_model.h>
#include <continua/inference/fit_parameter.h>
#include <continua/inference/flat_direction.h>

#include <deal.II/lac/full_matrix.h>

#include <limits>
#include <string>
#include <vector>

namespace Continua
{
/**
 * The errors that an experiment would have, before there are data: the Fisher information J^T W J
 * of each record at the start values of the parameters. One Jacobian is enough for all choices of
 * records. Parameters that are held are known; priors add their information.
 */
class ExpectedErrors
{
public:
  struct Errors
  {
    std::vector<double>
        standard_errors; ///< [unit] of each parameter; 0 if held, infinite if unseen
    dealii::FullMatrix<double> correlation; ///< of the parameters that are not held [1]
    double log_determinant; ///< ln det of the information by sizes of the coordinates [1]
    std::vector<FlatDirection> flat_directions;
  };
  /// Records chosen, and what they give.
  struct Choice
  {
    std::vector<unsigned int> candidates; ///< which of them were added
    Errors errors;
  };

  /// `records` with their noise, the standard deviations known; their values are not used. The
  /// model is evaluated in one call for all differences (FitOptions::difference_step). Throws
  /// std::invalid_argument as LeastSquaresFit does, RunError if the model fails.
  ExpectedErrors(std::vector<FitParameter> parameters,
                 const std::vector<DataRecord> &records,
                 FitModel &model,
                 double difference_step = 1e-3,
                 double flat_factor = 2.);

  /// With all records of these indices together.
  Errors of(const std::vector<unsigned int> &records) const;
  Errors of_all() const;
  /// J^T W J of one record, of the coordinates of the parameters that are not held.
  dealii::FullMatrix<double> information(unsigned int record) const;

  /**
   * Sets of `n_chosen` (1: single ones, 2: pairs ...) of the `candidates` added to `always`, best
   * first: by the standard error of `parameter`, or by the determinant (D-optimal) if `parameter`
   * is `by_determinant`. Each candidate may have several records (a station with pressure and flow
   * rate).
   */
  std::vector<Choice> rank(const std::vector<unsigned int> &always,
                           const std::vector<std::vector<unsigned int>> &candidates,
                           unsigned int n_chosen,
                           unsigned int parameter) const;
  static constexpr unsigned int by_determinant = std::numeric_limits<unsigned int>::max();

private:
  std::vector<FitParameter> parameters;
  double flat_factor;
  std::vector<unsigned int> not_held;
  /// [record][parameter that is not held][row]: few rows with the same J^T W J.
  std::vector<std::vector<std::vector<double>>> columns;
};
} // namespace Continua

#endif
