#ifndef continua_base_quantity_names_h
#define continua_base_quantity_names_h

#include <continua/base/expected_value.h>
#include <continua/base/input_error.h>
#include <continua/base/parameter_section.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// A value is expected of a quantity that no run of the input states: misspelt, or made impossible
/// by what the command line changes.
class ImpossibleQuantity : public InputError
{
public:
  using InputError::InputError;
};

/**
 * The quantities that a run can state in its summary, known before the run: by them a misspelt name
 * in the section Expected is found before any work is done. Whoever adds a quantity to a Summary
 * adds its name here, too. A run need not state all of them: an oscillation that is too short has
 * no frequency.
 */
class QuantityNames
{
public:
  /// `probe`: the probe, section or region the quantity comes from; empty: the run as a whole.
  void add(const std::string &name, const std::string &probe = "");
  /// Takes over another's names.
  void add(const QuantityNames &other);

  bool has(const std::string &name, const std::string &probe) const;
  /// Whether any probe, or the run as a whole, has the quantity.
  bool any_has(const std::string &name) const;
  /// Whether there is the quantity of which something is expected.
  bool states(const ExpectedValue &expected) const;
  /// "PROBE: NAME", or "NAME" of the run as a whole; sorted.
  std::vector<std::string> labels() const;

  /// Throws InputError, as said of the entry `key` of `section`, for the first of `asked` ("PROBE:
  /// NAME", or "NAME" of whatever probe) that has no name here. A position in it may have any unit
  /// and is brought into the form that the name has ("stations 43 mm" is "stations 0.043 m").
  void refuse_unknown(const ParameterSection &section,
                      const std::string &key,
                      std::vector<std::string> &asked) const;
  /// The same for `expected`, the lines of `section`.
  void refuse_unknown(const ParameterSection &section, std::vector<ExpectedValue> &expected) const;
  /// The same for the section Expected of `file`, by ImpossibleQuantity. A line that the command
  /// line made impossible is marked as not compared instead.
  void refuse_unknown(ParameterFile &file,
                      const ParameterSection &section,
                      std::vector<ExpectedValue> &expected) const;

private:
  std::set<std::pair<std::string, std::string>> names; ///< probe, name

  /// Whether there is the quantity; its probe then has the form that the name has.
  bool find(ExpectedValue &expected) const;
  /// The nearest name, for a message.
  std::string remedy(const std::string &asked) const;
};
} // namespace Continua

#endif
