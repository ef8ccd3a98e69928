#ifndef continua_continuum_vector_numbering_h
#define continua_continuum_vector_numbering_h

#include <continua/base/archive.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <deal.II/dofs/dof_handler.h>

#include <mpi.h>

#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * Numbers for the entries of vectors that do not depend on the number of ranks, so that a vector
 * can be saved by some ranks and loaded by others, bit by bit. A rank's piece of the archive holds
 * its entries in the order of these numbers, and which numbers they are; the archive holds the
 * smallest and the largest number of each piece, so that a rank reads only those pieces that may
 * have entries of its own.
 */
class VectorNumbering
{
public:
  /// `name`: of the vectors' space in archives. `numbers`: of this rank's entries, in their local
  /// order; no number stands for two entries, on whichever ranks. Collective.
  VectorNumbering(MPI_Comm communicator,
                  const std::string &name,
                  const std::vector<unsigned long> &numbers);

  /// The numbering itself, to be saved once and before the vectors.
  void save(ArchiveWriter &archive) const;
  void save(ArchiveWriter &archive, const std::string &name, const DistributedVector &vector) const;
  /// Throws RunError if an entry is missing (another mesh).
  void load(const ArchiveReader &archive, const std::string &name, DistributedVector &vector) const;

private:
  using Interval = std::pair<unsigned long, unsigned long>; ///< begin, end

  std::string name;
  std::vector<unsigned int> order; ///< local indices, sorted by number; empty: as they are
  std::vector<Interval> intervals; ///< of the numbers, sorted
  std::size_t n_entries;
  std::vector<unsigned long> extents; ///< of each rank, begin and end; equal if it has none
};

/**
 * The numbers of a rank's dofs, which DoFRenumbering::hierarchical has put in the order of the
 * tree. On a parallel::distributed::Triangulation these are the dofs' own: a rank has the cells of
 * one stretch of the curve, and a dof between two ranks belongs to the first one, so that counting
 * along the curve is the same on any number of ranks. On a parallel::shared::Triangulation, whose
 * ranks have cells here and there: the place of the first cell that has the dof, and its number in
 * that cell.
 */
template <int dim>
std::vector<unsigned long> numbers_of_dofs(const dealii::DoFHandler<dim> &dof_handler);
} // namespace Continua

#endif
