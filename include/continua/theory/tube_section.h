#ifndef continua_theory_tube_section_h
#define continua_theory_tube_section_h

#include <continua/materials/material.h>

#include <vector>

namespace Continua
{
/// The cross-section of a tube full of liquid, as wave theory sees it: what carries a harmonic
/// wave.
struct TubeSection
{
  double inner_radius = 0.01; ///< R [m]
  double mean_pressure = 0.;  ///< of the loaded state whose radius and wall these are [Pa]
  Material fluid;
  std::vector<double>
      layer_thicknesses;        ///< from the inner to the outer layer [m]; empty: rigid wall
  std::vector<Material> layers; ///< as many
  bool tethered = false;        ///< the outer surface is held axially
  // What is around pushes the outer surface back, of moduli [Pa/m] and [Pa s/m]; else it is free.
  double radial_stiffness = 0., radial_damping = 0.;
  double axial_stiffness = 0., axial_damping = 0.; ///< not where it is tethered

  /// Traction of the surroundings over minus the displacement of the outer surface [Pa/m].
  std::complex<double> radial_support(const std::complex<double> &omega) const;
  std::complex<double> axial_support(const std::complex<double> &omega) const;
  // Of a rigid wall all of the following are zero.
  double wall_thickness() const; ///< h [m]
  double wall_area() const;      ///< of the wall's section [m^2]
  /// sum Y_i(omega) h_i / h: Young's modulus of the wall as a membrane [Pa].
  std::complex<double> membrane_modulus(const std::complex<double> &omega) const;
  /// Young's modulus of a membrane that gives way to a pressure inside as the wall, as a membrane,
  /// and the surroundings do together [Pa]. Where they push back along the axis, too, that is left
  /// out.
  std::complex<double> hoop_modulus(const std::complex<double> &omega) const;
  /// sum rho_i h_i / h [kg/m^3].
  double wall_density() const;
  /// Poisson's ratio of the layers at that frequency, weighted as the modulus.
  std::complex<double> poisson_ratio(const std::complex<double> &omega) const;
};

/// Whether waves are the same in both: in geometry, materials and hold.
bool operator==(const TubeSection &a, const TubeSection &b);
} // namespace Continua

#endif
