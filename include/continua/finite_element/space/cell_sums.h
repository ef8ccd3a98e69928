#ifndef continua_finite_element_space_cell_sums_h
#define continua_finite_element_space_cell_sums_h

#include <continua/linear_algebra/distributed_vector.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/types.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/vector.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * Sums of what cells give to the rows of a vector. While the cells are visited they are kept by
 * place, in plain memory: a distributed vector looks up each entry, and hanging nodes are condensed
 * once for all cells in place of once for each.
 */
class CellSums
{
public:
  /// The mesh has changed. `ghosted`: a vector with the ghost entries whose places the cells have
  /// (QuadratureCell); `owned_indices`: a contiguous range; `hanging`: the lines that are
  /// condensed. Collective.
  void reinit(const DistributedVector &ghosted,
              const dealii::IndexSet &owned_indices,
              const dealii::AffineConstraints<double> &hanging);
  /// Adds what a cell gives.
  void add(const std::vector<int> &places, const dealii::Vector<double> &of_cell)
  {
    for (std::size_t i = 0; i < places.size(); ++i)
      sums[places[i]] += of_cell[i];
  }
  /// The sums by place, to which cells may add without add().
  double *by_place() { return sums.data(); }
  /// Adds the sums to an owned vector, with the hanging nodes condensed, and begins anew.
  /// Collective.
  void add_to(DistributedVector &rows);
  /// Begins anew.
  void forget();

private:
  /// A place whose sum belongs to entries of other ranks, or to those that a hanging node hangs on.
  struct Elsewhere
  {
    std::size_t place = 0;
    /// Entries of `of_others`, with their weights.
    std::vector<std::pair<unsigned int, double>> entries;
  };

  std::vector<double> sums;    ///< by place
  std::size_t first_owned = 0; ///< place of the first entry of this rank
  std::vector<Elsewhere> elsewhere;
  bool some_are_elsewhere = false; ///< on any rank
  /// What these give, with the entries of other ranks: keeps the plan of the exchange.
  dealii::LinearAlgebra::distributed::Vector<double> of_others;
};
} // namespace Continua

#endif
