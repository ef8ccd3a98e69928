#ifndef continua_base_name_choice_h
#define continua_base_name_choice_h

#include <continua/base/parameter_section.h>

#include <string>
#include <vector>

namespace Continua
{
/// "Did you mean 'tip'? There are: tip, root", for messages about a name that does not exist.
std::string choices(const std::string &name, const std::vector<std::string> &candidates);

/// The number of a region's or boundary's name; refuses one that the mesh does not have, or, with
/// another beginning of the message, is not there.
unsigned int find_name(const ParameterSection &section,
                       const std::string &key,
                       const std::string &name,
                       const std::vector<std::string> &names,
                       const std::string &problem = "the mesh has no '");
} // namespace Continua

#endif
