#ifndef continua_network_terminal_entries_h
#define continua_network_terminal_entries_h

#include <continua/base/parameter_section.h>
#include <continua/network/terminal.h>

#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// What stands at the loose end of a node, as a file describes it.
struct TerminalEntries
{
  std::string node;
  TerminalLaw law; ///< without the initial pressure where the file has none
  bool has_initial_pressure = false;
  double period = 0.; ///< of a table that is repeated [s]; 0: none
  /// Throws an InputError that names the node, with problem and remedy.
  std::function<void(const std::string &, const std::string &)> refuse;

  /// The types and a line on each, in the order of the manual.
  static std::vector<std::pair<std::string, std::string>> types();
  /// Declares and reads one subsection of Terminals, called after the node. Throws InputError.
  static TerminalEntries read(ParameterSection section);
  /// The rows of a csv file with the columns node, proximal resistance, distal resistance and
  /// compliance: windkessels, and where the compliance is 0 resistances of both. Throws InputError.
  static std::vector<TerminalEntries> read_table(const std::string &file, double pressure_behind);
};
} // namespace Continua

#endif
