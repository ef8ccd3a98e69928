#ifndef continua_mesh_clamped_end_h
#define continua_mesh_clamped_end_h

#include <continua/base/parameter_section.h>

#include <string>

namespace Continua
{
/**
 * Declares and reads `Axial grading` of the section Mesh: the length of the first cell at an end
 * where a vessel's wall is clamped, over that of the equal cells elsewhere. `boundaries`: the names
 * of such ends, for the text. Throws InputError.
 */
void add_axial_grading(ParameterSection mesh, double &grading, const std::string &boundaries);

/// The length [m] of that cell: `grading` times `equal_cell` [m], or, if it is 0, half of sqrt(R
/// h), since a clamped wall bends over about that length.
double
clamped_end_cell(double grading, double equal_cell, double inner_radius, double wall_thickness);
} // namespace Continua

#endif
