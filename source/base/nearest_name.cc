#include <continua/base/nearest_name.h>

#include <algorithm>
#include <cctype>

namespace Continua
{
namespace
{
std::string lower_case(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](const unsigned char letter)
                 { return static_cast<char>(std::tolower(letter)); });
  return text;
}

/// The number of insertions, deletions, replacements and swaps of neighbours that turn `a` into
/// `b`.
std::size_t edit_distance(const std::string &a, const std::string &b)
{
  // distance[i][j] belongs to the first i letters of a and the first j of b
  std::vector<std::vector<std::size_t>> distance(a.size() + 1,
                                                 std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j)
      if (i == 0 || j == 0)
        distance[i][j] = i + j;
      else
      {
        const std::size_t replaced = distance[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
        distance[i][j] = std::min({distance[i - 1][j] + 1, distance[i][j - 1] + 1, replaced});
        if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
          distance[i][j] = std::min(distance[i][j], distance[i - 2][j - 2] + 1);
      }
  return distance[a.size()][b.size()];
}
} // namespace

std::string nearest_name(const std::string &name, const std::vector<std::string> &candidates)
{
  // Nobody means a name of such a length, and the distance takes the product of both.
  constexpr std::size_t longest_name = 200;
  if (name.size() > longest_name)
    return "";
  const std::string typed = lower_case(name);
  std::string nearest;
  std::size_t least = std::string::npos;
  for (const std::string &candidate : candidates)
  {
    const std::size_t distance = edit_distance(typed, lower_case(candidate));
    const std::size_t length = std::max(name.size(), candidate.size());
    if (distance <= (length + 2) / 3 && distance < length && distance < least)
    {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}
} // namespace Continua
