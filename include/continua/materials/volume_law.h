#ifndef continua_materials_volume_law_h
#define continua_materials_volume_law_h

namespace Continua
{
/**
 * How the density of a fluid follows its pressure where convection is on:
 *
 *   c(p) = (d rho/dp)/rho = 1/(K + n (p - p0)),     rho = rho0 (1 + n (p - p0)/K)^(1/n)
 *
 * n = 0 is a constant bulk modulus, rho = rho0 exp((p - p0)/K); n = 1 the thesis's equation of
 * state (2.28); n = 7.15 water (Tait). 1/K = 0 is incompressible.
 */
struct VolumeLaw
{
  double inverse_bulk_modulus = 0.; ///< 1/K at p0 [1/Pa]
  double exponent = 0.;             ///< n [1]
  double reference_pressure = 0.;   ///< p0, at which the density is that of the material [Pa]

  /// (K + n (p - p0))/K [1]: not positive where the law has no meaning.
  double stiffening(const double pressure) const
  {
    return 1. + exponent * (pressure - reference_pressure) * inverse_bulk_modulus;
  }
  /// c(p) [1/Pa].
  double compressibility(const double pressure) const
  {
    return inverse_bulk_modulus == 0. ? 0. : inverse_bulk_modulus / stiffening(pressure);
  }
  /// dc/dp = -n c^2 [1/Pa^2].
  double compressibility_slope(const double pressure) const
  {
    const double c = compressibility(pressure);
    return -exponent * c * c;
  }
  /// Energy per volume, 0 at p0: rho int_p0^p q c(q)/rho(q) dq [J/m^3], so that the power of the
  /// pressure is its rate and its flux. About p^2/(2 K).
  double energy(double pressure) const;
  /// rho/rho0 [1].
  double density_ratio(const double pressure) const
  {
    return inverse_bulk_modulus == 0. ? 1. : density_ratio_of_compressible(pressure);
  }

private:
  double density_ratio_of_compressible(double pressure) const;
};
} // namespace Continua

#endif
