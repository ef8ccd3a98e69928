#ifndef continua_finite_element_terms_follower_pressure_h
#define continua_finite_element_terms_follower_pressure_h

#include <continua/continuum/problem.h>
#include <continua/finite_element/space/deformed_face_point.h>
#include <continua/finite_element/space/space.h>
#include <continua/time_integration/step.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <map>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * Pressures on the faces of a body in finite deformation, which follow the faces,
 *
 *   - int v . p n da,   n da = J F^-T N dA:
 *
 * those that are given, and those of cavities. On a liquid, whose mesh passes its matter, also
 * tractions that are given, int v . t da; there a pressure or a traction that depends on the place
 * has the present one, on a solid that of its matter at rest. The linear loads have the integral
 * over the faces at rest of what is given, which is therefore taken off here. What acts on the
 * faces is found once for a mesh.
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
  /// Takes the pressures of the cavities [Pa].
  void set_cavity_pressures(const std::vector<double> &pressures) { cavity_pressures = pressures; }
  /// Whether the cell has a face with a pressure.
  bool has_face(const Cell &cell) const { return faces_of_cells.count(number_of(cell)) > 0; }
  /// Adds the forces on the cell's velocities [N], component by component, at the pressures of the
  /// step; of given ones less those on the body at rest.
  void add(const Cell &cell,
           const Step &step,
           const dealii::Vector<double> &displacement,
           dealii::Vector<double> &forces) const;
  /// Adds minus their derivative by the displacement times `factor`, on a solid.
  void subtract_derivative(const Cell &cell,
                           const Step &step,
                           const dealii::Vector<double> &displacement,
                           double factor,
                           dealii::FullMatrix<double> &matrix) const;

private:
  struct Face
  {
    const BoundaryCondition *condition;
    int cavity; ///< its number, or -1
    bool is_of_liquid;
    std::vector<DeformedFacePoint<dim>> points;
  };

  const Space<dim> &space;
  const Problem &problem;
  const dealii::Quadrature<dim - 1> quadrature;
  std::map<std::pair<int, int>, std::vector<Face>> faces_of_cells; ///< by level and index
  std::vector<double> cavity_pressures;

  static std::pair<int, int> number_of(const Cell &cell) { return {cell->level(), cell->index()}; }
  /// Whether there is something to follow on a face of a condition.
  static bool acts(const BoundaryCondition &condition, bool is_on_liquid);
  /// The force of what is given on a liquid less that at rest [N].
  dealii::Tensor<1, dim> force_on_liquid(const DeformedFacePoint<dim> &point,
                                         const Face &face,
                                         const Step &step,
                                         const dealii::Vector<double> &displacement) const;
  /// Of the step [Pa].
  double pressure_at(const DeformedFacePoint<dim> &point, const Face &face, const Step &step) const;
};
} // namespace Continua

#endif
