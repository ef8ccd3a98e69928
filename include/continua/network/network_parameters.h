#ifndef continua_network_network_parameters_h
#define continua_network_network_parameters_h

#include <continua/network/element_entries.h>
#include <continua/network/flow_law.h>
#include <continua/network/network.h>
#include <continua/network/terminal_entries.h>
#include <continua/network/vessel_entries.h>
#include <continua/theory/korteweg.h>

#include <functional>
#include <string>
#include <vector>

namespace Continua
{
/// The section Network: vessels, what stands at their loose ends, stations and times.
struct NetworkParameters
{
  enum class Wall
  {
    square_root,
    neo_hookean
  };
  /// A place where values are recorded.
  struct Station
  {
    std::string name, vessel, element; ///< one of the two
    double position = 0.;              ///< from the start of the vessel [m]
    unsigned int number = 0;           ///< of the vessel or the element
  };
  FlowLaw liquid;
  WallRelaxation relaxation; ///< of vessels without a Material
  Wall wall = Wall::square_root;
  WallTheory wall_theory = WallTheory::thin;
  double poissons_ratio = 0.5;    ///< [1]
  double reference_pressure = 0.; ///< under which the vessels have their radii [Pa]
  double initial_pressure = 0.;   ///< [Pa]
  double cell_length = 0.005;     ///< at most [m]
  unsigned int fewest_cells = 4;  ///< of a vessel
  double courant_number = 0.8;    ///< [1]
  double time_step = 0.;          ///< at most [s]; 0: by itself
  double period = 0.;             ///< of a beat [s]; 0: no beats
  unsigned int most_beats = 30;
  bool by_newton = false;      ///< whether Newton's method finds the periodic state
  double tolerance = 1e-3;     ///< of the periodic state [1]
  double end_time = 0.;        ///< [s], without beats
  double output_interval = 0.; ///< [s]
  std::vector<VesselEntries> vessels;
  std::vector<ElementEntries> elements;
  std::vector<TerminalEntries> terminals;
  std::vector<Station> stations;
  std::vector<std::string> nodes; ///< in the order in which vessels and elements name them
  /// Loose ends at which a body stands; to be set before check(). The steps and times of such a
  /// network are those of the run of the body.
  std::vector<std::string> nodes_at_body;
  bool has_initial_pressure = false; ///< in the file
  /// Of the loads of a body in a start from their mean; 0: it is no such start [s].
  double period_of_loads = 0.;

  /// Declares and reads. Throws InputError for what is wrong in an entry or a row.
  void read(ParameterSection section);
  /// The walls of vessels that name one of these materials. Throws InputError, also for an entry of
  /// `section` that then has no effect and for a material that no vessel names.
  /// `of_body`: materials that are also those of a body.
  void read_materials(const ParameterSection &section,
                      ParameterSection materials,
                      const std::vector<std::string> &of_body = {});
  /// Refuses the entries of a run of the network alone, after read(). Throws InputError.
  static void refuse_times(const ParameterSection &section);
  /// Numbers the nodes and the vessels of the stations. Throws InputError for what is no network:
  /// no vessel, a loose end without a terminal, a terminal at no loose end, parts that do not meet,
  /// heights that do not fit together, a station outside its vessel, times that are missing.
  void check(ParameterSection section);
  /// Of hearts, which must be positive in a time [s], looked at once in a `step` [s] (0: a
  /// thousand times); check() does it where there is no body. Throws InputError.
  void check_elastances(double duration, double step = 0.) const;
  /// The network in its state at rest. After check(). Throws std::domain_error if there is no such
  /// state.
  Network make() const { return make({}); }
  /// The same, with the flow rates into the network [m^3/s], of time [s], at its nodes at a body.
  Network make(const std::vector<std::function<double(double)>> &inflows_of_body) const;
  /// Whether the file gives a pressure or a charge with which the network starts at rest.
  bool gives_state_at_rest() const;
  /// Whether its steady flow is known for any flow rates out of the body. After check().
  bool has_steady_flow() const;
  unsigned int node(const std::string &name) const;  ///< its number; nodes.size(): there is none
  std::vector<unsigned int> numbers_at_body() const; ///< of nodes_at_body, after check()
  bool has_element(const std::string &node) const;   ///< whether one stands at the node
  /// The elements, in the order of `elements`, and behind them what terminals at their nodes are
  /// made of. After check().
  Circuit::Description circuit() const;
  double largest_step() const; ///< [s], beside that of the waves
  unsigned int n_cells(const VesselEntries &vessel) const;
  /// Of the records in a beat, or in the run.
  unsigned int n_intervals() const;

private:
  std::vector<double> heights; ///< of the nodes [m]

  unsigned int n_ends(unsigned int node) const; ///< of vessels at a node
  bool is_at_body(const std::string &node) const;
  void read_liquid(ParameterSection &section);
  void read_wall(ParameterSection &section);
  void read_times(ParameterSection &section);
  void check_materials(const ParameterSection &section,
                       ParameterSection materials,
                       const std::vector<std::string> &of_body) const;
  void check_ends();
  void check_elements() const;
  void check_node_of_element(const ElementEntries &element,
                             const std::string &key,
                             const std::string &name) const;
  static void check_terminal_at_element(const TerminalEntries &terminal, bool has_store);
  void check_pressures() const;
  void set_heights();
  void check_stations(ParameterSection &section);
  void check_times(const ParameterSection &section);
  std::unique_ptr<Vessel> make_vessel_of(const VesselEntries &entries) const;
};
} // namespace Continua

#endif
