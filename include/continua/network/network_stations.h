#ifndef continua_network_network_stations_h
#define continua_network_network_stations_h

#include <continua/network/network_parameters.h>

#include <string>
#include <vector>

namespace Continua
{
/// What is recorded of a network: its stations in vessels and at elements, and each chamber of a
/// heart under its own name.
class NetworkStations
{
public:
  struct Field
  {
    std::string name, unit;
    bool has_extremes = true; ///< whether its largest and smallest value tell something
  };
  /// After NetworkParameters::check().
  explicit NetworkStations(const NetworkParameters &parameters);

  std::size_t n_stations() const { return places.size(); }
  const std::string &name(const std::size_t station) const { return places[station].name; }
  /// The first one is a pressure.
  const std::vector<Field> &fields(std::size_t station) const;
  bool is_chamber(const std::size_t station) const
  {
    return places[station].kind == Kind::chamber || places[station].kind == Kind::heart;
  }
  /// By the stations and their fields: "name: field [unit]".
  std::vector<std::string> columns() const;
  std::size_t n_columns() const { return columns().size(); }
  /// Appends the present values, in this order.
  void append_values(const Network &network, std::vector<double> &row) const;

private:
  enum class Kind
  {
    vessel,
    between, ///< two nodes
    compliance,
    chamber,
    heart ///< a terminal
  };
  struct Place
  {
    std::string name;
    Kind kind;
    unsigned int number; ///< of the vessel, the element or the node
    double position;     ///< in the vessel [m]
  };
  std::vector<Place> places;
};
} // namespace Continua

#endif
