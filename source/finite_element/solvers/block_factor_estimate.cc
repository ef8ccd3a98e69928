#include <continua/finite_element/solvers/block_factor_estimate.h>
#include <continua/linear_algebra/mumps_solver.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <utility>

namespace Continua
{
using namespace dealii;

template <int dim>
double estimate_block_factor(const Space<dim> &space,
                             const BoundaryConstraints<dim> &constraints,
                             const std::vector<unsigned int> &velocities)
{
  const auto n_nodes = static_cast<unsigned int>(velocities.size()) / dim;
  const unsigned int n_nodes_of_all = Utilities::MPI::sum(n_nodes, space.communicator);
  unsigned int first_node = 0; // MPI leaves that of the first rank as it is
  MPI_Exscan(&n_nodes, &first_node, 1, MPI_UNSIGNED, MPI_SUM, space.communicator);
  // One more than the number of a velocity's node; zero where it is not in the block.
  DistributedVector owned_numbers = space.velocity_vector(),
                    numbers(space.velocity_owned, space.velocity_relevant, space.communicator);
  for (std::size_t k = 0; k < velocities.size(); ++k)
  {
    const std::size_t node = first_node + k / dim;
    owned_numbers.begin()[velocities[k]] = 1. + static_cast<double>(node);
  }
  numbers = owned_numbers;

  std::vector<int> rows, columns;
  for (unsigned int k = 0; k < n_nodes; ++k)
  {
    rows.push_back(static_cast<int>(first_node + k));
    columns.push_back(rows.back());
  }
  const AffineConstraints<double> &lines = constraints.all();
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  std::vector<int> nodes;
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      nodes.clear();
      const auto add_node_of = [&](const types::global_dof_index index)
      {
        if (numbers[index] > 0.)
          nodes.push_back(static_cast<int>(numbers[index]) - 1);
      };
      cell->get_dof_indices(indices);
      for (const auto index : indices)
        if (!lines.is_constrained(index))
          add_node_of(index);
        else
          for (const auto &entry : *lines.get_constraint_entries(index))
            add_node_of(entry.first);
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      for (auto row = nodes.begin(); row != nodes.end(); ++row)
        for (auto column = nodes.begin(); column != row; ++column)
        {
          rows.push_back(*row);
          columns.push_back(*column);
        }
    }
  const FactorEstimate of_nodes =
      MumpsSolver<float>(MumpsSymmetry::quasi_definite, MumpsScaling::none, space.communicator)
          .analyse(static_cast<int>(n_nodes_of_all), std::move(rows), std::move(columns));
  return Utilities::fixed_power<2>(static_cast<double>(dim)) * of_nodes.n_entries;
}

template double estimate_block_factor<2>(const Space<2> &,
                                         const BoundaryConstraints<2> &,
                                         const std::vector<unsigned int> &);
template double estimate_block_factor<3>(const Space<3> &,
                                         const BoundaryConstraints<3> &,
                                         const std::vector<unsigned int> &);
} // namespace Continua
