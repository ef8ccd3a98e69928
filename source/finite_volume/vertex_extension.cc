#include <continua/finite_volume/vertex_extension.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/vector.h>

#include <utility>

namespace Continua
{
using namespace dealii;

template <int dim>
void VertexExtension<dim>::reinit(const DoFHandler<dim> &dofs,
                                  const AffineConstraints<double> &hanging_nodes,
                                  const bool axisymmetric,
                                  const std::vector<bool> &is_liquid,
                                  const DistributedVector &is_known)
{
  hanging = &hanging_nodes;
  IndexSet relevant;
  DoFTools::extract_locally_relevant_dofs(dofs, relevant);
  rows.reinit(is_known);
  ghosted.reinit(dofs.locally_owned_dofs(), relevant, dofs.get_communicator());
  ghosted = is_known;
  constraints.reinit(relevant);
  constraints.merge(hanging_nodes);
  for (const auto index : relevant)
    if (ghosted(index) > 0. && !constraints.is_constrained(index))
      constraints.add_line(index);
  constraints.close();
  owned.clear();
  for (const auto index : dofs.locally_owned_dofs())
    owned.push_back(static_cast<int>(index));
  packed.resize(owned.size());
  assemble(dofs, axisymmetric, is_liquid);
  factorise(dofs);
}

template <int dim>
void VertexExtension<dim>::assemble(const DoFHandler<dim> &dofs,
                                    const bool axisymmetric,
                                    const std::vector<bool> &is_liquid)
{
  const FiniteElement<dim> &element = dofs.get_fe();
  FEValues<dim> values(element, QGauss<dim>(2),
                       update_values | update_gradients | update_quadrature_points |
                           update_JxW_values);
  const FEValuesExtractors::Vector displacement(0);
  const unsigned int n = element.n_dofs_per_cell();
  cells.clear();
  for (const auto &cell : dofs.active_cell_iterators())
  {
    if (!cell->is_locally_owned() || !is_liquid[cell->material_id()])
      continue;
    values.reinit(cell);
    double volume = 0.;
    const auto weight = [&](const unsigned int q) {
      return values.JxW(q) * (axisymmetric ? 2. * numbers::PI * values.quadrature_point(q)[1] : 1.);
    };
    for (const unsigned int q : values.quadrature_point_indices())
      volume += weight(q);
    cells.emplace_back();
    cells.back().indices.resize(n);
    cell->get_dof_indices(cells.back().indices);
    cells.back().matrix.reinit(n, n);
    for (const unsigned int q : values.quadrature_point_indices())
    {
      const double factor = 2. * weight(q) / volume;
      const auto hoop = [&](const unsigned int i) {
        return axisymmetric ? values[displacement].value(i, q)[1] / values.quadrature_point(q)[1]
                            : 0.;
      };
      for (unsigned int i = 0; i < n; ++i)
      {
        const auto strain = values[displacement].symmetric_gradient(i, q);
        const double growth = trace(strain) + hoop(i);
        for (unsigned int j = 0; j < n; ++j)
        {
          const auto other = values[displacement].symmetric_gradient(j, q);
          cells.back().matrix(i, j) +=
              factor * (strain * other + hoop(i) * hoop(j) + growth * (trace(other) + hoop(j)));
        }
      }
    }
  }
}

template <int dim>
void VertexExtension<dim>::factorise(const DoFHandler<dim> &dofs)
{
  SymmetricTriplets triplets;
  triplets.n = static_cast<int>(dofs.n_dofs());
  const auto add =
      [&triplets](const unsigned int row, const unsigned int column, const double value)
  {
    if (row < column)
      return;
    triplets.rows.push_back(static_cast<int>(row));
    triplets.columns.push_back(static_cast<int>(column));
    triplets.values.push_back(value);
  };
  for (const int index : owned)
    if (constraints.is_constrained(index))
      add(index, index, 1.);
  std::vector<std::vector<std::pair<unsigned int, double>>> masters;
  for (const Cell &cell : cells)
  {
    masters.assign(cell.indices.size(), {});
    for (unsigned int i = 0; i < masters.size(); ++i)
      if (!constraints.is_constrained(cell.indices[i]))
        masters[i].emplace_back(cell.indices[i], 1.);
      else
        for (const auto &entry : *constraints.get_constraint_entries(cell.indices[i]))
          masters[i].emplace_back(entry.first, entry.second);
    for (unsigned int i = 0; i < masters.size(); ++i)
      for (unsigned int j = 0; j < masters.size(); ++j)
        for (const auto &[row, row_weight] : masters[i])
          for (const auto &[column, column_weight] : masters[j])
            add(row, column, row_weight * column_weight * cell.matrix(i, j));
  }
  factor = make_symmetric_factor(DirectSolver::automatic, true, triplets.values.size(),
                                 dofs.get_communicator());
  factor->factorize(std::move(triplets), owned);
}

template <int dim>
void VertexExtension<dim>::extend(DistributedVector &displacement)
{
  hanging->distribute(displacement);
  ghosted = displacement;
  rows = 0.;
  for (const Cell &cell : cells)
  {
    Vector<double> entries(cell.indices.size()), forces(cell.indices.size());
    for (unsigned int i = 0; i < entries.size(); ++i)
      entries[i] = ghosted(cell.indices[i]);
    if (entries.linfty_norm() == 0.)
      continue;
    cell.matrix.vmult(forces, entries);
    forces *= -1.;
    hanging->distribute_local_to_global(forces, cell.indices, rows);
  }
  rows.compress(VectorOperation::add);
  for (std::size_t i = 0; i < packed.size(); ++i)
    packed[i] = constraints.is_constrained(owned[i]) ? 0. : rows.begin()[i];
  factor->solve(packed);
  for (std::size_t i = 0; i < packed.size(); ++i)
    displacement.begin()[i] += packed[i];
  hanging->distribute(displacement);
}

template class VertexExtension<2>;
template class VertexExtension<3>;
} // namespace Continua
