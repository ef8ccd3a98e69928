#ifndef continua_network_flow_law_h
#define continua_network_flow_law_h

#include <cmath>

namespace Continua
{
/**
 * The liquid in a vessel, and how its velocity varies over the section: u(r) = U (zeta + 2)/zeta (1
 * - (r/R)^zeta) with the mean velocity U and the exponent zeta (2: Poiseuille, 9: nearly flat; T.
 * J. R. Hughes, J. Lubliner, Math. Biosci. 18 (1973) 161; N. P. Smith, A. J. Pullan, P. J. Hunter,
 * SIAM J. Appl. Math. 62 (2002) 990). Its wall shear stress gives the friction per length, and its
 * momentum the factor alpha = (zeta + 2)/(zeta + 1), for which many programs take 1.
 */
struct FlowLaw
{
  double density = 1060.;          ///< rho [kg/m^3]
  double viscosity = 0.004;        ///< mu [Pa s]
  double profile_exponent = 2.;    ///< zeta [1], positive
  double momentum_correction = 1.; ///< alpha [1], at least 1
  bool remembers = false;          ///< the friction is Womersley's (friction_memory.h)
  double gravity = 9.81;           ///< [m/s^2], downwards

  static constexpr double pi = 3.14159265358979323846;

  /// The factor of -Q/A in the equation of momentum, 2 pi (zeta + 2) mu/rho [m^2/s].
  double friction() const { return 2. * pi * (profile_exponent + 2.) * viscosity / density; }
  /// The difference between the two wave speeds over two [m/s], for A dp/dA = rho c^2 [Pa] and U
  /// [m/s]: the waves run with alpha U - speed and alpha U + speed.
  double relative_speed(const double density_times_speed_squared, const double velocity) const
  {
    return std::sqrt(density_times_speed_squared / density +
                     momentum_correction * (momentum_correction - 1.) * velocity * velocity);
  }
};
} // namespace Continua

#endif
