#ifndef continua_finite_volume_cell_wise_checks_h
#define continua_finite_volume_cell_wise_checks_h

#include <continua/base/parameter_section.h>
#include <continua/continuum/problem.h>
#include <continua/finite_volume/cell_wise_parameters.h>

namespace Continua
{
/// Refuses what no rule between features covers (see Rule): entries and boundaries that the
/// cell-wise discretisation cannot take as they are. `problem` has no outlets yet. `steady`:
/// whether there are no steps in time, but a state at rest or modes. Throws InputError.
void check_cell_wise(const Problem &problem,
                     const CellWiseParameters &parameters,
                     bool steady,
                     ParameterSection root);
} // namespace Continua

#endif
