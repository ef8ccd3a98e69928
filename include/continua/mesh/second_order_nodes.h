#ifndef continua_mesh_second_order_nodes_h
#define continua_mesh_second_order_nodes_h

#include <continua/mesh/quadratic_cell_manifold.h>

#include <deal.II/grid/tria.h>

#include <map>
#include <vector>

namespace Continua
{
/**
 * The nodes in the middle of edges, faces and cells of a mesh of second order from a file of gmsh.
 * A node is found by the vertices between which it lies, so that cells that share an edge or a face
 * share its node, whatever their orientation is. A node that the file does not have (in the middle
 * of an element with 8 or 20 nodes) is where the incomplete polynomial of those elements has it.
 */
template <int dim>
class SecondOrderNodes
{
public:
  /// Whether there are none: all cells are straight.
  bool empty() const { return middles.empty(); }
  /// Takes the nodes of a cell. `nodes`: their places in `points`, in gmsh's order; 8 or 9, in
  /// three dimensions 20 or 27. Returns the vertices of an edge or face for which another cell has
  /// another node; empty if all fits.
  std::vector<unsigned int> add(const std::vector<unsigned int> &nodes,
                                const std::vector<dealii::Point<dim>> &points);
  /// Whether a cell, by its vertices in deal.II's order, is in the order of its directions
  /// (1), in the opposite one (-1), or is invalid (0): the map turns over or has no volume.
  int orientation(const std::vector<unsigned int> &vertices,
                  const std::vector<dealii::Point<dim>> &points) const;
  /// Gives the vertices other numbers, by their present ones.
  void renumber(const std::map<unsigned int, unsigned int> &new_numbers);
  /// Makes the cells of the coarse mesh that are not straight manifolds. The vertices of the mesh
  /// have the numbers of these nodes.
  void attach(dealii::Triangulation<dim> &triangulation) const;

private:
  /// `vertices` in deal.II's order.
  QuadraticCellManifold<dim> cell(const std::vector<unsigned int> &vertices,
                                  const std::vector<dealii::Point<dim>> &points) const;

  /// By the vertices in increasing order [m].
  std::map<std::vector<unsigned int>, dealii::Point<dim>> middles;
};
} // namespace Continua

#endif
