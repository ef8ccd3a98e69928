#include <continua/finite_element/products/linear_velocities.h>
#include <continua/finite_element/space/velocity_nodes.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparsity_tools.h>

#include <EpetraExt_MatrixMatrix.h>
#include <EpetraExt_Transpose_RowMatrix.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
/// The same cell with the unknowns of another DoFHandler on its mesh.
template <int dim>
typename DoFHandler<dim>::active_cell_iterator
cell_of(const typename DoFHandler<dim>::active_cell_iterator &cell, const DoFHandler<dim> &other)
{
  return {&other.get_triangulation(), cell->level(), cell->index(), &other};
}
} // namespace

template <int dim>
LinearVelocities<dim>::LinearVelocities(const Space<dim> &space,
                                        const AffineConstraints<double> &constraints,
                                        const std::vector<bool> &stiff)
    : space(space),
      constraints(constraints),
      element(space.linear_element()),
      dof_handler(space.triangulation)
{
  dof_handler.distribute_dofs(element);
  owned = dof_handler.locally_owned_dofs();
  DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
  find_stiff(stiff);
  constrain();
  for (const unsigned int i : nodes_in_order(dof_handler))
  {
    const auto place = relevant.index_within_set(owned.nth_index_in_set(i));
    if (is_stiff[place] && !is_hanging[place])
      rows.push_back(i);
  }
  interpolate(stiff);
}

template <int dim>
DistributedVector LinearVelocities<dim>::vector() const
{
  return DistributedVector(owned, space.communicator);
}

template <int dim>
template <typename Visit>
void LinearVelocities<dim>::for_vertices(const Visit &visit) const
{
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (!cell->is_artificial())
    {
      const auto of_space = cell_of(cell, space.velocity_dofs);
      for (const unsigned int v : cell->vertex_indices())
        for (unsigned int c = 0; c < dim; ++c)
          visit(of_space->vertex_dof_index(v, c), cell->vertex_dof_index(v, c));
    }
}

template <int dim>
void LinearVelocities<dim>::find_stiff(const std::vector<bool> &stiff)
{
  DistributedVector flags = space.velocity_vector();
  for (unsigned int i = 0; i < stiff.size(); ++i)
    flags.begin()[i] = stiff[i] ? 1. : 0.;
  DistributedVector ghosted(space.velocity_owned, space.velocity_relevant, space.communicator);
  ghosted = flags;
  is_stiff.assign(relevant.n_elements(), false);
  for_vertices(
      [&](const types::global_dof_index of_space, const types::global_dof_index linear)
      {
        if (ghosted[of_space] > 0.)
          is_stiff[relevant.index_within_set(linear)] = true;
      });
}

template <int dim>
void LinearVelocities<dim>::constrain()
{
  lines.clear();
  lines.reinit(relevant);
  DoFTools::make_hanging_node_constraints(dof_handler, lines);
  is_hanging.assign(relevant.n_elements(), false);
  for (const auto &line : lines.get_lines())
    is_hanging[relevant.index_within_set(line.index)] = true;
  std::map<types::global_dof_index, types::global_dof_index> linear_of;
  for_vertices([&](const types::global_dof_index of_space, const types::global_dof_index linear)
               { linear_of[of_space] = linear; });
  // A prescribed component follows from the others of its node, which lie at the same vertex.
  for (const auto &[of_space, linear] : linear_of)
  {
    if (!constraints.is_constrained(of_space) || lines.is_constrained(linear))
      continue;
    lines.add_line(linear);
    for (const auto &[master, weight] : *constraints.get_constraint_entries(of_space))
    {
      const auto linear_master = linear_of.find(master);
      if (linear_master != linear_of.end())
        lines.add_entry(linear, linear_master->second, weight);
    }
  }
  lines.close();
}

