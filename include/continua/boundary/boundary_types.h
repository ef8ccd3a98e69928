#ifndef continua_boundary_boundary_types_h
#define continua_boundary_boundary_types_h

#include <continua/base/parameter_section.h>
#include <continua/base/words.h>
#include <continua/boundary/boundary_condition.h>

#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// The types that exist: name and a line of description, for the manual and `Type`.
std::vector<std::pair<std::string, std::string>> boundary_types();
const Words<BoundaryType> &boundary_type_words();

/// Reads the entries of the condition's type, in a space of `dim` dimensions. Throws InputError.
void read_boundary_type(ParameterSection &section, BoundaryCondition &condition, unsigned int dim);
} // namespace Continua

#endif
