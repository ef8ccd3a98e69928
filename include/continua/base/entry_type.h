#ifndef continua_base_entry_type_h
#define continua_base_entry_type_h

#include <continua/base/numeric_form.h>
#include <continua/base/parameter_section.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Continua
{
/// How the text of an entry becomes a value, and what its documentation says of it. Internal to
/// ParameterSection.
template <typename Value>
struct EntryType
{
  std::string default_value; ///< as text; empty where there is none
  std::string values;        ///< what is accepted, in words: "number > 0"
  std::string unit;          ///< "Pa", "1"; empty for what is no quantity
  bool may_be_empty =
      false;          ///< whether an empty text is a value; it always is where it is the default
  std::string remedy; ///< for a text that cannot be read
  /// Throws std::invalid_argument with the problem.
  std::function<Value(const std::string &)> read;
  /// The value as text, in one form only.
  std::function<std::string(const Value &)> write;
  /// Of numbers; empty for what is none.
  std::optional<NumericForm> number = {};
};

/// The default of each type is `value`, where the type accepts it.
EntryType<double> quantity_type(double value, const Dimension &dimension, const Range &range);
/// Each with its own unit, or one unit after the last for all without.
EntryType<std::vector<double>> quantity_list_type(const std::vector<double> &values,
                                                  const Dimension &dimension,
                                                  const Range &range);
EntryType<unsigned int> integer_type(unsigned int value, unsigned int lower, unsigned int upper);
EntryType<std::vector<unsigned int>> integer_list_type(const std::vector<unsigned int> &values,
                                                       unsigned int lower);
EntryType<bool> truth_type(bool value);
EntryType<std::string> text_type(const std::string &value);
/// Commas inside parentheses do not separate.
EntryType<std::vector<std::string>> word_list_type(const std::vector<std::string> &values);
EntryType<std::string> choice_type(const std::string &value,
                                   const std::vector<std::string> &choices);
} // namespace Continua

#endif
