#include <continua/finite_element/space/ghosted_copy.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/exceptions.h>
#include <deal.II/base/types.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

void GhostedCopy::reinit(const IndexSet &owned_indices,
                         const IndexSet &relevant_indices,
                         const AffineConstraints<double> &hanging,
                         const MPI_Comm communicator)
{
  Assert(owned_indices.is_contiguous(), ExcInternalError());
  IndexSet needed = relevant_indices;
  for (const auto index : owned_indices)
    if (hanging.is_constrained(index))
      for (const auto &entry : *hanging.get_constraint_entries(index))
        needed.add_index(entry.first);
  partitioner =
      std::make_shared<const Utilities::MPI::Partitioner>(owned_indices, needed, communicator);

  const IndexSet &ghost_indices = partitioner->ghost_indices();
  ghosts.assign(ghost_indices.n_elements(), 0.);
  sent.assign(partitioner->n_import_indices(), 0.);
  first_owned = owned_indices.n_elements() > 0
                    ? relevant_indices.index_within_set(owned_indices.nth_index_in_set(0))
                    : 0;
  n_places = relevant_indices.n_elements();
  places.clear();
  for (const auto index : ghost_indices)
    places.push_back(relevant_indices.is_element(index)
                         ? static_cast<int>(relevant_indices.index_within_set(index))
                         : -1);
  // Their owners know: another rank need not see the coarser cell on which they hang.
  bool one_hangs = false;
  for (const auto &[first, last] : partitioner->import_indices())
    for (unsigned int i = first; i < last; ++i)
      one_hangs = one_hangs || hanging.is_constrained(owned_indices.nth_index_in_set(i));
  some_ghosts_hang = Utilities::MPI::max(one_hangs ? 1 : 0, communicator) > 0;

  hanging_nodes.clear();
  for (const auto index : owned_indices)
    if (hanging.is_constrained(index))
    {
      HangingNode node{owned_indices.index_within_set(index), {}};
      for (const auto &[of, weight] : *hanging.get_constraint_entries(index))
      {
        const bool is_owned = owned_indices.is_element(of);
        node.summands.push_back(
            {is_owned,
             is_owned ? owned_indices.index_within_set(of) : ghost_indices.index_within_set(of),
             weight});
      }
      hanging_nodes.push_back(node);
    }
}

void GhostedCopy::exchange(const double *const owned_entries)
{
  partitioner->export_to_ghosted_array_start<double, MemorySpace::Host>(
      0, ArrayView<const double>(owned_entries, partitioner->locally_owned_size()),
      ArrayView<double>(sent.data(), sent.size()), ArrayView<double>(ghosts.data(), ghosts.size()),
      requests);
  partitioner->export_to_ghosted_array_finish<double, MemorySpace::Host>(
      ArrayView<double>(ghosts.data(), ghosts.size()), requests);
}

void GhostedCopy::copy(const DistributedVector &owned, DistributedVector &ghosted)
{
  Assert(partitioner != nullptr &&
             owned.locally_owned_size() == partitioner->locally_owned_size() &&
             static_cast<std::size_t>(ghosted.trilinos_vector().MyLength()) == n_places,
         ExcInternalError());
  // From deal.II 9.8 on, a vector with ghosts changes by assignment alone.
  double *const entries = ghosted.trilinos_vector()[0];
  double *const owned_entries = entries + first_owned;
  std::copy(owned.begin(), owned.end(), owned_entries);
  exchange(owned_entries);
  for (const HangingNode &node : hanging_nodes)
  {
    double sum = 0.;
    for (const Summand &summand : node.summands)
      sum += summand.weight *
             (summand.is_owned ? owned_entries[summand.index] : ghosts[summand.index]);
    owned_entries[node.index] = sum;
  }
  if (some_ghosts_hang)
    exchange(owned_entries);
  for (std::size_t k = 0; k < places.size(); ++k)
    if (places[k] >= 0)
      entries[places[k]] = ghosts[k];
}
} // namespace Continua
