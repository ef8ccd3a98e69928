#include <continua/finite_element/space/cell_sums.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/index_set.h>

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
  indices.clear();
  first_owned = 0;
  bool has_owned = false;
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
        elsewhere.push_back({place, {{index, 1.}}});
    }
    else
      elsewhere.push_back({place, *hanging.get_constraint_entries(index)});
  }
  for (const Elsewhere &sum : elsewhere)
    for (const auto &entry : sum.entries)
      indices.push_back(entry.first);
  values.resize(indices.size());
}

void CellSums::add_to(DistributedVector &rows)
{
  std::size_t n = 0;
  for (const Elsewhere &sum : elsewhere)
  {
    for (const auto &entry : sum.entries)
      values[n++] = entry.second * sums[sum.place];
    sums[sum.place] = 0.;
  }
  for (std::size_t i = 0; i < rows.locally_owned_size(); ++i)
    rows.begin()[i] += sums[first_owned + i];
  if (n > 0)
    rows.add(indices, values);
  rows.compress(VectorOperation::add);
  forget();
}

void CellSums::forget()
{
  std::fill(sums.begin(), sums.end(), 0.);
}
} // namespace Continua
