#include <continua/finite_element/solvers/condensed_system.h>

#include <continua/base/nearly_equal.h>
#include <continua/linear_algebra/for_row.h>
#include <continua/mesh/cells_in_tree_order.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_FECrsMatrix.h>
#include <Epetra_Map.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
using Entries = std::vector<std::pair<int, double>>;

/// Sorts by column and adds what stands in the same one.
void merge(Entries &entries)
{
  std::sort(entries.begin(), entries.end(),
            [](const auto &a, const auto &b) { return a.first < b.first; });
  std::size_t last = 0;
  for (std::size_t k = 1; k < entries.size(); ++k)
    if (entries[k].first == entries[last].first)
      entries[last].second += entries[k].second;
    else
      entries[++last] = entries[k];
  if (!entries.empty())
    entries.resize(last + 1);
}

/// The constraints of every column of this rank's rows. Where hanging nodes lie on the border of
/// two ranks a row couples with dofs that are on none of this rank's cells, ghost cells included.
template <int dim>
AffineConstraints<double> constraints_of_columns(const Space<dim> &space,
                                                 const std::vector<RegionOperators> &operators,
                                                 const BoundaryConstraints<dim> &constraints)
{
  IndexSet columns = space.velocity_relevant;
  std::vector<types::global_dof_index> others;
  const auto collect = [&](const TrilinosWrappers::SparseMatrix &matrix, const unsigned int n_rows)
  {
    if (matrix.m() == 0)
      return; // a product without a matrix, or no part of this system
    for (unsigned int i = 0; i < n_rows; ++i)
      for_row(matrix, i,
              [&](const types::global_dof_index j, double)
              {
                if (!space.velocity_relevant.is_element(j))
                  others.push_back(j);
              });
  };
  for (const RegionOperators &region : operators)
  {
    // A stiffness has all the columns that the mass has.
    collect(region.stiffness, space.velocity_owned.n_elements());
    if (region.is_supported)
      collect(region.support_stiffness, space.velocity_owned.n_elements());
    collect(region.divergence, space.pressure_owned.n_elements());
  }
  std::sort(others.begin(), others.end());
  columns.add_indices(others.begin(), std::unique(others.begin(), others.end()));
  columns.compress();

  AffineConstraints<double> lines(columns);
  lines.merge(constraints.all(), AffineConstraints<double>::no_conflicts_allowed, true);
  if (Utilities::MPI::n_mpi_processes(space.communicator) > 1)
    lines.make_consistent_in_parallel(space.velocity_owned, columns, space.communicator);
  lines.close();
  return lines;
}

/// Condenses rows of this rank's operators: the boundary constraints go to their masters.
template <int dim>
class CondensedRows
{
public:
  CondensedRows(const Space<dim> &space,
                const std::vector<RegionOperators> &operators,
                const BoundaryConstraints<dim> &constraints)
      : space(space),
        operators(operators),
        lines(constraints_of_columns(space, operators, constraints))
  {
  }

  /// Calls add(i, entries) for the rows of A, in any order; what is given twice adds. `wanted`, if
  /// it is not null: the local indices of the rows that are given.
  template <typename Add>
  void for_velocity(const SystemCoefficients &coefficients,
                    const VolumetricStiffness *volumetric,
                    const std::vector<bool> *wanted,
                    const Add &add);
  /// The same for B and C.
  template <typename Add>
  void for_divergence(const SystemCoefficients &coefficients, const Add &add);
  template <typename Add>
  void for_compression(const std::vector<double> &compressibility, const Add &add);

private:
  const Space<dim> &space;
  const std::vector<RegionOperators> &operators;
  const AffineConstraints<double> lines;
  Entries row, condensed, row_masters, column_masters;

  void take(const TrilinosWrappers::SparseMatrix &matrix, unsigned int i, double factor);
  /// The free dofs that a velocity dof stands for, with their weights: the rows of T. Hanging nodes
  /// are condensed already: they stand in no row but their own.
  void find_masters(int index, Entries &masters) const;
  /// Columns go to their masters; the constrained ones stand for others.
  void condense();
};

template <int dim>
void CondensedRows<dim>::take(const TrilinosWrappers::SparseMatrix &matrix,
                              const unsigned int i,
                              const double factor)
{
  if (factor != 0.)
    for_row(matrix, i,
            [&](const int j, const double value) { row.emplace_back(j, factor * value); });
}

template <int dim>
void CondensedRows<dim>::find_masters(const int index, Entries &masters) const
{
  masters.clear();
  if (!lines.is_constrained(index))
    masters.emplace_back(index, 1.);
  else
    for (const auto &entry : *lines.get_constraint_entries(index))
      masters.emplace_back(entry.first, entry.second);
}

