#ifndef continua_base_text_table_h
#define continua_base_text_table_h

#include <string>
#include <vector>

namespace Continua
{
/// Lines of a table whose columns are as wide as their widest cell; the first column to the left.
std::vector<std::string> aligned_lines(const std::vector<std::vector<std::string>> &rows);

/// A number with that many digits that count.
std::string number_text(double value, int n_digits);

/// "pressure [Pa]"; the name alone for a quantity without a unit.
std::string with_unit(const std::string &name, const std::string &unit);

/// A text in a csv file (RFC 4180).
std::string csv_cell(const std::string &text);
/// A number in a csv file; nothing where there is none.
std::string csv_cell(double value);
} // namespace Continua

#endif
