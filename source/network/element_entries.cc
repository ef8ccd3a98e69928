#include <continua/network/element_entries.h>

#include <continua/base/required_entry.h>
#include <continua/base/words.h>
#include <continua/network/value_of_time.h>

namespace Continua
{
namespace
{
using Type = ElementLaw::Type;

const Words<Type> &element_type_words()
{
  static const Words<Type> words = {{"resistance", Type::resistance},
                                    {"valve", Type::valve},
                                    {"compliance", Type::compliance},
                                    {"chamber", Type::chamber}};
  return words;
}

void read_between_nodes(ParameterSection &section, ElementEntries &element)
{
  section.add("From", element.from,
              "The node from which the flow rate counts, called as you like. Ends of vessels and "
              "other elements may be at the same node. Required.");
  section.add("To", element.to, "The other node. Required.");
  section.require("From");
  section.require("To");
  section.add("Resistance", element.law.resistance, Dimensions::flow_resistance,
              "Difference of the pressures over the flow rate that stays; of a valve where it is "
              "open.",
              Range::not_negative());
  constexpr Dimension inertance{1, -4, 0};
  section.add("Inertance", element.law.inertance, inertance,
              "Difference of the pressures over the change of the flow rate per time: density "
              "times length over the section of a rigid tube.",
              Range::not_negative());
  // Without nodes the entries are only listed.
  if (element.from.empty() || element.to.empty())
    return;
  if (element.law.resistance == 0. && element.law.inertance == 0.)
    section.refuse("Resistance", "is zero, and so is the Inertance",
                   "Give one of them, or let both ends be one node");
  if (element.from == element.to)
    section.refuse("To", "the element '" + element.law.name + "' ends at the node where it starts",
                   "Name another node");
}
} // namespace

std::string ElementEntries::type_name() const
{
  return word_of(element_type_words(), law.type);
}

std::vector<std::pair<std::string, std::string>> ElementEntries::types()
{
  return {{"resistance", "A pressure that is lost in proportion to the flow rate between two "
                         "nodes; with an Inertance the liquid between them has mass."},
          {"valve", "The same, and nothing flows back."},
          {"compliance", "A volume at a node in proportion to the pressure there."},
          {"chamber", "A chamber of a heart at a node, with a pressure in proportion to its volume "
                      "by an elastance over time. Its valves are elements of their own."}};
}

ElementEntries ElementEntries::read(ParameterSection section)
{
  ElementEntries element;
  ElementLaw &law = element.law;
  law.name = section.name();
  add_choice(section, "Type", law.type, element_type_words(), "What the element is.");
  section.require("Type");
  if (law.stores())
  {
    section.add("Node", element.from, "Where it stands, called as you like. Required.");
    section.require("Node");
  }
  constexpr Dimension elastance{1, -4, -2}, volume{0, 3, 0};
  switch (law.type)
  {
  case Type::resistance:
  case Type::valve:
    read_between_nodes(section, element);
    break;
  case Type::compliance:
    law.compliance = required_entry(section, "Compliance", Dimensions::compliance,
                                    "Volume stored over pressure.", Range::positive());
    section.add("Pressure outside", law.outside_pressure, Dimensions::pressure,
                "With which nothing is stored.");
    section.add("Initial pressure", element.initial_pressure, Dimensions::pressure,
                "At the start; left out: the initial pressure of the network.");
    element.has_initial_pressure = section.given("Initial pressure");
    break;
  case Type::chamber:
  {
    const ValueOfTime over_time =
        ValueOfTime::read(section, "Elastance", elastance,
                          "Pressure in the chamber over its volume less the unloaded one, over "
                          "time; positive.");
    law.elastance = over_time.value;
    element.period = over_time.period;
    section.add("Unloaded volume", law.unloaded_volume, volume, "Of the chamber without pressure.",
                Range::not_negative());
    law.initial_volume = required_entry(section, "Initial volume", volume,
                                        "Of the chamber at the start.", Range::positive());
    break;
  }
  }
  element.refuse = [section](const std::string &key, const std::string &problem,
                             const std::string &remedy) { section.refuse(key, problem, remedy); };
  return element;
}
} // namespace Continua
