#ifndef continua_theory_stream_waves_h
#define continua_theory_stream_waves_h

#include <continua/theory/complex_bessel.h>
#include <continua/theory/scaled_system.h>
#include <continua/theory/stream.h>

#include <vector>

namespace Continua
{
/**
 * Long axisymmetric waves exp(i(omega t - k z)) in a round tube whose liquid flows: the linearised
 * equations of momentum and mass with a mean velocity V(r),
 *
 *   rho (i (omega - k V) u + v V') = i k p + eta/r (r u')',
 *   (r v)'/r = i k u - i (omega - k V) p/K,
 *
 * with a pressure that is uniform over the section and a wall that moves radially only, by R D p/2.
 * D [1/Pa] is the distensibility of the section. The wall has the velocity v = i omega R D p/2 of
 * the liquid (i (omega - k V) R D p/2 where it moves and the liquid slips). Its axial velocity is
 * zero, that is u = 0 on a mesh that stays and u = -V' R D p/2 on the wall as it moves.
 *
 * Without viscosity, with lambda = omega/k, the mean over the section of 1/(lambda - V)^2 is
 * rho (D lambda'/(lambda - V_wall) + 1/K), where lambda' is lambda on a mesh that stays and lambda
 * - V_wall on a moving wall. Both agree where the liquid does not slip. A plug flow has on the
 * moving wall c +- U, and on the mesh that stays lambda (lambda - U) = c^2 for an incompressible
 * liquid; Poiseuille's flow has U +- sqrt(U^2 + c^2) on both.
 */
class StreamWaves
{
public:
  enum class Direction
  {
    with_stream,
    against_stream
  };
  using Wall = StreamWall;

  /// `radius` [m], `density` [kg/m^3], `viscosity` [Pa s], `inverse_bulk_modulus` [1/Pa].
  /// Throws std::invalid_argument for values that are not.
  StreamWaves(const Stream &stream,
              double radius,
              double density,
              double viscosity,
              double inverse_bulk_modulus);

  /// Speed [m/s] of a long wave without viscosity, in a tube of this distensibility [1/Pa];
  /// positive with the stream, negative against it. Throws std::domain_error if the stream is so
  /// fast that no wave runs against it.
  double long_wave_speed(double distensibility, Direction direction, Wall wall) const;

  /// Wave number k [1/m] of a wave of frequency omega > 0 [1/s] in the viscous liquid; Re k < 0
  /// against the stream. A plug flow slips, and knows no viscosity. `distensibility` is that at
  /// the frequency. Throws std::domain_error as above, and if the iteration does not converge.
  Complex wave_number(double omega, Complex distensibility, Direction direction, Wall wall) const;

private:
  Stream stream;
  double radius, density, viscosity, inverse_bulk_modulus;

  /// The mean over the section of 1/(speed - V)^2 [s^2/m^2].
  double mean_inverse_square(double speed) const;
  /// The speeds of a plug flow, of which the distensibility may be complex [m/s].
  Complex plug_speed(Complex distensibility, Direction direction, Wall wall) const;

  /// Chebyshev's points s and what belongs to them, for a number of intervals.
  struct Collocation
  {
    explicit Collocation(unsigned int n_intervals);

    std::vector<double> points; ///< from s = 1 to s = 0
    ComplexMatrix diffusion;    ///< d/ds (s d/ds)
    ComplexMatrix integral;     ///< from s = 0
  };
  /// What unit pressure moves into the wall less what the wall takes; zero for a wave [1/(Pa s)].
  Complex excess(const Collocation &collocation,
                 double omega,
                 Complex wave_number,
                 Complex distensibility,
                 Wall wall) const;
};
} // namespace Continua

#endif
