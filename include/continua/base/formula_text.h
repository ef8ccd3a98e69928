#ifndef continua_base_formula_text_h
#define continua_base_formula_text_h

#include <string>

namespace Continua
{
/// Throws std::invalid_argument with the problem of a formula that muParser must not see: brackets
/// nested deeper than 100, more than 20,000 characters (both would end in a crash), an assignment
/// with '=', which would change a variable, or comparisons in a row such as a < t < b, which
/// muParser takes for (a < t) < b.
void check_formula_text(const std::string &text);

/// What to write instead, for the message about a formula that muParser refuses: of one with the
/// words if, then or else in another language's form. It begins with "; ", or is empty.
std::string formula_hint(const std::string &text);
} // namespace Continua

#endif
