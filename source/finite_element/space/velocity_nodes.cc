#include <continua/finite_element/space/velocity_nodes.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe.h>

#include <algorithm>
#include <array>
#include <map>

namespace Continua
{
using namespace dealii;

template <int dim>
std::vector<unsigned int> nodes_in_order(const DoFHandler<dim> &velocity_dofs)
{
  const FiniteElement<dim> &element = velocity_dofs.get_fe();
  const IndexSet &owned = velocity_dofs.locally_owned_dofs();
  const unsigned int n_dofs = element.n_dofs_per_cell();
  std::vector<std::array<unsigned int, dim>> place(n_dofs / dim);
  for (unsigned int i = 0; i < n_dofs; ++i)
  {
    const auto component = element.system_to_component_index(i);
    place[component.second][component.first] = i;
  }
  std::vector<bool> is_known(owned.n_elements(), false);
  std::vector<unsigned int> order;
  std::vector<types::global_dof_index> indices(n_dofs);
  // An owned velocity lies on an owned cell.
  for (const auto &cell : velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      cell->get_dof_indices(indices);
      for (const auto &node : place)
        for (const unsigned int i : node)
          if (owned.is_element(indices[i]))
          {
            const unsigned int local = owned.index_within_set(indices[i]);
            if (!is_known[local])
              order.push_back(local);
            is_known[local] = true;
          }
    }
  return order;
}

template <int dim>
std::vector<std::vector<double>> rigid_motions(const Mapping<dim> &mapping,
                                               const DoFHandler<dim> &velocity_dofs)
{
  const IndexSet &owned = velocity_dofs.locally_owned_dofs();
  const MPI_Comm communicator = velocity_dofs.get_communicator();
  const unsigned int n_local = owned.n_elements();
  std::map<types::global_dof_index, Point<dim>> points;
  DoFTools::map_dofs_to_support_points(mapping, velocity_dofs, points);
  Point<dim> middle;
  double n_all = n_local;
  for (const auto index : owned)
    middle += points.at(index);
  Utilities::MPI::sum(ArrayView<const double>(&middle[0], dim), communicator,
                      ArrayView<double>(&middle[0], dim));
  n_all = Utilities::MPI::sum(n_all, communicator);
  middle /= n_all;
  double size = 0.;
  for (const auto index : owned)
    size = std::max(size, points.at(index).distance(middle));
  size = Utilities::MPI::max(size, communicator);

  constexpr unsigned int n_rotations = dim == 2 ? 1 : 3;
  std::vector<std::vector<double>> modes(dim + n_rotations, std::vector<double>(n_local, 0.));
  for (unsigned int c = 0; c < dim; ++c)
  {
    ComponentMask component(dim, false);
    component.set(c, true);
    for (const auto index : DoFTools::extract_dofs(velocity_dofs, component))
    {
      const unsigned int local = owned.index_within_set(index);
      const Tensor<1, dim> x = (points.at(index) - middle) / size;
      modes[c][local] = 1.;
      for (unsigned int k = 0; k < n_rotations; ++k)
      {
        // In the plane of two axes.
        const unsigned int first = dim == 2 ? 0 : (k + 1) % 3, second = dim == 2 ? 1 : (k + 2) % 3;
        if (c == first)
          modes[dim + k][local] = -x[second];
        else if (c == second)
          modes[dim + k][local] = x[first];
      }
    }
  }
  return modes;
}

template std::vector<unsigned int> nodes_in_order(const DoFHandler<2> &);
template std::vector<unsigned int> nodes_in_order(const DoFHandler<3> &);
template std::vector<std::vector<double>> rigid_motions(const Mapping<2> &, const DoFHandler<2> &);
template std::vector<std::vector<double>> rigid_motions(const Mapping<3> &, const DoFHandler<3> &);
} // namespace Continua
