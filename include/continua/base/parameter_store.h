#ifndef continua_base_parameter_store_h
#define continua_base_parameter_store_h

#include <continua/base/numeric_form.h>
#include <continua/base/parameter_text.h>

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Continua
{
/**
 * What the sections of one parameter file share: the user's text, what has been declared, and
 * deal.II's ParameterHandler, which alone holds the values. Internal to ParameterFile and
 * ParameterSection.
 */
struct ParameterStore
{
  /// What an entry is, but for its value.
  struct Declaration
  {
    std::vector<std::string> section;
    std::string key;
    std::string default_value; ///< with its unit; empty where there is none
    std::string values;        ///< what is accepted, in words: "number > 0"
    std::string unit;          ///< "Pa", "1"; empty for what is no quantity
    std::string text;          ///< without the unit
    /// Brings the text of a value into one form only, in SI: two ways to write one value have the
    /// same.
    std::function<std::string(const std::string &)> one_form;
    bool is_input_file = false; ///< the value is the absolute path of a file
    /// Of numbers; empty for what is none.
    std::optional<NumericForm> number = {};

    /// The section and the key.
    std::vector<std::string> path() const;
    /// The documentation of a quantity ends with its unit.
    std::string documentation() const;
    /// The documentation, and the values that are accepted: a parameter file has no other place for
    /// them.
    std::string full_documentation() const;
  };

  ParameterText text;
  bool is_documentation = false; ///< there is no user's file: entries are declared to be described
  std::vector<Declaration> declarations;          ///< in the order in which they were declared
  std::vector<std::vector<std::string>> sections; ///< those declared, parents before children
  std::vector<std::string> input_files;           ///< besides those of `text`
  /// Whether entries are passed over which the changes of the command line make impossible.
  bool passes_over_impossible = false;
  std::vector<std::vector<std::string>> passed_over; ///< their paths

  void declare_section(const std::vector<std::string> &path);
  /// Declares an entry, whose value is then its default. A second declaration replaces the first.
  void declare(const Declaration &declaration, const dealii::Patterns::PatternBase &pattern);
  /// Gives a declared entry its value; the pattern accepts it.
  void set(const Declaration &declaration, const std::string &value);
  /// The value of a declared entry: what set() gave it, or the default.
  std::string value(const Declaration &declaration) const;
  void add_input_file(const std::string &path);

  /// What the user's text sets; null if it does not have the entry.
  const ParameterText::Entry *given(const std::vector<std::string> &section,
                                    const std::string &key) const;
  bool is_declared(const std::vector<std::string> &path) const;
  bool is_declared(const std::vector<std::string> &path, const std::string &key) const;
  /// The keys and the subsections declared in a section.
  std::vector<std::string> keys(const std::vector<std::string> &path) const;
  std::vector<std::string> subsections(const std::vector<std::string> &path) const;
  /// One message a line for what was set and not declared, as InputErrors.
  std::vector<InputError> unknown() const;

private:
  void enter(const std::vector<std::string> &section);
  void leave(const std::vector<std::string> &section);
  void find_unknown(const ParameterText::Section &section,
                    const std::vector<std::string> &path,
                    std::vector<InputError> &errors) const;
  /// "Did you mean ...?" or what there is instead.
  std::string suggestion(const std::vector<std::string> &path, const std::string &name) const;

  dealii::ParameterHandler handler;
};
} // namespace Continua

#endif
