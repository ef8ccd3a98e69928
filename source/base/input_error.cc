#include <continua/base/input_error.h>

namespace Continua
{
namespace
{
/// Ends a sentence that has no end yet.
std::string sentence(const std::string &text)
{
  if (text.empty() || text.back() == '.' || text.back() == '?' || text.back() == '!')
    return text;
  return text + ".";
}

std::string compose(const Origin &origin,
                    const std::string &key,
                    const std::string &problem,
                    const std::string &remedy)
{
  std::string text;
  if (!origin.file.empty())
    text += origin.file + (origin.line > 0 ? ":" + std::to_string(origin.line) : "") + ": ";
  if (!key.empty())
    text += "'" + key + "': ";
  text += sentence(problem);
  if (!problem.empty() && !remedy.empty())
    text += " ";
  return text + sentence(remedy);
}
} // namespace

InputError::InputError(const Origin &origin,
                       const std::string &key,
                       const std::string &problem,
                       const std::string &remedy)
    : std::runtime_error(compose(origin, key, problem, remedy))
{
}
} // namespace Continua
