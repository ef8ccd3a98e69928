#include <continua/finite_element/products/matrix_free_regions.h>

#include <Epetra_BlockMap.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

namespace
{
/// The places of all cells' pressures in a vector with ghost entries.
template <int dim>
std::vector<int> pressure_places(const Space<dim> &space)
{
  const DistributedVector ghosted(space.pressure_owned, space.pressure_relevant,
                                  space.communicator);
  constexpr unsigned int n_pressures = 1U << dim;
  std::vector<int> places(std::size_t(space.triangulation.n_active_cells()) * n_pressures, -1);
  std::vector<types::global_dof_index> indices(n_pressures);
  for (const auto &cell : space.pressure_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      AssertDimension(cell->get_fe().n_dofs_per_cell(), n_pressures);
      cell->get_dof_indices(indices);
      for (unsigned int k = 0; k < n_pressures; ++k)
        places[std::size_t(cell->active_cell_index()) * n_pressures + k] =
            ghosted.trilinos_partitioner().LID(
                static_cast<TrilinosWrappers::types::int_type>(indices[k]));
    }
  return places;
}
} // namespace

template <int dim>
MatrixFreeRegions<dim>::MatrixFreeRegions(const Space<dim> &space,
                                          const BoundaryConstraints<dim> &constraints,
                                          const unsigned int n_regions,
                                          const InstructionSet instruction_set)
    : cells(make_matrix_free_product<dim, double>(
          instruction_set,
          {space.mapping, space.velocity_dofs, constraints.all(), space.is_axisymmetric(),
           &space.velocity_hanging, pressure_places(space)})),
      nodes_of_regions(n_regions)
{
  cells->initialise_of_region(source_entries);
  cells->initialise_of_region(target_entries);
  find_nodes(space);
}

template <int dim>
void MatrixFreeRegions<dim>::find_nodes(const Space<dim> &space)
{
  // A region's product also has the nodes that its hanging ones hang on. Ghost cells show what
  // other ranks' cells share with owned nodes.
  std::vector<std::vector<bool>> is_of_region(
      nodes_of_regions.size(), std::vector<bool>(space.velocity_owned.n_elements(), false));
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (!cell->is_artificial())
    {
      std::vector<bool> &is_in = is_of_region[cell->material_id()];
      const auto take = [&](const types::global_dof_index index)
      {
        if (space.velocity_owned.is_element(index))
          is_in[space.velocity_owned.index_within_set(index)] = true;
      };
      cell->get_dof_indices(indices);
      for (const auto index : indices)
      {
        take(index);
        if (space.velocity_hanging.is_constrained(index))
          for (const auto &entry : *space.velocity_hanging.get_constraint_entries(index))
            take(entry.first);
      }
    }
  for (std::size_t region = 0; region < is_of_region.size(); ++region)
    for (unsigned int i = 0; i < is_of_region[region].size(); ++i)
      if (is_of_region[region][i])
        nodes_of_regions[region].push_back(i);
}

template <int dim>
void MatrixFreeRegions<dim>::multiply(const unsigned int region,
                                      const double mass,
                                      const double stiffness,
                                      DistributedVector &target,
                                      const DistributedVector &source) const
{
  std::copy(source.begin(), source.end(), source_entries.begin());
  cells->multiply_region(target_entries, source_entries, region, mass, stiffness);
  std::copy(target_entries.begin(), target_entries.end(), target.begin());
}

template <int dim>
void MatrixFreeRegions<dim>::mass_diagonal(const unsigned int region,
                                           DistributedVector &diagonal) const
{
  cells->find_diagonal(target_entries, region, 1., 0.);
  std::copy(target_entries.begin(), target_entries.end(), diagonal.begin());
}

template <int dim>
void MatrixFreeRegions<dim>::stiffness_diagonal(const unsigned int region,
                                                DistributedVector &diagonal) const
{
  cells->find_diagonal(target_entries, region, 0., 1.);
  std::copy(target_entries.begin(), target_entries.end(), diagonal.begin());
}

template class MatrixFreeRegions<2>;
template class MatrixFreeRegions<3>;
} // namespace Continua
