#include <continua/base/formula_text.h>

#include <cctype>
#include <stdexcept>
#include <vector>

namespace Continua
{
namespace
{
constexpr std::size_t longest_formula = 20000;
constexpr unsigned int deepest_brackets = 100;

bool assigns(const std::string &text)
{
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '=')
    {
      if (i + 1 < text.size() && text[i + 1] == '=')
        ++i;
      else if (i == 0 || std::string("<>!").find(text[i - 1]) == std::string::npos)
        return true;
    }
  return false;
}

/// Whether the comparisons of a formula follow each other, as in a < t < b, without && or brackets
/// between them.
bool chains_comparisons(const std::string &text)
{
  // By depth of the brackets: comparisons since the last separator.
  std::vector<unsigned int> n_comparisons(1, 0);
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const char letter = text[i], next = i + 1 < text.size() ? text[i + 1] : ' ';
    if (letter == '(')
      n_comparisons.push_back(0);
    else if (letter == ')' && n_comparisons.size() > 1)
      n_comparisons.pop_back();
    else if (std::string(",?:&|").find(letter) != std::string::npos)
      n_comparisons.back() = 0;
    else if (letter == '<' || letter == '>' || ((letter == '=' || letter == '!') && next == '='))
    {
      if (++n_comparisons.back() > 1)
        return true;
      if (next == '=')
        ++i;
    }
  }
  return false;
}

bool has_word(const std::string &text, const std::string &word)
{
  const auto is_part = [&text](const std::size_t i)
  {
    return i < text.size() &&
           (std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_');
  };
  for (std::size_t i = text.find(word); i != std::string::npos; i = text.find(word, i + 1))
    if ((i == 0 || !is_part(i - 1)) && !is_part(i + word.size()))
      return true;
  return false;
}
} // namespace

void check_formula_text(const std::string &text)
{
  if (text.size() > longest_formula)
    throw std::invalid_argument("the formula has " + std::to_string(text.size()) +
                                " characters, more than " + std::to_string(longest_formula));
  unsigned int depth = 0;
  for (const char letter : text)
  {
    depth += letter == '(' ? 1 : 0;
    depth -= letter == ')' && depth > 0 ? 1 : 0;
    if (depth > deepest_brackets)
      throw std::invalid_argument("the formula has more than " + std::to_string(deepest_brackets) +
                                  " brackets one inside the other");
  }
  if (assigns(text))
    throw std::invalid_argument("'" + text + "' assigns with '='; a comparison is '=='");
  if (chains_comparisons(text))
    throw std::invalid_argument("'" + text +
                                "' compares twice in a row: a < t < b is (a < t) < b, which "
                                "compares 0 or 1 with b. Write a < t && t < b, or brackets");
}

std::string formula_hint(const std::string &text)
{
  if (has_word(text, "if") || has_word(text, "then") || has_word(text, "else"))
    return "; a choice is written if(CONDITION, A, B) or (CONDITION ? A : B)";
  return "";
}
} // namespace Continua
