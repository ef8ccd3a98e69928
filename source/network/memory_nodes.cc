#include <continua/network/memory_nodes.h>

#include <continua/network/solve_rows.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
using Affine = VesselMemory::Affine;
} // namespace

MemoryNodes::MemoryNodes(std::vector<Edge> edges, const unsigned int n_nodes)
    : edges(std::move(edges)), n_nodes(n_nodes)
{
}

MemoryNodes::Flows MemoryNodes::flows_of(const Edge &edge,
                                         const std::vector<Terminal::LinearLaw> &laws) const
{
  // What an end has [Pa], by the flow rates of both.
  const auto head_of = [&](const Vessel::End end)
  {
    const bool at_end = end == Vessel::End::end;
    const unsigned int node = at_end ? edge.to : edge.from;
    const Terminal::LinearLaw &law = laws[node];
    const Vessel::LinearEnd line = edge.vessel->linear_end(end);
    const Affine inside = edge.vessel->memory()->flow_inside(at_end),
                 memory = edge.vessel->memory()->end_pressure(at_end);
    const double outwards = at_end ? line.impedance : -line.impedance;
    return Affine{
        line.pressure + outwards * inside.constant + law.memory_share * memory.constant +
            (law.of_pressure == 0. && law.of_flow == 0. ? line.dynamic_pressure : 0.),
        outwards * inside.of_start + law.memory_share * memory.of_start - (at_end ? 0. : outwards),
        outwards * inside.of_end + law.memory_share * memory.of_end - (at_end ? outwards : 0.)};
  };
  const Affine start = head_of(Vessel::End::start), end = head_of(Vessel::End::end);
  const double determinant = start.of_start * end.of_end - start.of_end * end.of_start;
  return {{(-end.of_end * start.constant + start.of_end * end.constant) / determinant,
           end.of_end / determinant, -start.of_end / determinant},
          {(end.of_start * start.constant - start.of_start * end.constant) / determinant,
           -end.of_start / determinant, start.of_start / determinant}};
}

void MemoryNodes::solve(const std::vector<const Terminal *> &terminals,
                        const bool second,
                        const double time,
                        const double step)
{
  // Zeros at junctions.
  std::vector<Terminal::LinearLaw> laws(n_nodes, {0., 0., 0., 1.});
  for (unsigned int node = 0; node < n_nodes; ++node)
    if (terminals[node] != nullptr)
      laws[node] = terminals[node]->linear_law(second, time, step);
  Rows rows(n_nodes, std::vector<double>(n_nodes + 1, 0.));
  for (unsigned int node = 0; node < n_nodes; ++node)
    if (terminals[node] != nullptr)
    {
      rows[node][node] = laws[node].of_pressure;
      rows[node][n_nodes] = laws[node].right;
    }
  std::vector<Flows> flows;
  for (const Edge &edge : edges)
  {
    edge.vessel->begin_memory_stage(second, step);
    flows.push_back(flows_of(edge, laws));
    const auto add = [&](const unsigned int node, const double sign, const Affine &flow)
    {
      const double factor = sign * (terminals[node] != nullptr ? laws[node].of_flow : 1.);
      rows[node][edge.from] += factor * flow.of_start;
      rows[node][edge.to] += factor * flow.of_end;
      rows[node][n_nodes] -= factor * flow.constant;
    };
    add(edge.from, -1., flows.back().start);
    add(edge.to, 1., flows.back().end);
  }
  std::vector<double> heads;
  if (!solve_rows(rows, heads))
    throw std::domain_error("the flow rates at the ends of walls that relax were not found");
  for (std::size_t i = 0; i < edges.size(); ++i)
    edges[i].vessel->end_memory_stage(flows[i].start.at(heads[edges[i].from], heads[edges[i].to]),
                                      flows[i].end.at(heads[edges[i].from], heads[edges[i].to]));
}
} // namespace Continua