template <int dim>
void CondensedRows<dim>::condense()
{
  condensed.clear();
  merge(row);
  for (const auto &[column, value] : row)
  {
    find_masters(column, column_masters);
    for (const auto &[to_column, weight] : column_masters)
      condensed.emplace_back(to_column, weight * value);
  }
  merge(condensed);
}

template <int dim>
template <typename Add>
void CondensedRows<dim>::for_velocity(const SystemCoefficients &coefficients,
                                      const VolumetricStiffness *const volumetric,
                                      const std::vector<bool> *const wanted,
                                      const Add &add)
{
  for (unsigned int i = 0; i < space.velocity_owned.n_elements(); ++i)
  {
    if (wanted != nullptr && !(*wanted)[i])
      continue;
    const int global = space.velocity_owned.nth_index_in_set(i);
    if (lines.is_constrained(global))
      add(global, Entries{{global, 1.}});
    if (space.velocity_hanging.is_constrained(global))
      continue;
    find_masters(global, row_masters);
    if (row_masters.empty())
      continue;
    row.clear();
    for (unsigned int region = 0; region < operators.size(); ++region)
    {
      take(operators[region].mass, i, coefficients.mass[region]);
      take(operators[region].stiffness, i, coefficients.stiffness[region]);
      if (volumetric != nullptr && volumetric->coefficients[region] != 0.)
        take(volumetric->matrices[region], i, volumetric->coefficients[region]);
      if (operators[region].is_supported)
      {
        take(operators[region].support_stiffness, i, coefficients.support_stiffness);
        take(operators[region].support_damping, i, coefficients.support_damping);
      }
    }
    condense();
    for (const auto &[to_row, weight] : row_masters)
    {
      Entries weighted = condensed;
      for (auto &entry : weighted)
        entry.second *= weight;
      add(to_row, weighted);
    }
  }
}

template <int dim>
template <typename Add>
void CondensedRows<dim>::for_divergence(const SystemCoefficients &coefficients, const Add &add)
{
  for (unsigned int k = 0; k < space.pressure_owned.n_elements(); ++k)
  {
    const int global = space.pressure_owned.nth_index_in_set(k);
    if (space.pressure_hanging.is_constrained(global))
      continue;
    row.clear();
    for (unsigned int region = 0; region < operators.size(); ++region)
      take(operators[region].divergence, k, coefficients.has(region) ? 1. : 0.);
    condense();
    add(global, condensed);
  }
}

template <int dim>
template <typename Add>
void CondensedRows<dim>::for_compression(const std::vector<double> &compressibility, const Add &add)
{
  for (unsigned int k = 0; k < space.pressure_owned.n_elements(); ++k)
  {
    const int global = space.pressure_owned.nth_index_in_set(k);
    row.clear();
    if (space.pressure_hanging.is_constrained(global))
      row.emplace_back(global, 1.);
    else
      for (unsigned int region = 0; region < operators.size(); ++region)
        take(operators[region].pressure_mass, k, compressibility[region]);
    merge(row);
    add(global, row);
  }
}

/// Where the operators have products, the matrices of all cells would take more memory than a
/// factor of moderate size. They are made for so many parts of the cells, one after the other.
constexpr unsigned int n_parts_of_cells = 4;

/// Mass and stiffness of a part of the cells as matrices; with the supports in the first part.
template <int dim>
std::vector<RegionOperators> matrices_of_part(const Space<dim> &space,
                                              const std::vector<RegionOperators> &operators,
                                              const unsigned int part)
{
  const std::size_t n_cells = space.triangulation.n_active_cells();
  std::vector<RegionOperators> result(operators.size());
  assemble_velocity_operators<dim>(
      space,
      [&](const typename DoFHandler<dim>::active_cell_iterator &cell)
      { return cell->active_cell_index() * n_parts_of_cells / n_cells == part; },
      result);
  for (unsigned int region = 0; region < operators.size() && part == 0; ++region)
    if (operators[region].is_supported)
    {
      result[region].is_supported = true;
      result[region].support_stiffness.copy_from(operators[region].support_stiffness);
      result[region].support_damping.copy_from(operators[region].support_damping);
    }
  return result;
}

Epetra_Map map_of(const IndexSet &owned, const MPI_Comm communicator)
{
  return owned.make_trilinos_map(communicator, false);
}

/// Adds rows of entries to a matrix.
class RowAdder
{
public:
  explicit RowAdder(Epetra_FECrsMatrix &matrix) : matrix(matrix) {}

