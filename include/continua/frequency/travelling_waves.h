#ifndef continua_frequency_travelling_waves_h
#define continua_frequency_travelling_waves_h

#include <complex>
#include <string>
#include <vector>

namespace Continua
{
/// One wave that goes both ways along a uniform line, with its standard deviations; these are NaN
/// where there are as many numbers as unknowns.
struct TravellingWave
{
  /// g = i k [1/m]: the forward wave is e^(i omega t - g z). Its real part is the attenuation.
  std::complex<double> propagation;
  double speed;                 ///< omega/Im g [m/s]
  double attenuation;           ///< Re g [1/m]
  double speed_deviation;       ///< standard deviation of the speed [m/s]
  double attenuation_deviation; ///< standard deviation of the attenuation [1/m]
  /// By field: the amplitude of the forward wave at the first station and of the backward wave at
  /// the last one, in the unit of the field.
  std::vector<std::complex<double>> forward, backward;
};

/// What the stations of a line say of its waves at one frequency.
struct TravellingWaves
{
  std::vector<TravellingWave> waves; ///< the slowest first; empty where there is a `refusal`
  /// Root of the mean square of what is left of the fields, each over its own root mean square [1].
  double misfit;
  /// The smallest sine of the angle between one wave's direction and all others [1]: errors of the
  /// fields enter the waves with up to its inverse.
  double independence;
  std::string refusal; ///< why there are no waves; a sentence without its full stop
};

struct TravellingWavesOptions
{
  unsigned int n_waves = 1;
  /// g of each wave to begin with [1/m]; without it the stations give it.
  std::vector<std::complex<double>> start;
  /// The least `independence` of waves that are told.
  double least_independence = 1e-3;
};

/**
 * Fits waves that go both ways to complex amplitudes at stations, by nonlinear least squares:
 *
 *   u_f(z) = sum over the waves of F_f e^(-g z) + B_f e^(-g (L - z)).
 *
 * Each field f (a pressure, a displacement) has its own F and B and the same g. F and B follow for
 * given g by linear least squares, and g by GSL's trust region. Stations at equal distances d give
 * the start by the recurrence u(z - d) + u(z + d) = 2 cosh(g d) u(z), as in the method of Prony;
 * others by a search over phases. Stations further apart than half a wave are ambiguous: without a
 * start the longest wave is meant.
 *
 * `positions`: of the stations [m], increasing. `fields`: by field, a value for each station.
 * Stations without enough values, nearer than the waves can be told apart, or at multiples of half
 * a wave are a `refusal`. Throws std::invalid_argument for positions that do not increase, fields
 * of another length, a frequency that is not positive, and a start of another number of waves.
 */
TravellingWaves fit_travelling_waves(const std::vector<double> &positions,
                                     const std::vector<std::vector<std::complex<double>>> &fields,
                                     double angular_frequency,
                                     const TravellingWavesOptions &options = {});
} // namespace Continua

#endif
