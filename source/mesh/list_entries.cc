#include <continua/mesh/list_entries.h>

namespace Continua
{
void check_number_of_entries(const ParameterSection &section,
                             const std::string &key,
                             const std::size_t n_entries,
                             const std::size_t n_wanted,
                             const std::string &what)
{
  if (n_entries != n_wanted)
    section.refuse(key,
                   "the list has " + std::to_string(n_entries) +
                       (n_entries == 1 ? " entry, not " : " entries, not ") +
                       std::to_string(n_wanted),
                   "Give " + std::to_string(n_wanted) + ", " + what);
}

std::string one_for_each_direction(const unsigned int dim)
{
  return dim == 2 ? "one for each of x, y" : "one for each of x, y, z";
}
} // namespace Continua
