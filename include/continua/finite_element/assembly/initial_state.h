#ifndef continua_finite_element_assembly_initial_state_h
#define continua_finite_element_assembly_initial_state_h

#include <continua/base/log.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/space/space.h>

#include <vector>

namespace Continua
{
/**
 * The pressure in equilibrium with a displacement: sum M_p p / K = - B D, by conjugate gradients; 0
 * where nothing compressible determines it [Pa].
 */
template <int dim>
void solve_equilibrium_pressure(const Space<dim> &space,
                                const Problem &problem,
                                const std::vector<RegionOperators> &operators,
                                const DistributedVector &displacement,
                                DistributedVector &pressure);

/**
 * Sets velocity [m/s], displacement [m] and pressure [Pa] at t = 0 from the problem's interior data
 * (at the nodes). A displacement without a pressure gets the one in equilibrium with it; one with a
 * pressure that contradicts it in a solid by more than 5 % is warned of.
 */
template <int dim>
void set_initial_state(const Space<dim> &space,
                       const Problem &problem,
                       const std::vector<RegionOperators> &operators,
                       Log &log,
                       DistributedVector &velocity,
                       DistributedVector &displacement,
                       DistributedVector &pressure);
} // namespace Continua

#endif
