#include <continua/finite_element/solvers/iterative/joint_block_assembly.h>

#include <continua/finite_element/products/region_operators.h>

#include <deal.II/lac/full_matrix.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

template <int dim>
JointBlockAssembly<dim>::JointBlockAssembly(const Space<dim> &space,
                                            const BoundaryConstraints<dim> &constraints,
                                            const SystemCoefficients &coefficients,
                                            const TrilinosWrappers::SparseMatrix *const supports,
                                            SaddlePointBlock &block)
    : space(space),
      lines(constraints.all()),
      coefficients(coefficients),
      supports(supports),
      block(block),
      indices(space.velocity_element.n_dofs_per_cell()),
      rows(indices.size())
{
}

template <int dim>
void JointBlockAssembly<dim>::add_velocities(const std::vector<unsigned int> &stiff)
{
  learn_numbers();
  const std::size_t n_entries = count_entries();
  if (supports != nullptr)
    block.add_velocity_entries(supports->trilinos_matrix());
  block.reserve(n_entries + stiff.size());
  add_cells();
  // A constrained velocity has no equation. The supports have a one there, too.
  for (const unsigned int i : stiff)
  {
    const auto index = space.velocity_owned.nth_index_in_set(i);
    const int row = block.number(static_cast<int>(index));
    if (lines.is_constrained(index) && supports == nullptr)
      block.add_velocity_entry(row, row, 1.);
  }
}

template <int dim>
void JointBlockAssembly<dim>::learn_numbers()
{
  std::vector<int> of_others;
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      cell->get_dof_indices(indices);
      for (const auto index : indices)
        if (lines.is_constrained(index))
          for (const auto &entry : *lines.get_constraint_entries(index))
            of_others.push_back(static_cast<int>(entry.first));
        else if (!space.velocity_owned.is_element(index))
          of_others.push_back(static_cast<int>(index));
    }
  block.learn_numbers(of_others);
}

template <int dim>
std::size_t JointBlockAssembly<dim>::find_rows()
{
  std::size_t n_rows = 0;
  for (unsigned int i = 0; i < indices.size(); ++i)
  {
    rows[i].clear();
    const auto add = [&](const types::global_dof_index velocity, const double weight)
    {
      const int row = block.number(static_cast<int>(velocity));
      if (row >= 0)
        rows[i].emplace_back(row, weight);
    };
    if (!lines.is_constrained(indices[i]))
      add(indices[i], 1.);
    else
      for (const auto &[master, weight] : *lines.get_constraint_entries(indices[i]))
        add(master, weight);
    n_rows += rows[i].size();
  }
  return n_rows;
}

template <int dim>
std::size_t JointBlockAssembly<dim>::count_entries()
{
  std::size_t n_entries = 0;
  is_of_block.assign(space.triangulation.n_active_cells(), false);
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      cell->get_dof_indices(indices);
      const std::size_t n_rows = find_rows();
      is_of_block[cell->active_cell_index()] = n_rows > 0;
      // Half of the pairs, and what a row has with itself, which several velocities may give.
      of_cell.clear();
      for (const auto &of_velocity : rows)
        for (const auto &entry : of_velocity)
          of_cell.push_back(entry.first);
      std::sort(of_cell.begin(), of_cell.end());
      std::size_t n_on_diagonal = 0;
      for (std::size_t k = 0, first = 0; k < n_rows; ++k)
      {
        if (of_cell[k] != of_cell[first])
          first = k;
        n_on_diagonal += 2 * (k - first) + 1; // adds up to the square of how often it is there
      }
      n_entries += (n_rows * n_rows + n_on_diagonal) / 2;
    }
  return n_entries;
}

template <int dim>
void JointBlockAssembly<dim>::add_cells()
{
  using Cell = typename DoFHandler<dim>::active_cell_iterator;
  visit_velocity_matrices<dim>(
      space, [&](const Cell &cell) { return is_of_block[cell->active_cell_index()]; },
      [&](const Cell &cell, const std::vector<types::global_dof_index> &indices_of_cell,
          const FullMatrix<double> &mass, const FullMatrix<double> &stiffness)
      {
        indices = indices_of_cell;
        find_rows();
        const double of_mass = coefficients.mass[cell->material_id()],
                     of_stiffness = coefficients.stiffness[cell->material_id()];
        for (unsigned int i = 0; i < rows.size(); ++i)
          for (unsigned int j = 0; j < rows.size(); ++j)
          {
            const double value = of_mass * mass(i, j) + of_stiffness * stiffness(i, j);
            for (const auto &[row, of_row] : rows[i])
              for (const auto &[column, of_column] : rows[j])
                if (column <= row)
                  block.add_velocity_entry(row, column, of_row * of_column * value);
          }
      });
}

template class JointBlockAssembly<2>;
template class JointBlockAssembly<3>;
} // namespace Continua
