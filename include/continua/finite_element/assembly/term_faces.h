#ifndef continua_finite_element_assembly_term_faces_h
#define continua_finite_element_assembly_term_faces_h

#include <continua/continuum/problem.h>
#include <continua/finite_element/space/deformed_face_point.h>
#include <continua/finite_element/space/quadrature_cells.h>
#include <continua/finite_element/space/space.h>

#include <deal.II/base/quadrature.h>

#include <map>
#include <utility>
#include <vector>

namespace Continua
{
/// A face on which terms of its cell act.
template <int dim>
struct TermFace
{
  const BoundaryCondition *condition;
  int unknown_pressure;    ///< its number, or -1
  bool has_traction;       ///< that is given and follows the present shape
  bool has_total_pressure; ///< where liquid flows in
  std::vector<DeformedFacePoint<dim>> points;
  /// Of a face with the total pressure: the shape functions of the pressure, [point][function].
  std::vector<std::vector<double>> pressure_values;
};

/// The faces on which terms act, of the cells of one RegionModel, with all that integrals over them
/// need besides the state: made once for a mesh.
template <int dim>
class TermFaces
{
public:
  using Cell = QuadratureCell<dim>;

  /// Both must outlive it.
  TermFaces(const Space<dim> &space, const Problem &problem);

  /// The mesh has changed; `cells`: those of the model.
  void reinit(const std::vector<Cell> &cells);
  /// The faces of a cell.
  const std::vector<TermFace<dim>> &of(const Cell &cell) const
  {
    if (faces_of_cells.empty())
      return none;
    const auto found = faces_of_cells.find(number_of(cell));
    return found == faces_of_cells.end() ? none : found->second;
  }

private:
  const Space<dim> &space;
  const Problem &problem;
  const std::vector<TermFace<dim>> none;
  std::map<std::pair<int, int>, std::vector<TermFace<dim>>> faces_of_cells; ///< by level and index

  static std::pair<int, int> number_of(const Cell &cell)
  {
    return {cell.velocity_cell->level(), cell.velocity_cell->index()};
  }
  /// Whether what flows in through a condition's faces of a region has the total pressure.
  bool has_total_pressure(unsigned int region, const BoundaryCondition &condition) const;
};
} // namespace Continua

#endif
