#ifndef continua_base_parameter_file_h
#define continua_base_parameter_file_h

#include <continua/base/parameter_section.h>
#include <continua/base/parameter_text.h>

#include <map>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * A `.prm` file with its includes and the command line's overrides: first read as text (each entry
 * with its file and line), then declared by ParameterSection in deal.II's ParameterHandler, which
 * alone holds the values, checked for leftovers, and printed resolved. Syntax as deal.II's
 * ParameterHandler: `subsection NAME`, `set KEY = VALUE`, `end`, `#` comments, a backslash at the
 * end of a line continues it, and `include FILE` relative to the including file. A name that has
 * such a letter stands between double quotes (quoted_name.h). An entry in an
 * including file overrides that of the included one wherever it stands; a key set twice in one file
 * is an error.
 */
class ParameterFile
{
public:
  /// An empty file: every entry has its default (for printing the documentation).
  ParameterFile();
  /// Reads `path`; `overrides` are "Section/Subsection/Key=value" as given to --set. An empty
  /// `path` makes documentation of what the overrides choose (types). Throws InputError.
  ParameterFile(const std::string &path, const std::vector<std::string> &overrides = {});
  ~ParameterFile();
  ParameterFile(ParameterFile &&) noexcept;
  ParameterFile &operator=(ParameterFile &&) noexcept;

  /// The same text with other values of some entries, "Section/Key" and a value each, in which
  /// nothing is declared yet.
  ParameterFile changed(const std::vector<std::pair<std::string, std::string>> &settings) const;

  /// The top section.
  ParameterSection root();

  /// Throws one InputError for all entries and sections that were set but not declared, one a line,
  /// each with the nearest declared name.
  void refuse_unknown() const;
  /// Whether there is any.
  bool has_undeclared() const;

  /// From now on entries that the changes of the command line make impossible are passed over: the
  /// file was found valid without these changes.
  void pass_over_impossible();
  /// The changes ("--set Section/Key=value") that make a declared entry of the file impossible,
  /// which is then printed as a comment. Empty if the entry is a mistake, or itself such a change.
  std::string changes_that_exclude(const std::string &path_of_entry);

  /// What the user's file and the command line set, as text.
  const ParameterText &text() const;

  /// Every file that was read, as paths from the working directory: the .prm, its includes, its
  /// input files.
  std::vector<std::string> input_files() const;

  enum class Style
  {
    prm,
    json,
    markdown
  };
  /// Every declared entry with its value: the resolved parameters. prm has each text as a comment,
  /// and each entry that the user did not set (but of an empty file), and can be read again from
  /// any directory (input files are named by their absolute paths), also by a plain
  /// ParameterHandler that has declared the entries; json is a list of objects with path, value,
  /// default, values (what is accepted), unit and text; markdown is a table a section for the
  /// manual.
  /// A parameter file cannot hold every path (can_be_a_value). In place of such a one stands its
  /// name among the `copies` (by absolute paths), or else the path from the working directory.
  /// Throws InputError if that cannot stand there either.
  void print(std::ostream &out,
             Style style,
             const std::map<std::string, std::string> &copies = {}) const;

  /// All resolved entries but those that are, or lie in, one of `left_out` ("Output", "Time/End
  /// time"), sorted, a line "PATH=VALUE" each, and of each input file "content of NAME=HASH": what
  /// makes two cases the same. It does not depend on the unit or the order in which values were
  /// written, nor on the directory of an input file, but on what it contains.
  std::string identity_text(const std::vector<std::string> &left_out = {}) const;
  /// A hash (FNV-1a, 64 bit, 16 hexadecimal digits) of that text.
  std::string identity(const std::vector<std::string> &left_out = {}) const;

private:
  friend class ParameterSection;
  friend class NumericEntry;
  std::unique_ptr<ParameterStore> store;
};
} // namespace Continua

#endif
