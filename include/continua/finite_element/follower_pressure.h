#ifndef continua_finite_element_follower_pressure_h
#define continua_finite_element_follower_pressure_h

#include <continua/continuum/kinematics.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/space.h>
#include <continua/time_integration/step.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/table.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <map>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * A given pressure on the faces of a body in finite deformation: it follows the faces,
 *
 *   - int v . p n da,   n da = J F^-T N dA.
 *
 * The linear loads have -int v . p N dA, which is therefore taken off here. What acts on the faces
 * is found once for a mesh.
 */
template <int dim>
class FollowerPressure
{
public:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  /// Both must outlive it.
  FollowerPressure(const Space<dim> &space, const Problem &problem);

  /// The mesh has changed.
  void reinit();
  /// Whether the cell has a face with a given pressure.
  bool has_face(const Cell &cell) const { return faces_of_cells.count(number_of(cell)) > 0; }
  /// Adds the forces on the cell's velocities [N], component by component, at the pressures of the
  /// step, less those on the body at rest.
  void add(const Cell &cell,
           const Step &step,
           const dealii::Vector<double> &displacement,
           dealii::Vector<double> &forces) const;
  /// Adds minus their derivative by the displacement times `factor`.
  void subtract_derivative(const Cell &cell,
                           const Step &step,
                           const dealii::Vector<double> &displacement,
                           double factor,
                           dealii::FullMatrix<double> &matrix) const;

private:
  struct Point
  {
    dealii::Point<dim> place;
    dealii::Tensor<1, 3> area; ///< N dA [m^2]
    double hoop = 0.;          ///< 1/R in axisymmetry, else 0 [1/m]
    /// Of the shape functions of a component.
    std::vector<double> values;
    std::vector<dealii::Tensor<1, dim>> gradients;
  };
  struct Face
  {
    const BoundaryPart *part;
    std::vector<Point> points;
  };

  const Space<dim> &space;
  const Problem &problem;
  const dealii::QGauss<dim - 1> quadrature;
  std::map<std::pair<int, int>, std::vector<Face>> faces_of_cells; ///< by level and index

  static std::pair<int, int> number_of(const Cell &cell) { return {cell->level(), cell->index()}; }
  static Kinematics kinematics(const Point &point, const dealii::Vector<double> &displacement);
  /// Of the step [Pa].
  static double pressure_at(const Point &point, const Face &face, const Step &step);
};
} // namespace Continua

#endif
