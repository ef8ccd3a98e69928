#ifndef continua_network_element_entries_h
#define continua_network_element_entries_h

#include <continua/base/parameter_section.h>
#include <continua/network/circuit.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// An element without a length, as a file describes it.
struct ElementEntries
{
  std::string from, to; ///< its nodes; of what stores only `from`
  ElementLaw law;       ///< without the numbers of the nodes
  bool has_initial_pressure = false;
  double initial_pressure = 0.; ///< of a compliance [Pa]
  double period = 0.;           ///< of a table that is repeated [s]; 0: none
  /// Throws the InputError of an entry ("From", ...) with problem and remedy.
  std::function<void(const std::string &, const std::string &, const std::string &)> refuse;

  /// The entry that names its node, or its first one.
  std::string key_of_node() const { return law.stores() ? "Node" : "From"; }
  std::string type_name() const;
  /// The types and a line on each, in the order of the manual.
  static std::vector<std::pair<std::string, std::string>> types();
  /// Declares and reads one subsection of Elements, called after the element. Throws InputError.
  static ElementEntries read(ParameterSection section);
};
} // namespace Continua

#endif