  void operator()(const int row, const Entries &entries) const
  {
    columns.clear();
    values.clear();
    for (const auto &[column, value] : entries)
    {
      columns.push_back(column);
      values.push_back(value);
    }
    matrix.InsertGlobalValues(1, &row, static_cast<int>(columns.size()), columns.data(),
                              values.data(), Epetra_FECrsMatrix::ROW_MAJOR);
  }

private:
  Epetra_FECrsMatrix &matrix;
  mutable std::vector<int> columns;
  mutable std::vector<double> values;
};

/// Finishes the assembly and hands the entries over.
void complete(Epetra_FECrsMatrix &matrix,
              const Epetra_Map &domain,
              const Epetra_Map &range,
              TrilinosWrappers::SparseMatrix &target)
{
  const int status = matrix.GlobalAssemble(domain, range, true);
  AssertThrow(status >= 0, LACExceptions::ExcTrilinosError(status));
  target.reinit(static_cast<const Epetra_CrsMatrix &>(matrix));
}
} // namespace

template <int dim>
void assemble_volumetric_stiffness(const Space<dim> &space,
                                   const std::vector<RegionOperators> &operators,
                                   VolumetricStiffness &volumetric)
{
  volumetric.matrices.clear();
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    volumetric.matrices.emplace_back();
    if (volumetric.coefficients[region] == 0.)
      continue;
    volumetric.matrices.back().copy_from(operators[region].stiffness);
    volumetric.matrices.back() = 0.;
  }
  const Quadrature<dim> quadrature = space.quadrature(space.n_quadrature_points());
  FEValues<dim> values(space.mapping, space.velocity_element, quadrature,
                       update_values | update_gradients | update_quadrature_points |
                           update_JxW_values);
  const unsigned int n_dofs = space.velocity_element.n_dofs_per_cell();
  FullMatrix<double> matrix(n_dofs, n_dofs);
  std::vector<types::global_dof_index> indices(n_dofs);
  std::vector<double> trace(n_dofs);
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (cell->is_locally_owned() && volumetric.coefficients[cell->material_id()] != 0.)
    {
      values.reinit(cell);
      matrix = 0.;
      for (const unsigned int q : values.quadrature_point_indices())
      {
        const double weight = values.JxW(q) * space.circumference(values.quadrature_point(q));
        for (unsigned int i = 0; i < n_dofs; ++i)
        {
          const unsigned int c = space.velocity_element.system_to_component_index(i).first;
          trace[i] = values.shape_grad(i, q)[c];
          if (space.is_axisymmetric() && c == 1)
            trace[i] += values.shape_value(i, q) / values.quadrature_point(q)[1];
        }
        for (unsigned int i = 0; i < n_dofs; ++i)
          for (unsigned int j = 0; j < n_dofs; ++j)
            matrix(i, j) += weight * trace[i] * trace[j];
      }
      cell->get_dof_indices(indices);
      space.velocity_hanging.distribute_local_to_global(matrix, indices,
                                                        volumetric.matrices[cell->material_id()]);
    }
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (volumetric.coefficients[region] != 0.)
      volumetric.matrices[region].compress(VectorOperation::add);
}

template <int dim>
void assemble_velocity_block(const Space<dim> &space,
                             const std::vector<RegionOperators> &operators,
                             const BoundaryConstraints<dim> &constraints,
                             const SystemCoefficients &coefficients,
                             const VolumetricStiffness *const volumetric,
                             const std::vector<bool> *const rows,
                             TrilinosWrappers::SparseMatrix &matrix)
{
  const Epetra_Map velocities = map_of(space.velocity_owned, space.communicator);
  Epetra_FECrsMatrix sum(Copy, velocities, 0);
  CondensedRows<dim>(space, operators, constraints)
      .for_velocity(coefficients, volumetric, rows, RowAdder(sum));
  complete(sum, velocities, velocities, matrix);
}

template <int dim>
void assemble_divergence(const Space<dim> &space,
                         const std::vector<RegionOperators> &operators,
                         const BoundaryConstraints<dim> &constraints,
                         TrilinosWrappers::SparseMatrix &matrix)
{
  const Epetra_Map velocities = map_of(space.velocity_owned, space.communicator);
  const Epetra_Map pressures = map_of(space.pressure_owned, space.communicator);
  Epetra_FECrsMatrix sum(Copy, pressures, 0);
  CondensedRows<dim>(space, operators, constraints).for_divergence({}, RowAdder(sum));
  complete(sum, velocities, pressures, matrix);
}

