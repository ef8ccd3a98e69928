#ifndef continua_materials_prony_series_h
#define continua_materials_prony_series_h

#include <complex>
#include <functional>
#include <vector>

namespace Continua
{
/**
 * A spring and further springs that relax, side by side (generalised Maxwell): a modulus, of shear
 * or another one, and how closely it follows the law to which it was fitted.
 */
struct PronySeries
{
  double spring = 0.;          ///< modulus of the spring that never relaxes [Pa]
  std::vector<double> moduli;  ///< of the branches [Pa]
  std::vector<double> times;   ///< their relaxation times [s], the longest first
  double lowest_frequency = 0; ///< of the band of the fit [Hz]
  double highest_frequency = 0;
  double error = 0.; ///< largest |series/law - 1| over the band, real and imaginary part together

  /// Stress over strain in harmonic motion exp(i omega t) [Pa], omega [1/s].
  std::complex<double> modulus(double omega) const;
};

/// Stress over strain in harmonic motion exp(i omega t) [Pa] as a function of omega [1/s].
using ComplexModulus = std::function<std::complex<double>(double)>;

/// More branches than this are not tried.
constexpr unsigned int most_prony_branches = 40;

/**
 * The series of so many branches, all moduli and times positive and all times free, that follows
 * `law` from `lowest_frequency` to `highest_frequency` [Hz], 0 < lowest < highest. Levenberg and
 * Marquardt's least squares (GSL) of the relative errors at frequencies that are evenly spaced in
 * the logarithm, in the logarithms of moduli and times; their weights are then moved to where the
 * error is largest (C. L. Lawson's iteration), which halves the largest error. Throws
 * std::domain_error where the law has no positive storage modulus.
 */
PronySeries fit_prony_series(const ComplexModulus &law,
                             double lowest_frequency,
                             double highest_frequency,
                             unsigned int n_branches);

/// The same with as few branches as meet the tolerance of the largest error. Throws
/// std::range_error, with the error that is reached, if most_prony_branches do not.
PronySeries fit_prony_series_within(const ComplexModulus &law,
                                    double lowest_frequency,
                                    double highest_frequency,
                                    double tolerance);
} // namespace Continua

#endif
