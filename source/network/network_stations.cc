#include <continua/network/network_stations.h>

namespace Continua
{
NetworkStations::NetworkStations(const NetworkParameters &parameters)
{
  for (const NetworkParameters::Station &station : parameters.stations)
  {
    if (station.element.empty())
    {
      places.push_back({station.name, Kind::vessel, station.number, station.position});
      continue;
    }
    const ElementLaw &law = parameters.elements[station.number].law;
    places.push_back({station.name,
                      law.type == ElementLaw::Type::compliance ? Kind::compliance
                      : law.type == ElementLaw::Type::chamber  ? Kind::chamber
                                                               : Kind::between,
                      station.number, 0.});
  }
  const Circuit::Description circuit = parameters.circuit();
  for (unsigned int i = 0; i < circuit.elements.size(); ++i)
    if (circuit.elements[i].type == ElementLaw::Type::chamber)
      places.push_back({circuit.elements[i].name, Kind::chamber, i, 0.});
  for (const TerminalEntries &terminal : parameters.terminals)
    if (terminal.law.type == TerminalLaw::Type::heart && !parameters.has_element(terminal.node))
      places.push_back({terminal.node, Kind::heart, parameters.node(terminal.node), 0.});
}

const std::vector<NetworkStations::Field> &NetworkStations::fields(const std::size_t station) const
{
  static const Field pressure{"pressure", "Pa"}, flow{"flow rate", "m^3/s"},
      volume{"volume", "m^3"};
  static const std::vector<Field> of_vessel = {pressure, flow, {"area", "m^2"}},
                                  of_between = {pressure, flow, {"pressure behind", "Pa"}},
                                  of_compliance = {pressure, volume},
                                  of_chamber = {pressure, volume, {"work", "J", false}};
  switch (places[station].kind)
  {
  case Kind::vessel:
    return of_vessel;
  case Kind::between:
    return of_between;
  case Kind::compliance:
    return of_compliance;
  default:
    return of_chamber;
  }
}

std::vector<std::string> NetworkStations::columns() const
{
  std::vector<std::string> names;
  for (std::size_t s = 0; s < places.size(); ++s)
    for (const Field &field : fields(s))
      names.push_back(places[s].name + ": " + field.name + " [" + field.unit + "]");
  return names;
}

void NetworkStations::append_values(const Network &network, std::vector<double> &row) const
{
  for (const Place &place : places)
    switch (place.kind)
    {
    case Kind::vessel:
    {
      const Vessel::Values values = network.vessel(place.number).values(place.position);
      row.insert(row.end(), {values.pressure, values.flow, values.area});
      break;
    }
    case Kind::heart:
    {
      const Heart &heart = network.heart(place.number);
      row.insert(row.end(), {heart.pressure(network.time()), heart.volume(), heart.work()});
      break;
    }
    default:
    {
      const Circuit::Values values = network.circuit().values(place.number);
      if (place.kind == Kind::between)
        row.insert(row.end(), {values.pressure, values.flow, values.pressure_behind});
      else
        row.insert(row.end(), {values.pressure, values.volume});
      if (place.kind == Kind::chamber)
        row.push_back(values.work);
    }
    }
}
} // namespace Continua
