#ifndef continua_signal_two_wave_fit_h
#define continua_signal_two_wave_fit_h

#include <continua/signal/wave_analysis.h>

#include <cstddef>
#include <vector>

namespace Continua
{
/// What the fit of two waves says of the slow one.
struct TwoWaveFit
{
  double attenuation; ///< of the slow wave [1/m]; NaN without a fit
  double misfit;      ///< norm of what is left over that of pressure and flow rate [1]
  double uncertainty; ///< by how much a larger sigma changes the attenuation, over it [1]
};

/**
 * The loss of a wave beside another one, as the axial wave of a wall is beside the pressure wave of
 * a tube. Each wave goes both ways along a uniform tube: with the Laplace transforms over the
 * record, at s = sigma + i omega,
 *
 *   p(z) = sum over both waves of F e^(-g z) + B e^(g z),
 *   q(z) = sum of (F e^(-g z) - B e^(g z)) g/(kappa s (1 + m/sqrt(s))),
 *
 * since the liquid of any wave obeys the balance of momentum, kappa s q = -dp/dz, but for the
 * friction m/sqrt(s). The slow wave has g = s/c + b sqrt(s) + d s^2 + e s^3: the friction of a
 * liquid, a wall that relaxes, and the dispersion by inertia and bending of the wall. The fast one
 * has g = s/c. By least squares F and B follow for each s, and the eight numbers for all. sigma is
 * 6 over the length of the record, so that its end counts for 1/400. The frequencies are those
 * up to which the first station has a tenth of its largest pressure.
 *
 * The attenuation is the mean of Re g(i omega), weighted with the square of the pressure at the
 * first station.
 *
 * `stations`: three at least; `speed`: of the slow wave [m/s], to begin with. The record has flow
 * rates and begins at rest.
 */
TwoWaveFit
fit_two_waves(const WaveRecord &record, const std::vector<std::size_t> &stations, double speed);
} // namespace Continua

#endif
