#ifndef continua_mesh_structured_mesh_h
#define continua_mesh_structured_mesh_h

#include <deal.II/grid/tria.h>

#include <array>
#include <functional>
#include <vector>

namespace Continua
{
/**
 * A logically rectangular coarse mesh: the tensor product of one list of coordinates for each
 * direction, carried to its place by a smooth map. What all geometries by name are made of.
 */
template <int dim>
class StructuredMesh
{
public:
  /// The place of a cell in each direction.
  using CellIndex = std::array<unsigned int, dim>;
  using RegionOfCell = std::function<unsigned int(const CellIndex &)>;
  /// The second argument is deal.II's face number: 2 * direction + (0 for the lower, 1 for the
  /// upper side).
  using BoundaryOfFace = std::function<unsigned int(const CellIndex &, unsigned int)>;
  using Map = std::function<dealii::Point<dim>(const dealii::Point<dim> &)>;

  /// `points`: for each direction the ascending coordinates of the vertices [m], at least two.
  explicit StructuredMesh(const std::vector<std::vector<double>> &points);

  /**
   * Fills the empty triangulation (of any kind; on a distributed one, alike on every rank).
   * `region` gives the material id of a cell, `boundary` the boundary id of a face (and of its
   * edges); `map` must keep the orientation.
   */
  void create(
      dealii::Triangulation<dim> &triangulation,
      const RegionOfCell &region,
      const BoundaryOfFace &boundary,
      const Map &map = [](const dealii::Point<dim> &point) { return point; }) const;

private:
  const std::vector<std::vector<double>> points;
};
} // namespace Continua

#endif
