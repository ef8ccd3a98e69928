#ifndef continua_finite_element_assembly_cell_assembly_h
#define continua_finite_element_assembly_cell_assembly_h

#include <continua/finite_element/space/point_table.h>
#include <continua/finite_element/space/quadrature_cells.h>
#include <continua/finite_element/terms/point_change.h>
#include <continua/finite_element/terms/tested.h>

#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace Continua
{
/**
 * From what terms give at the quadrature points of a cell: the cell's rows, and the matrix of their
 * derivative. A derivative is linear in the value and the gradient of a change, so that the terms
 * are differentiated in these few directions at a point, and not for each shape function: the rest
 * is sums of products. All is done on the reference cell, whose shape functions are the same for
 * all cells.
 */
template <int dim>
class CellAssembly
{
public:
  /// The inverse of a Jacobian as QuadratureCell has it.
  using Jacobian = dealii::Tensor<2, dim>;

  /// Which changes have an effect besides those of velocity, its gradient and pressure.
  struct Directions
  {
    bool pressure_gradient = false;
    /// The viscous force of each velocity of the cell (StreamlinePoint), or null: it has none.
    const std::vector<dealii::Tensor<1, dim>> *viscous_forces = nullptr;
  };

  /// The cells must outlive it. Without pressures the unknowns of a cell are velocities alone, or
  /// what stands in their place.
  explicit CellAssembly(const QuadratureCells<dim> &cells, const bool has_pressures = true)
      : cells(cells),
        n_pressures(has_pressures ? cells.n_pressures() : 0),
        velocity_table(cells, PointTable<dim>::Field::velocity, true),
        pressure_table(cells, PointTable<dim>::Field::pressure, false),
        momentum_at_points(dim * velocity_table.size(), 0.),
        volume_at_points(pressure_table.size(), 0.)
  {
  }

  /// Adds what a point gives, times its weight, to what finish_rows() sums.
  void add(const unsigned int q,
           const Jacobian &inverse_jacobian,
           const double weight,
           const Tested<dim> &tested)
  {
    Column column;
    set_column(inverse_jacobian, weight, tested, column);
    for (unsigned int c = 0; c < dim; ++c)
    {
      double *const of_component = &momentum_at_points[c * velocity_table.size()];
      for (unsigned int s = 0; s <= dim; ++s)
        of_component[velocity_table.place(q, s)] += column.of_momentum[c][s];
    }
    volume_at_points[q] += column.of_volume;
  }
  /// What add() adds to, to be set by others before it.
  NumbersAtPoints<double> momentum() { return {momentum_at_points.data(), velocity_table.size()}; }
  double *volume() { return volume_at_points.data(); }
  /// Sets the rows of momentum, component by component, and of volume, and begins anew.
  void finish_rows(dealii::Vector<double> &momentum, dealii::Vector<double> &volume);
  /// Likewise those of momentum alone.
  void finish_rows(dealii::Vector<double> &momentum);
  /// Takes the derivative at a point, times its weight, for finish_matrix(): once for each of all
  /// points. `differentiate(change, tested)` sets what the derivative in the direction of a
  /// PointChange gives.
  template <typename Differentiate>
  void take_derivative(const unsigned int q,
                       const Jacobian &inverse_jacobian,
                       const double weight,
                       const Directions &directions,
                       const Differentiate &differentiate)
  {
    const auto take = [&](const PointChange<dim> &change, Column &column)
    {
      Tested<dim> tested;
      differentiate(change, tested);
      set_column(inverse_jacobian, weight, tested, column);
    };
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int k = 0; k <= dim; ++k)
      {
        PointChange<dim> change;
        if (k == 0)
          change.velocity[d] = 1.;
        else
          change.velocity_gradient[d] = inverse_jacobian[k - 1];
        take(change, by_velocity[d][k]);
      }
    for (unsigned int k = 0; n_pressures > 0 && k <= (directions.pressure_gradient ? dim : 0); ++k)
    {
      PointChange<dim> change;
      if (k == 0)
        change.pressure = 1.;
      else
        change.pressure_gradient = inverse_jacobian[k - 1];
      take(change, by_pressure[k]);
    }
    for (unsigned int d = 0; directions.viscous_forces != nullptr && d < dim; ++d)
    {
      PointChange<dim> change;
      change.viscous_force[d] = 1.;
      take(change, by_viscous_force[d]);
    }
    set_rows_of_point(q, directions);
  }
  /// Likewise of what FlowTermsAtPoints or SolidTermsAtPoints have set at a point.
  void take_derivative(unsigned int q, const double *numbers, bool has_pressure_gradient);
  /// Sets the matrix of the cell: velocities first, rows of volume times -1.
  void finish_matrix(dealii::FullMatrix<double> &matrix);

private:
  /// What a direction gives, by the values (0) and the derivatives along the coordinates of the
  /// reference cell (1 ...) of test functions.
  struct Column
  {
    std::array<std::array<double, dim + 1>, dim> of_momentum;
    double of_volume;
  };

  const QuadratureCells<dim> &cells;
  const unsigned int n_pressures; ///< of a cell
  const PointTable<dim> velocity_table, pressure_table;
  // What add() has added: by the numbers of a row of each table, of momentum component by
  // component.
  std::vector<double> momentum_at_points, volume_at_points;
  // Of the present point: by the value (0) or a derivative (1 ...) of a component.
  std::array<std::array<Column, dim + 1>, dim> by_velocity;
  std::array<Column, dim + 1> by_pressure;
  std::array<Column, dim> by_viscous_force;
  /// Of all points: what each trial function gives (a column of the matrix) by the value and the
  /// derivatives of a test function, for each component of momentum; dim + 1 rows a point.
  std::array<dealii::FullMatrix<double>, dim> of_momentum;
  dealii::FullMatrix<double>
      of_volume; ///< likewise by its value, a row a point, times -1; without pressures empty

  static void set_column(const Jacobian &inverse_jacobian,
                         double weight,
                         const Tested<dim> &tested,
                         Column &column);
  void set_rows_of_point(unsigned int q, const Directions &directions);
};
} // namespace Continua

#endif
