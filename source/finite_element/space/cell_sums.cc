#include <continua/finite_element/space/cell_sums.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>

#include <Epetra_BlockMap.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

void CellSums::reinit(const DistributedVector &ghosted,
                      const IndexSet &owned_indices,
                      const AffineConstraints<double> &hanging)
{
  Assert(owned_indices.is_contiguous(), ExcInternalError());
  const Epetra_BlockMap &places = ghosted.trilinos_partitioner();
  const auto n_places = static_cast<std::size_t>(places.NumMyElements());
  sums.assign(n_places, 0.);
  elsewhere.clear();
  first_owned = 0;
  bool has_owned = false;
  using Entries = std::vector<std::pair<types::global_dof_index, double>>;
  std::vector<std::pair<std::size_t, Entries>> found;
  std::vector<types::global_dof_index> others;
  for (std::size_t place = 0; place < n_places; ++place)
  {
    const auto index = static_cast<types::global_dof_index>(
        places.GID(static_cast<TrilinosWrappers::types::int_type>(place)));
    const bool is_owned = owned_indices.is_element(index);
    if (is_owned && !has_owned)
      first_owned = place;
    has_owned = has_owned || is_owned;
    if (!hanging.is_constrained(index))
    {
      if (!is_owned)
        found.push_back({place, {{index, 1.}}});
    }
    else
      found.push_back({place, *hanging.get_constraint_entries(index)});
  }
  for (const auto &[place, entries] : found)
    for (const auto &entry : entries)
      if (!owned_indices.is_element(entry.first))
        others.push_back(entry.first);
  std::sort(others.begin(), others.end());
  IndexSet of_other_ranks(owned_indices.size());
  of_other_ranks.add_indices(others.begin(), std::unique(others.begin(), others.end()));
  const MPI_Comm communicator = ghosted.get_mpi_communicator();
  of_others.reinit(owned_indices, of_other_ranks, communicator);
  for (const auto &[place, entries] : found)
  {
    elsewhere.push_back({place, {}});
    for (const auto &[index, weight] : entries)
      elsewhere.back().entries.emplace_back(of_others.get_partitioner()->global_to_local(index),
                                            weight);
  }
  some_are_elsewhere = Utilities::MPI::max(elsewhere.empty() ? 0 : 1, communicator) > 0;
}

void CellSums::add_to(DistributedVector &rows)
{
  for (const Elsewhere &sum : elsewhere)
  {
    for (const auto &[entry, weight] : sum.entries)
      of_others.local_element(entry) += weight * sums[sum.place];
    sums[sum.place] = 0.;
  }
  for (std::size_t i = 0; i < rows.locally_owned_size(); ++i)
    rows.begin()[i] += sums[first_owned + i];
  if (some_are_elsewhere)
  {
    of_others.compress(VectorOperation::add);
    for (std::size_t i = 0; i < rows.locally_owned_size(); ++i)
      rows.begin()[i] += of_others.local_element(i);
    of_others = 0.;
  }
  forget();
}

void CellSums::forget()
{
  std::fill(sums.begin(), sums.end(), 0.);
}
} // namespace Continua
