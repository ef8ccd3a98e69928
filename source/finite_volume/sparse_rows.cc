#include <continua/finite_volume/sparse_rows.h>

#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

SparseRows::SparseRows(const IndexSet &rows, const IndexSet &columns, const MPI_Comm communicator)
    : rows(rows),
      columns(columns),
      communicator(communicator),
      first(rows.n_elements() > 0 ? rows.nth_index_in_set(0) : 0),
      entries(rows.n_elements())
{
}

void SparseRows::move_to(TrilinosWrappers::SparseMatrix &matrix)
{
  std::size_t longest = 0;
  for (const auto &row : entries)
    longest = std::max(longest, row.size());
  TrilinosWrappers::SparsityPattern pattern(rows, columns, communicator, longest);
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    auto &row = entries[i];
    std::sort(row.begin(), row.end(),
              [](const auto &a, const auto &b) { return a.first < b.first; });
    std::vector<types::global_dof_index> in_row;
    for (const auto &entry : row)
      if (in_row.empty() || in_row.back() != entry.first)
        in_row.push_back(entry.first);
    pattern.add_entries(first + i, in_row.begin(), in_row.end(), true);
  }
  pattern.compress();
  matrix.reinit(pattern);
  for (std::size_t i = 0; i < entries.size(); ++i)
    for (const auto &entry : entries[i])
      matrix.add(first + i, entry.first, entry.second);
  matrix.compress(VectorOperation::add);
  entries.assign(entries.size(), {});
}
} // namespace Continua
