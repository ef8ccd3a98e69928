#ifndef continua_network_wall_material_h
#define continua_network_wall_material_h

#include <continua/materials/material.h>
#include <continua/network/wall_relaxation.h>

namespace Continua
{
/// What the wall of a vessel takes from a material, the same that linear wave theory takes: the
/// long-term modulus, Poisson's ratio, and how the modulus relaxes beside it.
struct WallMaterial
{
  double youngs_modulus = 0.;  ///< long-term [Pa]
  double poissons_ratio = 0.5; ///< [1]
  WallRelaxation relaxation;

  /// Throws std::domain_error for a liquid, a material without a spring that never relaxes, a power
  /// law, one of finite deformation, and one whose Poisson's ratio depends on time.
  static WallMaterial of(const Material &material);
};
} // namespace Continua

#endif
