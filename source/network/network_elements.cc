#include <continua/base/six_digits.h>
#include <continua/network/network_parameters.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
bool NetworkParameters::has_element(const std::string &name) const
{
  return std::any_of(elements.begin(), elements.end(),
                     [&](const ElementEntries &element)
                     { return element.from == name || element.to == name; });
}

Circuit::Description NetworkParameters::circuit() const
{
  Circuit::Description description;
  const auto pressure_at = [this](const unsigned int number)
  { return initial_pressure - liquid.density * liquid.gravity * heights[number]; };
  for (const ElementEntries &entries : elements)
  {
    ElementLaw law = entries.law;
    law.from = node(entries.from);
    law.to = node(entries.to);
    if (law.type == ElementLaw::Type::compliance)
      law.initial_volume =
          law.compliance *
          ((entries.has_initial_pressure ? entries.initial_pressure : pressure_at(law.from)) -
           law.outside_pressure);
    description.elements.push_back(law);
  }
  // A terminal is made of elements and of nodes of its own.
  unsigned int n = nodes.size();
  for (const TerminalEntries &terminal : terminals)
  {
    if (!has_element(terminal.node))
      continue;
    using Type = TerminalLaw::Type;
    const TerminalLaw &law = terminal.law;
    const unsigned int number = node(terminal.node);
    const auto add_between = [&](const ElementLaw::Type type, const unsigned int from,
                                 const unsigned int to, const double resistance)
    {
      ElementLaw between;
      between.type = type;
      between.name = terminal.node;
      between.from = from;
      between.to = to;
      between.resistance = resistance;
      description.elements.push_back(between);
    };
    const auto add_given = [&](const double pressure)
    {
      description.pressures.emplace_back(n, [pressure](const double /*time*/) { return pressure; });
      return n++;
    };
    switch (law.type)
    {
    case Type::flow_rate:
      description.inflows.emplace_back(number, law.value);
      break;
    case Type::pressure:
      description.pressures.emplace_back(number, law.value);
      break;
    case Type::resistance:
      add_between(ElementLaw::Type::resistance, number, add_given(law.pressure_behind),
                  law.resistance);
      break;
    case Type::windkessel:
    {
      ElementLaw compliance;
      compliance.type = ElementLaw::Type::compliance;
      compliance.name = terminal.node;
      compliance.from = n++;
      compliance.compliance = law.compliance;
      compliance.initial_volume =
          law.compliance *
          (terminal.has_initial_pressure ? law.initial_pressure : pressure_at(number));
      description.elements.push_back(compliance);
      add_between(ElementLaw::Type::resistance, number, compliance.from, law.resistance);
      add_between(ElementLaw::Type::resistance, compliance.from, add_given(law.pressure_behind),
                  law.distal_resistance);
      break;
    }
    case Type::heart:
    {
      ElementLaw chamber;
      chamber.type = ElementLaw::Type::chamber;
      chamber.name = terminal.node;
      chamber.from = n++;
      chamber.elastance = law.heart.elastance;
      chamber.unloaded_volume = law.heart.unloaded_volume;
      chamber.initial_volume = law.heart.initial_volume;
      description.elements.push_back(chamber);
      add_between(ElementLaw::Type::valve, chamber.from, number, law.heart.valve_resistance);
      add_between(ElementLaw::Type::valve, add_given(law.heart.filling_pressure), chamber.from,
                  law.heart.filling_resistance);
      break;
    }
    case Type::absorbing:
    case Type::closed:
      break;
    }
  }
  return description;
}

void NetworkParameters::check_elements() const
{
  for (auto element = elements.begin(); element != elements.end(); ++element)
  {
    if (std::any_of(elements.begin(), element,
                    [&](const ElementEntries &other)
                    { return other.law.name == element->law.name; }))
      element->refuse("", "two elements are called '" + element->law.name + "'",
                      "Rename one of them");
    for (const std::string &name : {element->from, element->to})
    {
      const std::string key = name == element->from ? element->key_of_node() : "To";
      if (name.empty())
        continue;
      check_node_of_element(*element, key, name);
    }
  }
  if (elements.empty())
    return;
  for (const VesselEntries &vessel : vessels)
    if (!vessel.wall.relaxation.is_elastic())
      elements.front().refuse(
          "",
          "the wall of the vessel '" + vessel.name +
              "' relaxes, and elements cannot stand "
              "beside such a wall",
          "Give the vessels an elastic wall, or put terminals in place of the elements");
}

void NetworkParameters::check_node_of_element(const ElementEntries &element,
                                              const std::string &key,
                                              const std::string &name) const
{
  unsigned int n_connections = n_ends(node(name)) + (is_at_body(name) ? 1 : 0), n_stores = 0;
  for (const ElementEntries &other : elements)
    if (other.from == name || other.to == name)
    {
      ++n_connections;
      n_stores += other.law.stores() ? 1 : 0;
    }
  if (n_stores > 1)
    element.refuse(key, "at the node '" + name + "' two elements store liquid",
                   "Put a resistance between them, or make one of them");
  bool has_terminal = false;
  for (const TerminalEntries &terminal : terminals)
    if (terminal.node == name)
    {
      has_terminal = true;
      check_terminal_at_element(terminal, n_stores > 0);
    }
  if (n_connections == 1 && !has_terminal && !element.law.stores())
    element.refuse(
        key, "the element '" + element.law.name + "' has a loose end at the node '" + name + "'",
        "Say in 'Terminals/" + name +
            "' what stands there (Type = pressure, windkessel, ...), or name the node "
            "of a vessel or of another element");
}

void NetworkParameters::check_terminal_at_element(const TerminalEntries &terminal,
                                                  const bool has_store)
{
  using Type = TerminalLaw::Type;
  const TerminalLaw &law = terminal.law;
  if (law.type == Type::absorbing)
    terminal.refuse("an absorbing end is that of a vessel, and at this node there are elements",
                    "Put the elements to another node");
  if (law.type == Type::pressure && has_store)
    terminal.refuse("the element at this node that stores liquid has a pressure of its own",
                    "Put a resistance between the two");
  const bool is_stiff =
      ((law.type == Type::resistance || law.type == Type::windkessel) && law.resistance == 0.) ||
      (law.type == Type::heart && law.heart.valve_resistance == 0.);
  if (is_stiff)
    terminal.refuse("beside elements its resistance next to the node is zero",
                    "Give a positive one, or elements in place of the terminal");
}

void NetworkParameters::check_pressures() const
{
  if (elements.empty())
    return;
  Circuit::Description description = circuit();
  // A vessel gives each node at its end a pressure, as a given one does.
  for (const VesselEntries &vessel : vessels)
    for (const std::string &name : {vessel.from, vessel.to})
      if (has_element(name))
        description.pressures.emplace_back(node(name), Circuit::Value());
  const std::string name = Circuit(description, {}).element_without_pressure();
  for (const ElementEntries &element : elements)
    if (element.law.name == name)
      element.refuse("", "nothing gives the pressure of one of its nodes at the start",
                     "Make one element of those that meet there, with the sum of their "
                     "inertances, or give the node a compliance, a resistance without inertance "
                     "to a node that has a pressure, a terminal with a pressure, or a vessel, "
                     "also between it and a body");
}
} // namespace Continua
