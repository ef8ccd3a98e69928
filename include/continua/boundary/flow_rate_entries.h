#ifndef continua_boundary_flow_rate_entries_h
#define continua_boundary_flow_rate_entries_h

#include <continua/base/parameter_section.h>
#include <continua/boundary/boundary_condition.h>

namespace Continua
{
/// The entries of Type = flow rate: the waveform, and how the velocity is distributed over the
/// section. `dim`: of the mesh. Throws InputError.
void read_flow_rate(ParameterSection &section, BoundaryCondition &condition, unsigned int dim);
} // namespace Continua

#endif
