#include <continua/finite_element/assembly/cell_assembly.h>

#include <deal.II/base/types.h>
#include <deal.II/lac/lapack_templates.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

namespace
{
/// Adds the sum of factors times rows of a table, each of `n` entries, to a target.
template <std::size_t n_rows>
void add_rows_of_table(const std::array<double, n_rows> &factors,
                       const double *const table,
                       const std::size_t n,
                       double *const target)
{
  DEAL_II_OPENMP_SIMD_PRAGMA
  for (std::size_t b = 0; b < n; ++b)
  {
    double sum = factors[0] * table[b];
    for (std::size_t k = 1; k < n_rows; ++k)
      sum += factors[k] * table[k * n + b];
    target[b] += sum;
  }
}
} // namespace

template <int dim>
void CellAssembly<dim>::set_column(const Jacobian &inverse_jacobian,
                                   const double weight,
                                   const Tested<dim> &tested,
                                   Column &column)
{
  for (unsigned int c = 0; c < dim; ++c)
  {
    column.of_momentum[c][0] = weight * tested.by_value[c];
    const Tensor<1, dim> by_gradient = inverse_jacobian * tested.by_gradient[c];
    for (unsigned int s = 0; s < dim; ++s)
      column.of_momentum[c][s + 1] = weight * by_gradient[s];
  }
  column.of_volume = weight * tested.of_volume;
}

template <int dim>
void CellAssembly<dim>::finish_rows(Vector<double> &momentum, Vector<double> &volume)
{
  finish_rows(momentum);
  pressure_table.set_sums(volume_at_points.data(), volume.begin());
  std::fill(volume_at_points.begin(), volume_at_points.end(), 0.);
}

template <int dim>
void CellAssembly<dim>::finish_rows(Vector<double> &momentum)
{
  for (unsigned int c = 0; c < dim; ++c)
    velocity_table.set_sums(&momentum_at_points[c * velocity_table.size()],
                            momentum.begin() + c * velocity_table.n_functions());
  std::fill(momentum_at_points.begin(), momentum_at_points.end(), 0.);
}

template <int dim>
void CellAssembly<dim>::set_rows_of_point(const unsigned int q, const Directions &directions)
{
  const std::size_t n_functions = cells.n_functions(), n_velocity = dim * n_functions,
                    n_unknowns = n_velocity + n_pressures;
  if (of_momentum[0].empty())
  {
    for (FullMatrix<double> &rows : of_momentum)
      rows.reinit((dim + 1) * cells.n_points(), n_unknowns);
    if (n_pressures > 0)
      of_volume.reinit(cells.n_points(), n_unknowns);
  }
  const double *const table = cells.table(q), *const of_pressure = cells.pressure_table(q);
  std::array<double, dim + 1> factors;
  // `entry(column)`: what a row has of a direction.
  const auto set_row = [&](double *const row, const auto &entry)
  {
    std::fill(row, row + n_unknowns, 0.);
    for (unsigned int d = 0; d < dim; ++d)
    {
      for (unsigned int k = 0; k <= dim; ++k)
        factors[k] = entry(by_velocity[d][k]);
      add_rows_of_table(factors, table, n_functions, row + d * n_functions);
    }
    if (directions.pressure_gradient)
    {
      for (unsigned int k = 0; k <= dim; ++k)
        factors[k] = entry(by_pressure[k]);
      add_rows_of_table(factors, of_pressure, n_pressures, row + n_velocity);
    }
    else
      add_rows_of_table(std::array<double, 1>{{entry(by_pressure[0])}}, of_pressure, n_pressures,
                        row + n_velocity);
    if (directions.viscous_forces == nullptr)
      return;
    for (unsigned int d = 0; d < dim; ++d)
    {
      const double factor = entry(by_viscous_force[d]);
      for (unsigned int j = 0; j < n_velocity; ++j)
        row[j] += factor * (*directions.viscous_forces)[j][d];
    }
  };
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int s = 0; s <= dim; ++s)
      set_row(&of_momentum[c]((dim + 1) * q + s, 0),
              [c, s](const Column &column) { return column.of_momentum[c][s]; });
  if (n_pressures > 0)
    set_row(&of_volume(q, 0), [](const Column &column) { return -column.of_volume; });
}

template <int dim>
void CellAssembly<dim>::take_derivative(const unsigned int q,
                                        const double *numbers,
                                        const bool has_pressure_gradient)
{
  const auto take = [&numbers](Column &column)
  {
    for (std::array<double, dim + 1> &of_component : column.of_momentum)
      for (double &number : of_component)
        number = *numbers++;
    column.of_volume = *numbers++;
  };
  for (std::array<Column, dim + 1> &of_component : by_velocity)
    for (Column &column : of_component)
      take(column);
  for (unsigned int k = 0; k <= (has_pressure_gradient ? dim : 0); ++k)
    take(by_pressure[k]);
  set_rows_of_point(q, {has_pressure_gradient, nullptr});
}

template <int dim>
void CellAssembly<dim>::finish_matrix(FullMatrix<double> &matrix)
{
  const std::size_t n_functions = cells.n_functions(), n_unknowns = of_momentum[0].n();
  if (matrix.m() != n_unknowns || matrix.n() != n_unknowns)
    matrix.reinit(n_unknowns, n_unknowns, true);
  // Sums over the points of values and derivatives of test functions times these rows. For BLAS,
  // which stores by columns, each of the three matrices is its transposed.
  const auto multiply = [n_unknowns](const double *const tests, const std::size_t n_tests,
                                     const FullMatrix<double> &rows, double *const result)
  {
    const types::blas_int n_rows = rows.m(), n_columns = n_unknowns, n = n_tests;
    const double one = 1., zero = 0.;
    gemm("N", "T", &n_columns, &n, &n_rows, &one, &rows(0, 0), &n_columns, tests, &n, &zero, result,
         &n_columns);
  };
  for (unsigned int c = 0; c < dim; ++c)
    multiply(cells.table(0), n_functions, of_momentum[c], &matrix(c * n_functions, 0));
  if (n_pressures > 0)
    multiply(cells.pressure_values(0), n_pressures, of_volume, &matrix(dim * n_functions, 0));
}

template class CellAssembly<2>;
template class CellAssembly<3>;
} // namespace Continua
