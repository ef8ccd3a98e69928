#ifndef continua_network_network_h
#define continua_network_network_h

#include <continua/network/circuit.h>
#include <continua/network/junction.h>
#include <continua/network/memory_nodes.h>
#include <continua/network/terminal.h>
#include <continua/network/vessel.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * Vessels and elements without a length (Circuit) that meet in nodes, and their common steps in
 * time. A loose end of a vessel has a TerminalLaw.
 */
class Network
{
public:
  /// A vessel from one node to another one; nodes are numbered from 0.
  struct Edge
  {
    std::unique_ptr<Vessel> vessel;
    unsigned int from, to;
  };
  /// `terminals`: for each node, in order; of nodes with several ends, and of those of the circuit,
  /// none is used. The circuit may have nodes beyond these.
  Network(std::vector<Edge> edges,
          const std::vector<TerminalLaw> &terminals,
          const Circuit::Description &elements = {});

  unsigned int n_vessels() const { return edges.size(); }
  const Vessel &vessel(const unsigned int number) const { return *edges[number].vessel; }
  Vessel &vessel(const unsigned int number) { return *edges[number].vessel; }
  const Circuit &circuit() const { return elements; }
  /// Of a terminal that is a heart.
  const Heart &heart(const unsigned int node) const { return loose_end(node).terminal.chamber(); }
  double time() const { return now; } ///< [s]
  double volume() const;              ///< of all liquid [m^3]
  /// Of liquid, walls, compliances and inertances [J]; without what the memory of walls stores.
  double energy() const;
  /// What has flowed in through loose ends since the start, less what has flowed out [m^3].
  double inflow() const { return entered; }
  unsigned int n_steps() const { return steps; }

  /// At rest under a pressure [Pa] where the height is zero. Throws std::domain_error.
  void start_at_rest(double pressure);
  /// Goes on to a time [s] in equal steps whose Courant number is at most `courant_number`, and
  /// which are not longer than `most` [s]. Throws StepFailure with time, vessel and place.
  void advance(double end_time,
               double courant_number,
               double most = std::numeric_limits<double>::infinity());

  // At the ends of a body.
  /// With a Courant number of 1 from the present state [s].
  double largest_step() const;
  /// Goes on to a time [s] in equal steps of this number. False if one of them is longer than
  /// largest_step() allows: the state is none then. Throws StepFailure.
  [[nodiscard]] bool advance_in(double end_time, unsigned int n_steps);
  /// Of a loose end, or of a node of elements: its pressure [Pa] in the last stage, and its mean
  /// over the time of the last advance_in().
  double end_pressure(unsigned int node) const;
  double mean_pressure(unsigned int node) const;
  /// The end of a vessel there, or null.
  const EndWave *vessel_at(unsigned int node) const;
  /// Hands over what a step changes.
  void visit(StateNumbers &numbers);
  /// The same without the time and what is counted since the start: what the further course depends
  /// on.
  void visit_state(StateNumbers &numbers);

private:
  friend class SteadyNetwork;
  struct Loose
  {
    Terminal terminal;
    double first_inflow;
    unsigned int node;
    double first_pressure = 0.; ///< in the first stage [Pa]
    double mean_pressure = 0.;  ///< over the steps of advance_in() [Pa]
  };
  std::vector<Edge> edges;
  std::vector<Loose> loose_ends;
  std::vector<Junction> junctions;
  Circuit elements;
  std::vector<double> means_of_elements; ///< by node, over the steps of advance_in() [Pa]
  unsigned int n_nodes;
  double now = 0., entered = 0.;
  unsigned int steps = 0;

  const Loose &loose_end(unsigned int node) const;
  void step(double length);
  void step_vessels(double length);
  /// The implicit stage of vessels with a memory.
  void solve_memory(bool at_end_of_step, double length);
  void solve_nodes(bool at_end_of_step, double length);
  void check_state() const;
};
} // namespace Continua

#endif
