#include <continua/finite_element/condensed_system.h>

#include <continua/base/nearly_equal.h>
#include <continua/linear_algebra/for_row.h>
#include <continua/mesh/cells_in_tree_order.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
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
    // The stiffness has all the columns that the mass and the supports have.
    collect(region.stiffness, space.velocity_owned.n_elements());
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

/// Calls velocity(i, entries), divergence(k, entries) and compression(k, entries) for the rows that
/// this rank's operators give, in any order; what is given twice adds.
template <int dim, typename Velocity, typename Divergence, typename Compression>
void for_entries(const Space<dim> &space,
                 const std::vector<RegionOperators> &operators,
                 const BoundaryConstraints<dim> &constraints,
                 const SystemCoefficients &coefficients,
                 const VolumetricStiffness *const volumetric,
                 const Velocity &add_velocity,
                 const Divergence &add_divergence,
                 const Compression &add_compression)
{
  const AffineConstraints<double> lines = constraints_of_columns(space, operators, constraints);
  // The free dofs that a velocity dof stands for, with their weights: the rows of T. Hanging nodes
  // are condensed already: they stand in no row but their own.
  const auto masters = [&lines](const int index, Entries &entries)
  {
    entries.clear();
    if (!lines.is_constrained(index))
      entries.emplace_back(index, 1.);
    else
      for (const auto &entry : *lines.get_constraint_entries(index))
        entries.emplace_back(entry.first, entry.second);
  };

  // Columns go to their masters; the constrained ones stand for others.
  Entries row, condensed, row_masters, column_masters;
  const auto condense = [&]()
  {
    condensed.clear();
    merge(row);
    for (const auto &[column, value] : row)
    {
      masters(column, column_masters);
      for (const auto &[to_column, weight] : column_masters)
        condensed.emplace_back(to_column, weight * value);
    }
    merge(condensed);
  };
  const auto take = [&row](const TrilinosWrappers::SparseMatrix &matrix, const unsigned int i,
                           const double factor)
  {
    if (factor != 0.)
      for_row(matrix, i,
              [&](const int j, const double value) { row.emplace_back(j, factor * value); });
  };
  for (unsigned int i = 0; i < space.velocity_owned.n_elements(); ++i)
  {
    const int global = space.velocity_owned.nth_index_in_set(i);
    if (lines.is_constrained(global))
      add_velocity(global, Entries{{global, 1.}});
    if (space.velocity_hanging.is_constrained(global))
      continue;
    masters(global, row_masters);
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
      add_velocity(to_row, weighted);
    }
  }
  for (unsigned int k = 0; k < space.pressure_owned.n_elements(); ++k)
  {
    const int global = space.pressure_owned.nth_index_in_set(k);
    if (space.pressure_hanging.is_constrained(global))
    {
      add_compression(global, Entries{{global, 1.}});
      continue;
    }
    row.clear();
    for (const RegionOperators &region : operators)
      take(region.divergence, k, 1.);
    condense();
    add_divergence(global, condensed);
    row.clear();
    for (unsigned int region = 0; region < operators.size(); ++region)
      take(operators[region].pressure_mass, k, coefficients.compressibility[region]);
    merge(row);
    add_compression(global, row);
  }
}
} // namespace

namespace
{
Epetra_Map map_of(const IndexSet &owned, const MPI_Comm communicator)
{
  return owned.make_trilinos_map(communicator, false);
}

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
  const QGauss<dim> quadrature(space.n_quadrature_points());
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
        const double weight = values.JxW(q) * space.measure(values.quadrature_point(q));
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
void assemble_condensed_blocks(const Space<dim> &space,
                               const std::vector<RegionOperators> &operators,
                               const BoundaryConstraints<dim> &constraints,
                               const SystemCoefficients &coefficients,
                               const VolumetricStiffness *const volumetric,
                               CondensedBlocks &blocks)
{
  const Epetra_Map velocities = map_of(space.velocity_owned, space.communicator);
  const Epetra_Map pressures = map_of(space.pressure_owned, space.communicator);
  Epetra_FECrsMatrix velocity(Copy, velocities, 0), divergence(Copy, pressures, 0),
      compression(Copy, pressures, 0);
  std::vector<int> columns;
  std::vector<double> values;
  const auto adder = [&columns, &values](Epetra_FECrsMatrix &matrix)
  {
    return [&](const int row, const Entries &entries)
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
    };
  };
  for_entries(space, operators, constraints, coefficients, volumetric, adder(velocity),
              adder(divergence), adder(compression));
  complete(velocity, velocities, velocities, blocks.velocity);
  complete(divergence, velocities, pressures, blocks.divergence);
  complete(compression, pressures, pressures, blocks.compression);
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
  for_entries(space, operators, constraints, coefficients, nullptr, adder(0, 0, 1.),
              adder(n_velocity, 0, -1.), adder(n_velocity, n_velocity, -1.));
  return result;
}

template void assemble_volumetric_stiffness(const Space<2> &,
                                            const std::vector<RegionOperators> &,
                                            VolumetricStiffness &);
template void assemble_volumetric_stiffness(const Space<3> &,
                                            const std::vector<RegionOperators> &,
                                            VolumetricStiffness &);
template void assemble_condensed_blocks(const Space<2> &,
                                        const std::vector<RegionOperators> &,
                                        const BoundaryConstraints<2> &,
                                        const SystemCoefficients &,
                                        const VolumetricStiffness *,
                                        CondensedBlocks &);
template void assemble_condensed_blocks(const Space<3> &,
                                        const std::vector<RegionOperators> &,
                                        const BoundaryConstraints<3> &,
                                        const SystemCoefficients &,
                                        const VolumetricStiffness *,
                                        CondensedBlocks &);
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
