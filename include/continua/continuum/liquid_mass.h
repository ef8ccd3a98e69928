#ifndef continua_continuum_liquid_mass_h
#define continua_continuum_liquid_mass_h

namespace Continua
{
/// The mass of the liquids on a mesh that moves, in a plane model for each metre of depth.
struct LiquidMass
{
  double present = 0.; ///< int rho dv over the present shape [kg]
  /// -int rho (U - W).n da over their boundary, over time by the formula by which the mesh has its
  /// place from its velocity W [kg].
  double inflow = 0.;
};
} // namespace Continua

#endif
