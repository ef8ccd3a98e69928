#ifndef continua_continuum_nonlinear_terms_h
#define continua_continuum_nonlinear_terms_h

namespace Continua
{
/// The powers that the forces of nonlinear terms have with a given velocity, by kind; this rank's
/// part [W]. Where the terms are corrections (see NonlinearSystem::has_all_terms()), the inertia
/// is that of a density that is not that of the material, the viscosity that of a viscosity that is
/// not that at rest, and there is no compression.
struct NonlinearPowers
{
  double inertia = 0.;
  double convection = 0.;    ///< with the skew form's part
  double stabilisation = 0.; ///< of grad-div and supg
  double viscosity = 0.;
  double inflow = 0.;      ///< at open ends that have the total pressure
  double strain = 0.;      ///< in finite deformation: of the law's stress
  double compression = 0.; ///< of the pressure
  double load = 0.;        ///< minus that of loads that follow the present shape, of cavities too
};

/// A kind of force, by its power; null: no force.
using PowerKind = double NonlinearPowers::*;

/// Which terms: a step with explicit convection takes those that carry at another velocity than the
/// rest.
enum class TermsTaken
{
  all,
  carrying, ///< convection and inflow
  not_carrying
};

/// Whether terms of that kind are among them.
inline bool takes_terms_of(const TermsTaken taken, const PowerKind kind)
{
  const bool carries = kind == &NonlinearPowers::convection || kind == &NonlinearPowers::inflow;
  return taken == TermsTaken::all || carries == (taken == TermsTaken::carrying);
}

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
