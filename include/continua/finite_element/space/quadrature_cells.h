#ifndef continua_finite_element_space_quadrature_cells_h
#define continua_finite_element_space_quadrature_cells_h

#include <continua/continuum/problem.h>
#include <continua/finite_element/space/numbers_at_points.h>
#include <continua/finite_element/space/space.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/base/table.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/vector.h>

#include <functional>
#include <vector>

namespace Continua
{
/// A cell as QuadratureCells keeps it.
template <int dim>
struct QuadratureCell
{
  using Point = CellPoint<dim>;

  typename dealii::DoFHandler<dim>::active_cell_iterator velocity_cell, pressure_cell;
  unsigned int region = 0;
  double size = 0.; ///< Convection::cell_size() [m]
  /// The dofs, of the velocity component by component.
  std::vector<dealii::types::global_dof_index> velocity_indices, pressure_indices;
  /// Their places in vectors with ghost entries.
  std::vector<int> velocity_places, pressure_places;
  std::vector<Point> points;
};

/// The entries of a vector with ghosts at a cell's places.
void set_entries(const std::vector<int> &places,
                 const DistributedVector &from,
                 dealii::Vector<double> &values);

/**
 * The owned cells of some regions, such as those of one model, with all that integrals over them
 * need besides the state: made once for a mesh. Shape functions are kept for the reference cell
 * alone; a gradient there times the inverse of the Jacobian is that in the body.
 */
template <int dim>
class QuadratureCells
{
public:
  /// Space and problem must outlive it.
  QuadratureCells(const Space<dim> &space,
                  const Problem &problem,
                  const dealii::Quadrature<dim> &quadrature,
                  RegionModel model);
  /// Of the regions of which `takes` is true, by their material ids.
  QuadratureCells(const Space<dim> &space,
                  const dealii::Quadrature<dim> &quadrature,
                  const std::function<bool(unsigned int region)> &takes);

  /// The mesh has changed.
  void reinit();

  /// In the order of the tree.
  const std::vector<QuadratureCell<dim>> &all() const { return cells; }
  unsigned int n_points() const { return quadrature.size(); }
  /// Shape functions of one component of the velocity, and of the pressure in one region.
  unsigned int n_functions() const { return shapes.size(1); }
  unsigned int n_pressures() const { return pressure_shapes.size(1); }
  /// The values of the shape functions at a point, one after the other.
  const double *values(const unsigned int q) const { return &shapes(q, 0); }
  const double *pressure_values(const unsigned int q) const { return &pressure_shapes(q, 0); }
  /// Their gradients on the reference cell.
  const dealii::Tensor<1, dim> *gradients(const unsigned int q) const { return &slopes(q, 0); }
  const dealii::Tensor<1, dim> *pressure_gradients(const unsigned int q) const
  {
    return &pressure_slopes(q, 0);
  }
  /// All of these, one row of n_functions() after the other: the values, then the derivatives along
  /// each coordinate of the reference cell.
  const double *table(const unsigned int q) const { return &values_and_slopes(q, 0); }
  /// Likewise of the pressure, n_pressures() a row.
  const double *pressure_table(const unsigned int q) const
  {
    return &pressure_values_and_slopes(q, 0);
  }
  /// The 3x3 gradient by the reference place of a vector with these entries in a cell, component by
  /// component: in axisymmetry with its radial component over the radius.
  dealii::Tensor<2, 3> gradient(const QuadratureCell<dim> &cell,
                                const dealii::Vector<double> &entries,
                                unsigned int q) const;

private:
  const Space<dim> &space;
  const dealii::Quadrature<dim> quadrature;
  const std::function<bool(unsigned int)> takes;
  // [point][function]
  dealii::Table<2, double> shapes, pressure_shapes;
  dealii::Table<2, dealii::Tensor<1, dim>> slopes, pressure_slopes;
  dealii::Table<2, double> values_and_slopes, pressure_values_and_slopes;
  std::vector<QuadratureCell<dim>> cells;
};
} // namespace Continua

#endif
