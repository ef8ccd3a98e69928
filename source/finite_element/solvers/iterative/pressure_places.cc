#include <continua/finite_element/solvers/iterative/pressure_places.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <vector>

namespace Continua
{
using namespace dealii;

template <int dim>
SchurComplement::Places places_of_pressures(const Space<dim> &space, const unsigned int n_regions)
{
  SchurComplement::Places places(dim, std::vector<double>(space.pressure_owned.n_elements(), 0.));
  std::vector<unsigned int> components(space.pressure_owned.n_elements(), 0);
  std::vector<bool> is_known(space.pressure_owned.n_elements(), false);
  std::vector<types::global_dof_index> indices;
  double size = 0.;
  for (const auto &cell : space.pressure_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const FiniteElement<dim> &element = cell->get_fe();
      indices.resize(element.n_dofs_per_cell());
      cell->get_dof_indices(indices);
      for (unsigned int i = 0; i < indices.size(); ++i)
        if (space.pressure_owned.is_element(indices[i]))
        {
          const unsigned int local = space.pressure_owned.index_within_set(indices[i]);
          if (is_known[local])
            continue;
          is_known[local] = true;
          // Each call maps all support points of the cell.
          const Point<dim> point =
              space.mapping.transform_unit_to_real_cell(cell, element.unit_support_point(i));
          for (unsigned int c = 0; c < dim; ++c)
            places[c][local] = point[c];
          components[local] = space.pressure_component(cell->material_id());
          size = std::max(size, point.norm());
        }
    }
  if (n_regions == 1)
    return places;
  const double shift = 10. * Utilities::MPI::max(size, space.communicator);
  for (std::size_t i = 0; i < components.size(); ++i)
    places[0][i] += shift * components[i];
  return places;
}

template SchurComplement::Places places_of_pressures(const Space<2> &, unsigned int);
template SchurComplement::Places places_of_pressures(const Space<3> &, unsigned int);
} // namespace Continua
