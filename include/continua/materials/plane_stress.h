#ifndef continua_materials_plane_stress_h
#define continua_materials_plane_stress_h

#include <continua/base/parameter_section.h>

namespace Continua
{
/// What the kinematics of plane stress make of a region, which is Hookean with Poisson's ratio nu.
/// The defaults belong to every other model.
struct PlaneStressFactors
{
  /// Mean pressure over the unknown p: (1+nu)/(1+2nu), since p is an auxiliary.
  double pressure_factor = 1.;
  /// eps_zz over eps_xx + eps_yy: -nu/(1-nu); not used in other models.
  double thickness_strain_factor = 0.;
};

/// Reads Poisson's ratio once more in a child of the section Materials, after read_material().
PlaneStressFactors read_plane_stress_factors(ParameterSection section);
} // namespace Continua

#endif
