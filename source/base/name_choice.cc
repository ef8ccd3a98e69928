#include <continua/base/name_choice.h>

#include <continua/base/joined.h>
#include <continua/base/nearest_name.h>
#include <continua/base/parameter_text.h>
#include <continua/base/quoted_name.h>

#include <algorithm>

namespace Continua
{
std::string choices(const std::string &name, const std::vector<std::string> &candidates)
{
  // As a list of names has to be written.
  std::vector<std::string> written;
  for (const std::string &candidate : candidates)
    written.push_back(quoted_name(candidate, "#,"));
  const std::string near = nearest_name(name, candidates);
  return (near.empty() ? "" : "Did you mean '" + quoted_name(near, "#,") + "'? ") +
         "There are: " + (written.empty() ? "none" : joined(written));
}

unsigned int find_name(const ParameterSection &section,
                       const std::string &key,
                       const std::string &name,
                       const std::vector<std::string> &names,
                       const std::string &problem)
{
  auto place = std::find(names.begin(), names.end(), name);
  // Where one name is the whole text of an entry, quotes and blanks are still as written.
  if (place == names.end())
    place = std::find(names.begin(), names.end(), without_quotes(collapse_blanks(name)));
  if (place == names.end())
    section.refuse(key, problem + name + "'", choices(name, names));
  return static_cast<unsigned int>(place - names.begin());
}
} // namespace Continua
