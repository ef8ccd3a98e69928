#ifndef continua_materials_flow_curve_h
#define continua_materials_flow_curve_h

namespace Continua
{
/**
 * The viscosity of a liquid over the rate of shear g = sqrt(2 dev D : dev D), D = sym grad U:
 *
 *   eta(g) = eta_inf + (eta_0 - eta_inf) (1 + (lambda g)^a)^((n - 1)/a)
 *
 * (Carreau 1972; with a of Yasuda, Armstrong and Cohen, Rheol. Acta 20 (1981) 163; a = 2 is
 * Carreau's own).
 */
struct FlowCurve
{
  double zero_rate_viscosity = 0.;     ///< eta_0 [Pa s]
  double infinite_rate_viscosity = 0.; ///< eta_inf [Pa s]
  double time = 0.;                    ///< lambda [s]
  double index = 1.;                   ///< n [1]
  double yasuda_exponent = 2.;         ///< a [1]

  /// eta(g) [Pa s].
  double viscosity(double rate) const;
  /// (d eta/d g)/g, which the tangent has [Pa s^3]; 0 at g = 0, where it stands beside g^2.
  double slope_over_rate(double rate) const;
};
} // namespace Continua

#endif
