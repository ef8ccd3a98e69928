#ifndef continua_base_table_cells_h
#define continua_base_table_cells_h

#include <string>
#include <vector>

namespace Continua
{
/// The text without blanks and tabs at its ends.
std::string without_blanks_around(const std::string &text);

/// Cells of a line of a table, without the blanks and quotes around them. A separator inside
/// brackets, as in "[mPa s]", or inside quotes does not separate; `separator` ' ' stands for any
/// number of blanks and tabs.
std::vector<std::string> split_into_cells(const std::string &line, char separator);

/// The first of semicolon, comma and tab that separates cells of this line; else a blank.
char find_separator(const std::string &line);

/// Leaves out empty cells at the end, which a separator at the end of each line makes, beyond the
/// first `n`.
void drop_empty_cells(std::vector<std::string> &cells, std::size_t n);

/// The cells by the line's own separator, without empty ones at the end.
std::vector<std::string> cells_of_line(const std::string &line);

/// Whether the cell is a finite number, and which; the exponent may be that of Fortran, 1.0D-03.
bool is_number(const std::string &cell, double &number);
bool are_numbers(const std::vector<std::string> &cells);

/// Whether the cell is a number with a decimal comma, such as 0,025.
bool has_decimal_comma(const std::string &cell);

/// Whether the line has nothing but numbers, with decimal points or commas.
bool has_only_numbers(const std::string &line);

/// Whether the cell stands for a value that is missing: nothing, "-", "nan", "NA".
bool is_gap(const std::string &cell);

/// The unit that the cell is, alone or in brackets: "ms", "[ms]", "(ms)"; empty if it is none.
std::string unit_of_cell(const std::string &cell);

/// Whether the line is neither empty nor a comment.
bool has_content(const std::string &line);

/// The separator that Excel names in a first line "sep=;"; 0 if it is no such line.
char separator_of_excel(const std::string &line);

/// Whether the cells are whole numbers of which the first one says how many rows follow, as some
/// programs write before the rows.
bool count_rows(const std::vector<std::string> &cells, std::size_t n_rows);

/// The example of a header, for rows with that many cells and this separator.
std::string header_for(const std::string &example, std::size_t n_cells, char separator);
} // namespace Continua

#endif
