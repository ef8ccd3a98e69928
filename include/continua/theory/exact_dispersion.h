#ifndef continua_theory_exact_dispersion_h
#define continua_theory_exact_dispersion_h

#include <continua/theory/ball.h>
#include <continua/theory/tube_section.h>
#include <continua/theory/wave_mode.h>

#include <array>
#include <memory>
#include <vector>

namespace Continua
{
/**
 * Harmonic axisymmetric waves in a viscous, compressible liquid inside a thick wall of one or more
 * (visco)elastic layers, without an approximation but linearity.
 *
 * Liquid and wall are the same continuum: in harmonic motion each is an isotropic body of density
 * rho, bulk modulus K and complex shear modulus mu(omega), which is i omega eta in the liquid. Its
 * displacement is grad phi + curl(psi e_theta), with phi = Z0(q_l r), psi = Z1(q_s r), times
 * exp(i(omega t - k z)), q_l^2 = rho omega^2/(K + 4 mu/3) - k^2, q_s^2 = rho omega^2/mu - k^2
 * (Pochhammer and Chree's solution for a rod, layer by layer): J on the axis, J and Y in each
 * layer. Displacement and the stresses sigma_rr, sigma_rz are continuous at each interface; outside
 * the surface is free of stress, or pushed back by what is around, sigma_rr = -k_r u_r and sigma_rz
 * = -k_z u_z, or held axially, or a rigid wall stands in place of all layers. A
 * wave exists where the determinant of these conditions is zero. It is computed with balls of as
 * many bits as make it certain: a thin wall's conditions nearly depend on each other.
 */
class ExactDispersion
{
public:
  using Complex = std::complex<double>;

  /// The waves that matter beside each other in a tube. Those of higher order die out within a
  /// fraction of the diameter.
  enum Family
  {
    pressure_wave, ///< mode I, Young's wave
    axial_wave,    ///< mode II, the wall's; not where the wall is tethered or rigid
    bending_wave,  ///< two evanescent ones, of the length sqrt(R h); not where the wall is rigid
    other_bending_wave,
    n_families
  };

  explicit ExactDispersion(const TubeSection &section);

  /// Which of them this section has.
  const std::vector<Family> &families() const { return present; }

  /// A first guess of the wave number [1/m]: of the pressure and axial waves the two roots of the
  /// long-wave theory of a viscous liquid in a membrane (Atabek and Lew 1966), the first one slower
  /// by what a thick wall's inner surface gives way more (Lame), of the bending waves those of a
  /// shell in vacuo. `omega` [1/s], complex: Im omega <= 0.
  Complex guess(Family family, const Complex &omega) const;

  /// The root near `start` [1/m]; false if the iteration (Muller's) does not converge.
  bool find_root(const Complex &omega, const Complex &start, Complex &wave_number) const;

  /// d omega/d Re k [m/s] along the curve of a root: the difference of the roots beside it, at
  /// angular frequencies that differ by a part of 1e-4; NaN if one is not found.
  double group_speed(const Complex &omega, const Complex &wave_number) const;

  /// The determinant, up to a factor without zeros, certain to 32 bits.
  Ball determinant(const Complex &omega, const Complex &wave_number) const;

  /// The wave of that root. Unit amplitude is 1 m of the liquid's mean axial displacement (pressure
  /// wave), of the wall's axial displacement (axial wave) or radial one (bending waves).
  WaveMode mode(Family family, const Complex &omega, const Complex &wave_number) const;

private:
  /// Displacements and stresses u_r, u_z, sigma_rr, sigma_rz (and sigma_zz, sigma_theta) of one of
  /// the four solutions in a layer.
  struct Column
  {
    Ball u_r, u_z, s_rr, s_rz, s_zz, s_tt;
  };
  using Columns = std::vector<Column>;
  /// What does not depend on the radius.
  struct Layer
  {
    Ball lame_term; ///< lambda div u = -lame_term phi
    Ball pressure;  ///< p = pressure phi
    Ball mu, q_l, q_s, k;
  };
  using Matrix = std::vector<std::vector<Ball>>;

  Layer layer(const Material &material, const Complex &omega, const Complex &k) const;
  /// At the inner radius of the wall.
  Columns core_columns(const Layer &fluid, const Ball &radius) const;
  Columns wall_columns(const Layer &wall, const Ball &radius) const;
  static Column column(const Layer &layer,
                       const Ball &radius,
                       const Ball &phi,
                       const Ball &phi_slope,
                       const Ball &psi,
                       const Ball &psi_over_curl);
  Matrix conditions(const Complex &omega, const Complex &k) const;
  /// The determinant with at least `precision` bits, which becomes what was needed.
  Ball determinant(const Complex &omega, const Complex &wave_number, slong &precision) const;
  /// The wave at Ball::precision, and how many bits of its numbers are certain.
  WaveMode uncertain_mode(Family family,
                          const Complex &omega,
                          const Complex &wave_number,
                          slong &certain_bits) const;

  TubeSection section;
  std::vector<double> radii; ///< of the interfaces from the inner wall outwards [m]
  std::vector<Family> present;
};
} // namespace Continua

#endif
