#ifndef continua_base_csv_table_h
#define continua_base_csv_table_h

#include <continua/base/input_error.h>
#include <continua/base/unit_scale.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * A csv file of numbers with units in its header: "time [ms], pressure [mmHg]". Separator: the
 * first of semicolon, comma, tab and blanks that the header has; below another header the rows may
 * be separated by blanks or tabs. Blanks and quotes around a cell, empty cells at the end of a
 * line, a byte order mark and the kind of line ends do not matter; lines that start with # and
 * empty lines are left out. Excel's first line "sep=;" names the separator. A known unit may also
 * stand in round brackets, "pressure (mmHg)", or in a line of units below the names. The decimal
 * separator is a point, the exponent e or Fortran's D. Columns and rows count from 0.
 *
 * Where the first line that is no comment has only numbers, the comment before it is the header if
 * it has as many names, and a unit; else the file has none and is refused, since its units would be
 * a guess.
 *
 * Whatever is wrong is thrown as an InputError with file, line, column and remedy.
 */
class CsvTable
{
public:
  /// Throws for a file that cannot be read or has no header, and for a row with another number of
  /// cells than the header. `example`: a header as it should be, for the remedy. `advice`: a
  /// sentence for messages about units and headers, with the entry that scales the values.
  CsvTable(const std::string &file, const std::string &example, const std::string &advice = "");

  std::size_t n_columns() const { return columns.size(); }
  std::size_t n_rows() const { return rows.size(); }
  const std::string &name(std::size_t column) const { return columns[column].name; }
  /// Where the header stands.
  Origin header() const { return {file, header_line}; }

  /// The column of this name among those from `first` on; throws if there is none or more than one.
  std::size_t find(const std::string &name, std::size_t first = 0) const;
  bool has_unit(std::size_t column) const { return columns[column].has_unit; }
  /// "'pressure', 'flow rate'": the columns from `first` on; by its number where the name is none
  /// that a person writes, since a file named by mistake may hold a secret.
  std::string names(std::size_t first = 0) const;
  /// The column's numbers in SI. Throws for a unit that is missing (unless the column has no
  /// dimension), unknown or of another dimension, and for a missing or malformed number.
  std::vector<double> values(std::size_t column, const Dimension &dimension) const;
  /// The column's cells as they are written, without blanks and quotes around them. Throws for an
  /// empty one.
  std::vector<std::string> texts(std::size_t column) const;
  /// The numbers of a column that must increase from row to row; messages say "the TIME 3 is not
  /// LATER than that of the row before".
  std::vector<double> increasing_values(std::size_t column,
                                        const Dimension &dimension,
                                        const std::string &time,
                                        const std::string &later) const;
  /// Throws if there are fewer rows.
  void require_rows(std::size_t n) const;
  /// Throws for the number in a row and column (or the row, if `column` is n_columns()).
  [[noreturn]] void refuse(std::size_t row,
                           std::size_t column,
                           const std::string &problem,
                           const std::string &remedy) const;

private:
  struct Column
  {
    std::string name;
    std::string unit;
    bool has_unit = false;
  };
  struct Row
  {
    unsigned int line;
    std::vector<std::string> cells;
  };
  static std::vector<Column> parse_header(const std::string &line, char separator);
  /// The comment before the first row that names its columns, and sets the line of the header;
  /// empty if there is none.
  std::string header_in_comment(const std::vector<std::string> &lines, std::size_t first_row);
  /// `content`: the indices of the lines that are neither empty nor comments.
  [[noreturn]] void refuse_without_header(const std::vector<std::string> &lines,
                                          const std::vector<std::size_t> &content,
                                          const std::string &example) const;
  /// Throws where the first line has only numbers with decimal commas, or lines of text stand
  /// before the first row.
  void refuse_what_is_no_header(const std::vector<std::string> &lines,
                                const std::vector<std::size_t> &content,
                                const std::string &example) const;
  static bool has_units(const std::vector<Column> &columns);
  /// Takes the cells of the line below the names as the units, if each is one.
  bool take_units(const std::vector<std::string> &cells);
  /// " (s, ms, min, h; Pa, kPa, ...)": what may stand in the place of the units of the example.
  static std::string units_of(const std::string &example);
  UnitScale unit_scale_of(std::size_t column, const Dimension &dimension) const;

  std::string file, advice;
  unsigned int header_line = 0;
  std::vector<Column> columns;
  std::vector<Row> rows;
};
} // namespace Continua

#endif
