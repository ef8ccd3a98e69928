#ifndef continua_theory_wave_mode_h
#define continua_theory_wave_mode_h

#include <array>
#include <complex>

namespace Continua
{
/**
 * A harmonic axisymmetric wave exp(i(omega t - k z)) in a tube: its wave number, and what it does
 * at unit amplitude. The wave that runs or decays the other way has -k; quantities that are even
 * under a reflection of z are then the same, the odd ones change their sign.
 */
struct WaveMode
{
  using Complex = std::complex<double>;

  Complex wave_number;       ///< k [1/m]; Im k < 0 decays towards z > 0
  Complex section_pressure;  ///< mean of p over the liquid's section [Pa]; even
  Complex axis_pressure;     ///< [Pa]; even
  Complex wall_shear_stress; ///< of the liquid on the wall, sigma_rz at the inner wall [Pa]; odd
  Complex wall_displacement; ///< u_r of the inner wall [m]; even
  Complex hoop_stress;       ///< sigma_theta, mean over the wall's section [Pa]; even

  /// What joins two tubes, or a tube and its end.
  enum Junction
  {
    traction,            ///< -sigma_zz, mean over the liquid's section [Pa]; even
    flow_rate,           ///< [m^3/s]; odd
    radial_displacement, ///< mean over the wall's section [m]; even
    axial_displacement,  ///< the same [m]; odd
    rotation,            ///< of the wall's section, the slope of u_z over r [1]; odd
    axial_force,         ///< of the wall [N]; even
    bending_moment,      ///< of the wall's axial stress about its middle [N m]; even
    shear_force,         ///< of the wall, the integral of sigma_rz [N]; odd
    n_junction_quantities
  };
  std::array<Complex, n_junction_quantities> junction;

  /// All these numbers in one order, for what is linear in them: interpolation.
  static constexpr unsigned int n_numbers = 6 + n_junction_quantities;
  std::array<Complex, n_numbers> numbers() const
  {
    std::array<Complex, n_numbers> list = {{wave_number, section_pressure, axis_pressure,
                                            wall_shear_stress, wall_displacement, hoop_stress}};
    for (unsigned int i = 0; i < n_junction_quantities; ++i)
      list[6 + i] = junction[i];
    return list;
  }
  static WaveMode from_numbers(const std::array<Complex, n_numbers> &list)
  {
    WaveMode mode{list[0], list[1], list[2], list[3], list[4], list[5], {}};
    for (unsigned int i = 0; i < n_junction_quantities; ++i)
      mode.junction[i] = list[6 + i];
    return mode;
  }

  /// 1 for the even and -1 for the odd quantities of a junction.
  static constexpr std::array<double, n_junction_quantities> parity = {
      {1., -1., 1., -1., -1., 1., 1., -1.}};
};
} // namespace Continua

#endif
