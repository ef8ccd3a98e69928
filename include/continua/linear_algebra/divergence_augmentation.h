#ifndef continua_linear_algebra_divergence_augmentation_h
#define continua_linear_algebra_divergence_augmentation_h

#include <continua/linear_algebra/distributed_vector.h>

#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <cstddef>
#include <map>
#include <vector>

namespace Continua
{
/**
 * Products with B^T W B in single precision: B the divergence of the velocities, W >= 0 a diagonal
 * of the pressures. The matrix itself, which has many more entries than B, is not formed: each row
 * of B is read once, for the product with it and with its transpose. The components of a node,
 * which usually have consecutive numbers, share one index.
 */
template <int n_components>
class DivergenceAugmentation
{
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<float>;

  /// B and the diagonal of W are not kept. Collective.
  DivergenceAugmentation(const dealii::TrilinosWrappers::SparseMatrix &divergence,
                         const DistributedVector &weights);

  /// target += B^T W B source; both have the velocities of this rank. Allocates nothing.
  /// Collective.
  void add_product(Vector &target, const Vector &source) const;
  /// Adds the diagonal of B^T W B. Collective.
  void add_diagonal(Vector &diagonal) const;

private:
  std::vector<float> weights;      ///< by row: those of W that are above zero
  std::vector<std::size_t> begins; ///< of the rows in `nodes`, and the end of the last one
  std::vector<unsigned int> nodes; ///< local indices of their first components
  std::vector<float> values;       ///< n_components for each of the nodes
  mutable Vector source_entries, target_entries; ///< with the columns that other ranks own

  void append_row(const std::map<unsigned int, float> &entries);
  void add_owned(Vector &target) const;
};
} // namespace Continua

#endif
