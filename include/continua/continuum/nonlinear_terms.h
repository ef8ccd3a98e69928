#ifndef continua_continuum_nonlinear_terms_h
#define continua_continuum_nonlinear_terms_h

#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
/// Forces of the terms that are not linear, by kind [N].
struct NonlinearForces
{
  DistributedVector inertia;       ///< of a density that is not that of the material, or of a
                                   ///< prestretch that changes the volume at rest
  DistributedVector convection;    ///< with the skew form's part
  DistributedVector stabilisation; ///< of grad-div and supg
  DistributedVector viscosity;     ///< of a viscosity that is not that at rest; in finite
                                   ///< deformation of the whole viscosity
  DistributedVector inflow;        ///< at open ends that have the total pressure
  DistributedVector strain;        ///< in finite deformation: of the law's stress
  DistributedVector compression;   ///< in finite deformation: of the pressure
};

/// Energies of a region whose density and compressibility follow the pressure, or in finite
/// deformation [J].
struct NonlinearEnergy
{
  double kinetic = 0.;     ///< int rho(p)/2 U^2
  double compressive = 0.; ///< of VolumeLaw::energy(); in finite deformation of the volume
  double strain = 0.;      ///< in finite deformation: of the law
};
} // namespace Continua

#endif