template <int dim>
void LinearVelocities<dim>::interpolate(const std::vector<bool> &stiff)
{
  // Of one cell: the linear shape functions that do not vanish at a node.
  const FiniteElement<dim> &fine = space.velocity_element;
  std::vector<std::vector<std::pair<unsigned int, double>>> values(fine.n_dofs_per_cell());
  for (unsigned int i = 0; i < fine.n_dofs_per_cell(); ++i)
  {
    const unsigned int c = fine.system_to_component_index(i).first;
    for (unsigned int j = 0; j < element.n_dofs_per_cell(); ++j)
      if (element.system_to_component_index(j).first == c)
      {
        const double value = element.shape_value(j, fine.unit_support_point(i));
        if (std::abs(value) > 1e-10)
          values[i].emplace_back(j, value);
      }
  }

  const Epetra_Map range = space.velocity_owned.make_trilinos_map(space.communicator, false);
  const Epetra_Map domain = owned.make_trilinos_map(space.communicator, false);
  Epetra_CrsMatrix matrix(Copy, range, 0);
  std::vector<bool> is_done(stiff.size(), false);
  std::vector<types::global_dof_index> of_space(fine.n_dofs_per_cell());
  std::vector<types::global_dof_index> linear(element.n_dofs_per_cell());
  std::map<int, double> row;
  std::vector<int> columns;
  std::vector<double> entries;
  const auto add = [&](const types::global_dof_index column, const double value)
  {
    if (is_stiff[relevant.index_within_set(column)])
      row[static_cast<int>(column)] += value;
  };
  // An owned velocity lies on an owned cell.
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      cell_of(cell, space.velocity_dofs)->get_dof_indices(of_space);
      cell->get_dof_indices(linear);
      for (unsigned int i = 0; i < of_space.size(); ++i)
      {
        if (!space.velocity_owned.is_element(of_space[i]) ||
            constraints.is_constrained(of_space[i]))
          continue;
        const unsigned int local = space.velocity_owned.index_within_set(of_space[i]);
        if (!stiff[local] || is_done[local])
          continue;
        is_done[local] = true;
        row.clear();
        for (const auto &[j, value] : values[i])
          if (!lines.is_constrained(linear[j]))
            add(linear[j], value);
          else
            for (const auto &[master, weight] : *lines.get_constraint_entries(linear[j]))
              add(master, value * weight);
        columns.clear();
        entries.clear();
        for (const auto &[column, value] : row)
        {
          columns.push_back(column);
          entries.push_back(value);
        }
        matrix.InsertGlobalValues(static_cast<int>(of_space[i]), static_cast<int>(columns.size()),
                                  entries.data(), columns.data());
      }
    }
  const int status = matrix.FillComplete(domain, range);
  AssertThrow(status >= 0, LACExceptions::ExcTrilinosError(status));
  interpolation_matrix.reinit(matrix);
}

