#ifndef continua_continuum_cavity_state_h
#define continua_continuum_cavity_state_h

namespace Continua
{
/// What a boundary with an unknown pressure has at a time. Of a body that is modelled in part, the
/// volume is that of the part; of a section with a flow rate it is 0.
struct CavityState
{
  double pressure = 0.; ///< [Pa]
  double volume = 0.;   ///< [m^3], in the plane of a metre of depth [m^2]
};
} // namespace Continua

#endif
