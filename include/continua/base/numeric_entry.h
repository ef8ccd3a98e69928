#ifndef continua_base_numeric_entry_h
#define continua_base_numeric_entry_h

#include <continua/base/numeric_form.h>
#include <continua/base/parameter_file.h>

#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * A number in a parameter file, by its path: `Geometry/Wall thickness`, or one number of a list by
 * its place from 1 on, `Materials/wall/Shear moduli 2`. It is what a study changes from run to run.
 */
class NumericEntry
{
public:
  /// Which entries count.
  enum class Kind
  {
    numbers,
    /// Also those of formulas and angles whose text in the file is a quantity, "Pressure = 2 kPa".
    quantities
  };

  /// Finds the entry among those that are declared: whoever reads the file has read it before.
  /// Throws InputError, as said of the entry `key` of `section`, if there is no such entry (with
  /// the nearest path), if it is no number, or if its list has no such place.
  NumericEntry(const ParameterFile &file,
               const std::string &path,
               const ParameterSection &section,
               const std::string &key,
               Kind kind = Kind::numbers);
  /// The paths of all numbers, but whole ones, that the user has set in these sections
  /// ("Materials") and below them, in the order of their declarations; of a list a path for each
  /// place.
  static std::vector<std::string>
  paths_given(const ParameterFile &file, const std::vector<std::string> &sections, Kind kind);

  /// With the place in a list.
  const std::string &path() const { return its_path; }
  /// Without it.
  const std::string &path_of_entry() const { return entry; }
  /// SI; "1" if there is none, and "rad" of an angle.
  std::string unit() const { return is_angle ? "rad" : form.dimension.unit(); }
  const Dimension &dimension() const { return form.dimension; }
  const Range &range() const { return form.range; } ///< that the file accepts [unit()]
  bool is_integer() const { return form.is_integer; }
  bool is_in_list() const { return form.is_list; }
  /// In the file, or the default [unit()]; NaN where there is none.
  double value() const { return is_in_list() ? numbers[place] : numbers.front(); }
  /// Whether the file accepts this number [unit()].
  bool accepts(double number) const;

  /// What sets the entries to these numbers [unit() each], as paths and texts: one of each entry,
  /// also of several places of one list. Throws std::invalid_argument if two are the same number.
  static std::vector<std::pair<std::string, std::string>>
  settings(const std::vector<NumericEntry> &entries, const std::vector<double> &numbers);

private:
  std::string its_path, entry;
  NumericForm form;
  std::vector<double> numbers; ///< all of the entry
  std::size_t place = 0;       ///< among them, from 0 on
  bool is_angle = false;       ///< in rad
};

/// Whether the number lies in the range.
bool contains(const Range &range, double number);
} // namespace Continua

#endif
