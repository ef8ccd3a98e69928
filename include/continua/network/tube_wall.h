#ifndef continua_network_tube_wall_h
#define continua_network_tube_wall_h

#include <continua/network/vessel.h>
#include <continua/theory/korteweg.h>
#include <continua/theory/tube_section.h>

#include <functional>
#include <memory>
#include <string>

namespace Continua
{
/**
 * The wall of a vessel, by the section of a tube that linear wave theory takes. Without laws of
 * finite deformation it is a SquareRootWall with Korteweg's speed of long waves in that section,
 * held along its axis or free, with what is around it. With such laws it is held, and exact: a
 * NeoHookeanWall, or a TabulatedWall of LoadedTube or
 * SaintVenantKirchhoffTube.
 */
class TubeWall
{
public:
  /// `theory`: of a wall of small strain, as Korteweg's. Throws std::domain_error with the reason,
  /// a predicate of the tube ("has ..."), if vessels have no such wall.
  TubeWall(const TubeSection &section, WallTheory theory);

  /// How it relaxes, relative to the stiffness of the wall law.
  const WallRelaxation &relaxation() const { return relaxing; }
  /// rho c^2 of long waves without load, all branches relaxed [Pa].
  double density_times_speed_squared() const;
  /// Mean stress around the tube over the section of the wall [Pa], at the pressure of the wall
  /// [Pa] and the inner radius [m]. In finite deformation the section is taken to keep its area, as
  /// an incompressible wall does. Beside a support the wall bears the share of the pressure that it
  /// has when all branches are relaxed, at all times.
  double hoop_stress(double pressure, double inner_radius) const;

  /// A vessel whose section at z [m] is `section(z)`, all of the law of `section(0)`. Without
  /// strain it has the pressure `shift` [Pa].
  static std::unique_ptr<Vessel> make(const VesselDescription &description,
                                      const FlowLaw &flow_law,
                                      const std::function<TubeSection(double)> &section,
                                      WallTheory theory,
                                      double shift);

private:
  TubeSection section;
  WallTheory theory;
  WallRelaxation relaxing;
  double wall_share = 1.; ///< of the pressure that the wall itself bears, beside what is around it

  bool is_finite() const { return section.layers.front().strain_law != nullptr; }
  bool is_neo_hookean() const;
  void check_finite() const;
  void set_relaxation();
};
} // namespace Continua

#endif
