#include <continua/network/terminal_entries.h>

#include <continua/base/csv_table.h>
#include <continua/base/required_entry.h>
#include <continua/base/words.h>
#include <continua/network/value_of_time.h>

#include <memory>

namespace Continua
{
namespace
{
using Type = TerminalLaw::Type;

const Words<Type> &terminal_type_words()
{
  static const Words<Type> words = {
      {"flow rate", Type::flow_rate},   {"pressure", Type::pressure},
      {"resistance", Type::resistance}, {"windkessel", Type::windkessel},
      {"heart", Type::heart},           {"absorbing", Type::absorbing},
      {"closed", Type::closed}};
  return words;
}

void read_value(ParameterSection &section,
                TerminalEntries &terminal,
                const std::string &key,
                const Dimension &dimension,
                const std::string &text)
{
  const ValueOfTime over_time = ValueOfTime::read(section, key, dimension, text);
  terminal.period = over_time.period;
  terminal.law.value = over_time.value;
}

void read_pressure_behind(ParameterSection &section, TerminalLaw &law)
{
  section.add("Pressure behind", law.pressure_behind, Dimensions::pressure,
              "Into which the liquid flows.");
}

void read_initial_pressure(ParameterSection &section,
                           TerminalEntries &terminal,
                           const std::string &text)
{
  section.add("Initial pressure", terminal.law.initial_pressure, Dimensions::pressure, text);
  terminal.has_initial_pressure = section.given("Initial pressure");
}
} // namespace

std::vector<std::pair<std::string, std::string>> TerminalEntries::types()
{
  return {
      {"flow rate", "A flow rate over time, into the vessel."},
      {"pressure", "A pressure over time."},
      {"resistance", "A pressure in proportion to the flow rate out of the vessel."},
      {"windkessel",
       "A resistance before a compliance that stands beside a second resistance (the windkessel "
       "of three elements)."},
      {"heart",
       "A chamber with a pressure in proportion to its volume, by an elastance over time, with a "
       "valve to the vessel and another one through which it fills."},
      {"absorbing",
       "The vessel goes on without limit: waves leave, and what comes in is the state at rest. The "
       "wave that leaves is taken as one without friction."},
      {"closed", "Nothing flows."}};
}

TerminalEntries TerminalEntries::read(ParameterSection section)
{
  TerminalEntries terminal;
  terminal.node = section.name();
  TerminalLaw &law = terminal.law;
  add_choice(section, "Type", law.type, terminal_type_words(),
             "What stands at the loose end of this node.");
  section.require("Type");
  switch (law.type)
  {
  case Type::flow_rate:
    read_value(section, terminal, "Flow rate", Dimensions::flow_rate, "Into the vessel.");
    break;
  case Type::pressure:
    read_value(section, terminal, "Pressure", Dimensions::pressure, "At the end of the vessel.");
    break;
  case Type::resistance:
    law.resistance =
        required_entry(section, "Resistance", Dimensions::flow_resistance,
                       "Pressure over the flow rate out of the vessel.", Range::not_negative());
    read_pressure_behind(section, law);
    break;
  case Type::windkessel:
    law.resistance = required_entry(section, "Proximal resistance", Dimensions::flow_resistance,
                                    "Before the compliance.", Range::not_negative());
    law.distal_resistance =
        required_entry(section, "Distal resistance", Dimensions::flow_resistance,
                       "Beside the compliance.", Range::positive());
    law.compliance = required_entry(section, "Compliance", Dimensions::compliance,
                                    "Volume stored over pressure.", Range::positive());
    read_pressure_behind(section, law);
    read_initial_pressure(section, terminal,
                          "Pressure of the compliance at the start; left out: the initial pressure "
                          "of the network.");
    break;
  case Type::heart:
  {
    constexpr Dimension elastance{1, -4, -2}, volume{0, 3, 0};
    read_value(section, terminal, "Elastance", elastance,
               "Pressure in the chamber over its volume less the unloaded one, over time; "
               "positive.");
    Heart::Law &heart = law.heart;
    heart.elastance = law.value;
    section.add("Unloaded volume", heart.unloaded_volume, volume,
                "Of the chamber without pressure.", Range::not_negative());
    heart.initial_volume = required_entry(section, "Initial volume", volume,
                                          "Of the chamber at the start.", Range::positive());
    heart.valve_resistance =
        required_entry(section, "Valve resistance", Dimensions::flow_resistance,
                       "Of the valve to the vessel, where it is open.", Range::not_negative());
    heart.filling_pressure =
        required_entry(section, "Filling pressure", Dimensions::pressure,
                       "Before the valve through which the chamber fills.", Range());
    heart.filling_resistance =
        required_entry(section, "Filling resistance", Dimensions::flow_resistance,
                       "Of this valve, where it is open.", Range::positive());
    break;
  }
  case Type::absorbing:
    read_initial_pressure(section, terminal,
                          "Pressure of the state at rest, from which the waves differ; left out: "
                          "the initial pressure of the network.");
    break;
  case Type::closed:
    break;
  }
  terminal.refuse = [section](const std::string &problem, const std::string &remedy)
  { section.refuse("", problem, remedy); };
  return terminal;
}

std::vector<TerminalEntries> TerminalEntries::read_table(const std::string &file,
                                                         const double pressure_behind)
{
  const auto table = std::make_shared<const CsvTable>(
      file,
      "node, proximal resistance [Pa s/m^3], distal resistance [Pa s/m^3], compliance [m^3/Pa]");
  table->require_rows(1);
  const std::vector<std::string> nodes = table->texts(table->find("node"));
  const auto numbers = [&](const std::string &name, const Dimension &dimension)
  {
    const std::size_t column = table->find(name);
    std::vector<double> values = table->values(column, dimension);
    for (std::size_t row = 0; row < values.size(); ++row)
      if (!(values[row] >= 0.))
        table->refuse(row, column, "is negative", "Write zero or a positive number");
    return values;
  };
  const std::vector<double> proximal = numbers("proximal resistance", Dimensions::flow_resistance),
                            distal = numbers("distal resistance", Dimensions::flow_resistance),
                            compliance = numbers("compliance", Dimensions::compliance);
  std::vector<TerminalEntries> terminals(nodes.size());
  for (std::size_t row = 0; row < nodes.size(); ++row)
  {
    terminals[row].node = nodes[row];
    TerminalLaw &law = terminals[row].law;
    law.pressure_behind = pressure_behind;
    if (compliance[row] > 0.)
    {
      law.type = Type::windkessel;
      law.resistance = proximal[row];
      law.distal_resistance = distal[row];
      law.compliance = compliance[row];
      if (!(distal[row] > 0.))
        table->refuse(row, table->find("distal resistance"),
                      "is zero beside a compliance, which it would empty at once",
                      "Write a positive number, or 0 for the compliance");
    }
    else
    {
      law.type = Type::resistance;
      law.resistance = proximal[row] + distal[row];
    }
    terminals[row].refuse = [table, row](const std::string &problem, const std::string &remedy)
    { table->refuse(row, table->find("node"), problem, remedy); };
  }
  return terminals;
}
} // namespace Continua
