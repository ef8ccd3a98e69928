#ifndef continua_boundary_boundary_conditions_h
#define continua_boundary_boundary_conditions_h

#include <continua/base/parameter_file.h>
#include <continua/base/parameter_section.h>
#include <continua/boundary/boundary_condition.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * The names of the boundaries along which the section Boundaries prescribes the velocity (Type =
 * fixed, velocity, or flow rate with a profile, Tangential = fixed, Coupling = flow), for a
 * geometry, which is made before the conditions can be read. Declares and refuses nothing.
 */
std::set<std::string> boundaries_held_across(const ParameterFile &file);

/// Whether the mesh of some boundary follows a prescribed motion (Mesh = follows). Declares and
/// refuses nothing.
bool some_mesh_follows(const ParameterFile &file);

/**
 * Reads the section Boundaries: one child for each boundary, named after it; or a child of any name
 * with `Boundary` and `Region`. `pairs` are the (boundary, region) pairs that the mesh has: each
 * must get exactly one condition. Throws InputError.
 */
std::vector<BoundaryCondition>
read_boundary_conditions(ParameterSection section,
                         const std::vector<std::string> &boundaries,
                         const std::vector<std::string> &regions,
                         const std::set<std::pair<unsigned int, unsigned int>> &pairs,
                         unsigned int n_dimensions,
                         bool axisymmetric);
} // namespace Continua

#endif
