#ifndef continua_base_parameter_section_h
#define continua_base_parameter_section_h

#include <continua/base/input_error.h>
#include <continua/base/units.h>

#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
class ParameterFile;
struct ParameterStore;

/// The numbers an entry accepts; a bound is accepted itself unless it is said to be open.
struct Range
{
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_open = false;
  bool upper_open = false;

  static Range positive() { return {0., std::numeric_limits<double>::infinity(), true, false}; }
  static Range not_negative()
  {
    return {0., std::numeric_limits<double>::infinity(), false, false};
  }
};

/**
 * One subsection of a parameter file. Each `add` declares an entry (name, default = the variable's
 * value, pattern, text with unit) in deal.II's ParameterHandler, sets there what the file or the
 * command line gives, or throws an InputError with file, line, key and remedy; and at once the
 * variable gets the value that the handler holds. What a file sets and
 * nobody has declared is refused at the end by ParameterFile::refuse_unknown(). A cheap handle:
 * copies refer to the same section of the same file, which must outlive them (it may be moved).
 *
 * Where the default says that there is none (a number that is infinite, NaN or out of its range, an
 * empty list, an empty word), an empty value (`set KEY =`) is the same as leaving the entry out.
 */
class ParameterSection
{
public:
  ParameterSection(ParameterFile &file, const std::vector<std::string> &path);

  /// A quantity; the file may give a unit of the same dimension, the variable is in SI.
  void add(const std::string &key,
           double &value,
           const Dimension &dimension,
           const std::string &text,
           const Range &range = Range());
  /// A comma-separated list of quantities, each with its own unit, or one unit after the last for
  /// all without.
  void add(const std::string &key,
           std::vector<double> &values,
           const Dimension &dimension,
           const std::string &text,
           const Range &range = Range());
  void add(const std::string &key,
           unsigned int &value,
           const std::string &text,
           unsigned int lower = 0,
           unsigned int upper = std::numeric_limits<unsigned int>::max());
  void
  add(const std::string &key, bool &value, const std::string &text); ///< true | false, yes | no
  void add(const std::string &key, std::string &value, const std::string &text);
  /// A comma-separated list of words; commas inside parentheses do not separate.
  void add(const std::string &key, std::vector<std::string> &values, const std::string &text);
  /// A list of unsigned integers, comma-separated.
  void add(const std::string &key,
           std::vector<unsigned int> &values,
           const std::string &text,
           unsigned int lower = 0);
  /// One of a few words, which begin with no blank and hold no '|'.
  void add_choice(const std::string &key,
                  std::string &value,
                  const std::vector<std::string> &choices,
                  const std::string &text);
  /// A file to read: `path` becomes the path relative to the file that names it (on the
  /// command line: to the working directory); empty stays empty; refused if it is no regular file
  /// or cannot be read. The file is copied to the output's `input/`. A default is taken as it is
  /// and not looked for.
  void add_input_file(const std::string &key, std::string &path, const std::string &text);
  /// Refuses `old_key` with the name that it has now.
  void renamed(const std::string &old_key, const std::string &new_key);

  /// Whether the user set the entry to something (`set KEY =` is nothing, as in a printed file).
  bool given(const std::string &key) const;
  /// Throws InputError if the user did not set an entry that has no sensible default; not while the
  /// documentation of the entries is made.
  void require(const std::string &key) const;
  /// Where the entry stands (or, where it is not given, the section, or the file).
  Origin origin(const std::string &key = "") const;
  /// "Materials/fluid".
  std::string path() const;
  /// The last name of the path.
  std::string name() const;

  ParameterSection subsection(const std::string &name);
  /// Whether the user opens the subsection, with entries or without.
  bool has_subsection(const std::string &name) const;
  /// Whether the user sets anything in the subsection or below it. A printed file opens each
  /// section that was read: what nobody has set in it is no wish of the user.
  bool sets_in_subsection(const std::string &name) const;
  /// The names of the subsections in the file in their order: the members of a named family.
  std::vector<std::string> subsections() const;
  /// Declares every entry of this section as free text and returns them in their order (for
  /// Expected, Regions).
  std::vector<std::pair<std::string, std::string>> add_free_entries(const std::string &text);

  /// Throws MissingInput for this section.
  [[noreturn]] void refuse_missing(const std::string &problem, const std::string &remedy) const;
  /// Throws InputError, with the nearest name, for the first subsection in the file that is called
  /// after none of the `members` ("region", "boundary": their `kind`).
  void refuse_unknown_members(const std::vector<std::string> &members,
                              const std::string &kind) const;

  /// Throws InputError for an entry of this section; an empty key means the section itself.
  [[noreturn]] void
  refuse(const std::string &key, const std::string &problem, const std::string &remedy) const;

private:
  ParameterStore *store;
  std::vector<std::string> names;
};
} // namespace Continua

#endif