template <int dim>
void LinearVelocities<dim>::assemble(
    const typename MatrixFreeProduct<dim, double>::Coefficients &coefficients,
    const TrilinosWrappers::SparseMatrix *const supports,
    TrilinosWrappers::SparseMatrix &matrix) const
{
  const unsigned int n_dofs = element.n_dofs_per_cell();
  std::vector<types::global_dof_index> indices(n_dofs);
  std::vector<typename DoFHandler<dim>::active_cell_iterator> cells;
  DynamicSparsityPattern pattern(relevant);
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      cell->get_dof_indices(indices);
      if (std::none_of(indices.begin(), indices.end(),
                       [this](const types::global_dof_index index)
                       { return is_stiff[relevant.index_within_set(index)]; }))
        continue;
      cells.push_back(cell);
      lines.add_entries_local_to_global(indices, pattern, false);
    }
  for (const auto index : owned)
    pattern.add(index, index);
  SparsityTools::distribute_sparsity_pattern(pattern, owned, space.communicator, relevant);
  matrix.reinit(owned, owned, pattern, space.communicator);

  // In axisymmetry 1/r has no exact integral: the points are those of the quadratic velocities.
  const Quadrature<dim> quadrature =
      space.quadrature(space.is_axisymmetric() ? space.n_quadrature_points() : 2);
  FEValues<dim> values(space.mapping, element, quadrature,
                       update_values | update_gradients | update_quadrature_points |
                           update_JxW_values);
  FullMatrix<double> of_cell(n_dofs, n_dofs);
  std::vector<double> hoop(n_dofs, 0.), trace(n_dofs);
  std::vector<unsigned int> component(n_dofs);
  for (unsigned int i = 0; i < n_dofs; ++i)
    component[i] = element.system_to_component_index(i).first;
  for (const auto &cell : cells)
  {
    values.reinit(cell);
    const unsigned int region = cell->material_id(), number = cell->active_cell_index();
    const auto value = [](const std::vector<double> &of_all, const unsigned int i)
    { return of_all.empty() ? 0. : of_all[i]; };
    const double mass = coefficients.mass[region],
                 stiffness = coefficients.stiffness[region] +
                             value(coefficients.stiffness_of_cells, number),
                 lambda = value(coefficients.volumetric, region) +
                          value(coefficients.volumetric_of_cells, number);
    of_cell = 0.;
    for (const unsigned int q : values.quadrature_point_indices())
    {
      const double weight = values.JxW(q) * space.circumference(values.quadrature_point(q));
      for (unsigned int i = 0; i < n_dofs; ++i)
      {
        const unsigned int c = component[i];
        if (space.is_axisymmetric() && c == 1)
          hoop[i] = values.shape_value(i, q) / values.quadrature_point(q)[1];
        trace[i] = values.shape_grad(i, q)[c] + hoop[i];
      }
      for (unsigned int i = 0; i < n_dofs; ++i)
        for (unsigned int j = 0; j <= i; ++j)
        {
          const unsigned int c = component[i], d = component[j];
          const Tensor<1, dim> &v = values.shape_grad(i, q), &u = values.shape_grad(j, q);
          // 2 sym grad v : sym grad u, then its deviator.
          double entry = v[d] * u[c] + 2. * hoop[i] * hoop[j];
          if (c == d)
            entry += v * u;
          entry =
              stiffness * (entry - 2. / 3. * trace[i] * trace[j]) + lambda * trace[i] * trace[j];
          if (c == d)
            entry += mass * values.shape_value(i, q) * values.shape_value(j, q);
          of_cell(i, j) += weight * entry;
        }
    }
    for (unsigned int i = 0; i < n_dofs; ++i)
      for (unsigned int j = 0; j < i; ++j)
        of_cell(j, i) = of_cell(i, j);
    cell->get_dof_indices(indices);
    lines.distribute_local_to_global(of_cell, indices, matrix);
  }
  matrix.compress(VectorOperation::add);
  if (supports != nullptr)
    add_supports(*supports, matrix);
}

template <int dim>
void LinearVelocities<dim>::add_supports(const TrilinosWrappers::SparseMatrix &supports,
                                         TrilinosWrappers::SparseMatrix &matrix) const
{
  // The transpose as a matrix of its own: the product with a transpose fails in EpetraExt where
  // columns are empty.
  const Epetra_CrsMatrix &interpolation = interpolation_matrix.trilinos_matrix();
  EpetraExt::RowMatrix_Transpose transpose;
  const auto &restriction = dynamic_cast<const Epetra_CrsMatrix &>(
      transpose(const_cast<Epetra_CrsMatrix &>(interpolation))); // which it does not change
  Epetra_CrsMatrix half(Copy, interpolation.RowMap(), 0);
  const auto check = [](const int status)
  { AssertThrow(status >= 0, LACExceptions::ExcTrilinosError(status)); };
  check(EpetraExt::MatrixMatrix::Multiply(supports.trilinos_matrix(), false, interpolation, false,
                                          half));
  Epetra_CrsMatrix product(Copy, restriction.RowMap(), 0);
  check(EpetraExt::MatrixMatrix::Multiply(restriction, false, half, false, product));
  Epetra_CrsMatrix *sum = nullptr;
  check(EpetraExt::MatrixMatrix::Add(product, false, 1., matrix.trilinos_matrix(), false, 1., sum));
  const std::unique_ptr<Epetra_CrsMatrix> owner(sum);
  check(sum->FillComplete());
  matrix.reinit(*sum);
}

template class LinearVelocities<2>;
template class LinearVelocities<3>;
} // namespace Continua
