#include <continua/base/joined.h>

namespace Continua
{
std::string joined(const std::vector<std::string> &words)
{
  std::string text;
  for (const std::string &word : words)
    text += (text.empty() ? "" : ", ") + word;
  return text;
}
} // namespace Continua
