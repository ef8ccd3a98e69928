#ifndef continua_postprocess_name_choice_h
#define continua_postprocess_name_choice_h

#include <continua/base/parameter_section.h>

#include <string>
#include <vector>

namespace Continua
{
/// "Did you mean 'tip'? There are: tip, root", for messages about a name that does not exist.
std::string choices(const std::string &name, const std::vector<std::string> &candidates);

/// The number of a region's or boundary's name; refuses one that the mesh does not have.
unsigned int find_name(const ParameterSection &section,
                       const std::string &key,
                       const std::string &name,
                       const std::vector<std::string> &names);
} // namespace Continua

#endif
