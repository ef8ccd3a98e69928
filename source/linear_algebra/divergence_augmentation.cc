#include <continua/linear_algebra/divergence_augmentation.h>

#include <deal.II/base/index_set.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace Continua
{
using namespace dealii;

template <int n_components>
DivergenceAugmentation<n_components>::DivergenceAugmentation(
    const TrilinosWrappers::SparseMatrix &divergence, const DistributedVector &weights_of_pressures)
{
  const Epetra_CrsMatrix &matrix = divergence.trilinos_matrix();
  const IndexSet owned = divergence.locally_owned_domain_indices();
  IndexSet ghosts(owned.size());
  std::vector<types::global_dof_index> of_others;
  for (int c = 0; c < matrix.NumMyCols(); ++c)
  {
    const types::global_dof_index column = matrix.GCID(c);
    if (!owned.is_element(column))
      of_others.push_back(column);
  }
  std::sort(of_others.begin(), of_others.end());
  ghosts.add_indices(of_others.begin(), of_others.end());
  source_entries.reinit(owned, ghosts, divergence.get_mpi_communicator());
  target_entries.reinit(source_entries);

  begins.push_back(0);
  std::map<unsigned int, float> row_entries;
  for (int row = 0; row < matrix.NumMyRows(); ++row)
  {
    const double weight = weights_of_pressures.begin()[row];
    if (!(weight > 0.))
      continue;
    weights.push_back(static_cast<float>(weight));
    int n_entries = 0;
    double *entries = nullptr;
    int *locals = nullptr;
    matrix.ExtractMyRowView(row, n_entries, entries, locals);
    row_entries.clear();
    for (int e = 0; e < n_entries; ++e)
      if (entries[e] != 0.)
        row_entries[source_entries.get_partitioner()->global_to_local(matrix.GCID(locals[e]))] =
            static_cast<float>(entries[e]);
    append_row(row_entries);
  }
}

template <int n_components>
void DivergenceAugmentation<n_components>::append_row(const std::map<unsigned int, float> &entries)
{
  const unsigned int n_columns =
      source_entries.locally_owned_size() + source_entries.get_partitioner()->n_ghost_indices();
  for (const auto &[column, value] : entries)
  {
    if (nodes.size() == begins.back() || column >= nodes.back() + n_components)
    {
      nodes.push_back(std::min(column, n_columns - n_components));
      values.resize(values.size() + n_components, 0.f);
    }
    values[values.size() - n_components + column - nodes.back()] = value;
  }
  begins.push_back(nodes.size());
}

template <int n_components>
void DivergenceAugmentation<n_components>::add_product(Vector &target, const Vector &source) const
{
  std::copy(source.begin(), source.end(), source_entries.begin());
  source_entries.update_ghost_values();
  target_entries = 0.f;
  const float *const from = source_entries.begin();
  float *const to = target_entries.begin();
  for (std::size_t row = 0; row < weights.size(); ++row)
  {
    const float *value = values.data() + begins[row] * n_components;
    std::array<float, n_components> sums = {};
    for (std::size_t k = begins[row]; k < begins[row + 1]; ++k, value += n_components)
      for (int c = 0; c < n_components; ++c)
        sums[c] += value[c] * from[nodes[k] + c];
    const float sum = weights[row] * std::accumulate(sums.begin(), sums.end(), 0.f);
    value = values.data() + begins[row] * n_components;
    for (std::size_t k = begins[row]; k < begins[row + 1]; ++k, value += n_components)
      for (int c = 0; c < n_components; ++c)
        to[nodes[k] + c] += value[c] * sum;
  }
  source_entries.zero_out_ghost_values();
  add_owned(target);
}

template <int n_components>
void DivergenceAugmentation<n_components>::add_diagonal(Vector &diagonal) const
{
  target_entries = 0.f;
  for (std::size_t row = 0; row < weights.size(); ++row)
    for (std::size_t k = begins[row]; k < begins[row + 1]; ++k)
      for (int c = 0; c < n_components; ++c)
      {
        const float value = values[k * n_components + c];
        target_entries.local_element(nodes[k] + c) += weights[row] * value * value;
      }
  add_owned(diagonal);
}

template <int n_components>
void DivergenceAugmentation<n_components>::add_owned(Vector &target) const
{
  target_entries.compress(VectorOperation::add);
  for (unsigned int i = 0; i < target.locally_owned_size(); ++i)
    target.local_element(i) += target_entries.local_element(i);
}

template class DivergenceAugmentation<2>;
template class DivergenceAugmentation<3>;
} // namespace Continua
