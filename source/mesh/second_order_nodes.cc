#include <continua/mesh/gmsh_element_type.h>
#include <continua/mesh/second_order_nodes.h>

#include <algorithm>
#include <array>
#include <utility>

namespace Continua
{
using dealii::Point;

template <int dim>
std::vector<unsigned int> SecondOrderNodes<dim>::add(const std::vector<unsigned int> &nodes,
                                                     const std::vector<Point<dim>> &points)
{
  constexpr unsigned int n_corners = 1u << dim;
  const std::vector<std::vector<unsigned int>> &corners = corners_of_gmsh_nodes<dim>();
  for (unsigned int node = n_corners; node < nodes.size(); ++node)
  {
    std::vector<unsigned int> between;
    for (const unsigned int corner : corners[node - n_corners])
      between.push_back(nodes[corner]);
    std::sort(between.begin(), between.end());
    const Point<dim> &middle = points[nodes[node]];
    const auto [known, is_new] = middles.emplace(between, middle);
    // Files that have a node once for each element write it with few digits.
    const double tolerance = 1e-6 * points[between.front()].distance(points[between.back()]);
    if (!is_new && known->second.distance(middle) > tolerance)
      return between;
  }
  return {};
}

template <int dim>
QuadraticCellManifold<dim> SecondOrderNodes<dim>::cell(const std::vector<unsigned int> &vertices,
                                                       const std::vector<Point<dim>> &points) const
{
  using Cell = QuadraticCellManifold<dim>;
  typename Cell::Nodes nodes;
  std::array<std::vector<unsigned int>, Cell::n_nodes> corners;
  for (unsigned int node = 0; node < Cell::n_nodes; ++node)
    corners[node] = Cell::corners_of_node(node);
  // In the middle of 4 or 8 corners, of the file's element with 8 or 20 nodes.
  const auto incomplete_middle = [&](const std::vector<unsigned int> &of)
  {
    Point<dim> sum;
    for (unsigned int node = 0; node < Cell::n_nodes; ++node)
      if (corners[node].size() <= 2 &&
          std::includes(of.begin(), of.end(), corners[node].begin(), corners[node].end()))
        sum += (corners[node].size() == 1 ? -0.25 : 2. / of.size()) * nodes[node];
    return sum;
  };
  // Corners first, then edges, faces and the cell.
  for (const unsigned int n_corners : {1u, 2u, 4u, 8u})
    for (unsigned int node = 0; node < Cell::n_nodes; ++node)
    {
      if (corners[node].size() != n_corners)
        continue;
      std::vector<unsigned int> between;
      for (const unsigned int corner : corners[node])
        between.push_back(vertices[corner]);
      std::sort(between.begin(), between.end());
      const auto known = middles.find(between);
      nodes[node] = n_corners == 1           ? points[between.front()]
                    : known != middles.end() ? known->second
                                             : incomplete_middle(corners[node]);
    }
  return Cell(nodes);
}

template <int dim>
int SecondOrderNodes<dim>::orientation(const std::vector<unsigned int> &vertices,
                                       const std::vector<Point<dim>> &points) const
{
  const auto [least, largest] = cell(vertices, points).range_of_determinants();
  return least > 0. ? 1 : largest < 0. ? -1 : 0;
}

template <int dim>
void SecondOrderNodes<dim>::renumber(const std::map<unsigned int, unsigned int> &new_numbers)
{
  std::map<std::vector<unsigned int>, Point<dim>> renumbered;
  for (const auto &[vertices, middle] : middles)
  {
    std::vector<unsigned int> between;
    for (const unsigned int vertex : vertices)
      between.push_back(new_numbers.at(vertex));
    std::sort(between.begin(), between.end());
    renumbered.emplace(between, middle);
  }
  middles = std::move(renumbered);
}

template <int dim>
void SecondOrderNodes<dim>::attach(dealii::Triangulation<dim> &triangulation) const
{
  if (empty())
    return;
  for (const auto &coarse_cell : triangulation.cell_iterators_on_level(0))
  {
    std::vector<unsigned int> vertices;
    for (const unsigned int v : coarse_cell->vertex_indices())
      vertices.push_back(coarse_cell->vertex_index(v));
    const QuadraticCellManifold<dim> manifold = cell(vertices, triangulation.get_vertices());
    if (manifold.is_straight())
      continue;
    coarse_cell->set_all_manifold_ids(coarse_cell->index());
    triangulation.set_manifold(coarse_cell->index(), manifold);
  }
}

template class SecondOrderNodes<2>;
template class SecondOrderNodes<3>;
} // namespace Continua
