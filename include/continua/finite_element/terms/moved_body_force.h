#ifndef continua_finite_element_terms_moved_body_force_h
#define continua_finite_element_terms_moved_body_force_h

#include <continua/continuum/problem.h>
#include <continua/finite_element/space/quadrature_cells.h>
#include <continua/finite_element/space/space.h>
#include <continua/time_integration/step.h>

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/base/tensor.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Continua
{
/**
 * The body forces in finite deformation, at the present place x = X + d:
 *
 *   int v . ( rho b(x) + f(x) ) dv
 *
 * with the acceleration b and the force density f. A liquid has its present volume dv and the
 * density rho of the material, a solid its volume dV and its density at rest. The linear loads have
 * the integral over the mesh at rest, at X, which is therefore taken off here.
 */
template <int dim>
class MovedBodyForce
{
public:
  using Cell = QuadratureCell<dim>;

  /// Both must outlive it; `quadrature`: that of the cells.
  MovedBodyForce(const Space<dim> &space,
                 const Problem &problem,
                 const dealii::Quadrature<dim> &quadrature);

  /// Whether the motion changes the forces on a region.
  bool has_changes(unsigned int region) const;
  /// Adds the change of the forces on the cell's velocities [N], component by component, at the
  /// displacement of the cell [m]; `present`: the points with their present weights.
  void add(const QuadratureCells<dim> &cells,
           const Cell &cell,
           const std::vector<typename Cell::Point> &present,
           const Step &step,
           const dealii::Vector<double> &displacement,
           dealii::Vector<double> &forces);
  /// Adds minus their derivative by the displacement at constant weights, times `factor`.
  void subtract_derivative(const QuadratureCells<dim> &cells,
                           const Cell &cell,
                           const Step &step,
                           const dealii::Vector<double> &displacement,
                           double factor,
                           dealii::FullMatrix<double> &matrix);

private:
  const Problem &problem;
  const bool depends_on_space;
  dealii::FEValues<dim> places; ///< at rest

  /// rho b + f of a region at a place [N/m^3].
  dealii::Tensor<1, dim>
  density(unsigned int region, const dealii::Point<dim> &place, const Step &step) const;
  /// How far a point of the cell has moved [m].
  static dealii::Tensor<1, dim> way(const QuadratureCells<dim> &cells,
                                    unsigned int q,
                                    const dealii::Vector<double> &displacement);
};
} // namespace Continua

#endif
