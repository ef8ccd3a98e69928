#ifndef continua_theory_bar_law_fit_h
#define continua_theory_bar_law_fit_h

#include <continua/inference/fit_model.h>
#include <continua/inference/fit_parameter.h>
#include <continua/inference/fit_result.h>
#include <continua/theory/bar_law_start.h>

#include <memory>
#include <vector>

namespace Continua
{
/// constants of a law -> what tests of a bar show, over the units of their noise.
class BarModel : public FitModel
{
public:
  /// The law and the records must outlive this.
  BarModel(const BarLaw &law, const std::vector<BarRecord> &records);
  std::vector<Prediction> predict(const std::vector<std::vector<double>> &sets) override;

private:
  const BarLaw &law;
  const std::vector<BarRecord> &records;
};

/// A law that follows the records as closely as it can.
struct BarLawFit
{
  std::shared_ptr<const BarLaw> law;
  std::vector<FitParameter> parameters; ///< the constants, with start and bounds
  FitResult result;
  /// Root of the mean square of each record's residuals, over the units of its noise [1].
  std::vector<double> misfits;
  /// Schwarz's information criterion (Ann. Stat. 6 (1978) 461) of normal noise whose standard
  /// deviation is found for each record: sum over the records of n ln(mean square of the
  /// residuals), plus the number of constants times ln of the number of all values. The smaller one
  /// is better, by 10 very clearly (R. E. Kass, A. E. Raftery, J. Am. Stat. Assoc. 90 (1995) 773).
  double criterion = 0.;
};

/// A difference of the criterion that is very clear, and one that is not worth more than a bare
/// mention [1]; of the same paper.
constexpr double clear_difference = 10., slight_difference = 2.;

/**
 * Polishes a start by nonlinear least squares (LeastSquaresFit), all constants free and positive.
 * Each record's noise is found from its residuals. Branches are sorted, the longest first. Throws
 * std::invalid_argument if there are no more values than constants. Whether the search converged is
 * in the result.
 */
BarLawFit fit_bar_law(const BarLawStart &start, const std::vector<BarRecord> &records);

/// Series with more constants per value are left out of a comparison [1]: Schwarz's criterion is
/// that of many values, and falls without bound where the constants are as many as the values.
constexpr double most_constants_per_value = 0.5;

/// Prony series of 0, 1, 2, ... branches until two more branches make the criterion no better, or
/// have more constants than `most_constants_per_value` allows. A number of branches whose fit fails
/// or does not converge is left out.
std::vector<BarLawFit> fit_prony_series_to_bar(double poissons_ratio,
                                               const std::vector<BarRecord> &records,
                                               unsigned int most_branches);

/// The one with the least criterion; `fits` must not be empty.
const BarLawFit &best_of(const std::vector<BarLawFit> &fits);
/// The first one whose criterion is above the least one by no more than slight_difference: of
/// series in their order that with the fewest branches. `fits` must not be empty.
const BarLawFit &simplest_of(const std::vector<BarLawFit> &fits);
} // namespace Continua

#endif
