#ifndef continua_mesh_list_entries_h
#define continua_mesh_list_entries_h

#include <continua/base/parameter_section.h>

#include <string>
#include <vector>

namespace Continua
{
/// Throws InputError unless the list of entry `key` has `n_wanted` members; `what` tells what they
/// are: "one for each of x, y".
void check_number_of_entries(const ParameterSection &section,
                             const std::string &key,
                             std::size_t n_entries,
                             std::size_t n_wanted,
                             const std::string &what);

/// "one for each of x, y" or "one for each of x, y, z".
std::string one_for_each_direction(unsigned int dim);
} // namespace Continua

#endif
