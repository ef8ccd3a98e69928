#ifndef continua_finite_element_solvers_iterative_pressure_places_h
#define continua_finite_element_solvers_iterative_pressure_places_h

#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/schur_complement.h>

namespace Continua
{
/// Coordinates of the owned pressures, one vector for each direction [m]. Where pressures are
/// broken at interfaces, those of each region are shifted away from those of the others.
/// Collective.
template <int dim>
SchurComplement::Places places_of_pressures(const Space<dim> &space, unsigned int n_regions);
} // namespace Continua

#endif