template <int dim>
void assemble_pressure_mass(const Space<dim> &space,
                            const std::vector<RegionOperators> &operators,
                            const std::vector<double> &factors,
                            TrilinosWrappers::SparseMatrix &matrix)
{
  const Epetra_Map pressures = map_of(space.pressure_owned, space.communicator);
  Epetra_CrsMatrix sum(Copy, pressures, 0);
  Entries row;
  std::vector<int> columns;
  std::vector<double> values;
  for (unsigned int k = 0; k < space.pressure_owned.n_elements(); ++k)
  {
    const int global = space.pressure_owned.nth_index_in_set(k);
    row.clear();
    if (space.pressure_hanging.is_constrained(global))
      row.emplace_back(global, 1.);
    else
      for (unsigned int region = 0; region < operators.size(); ++region)
        for_row(operators[region].pressure_mass, k,
                [&](const int l, const double value)
                { row.emplace_back(l, factors[region] * value); });
    merge(row);
    columns.clear();
    values.clear();
    for (const auto &[column, value] : row)
    {
      columns.push_back(column);
      values.push_back(value);
    }
    sum.InsertGlobalValues(global, static_cast<int>(columns.size()), values.data(), columns.data());
  }
  sum.FillComplete();
  matrix.reinit(sum);
}

template <int dim>
SymmetricTriplets condensed_triplets(const Space<dim> &space,
                                     const std::vector<RegionOperators> &operators,
                                     const BoundaryConstraints<dim> &constraints,
                                     const SystemCoefficients &coefficients)
{
  const int n_velocity = space.velocity_dofs.n_dofs();
  SymmetricTriplets result;
  result.n = n_velocity + space.pressure_dofs.n_dofs();
  // Velocities come first; the lower triangle alone.
  const auto adder = [&result](const int first_row, const int first_column, const double factor)
  {
    return [&result, first_row, first_column, factor](const int row, const Entries &entries)
    {
      for (const auto &[column, value] : entries)
        if (first_row + row >= first_column + column)
        {
          result.rows.push_back(first_row + row);
          result.columns.push_back(first_column + column);
          result.values.push_back(factor * value);
        }
    };
  };
  // Each part gives the constrained velocities a one on the diagonal; any number does.
  if (operators.front().products)
    for (unsigned int part = 0; part < n_parts_of_cells; ++part)
      CondensedRows<dim>(space, matrices_of_part(space, operators, part), constraints)
          .for_velocity(coefficients, nullptr, nullptr, adder(0, 0, 1.));
  CondensedRows<dim> rows(space, operators, constraints);
  if (!operators.front().products)
    rows.for_velocity(coefficients, nullptr, nullptr, adder(0, 0, 1.));
  rows.for_divergence(coefficients, adder(n_velocity, 0, -1.));
  rows.for_compression(coefficients.compressibility, adder(n_velocity, n_velocity, -1.));
  return result;
}

template void assemble_volumetric_stiffness(const Space<2> &,
                                            const std::vector<RegionOperators> &,
                                            VolumetricStiffness &);
template void assemble_volumetric_stiffness(const Space<3> &,
                                            const std::vector<RegionOperators> &,
                                            VolumetricStiffness &);
template void assemble_velocity_block(const Space<2> &,
                                      const std::vector<RegionOperators> &,
                                      const BoundaryConstraints<2> &,
                                      const SystemCoefficients &,
                                      const VolumetricStiffness *,
                                      const std::vector<bool> *,
                                      TrilinosWrappers::SparseMatrix &);
template void assemble_velocity_block(const Space<3> &,
                                      const std::vector<RegionOperators> &,
                                      const BoundaryConstraints<3> &,
                                      const SystemCoefficients &,
                                      const VolumetricStiffness *,
                                      const std::vector<bool> *,
                                      TrilinosWrappers::SparseMatrix &);
template void assemble_divergence(const Space<2> &,
                                  const std::vector<RegionOperators> &,
                                  const BoundaryConstraints<2> &,
                                  TrilinosWrappers::SparseMatrix &);
template void assemble_divergence(const Space<3> &,
                                  const std::vector<RegionOperators> &,
                                  const BoundaryConstraints<3> &,
                                  TrilinosWrappers::SparseMatrix &);
template void assemble_pressure_mass(const Space<2> &,
                                     const std::vector<RegionOperators> &,
                                     const std::vector<double> &,
                                     TrilinosWrappers::SparseMatrix &);
template void assemble_pressure_mass(const Space<3> &,
                                     const std::vector<RegionOperators> &,
                                     const std::vector<double> &,
                                     TrilinosWrappers::SparseMatrix &);
template SymmetricTriplets condensed_triplets(const Space<2> &,
                                              const std::vector<RegionOperators> &,
                                              const BoundaryConstraints<2> &,
                                              const SystemCoefficients &);
template SymmetricTriplets condensed_triplets(const Space<3> &,
                                              const std::vector<RegionOperators> &,
                                              const BoundaryConstraints<3> &,
                                              const SystemCoefficients &);
} // namespace Continua
