#include <continua/finite_element/solvers/iterative/velocity_rows.h>

#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
using namespace dealii;

namespace
{
/// Mass, stiffness and supports as matrices, complete in some rows (by local index).
template <int dim>
std::vector<RegionOperators> assembled_at(const Space<dim> &space,
                                          const std::vector<RegionOperators> &operators,
                                          const std::vector<bool> &rows)
{
  DistributedVector is_wanted = space.velocity_vector();
  for (unsigned int i = 0; i < rows.size(); ++i)
    is_wanted.begin()[i] = rows[i] ? 1. : 0.;
  DistributedVector ghosted(space.velocity_owned, space.velocity_relevant, space.communicator);
  ghosted = is_wanted;
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  const auto is_at_row = [&](const typename DoFHandler<dim>::active_cell_iterator &cell)
  {
    cell->get_dof_indices(indices);
    for (const auto index : indices)
    {
      if (ghosted[index] > 0.)
        return true;
      if (space.velocity_hanging.is_constrained(index))
        for (const auto &entry : *space.velocity_hanging.get_constraint_entries(index))
          if (ghosted[entry.first] > 0.)
            return true;
    }
    return false;
  };
  std::vector<RegionOperators> result(operators.size());
  assemble_velocity_operators<dim>(space, is_at_row, result);
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (operators[region].is_supported)
    {
      result[region].is_supported = true;
      result[region].support_stiffness.copy_from(operators[region].support_stiffness);
      result[region].support_damping.copy_from(operators[region].support_damping);
    }
  return result;
}
} // namespace

template <int dim>
void assemble_velocity_rows(const Space<dim> &space,
                            const std::vector<RegionOperators> &operators,
                            const BoundaryConstraints<dim> &constraints,
                            const SystemCoefficients &coefficients,
                            const std::vector<unsigned int> *const wanted,
                            VolumetricStiffness &volumetric,
                            TrilinosWrappers::SparseMatrix &matrix)
{
  std::vector<bool> rows(space.velocity_owned.n_elements(), wanted == nullptr);
  if (wanted != nullptr)
    for (const unsigned int i : *wanted)
      rows[i] = true;
  // Where the regions have no matrices, these are made for the rows alone.
  std::vector<RegionOperators> of_regions;
  if (operators.front().products)
    of_regions = assembled_at(space, operators, rows);
  const std::vector<RegionOperators> &assembled = of_regions.empty() ? operators : of_regions;
  assemble_volumetric_stiffness(space, assembled, volumetric);
  assemble_velocity_block(space, assembled, constraints, coefficients, &volumetric, &rows, matrix);
}

template void assemble_velocity_rows(const Space<2> &,
                                     const std::vector<RegionOperators> &,
                                     const BoundaryConstraints<2> &,
                                     const SystemCoefficients &,
                                     const std::vector<unsigned int> *,
                                     VolumetricStiffness &,
                                     TrilinosWrappers::SparseMatrix &);

template void assemble_velocity_rows(const Space<3> &,
                                     const std::vector<RegionOperators> &,
                                     const BoundaryConstraints<3> &,
                                     const SystemCoefficients &,
                                     const std::vector<unsigned int> *,
                                     VolumetricStiffness &,
                                     TrilinosWrappers::SparseMatrix &);
} // namespace Continua
