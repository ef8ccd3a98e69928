#ifndef continua_frequency_winding_number_h
#define continua_frequency_winding_number_h

#include <complex>
#include <cstddef>
#include <functional>

namespace Continua
{
/// The sector inner <= |s| <= outer of the plane, from one angle to a larger one [rad].
struct PlaneSector
{
  double inner, outer;            ///< [rad/s]
  double first_angle, last_angle; ///< from the positive real axis [rad]
};
struct WindingNumber
{
  int number = 0;                ///< zeros less poles in the sector, by their multiplicities
  std::size_t n_evaluations = 0; ///< of the function
  bool is_known = false;         ///< false: the most evaluations did not do
};

/**
 * How often an analytic function turns round zero as s goes once round a sector: its zeros in there
 * less its poles (the principle of the argument). `logarithm` gives its logarithm, whose imaginary
 * part may be off by any multiple of 2 pi. The phase of a determinant of thousands of unknowns may
 * turn thousands of times along a side; each step along a side is therefore as long as the slope of
 * the step before predicts the phase. Sides are even in the angle and in ln |s|, in which a power
 * of s has a constant slope. A zero on the contour has no number.
 */
WindingNumber
winding_number(const std::function<std::complex<double>(std::complex<double>)> &logarithm,
               const PlaneSector &sector,
               std::size_t most_evaluations = 1000);
} // namespace Continua

#endif
