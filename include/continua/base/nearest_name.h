#ifndef continua_base_nearest_name_h
#define continua_base_nearest_name_h

#include <string>
#include <vector>

namespace Continua
{
/**
 * The candidate that a user who typed `name` most likely meant, for "Did you mean ...?"; empty if
 * none is near. The measure is the Damerau-Levenshtein distance with adjacent transpositions
 * (optimal string alignment), blind to case; near means that at most about one letter in three
 * differs. Of several equally near ones the first.
 */
std::string nearest_name(const std::string &name, const std::vector<std::string> &candidates);
} // namespace Continua

#endif
