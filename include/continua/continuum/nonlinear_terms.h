#ifndef continua_continuum_nonlinear_terms_h
#define continua_continuum_nonlinear_terms_h

#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
/// Forces of the terms that are not linear, by kind [N]. Where the terms are corrections (see
/// Operators::has_whole_terms()), the inertia is that of a density that is not that of the
/// material, the viscosity that of a viscosity that is not that at rest, and there is no
/// compression.
struct NonlinearForces
{
  DistributedVector inertia;
  DistributedVector convection;    ///< with the skew form's part
  DistributedVector stabilisation; ///< of grad-div and supg
  DistributedVector viscosity;
  DistributedVector inflow;      ///< at open ends that have the total pressure
  DistributedVector strain;      ///< in finite deformation: of the law's stress
  DistributedVector compression; ///< of the pressure
  DistributedVector load;        ///< minus the loads that follow the present shape, of cavities too
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
