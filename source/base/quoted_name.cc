#include <continua/base/parameter_text.h>
#include <continua/base/quoted_name.h>

namespace Continua
{
namespace
{
/// What may stand before a word, beside the beginning of the text.
bool divides(const char letter)
{
  return std::string(" \t,/=:(").find(letter) != std::string::npos;
}

/// The place behind the quotation that begins at `begin`; npos if nothing closes it.
std::size_t end_of_quotation(const std::string &text, const std::size_t begin)
{
  std::size_t quote = text.find('"', begin + 1);
  while (quote != std::string::npos && quote + 1 < text.size() && text[quote + 1] == '"')
    quote = text.find('"', quote + 2);
  return quote == std::string::npos ? quote : quote + 1;
}
} // namespace

std::vector<bool> quoted_letters(const std::string &text)
{
  std::vector<bool> quoted(text.size(), false);
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '"' && (i == 0 || divides(text[i - 1])))
    {
      const std::size_t end = end_of_quotation(text, i);
      if (end == std::string::npos)
        continue;
      for (; i < end; ++i)
        quoted[i] = true;
      --i;
    }
    else if (text[i] == '#')
      break; // the rest of a line is a comment
  return quoted;
}

std::size_t
find_unquoted(const std::string &text, const std::string &letters, const std::size_t begin)
{
  const std::vector<bool> quoted = quoted_letters(text);
  for (std::size_t i = begin; i < text.size(); ++i)
    if (!quoted[i] && letters.find(text[i]) != std::string::npos)
      return i;
  return std::string::npos;
}

std::vector<std::string> split_unquoted(const std::string &text, const char letter)
{
  const std::vector<bool> quoted = quoted_letters(text);
  std::vector<std::string> pieces(1);
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == letter && !quoted[i])
      pieces.emplace_back();
    else
      pieces.back() += text[i];
  return pieces;
}

std::string without_quotes(const std::string &text)
{
  // Nearly every name.
  if (text.find('"') == std::string::npos)
    return text;
  const std::vector<bool> quoted = quoted_letters(text);
  std::string result;
  bool is_inside = false;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (quoted[i] && text[i] == '"')
    {
      if (is_inside && i + 1 < text.size() && quoted[i + 1] && text[i + 1] == '"')
        result += text[++i];
      else
        is_inside = !is_inside;
    }
    else
      result += text[i];
  return result;
}

std::string quoted_name(const std::string &name, const std::string &special)
{
  const bool stands_as_it_is = !name.empty() && name.find_first_of(special) == std::string::npos &&
                               name.back() != '\\' && without_quotes(name) == name &&
                               collapse_blanks(name) == name;
  if (stands_as_it_is)
    return name;
  std::string text = "\"";
  for (const char letter : name)
    text += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return text + "\"";
}
} // namespace Continua
