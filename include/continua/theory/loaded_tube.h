#ifndef continua_theory_loaded_tube_h
#define continua_theory_loaded_tube_h

#include <continua/theory/korteweg.h>
#include <continua/theory/tube_section.h>

#include <vector>

namespace Continua
{
/**
 * A tube in finite deformation under an even pressure inside, and the long waves about this state.
 * The layers are incompressible and have hyperelastic laws. The axis is held at the length of the
 * mesh, in which the wall may have a prestretch. Nothing presses on the outer surface.
 *
 * With the radii R of the mesh and J0 = det F0 of the prestretch, each layer has r^2 = r_i^2 + J0
 * (R^2 - R_i^2) and the balance of forces gives the pressure p(a) of the inner radius a, the
 * integral of (tau_around - tau_across)/r over the wall (G. A. Holzapfel, T. C. Gasser, R. W.
 * Ogden, J. Elasticity 61 (2000) 1, section 4). A long wave of a liquid of density rho has the
 * speed 1/sqrt(rho D), D = (1/A) dA/dp = 2/(a dp/da) (J. C. Bramwell, A. V. Hill, Proc. R. Soc. B
 * 93 (1922) 298).
 */
class LoadedTube
{
public:
  /// `section` has the radius and the thicknesses of the mesh. Each layer is incompressible and has
  /// a strain law. Throws std::invalid_argument if that is not so.
  explicit LoadedTube(const TubeSection &section);
  /// The tube that has the radius and the thicknesses of `section` under `pressure` [Pa], as an
  /// image shows it. Throws as the constructor does, and std::domain_error if there is none.
  static LoadedTube of_image(const TubeSection &section, double pressure);

  /// Radii and thicknesses of the mesh: without load, and with opening angles of the opened ring.
  const TubeSection &section() const { return mesh; }
  /// [Pa], at the inner radius a > 0 [m]; all branches are relaxed.
  double pressure(double inner_radius) const;
  /// Pressure and axial force at the inner radius a > 0 [m]; all branches are relaxed.
  struct Loads
  {
    double pressure;    ///< [Pa]
    double axial_force; ///< F of the wall less the pressure on the closed end, N - pi a^2 p [N]
  };
  /// Both at once. The force, which a transducer at the closed end of a tube shows, is the integral
  /// of pi (2 sigma_along - sigma_around - sigma_across) r over the wall.
  Loads loads(double inner_radius) const;
  /// dp/da [Pa/m], all branches relaxed.
  double stiffness(double inner_radius) const;
  /// a [m] under that pressure, on the way up from a pressure below it. Throws std::domain_error if
  /// the tube has a largest pressure below this one, or no balance at a small radius.
  double inner_radius(double pressure) const;
  /// The same, found faster from a radius that is near.
  double inner_radius(double pressure, double start) const;
  /// [m].
  double outer_radius(double inner_radius) const;
  /// D [1/Pa] of slow waves.
  double distensibility(double inner_radius) const;
  /**
   * The wall about the state at this pressure [Pa], as wave theory takes it: one incompressible
   * layer that is held along its axis, of a theory of thin walls (that of long waves) or of thick
   * ones (the exact one). It has the present radius and
   * thickness, and the modulus with which it yields as the wall does. Branches and viscosities of
   * the layers become those of the one layer. Throws std::domain_error as inner_radius() does.
   */
  TubeSection section_about(double pressure, WallTheory wall_theory = WallTheory::thin) const;

private:
  /// At a point of a layer.
  struct WallPoint
  {
    double radius;      ///< r [m]
    PointStrain strain; ///< axis 0 along, 1 around, 2 across the wall
  };

  TubeSection mesh;
  std::vector<std::vector<dealii::Tensor<1, 3>>> fibres; ///< of the layers

  /// Of function(layer, point)/r over the present wall, from the inner to the outer radius; the
  /// function has the type Value.
  template <typename Value = double, typename Rule, typename Function>
  Value integral(double inner_radius, const Rule &rule, const Function &function) const;
};
} // namespace Continua

#endif
