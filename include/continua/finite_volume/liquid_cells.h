#ifndef continua_finite_volume_liquid_cells_h
#define continua_finite_volume_liquid_cells_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/continuum/problem.h>
#include <continua/finite_volume/cell_wise_space.h>

namespace Continua
{
/// Throws StepFailure where the volume exponent of a liquid leaves a bulk modulus that is not
/// positive at this pressure [Pa]. Collective.
template <int dim>
void refuse_soft_liquids(const CellWiseSpace<dim> &space,
                         const Problem &problem,
                         const DistributedVector &pressure);

/// This rank's part of the energies of a region of liquid, with the density that follows the
/// pressure, from velocity [m/s] and pressure [Pa].
template <int dim>
NonlinearEnergy energy_of_liquid(const CellWiseSpace<dim> &space,
                                 const Problem &problem,
                                 unsigned int region,
                                 const DistributedVector &velocity,
                                 const DistributedVector &pressure);
} // namespace Continua

#endif
