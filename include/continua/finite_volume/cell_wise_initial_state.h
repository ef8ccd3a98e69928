#ifndef continua_finite_volume_cell_wise_initial_state_h
#define continua_finite_volume_cell_wise_initial_state_h

#include <continua/continuum/problem.h>
#include <continua/finite_volume/cell_wise_space.h>
#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
/// Sets what the problem's interior data give of velocity [m/s], displacement [m] and the unknown
/// pressure [Pa] at t = 0, every value at its place: a cell's centre, a face's centre. What is not
/// given stays.
template <int dim>
void set_initial_values(const CellWiseSpace<dim> &space,
                        const Problem &problem,
                        DistributedVector &velocity,
                        DistributedVector &displacement,
                        DistributedVector &pressure);
} // namespace Continua

#endif
