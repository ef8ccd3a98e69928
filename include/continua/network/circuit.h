#ifndef continua_network_circuit_h
#define continua_network_circuit_h

#include <continua/network/end_wave.h>
#include <continua/network/solve_rows.h>
#include <continua/network/state_numbers.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// An element without a length (a lumped, or 0-D element). The flow rate is that from `from` to
/// `to`; what stores liquid stands at `from` alone.
struct ElementLaw
{
  enum class Type
  {
    resistance, ///< p_from - p_to = R Q + L dQ/dt
    valve,      ///< the same, and nothing flows back
    compliance, ///< a volume C (p - p_outside)
    chamber     ///< of a heart: p = elastance(t) (volume - unloaded volume)
  };
  Type type = Type::resistance;
  std::string name;
  unsigned int from = 0, to = 0;           ///< nodes
  double resistance = 0., inertance = 0.;  ///< R [Pa s/m^3], L [Pa s^2/m^3]
  double compliance = 0.;                  ///< C [m^3/Pa]
  double outside_pressure = 0.;            ///< [Pa]
  double initial_volume = 0.;              ///< [m^3], where something is stored
  std::function<double(double)> elastance; ///< of time [s]: [Pa/m^3], positive
  double unloaded_volume = 0.;             ///< [m^3]

  bool stores() const { return type == Type::compliance || type == Type::chamber; }
};

/**
 * Elements without a length between nodes, at which ends of vessels may stand, too. Unknown are the
 * pressures of the nodes: no liquid is lost at a node, and all ends of vessels there have its
 * pressure. What an element stores (the volume of a compliance or a chamber, the flow rate of an
 * inertance) is its state.
 *
 * With vessels a step has the trapezoidal rule, whose two ends are the two stages of the vessels:
 * so the volume that leaves the vessels is that which the elements take, to round-off. Without
 * vessels it has the two implicit stages of R. Alexander (SIAM J. Numer. Anal. 14 (1977) 1006) with
 * 1 - 1/sqrt(2): second order, and L-stable. In each stage Newton's method finds the pressures; a
 * valve is open where that gives a flow rate forwards.
 */
class Circuit
{
public:
  using Value = std::function<double(double)>; ///< of time [s]
  struct Description
  {
    std::vector<ElementLaw> elements;
    std::vector<std::pair<unsigned int, Value>> pressures; ///< of nodes that have a given one [Pa]
    std::vector<std::pair<unsigned int, Value>> inflows;   ///< into nodes [m^3/s]
  };
  Circuit() = default;
  /// `vessels`: ends at nodes of elements.
  Circuit(const Description &description,
          const std::vector<std::pair<unsigned int, EndWave>> &vessels);

  bool is_empty() const { return elements.empty(); }
  unsigned int n_elements() const { return elements.size(); }
  const ElementLaw &law(const unsigned int element) const { return elements[element].law; }
  double volume() const; ///< of all that stores [m^3]
  /// Whether a node of the network belongs to it.
  bool has_node(const unsigned int node) const { return place_of(node) < nodes.size(); }
  /// Of such a node in the last stage, and its mean over both stages of the last step [Pa].
  double pressure(const unsigned int node) const { return pressures[place_of(node)]; }
  double mean_pressure(const unsigned int node) const
  {
    const unsigned int place = place_of(node);
    return 0.5 * (first_pressures[place] + pressures[place]);
  }
  /// Of the vessels that end at a node, the first one, or null.
  const EndWave *vessel_at(unsigned int node) const;
  double energy() const; ///< of compliances and inertances [J]

  /// Whether the circuit has a given pressure, or something that stores, for the pressure of each
  /// node at a time; else the name of an element at a node that has none.
  std::string element_without_pressure() const;

  /// The pressures of the state that it has. All calls throw std::domain_error without a solution.
  void start_at_rest(double time);
  /// The state of a steady flow: pressures by the numbers of the nodes [Pa], and the flow rates of
  /// the elements [m^3/s].
  void start_steady(const std::vector<double> &of_nodes, const double *flows);
  /// By the numbers of the nodes, as the description has them.
  std::vector<std::pair<unsigned int, Value>> given_pressures() const { return by_number(given); }
  std::vector<std::pair<unsigned int, Value>> given_inflows() const { return by_number(inflows); }
  /// The stage at the begin (or the end) of a step of the vessels from `time` to `time + step` [s].
  void solve_stage(bool at_end_of_step, double time, double step);
  /// A step without vessels.
  void step_alone(double time, double step);
  /// What has flowed in from outside in the last step [m^3].
  double inflow_of_step() const { return entered; }

  /// An element after the last stage.
  struct Values
  {
    double pressure, pressure_behind; ///< of the nodes `from` and `to` [Pa]
    double flow;                      ///< from `from` to `to`, or into what stores [m^3/s]
    double volume;                    ///< [m^3], where something is stored
    double work;                      ///< that a chamber has done since the start [J]
  };
  Values values(unsigned int element) const;
  /// Hands over what a step changes.
  void visit(StateNumbers &numbers);
  /// The same for what only counts since the start.
  void visit_sums(StateNumbers &numbers);

private:
  struct Element
  {
    ElementLaw law;
    unsigned int from, to; ///< places in the list of nodes
    double state = 0.;     ///< volume [m^3] or flow rate [m^3/s] at the begin of the step
    double known = 0.;     ///< of the stage: the new state is known + share rate
    double rate = 0.;      ///< of the state in the last stage, per second
    double flow = 0.;      ///< in the last stage [m^3/s]
    double work = 0.;      ///< [J]
  };
  std::vector<Element> elements;
  std::vector<unsigned int> nodes;                            ///< their numbers in the network
  std::vector<double> pressures;                              ///< by node [Pa]
  std::vector<double> first_pressures;                        ///< in the first stage of a step [Pa]
  std::vector<std::pair<unsigned int, Value>> given, inflows; ///< by place
  std::vector<std::pair<unsigned int, EndWave>> vessels;      ///< by place
  std::vector<char> is_given;                                 ///< by place, in the present stage
  double entered = 0.;                                        ///< in the step [m^3]
  double entering = 0.;                                       ///< in the last stage [m^3/s]
  // Of the solve.
  Rows rows;
  std::vector<double> change, flow_into, areas;

  unsigned int place(unsigned int node);
  /// The number of nodes if it is none of them.
  unsigned int place_of(unsigned int node) const;
  std::vector<std::pair<unsigned int, Value>>
  by_number(std::vector<std::pair<unsigned int, Value>> by_place) const;
  void solve(double time, double share);
  void add_equations(double time, double share);
  void take_rates(double time, double share);
  static std::pair<double, double> flow_of(const Element &element, double difference, double share);
  static double volume_at(const ElementLaw &law, double pressure, double time);
  static double volume_slope(const ElementLaw &law, double time);
  void add_work(double time, double step, const std::vector<double> &before);
};
} // namespace Continua

#endif
