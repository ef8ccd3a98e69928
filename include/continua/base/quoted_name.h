#ifndef continua_base_quoted_name_h
#define continua_base_quoted_name_h

#include <string>
#include <vector>

namespace Continua
{
/**
 * Names between double quotes. A quote that begins a word opens a quotation, which the next quote
 * closes; two quotes in a quotation stand for one. In a quotation no letter has a meaning of its
 * own: no '#' begins a comment, no ',' '/' or '=' divides, and blanks stay. A quote within a word,
 * and one that nothing closes, is an ordinary letter.
 */

/// For each letter of the text, whether it belongs to a quotation, the quotes included.
std::vector<bool> quoted_letters(const std::string &text);
/// The place of the first such letter outside quotations, from `begin`; npos if there is none.
std::size_t
find_unquoted(const std::string &text, const std::string &letters, std::size_t begin = 0);
/// The pieces of the text between such letters outside quotations, quotes and blanks kept; one
/// piece if there are none.
std::vector<std::string> split_unquoted(const std::string &text, char letter);
/// The text without the quotes of its quotations.
std::string without_quotes(const std::string &text);
/// The name between quotes if it could not be read back as it stands: it has one of the letters
/// `special`, a quote that begins a word, blanks at an end or several together, a backslash at its
/// end, or no letter.
std::string quoted_name(const std::string &name, const std::string &special);
} // namespace Continua

#endif
