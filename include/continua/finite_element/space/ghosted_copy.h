#ifndef continua_finite_element_space_ghosted_copy_h
#define continua_finite_element_space_ghosted_copy_h

#include <continua/linear_algebra/distributed_vector.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/lac/affine_constraints.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace Continua
{
/**
 * Copies owned vectors into vectors with ghost entries, and sets hanging nodes there. The plan of
 * the exchange and the lines of the hanging nodes are kept: AffineConstraints::distribute() and an
 * assignment make them anew in each call.
 */
class GhostedCopy
{
public:
  /// The mesh has changed. `owned_indices`: a contiguous range; `relevant_indices`: those of
  /// vectors with ghost entries. Collective.
  void reinit(const dealii::IndexSet &owned_indices,
              const dealii::IndexSet &relevant_indices,
              const dealii::AffineConstraints<double> &hanging,
              MPI_Comm communicator);
  /// Collective.
  void copy(const DistributedVector &owned, DistributedVector &ghosted);

private:
  /// A summand of a hanging node: an owned entry, or one of `ghosts`.
  struct Summand
  {
    bool is_owned = false;
    std::size_t index = 0;
    double weight = 0.;
  };
  struct HangingNode
  {
    std::size_t index = 0; ///< among the owned entries
    std::vector<Summand> summands;
  };

  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner;
  std::size_t n_places = 0;    ///< in a vector with ghosts
  std::size_t first_owned = 0; ///< place of the first owned entry in a vector with ghosts
  std::vector<int> places;     ///< there, of each of `ghosts`; -1: it only serves hanging nodes
  std::vector<HangingNode> hanging_nodes; ///< owned ones
  bool some_ghosts_hang = false;          ///< on any rank
  std::vector<double> ghosts, sent;       ///< work space
  std::vector<MPI_Request> requests;

  /// Sets `ghosts` from owned entries of the ranks. Collective.
  void exchange(const double *owned_entries);
};
} // namespace Continua

#endif
