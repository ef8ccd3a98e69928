#ifndef continua_network_memory_nodes_h
#define continua_network_memory_nodes_h

#include <continua/network/terminal.h>
#include <continua/network/vessel.h>

#include <vector>

namespace Continua
{
/**
 * The implicit stage of vessels whose walls relax: the flow rates of all ends at once. At an end
 * stand beside each other the linear wave of the vessel (Vessel::linear_end), the pressure of the
 * memory, and what the node demands: of a junction that no liquid is lost and that all ends have
 * the same p + rho alpha U^2/2, of a loose end the law of its terminal. One linear equation a node.
 */
class MemoryNodes
{
public:
  struct Edge
  {
    Vessel *vessel;
    unsigned int from, to; ///< nodes
  };
  /// `terminals`: by node; none where vessels meet.
  MemoryNodes(std::vector<Edge> edges, unsigned int n_nodes);

  /// One of the two stages of a step from `time` [s]. `terminals` by node, null at junctions.
  /// Throws std::domain_error.
  void solve(const std::vector<const Terminal *> &terminals, bool second, double time, double step);

private:
  /// The flow rates of the two ends of a vessel by what its nodes have [Pa]: constant, of the start
  /// node, of the end node.
  struct Flows
  {
    VesselMemory::Affine start, end;
  };
  std::vector<Edge> edges;
  unsigned int n_nodes;

  Flows flows_of(const Edge &edge, const std::vector<Terminal::LinearLaw> &laws) const;
};
} // namespace Continua

#endif
