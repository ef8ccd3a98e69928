#ifndef continua_continuum_cavity_state_h
#define continua_continuum_cavity_state_h

namespace Continua
{
/// What a cavity has at a time. Of a body that is modelled in part, the volume is that of the part.
struct CavityState
{
  double pressure = 0.; ///< [Pa]
  double volume = 0.;   ///< [m^3], in the plane of a metre of depth [m^2]
};
} // namespace Continua

#endif
