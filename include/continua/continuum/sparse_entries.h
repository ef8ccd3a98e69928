#ifndef continua_continuum_sparse_entries_h
#define continua_continuum_sparse_entries_h

#include <continua/linear_algebra/distributed_vector.h>

#include <utility>
#include <vector>

namespace Continua
{
/// The owned entries of a vector that are not zero, by local index.
class SparseEntries
{
public:
  SparseEntries() = default;
  explicit SparseEntries(const DistributedVector &vector);

  /// This rank's part of the product with a vector of the same layout.
  double product(const DistributedVector &vector) const;
  /// Adds them, times a factor, to a vector.
  void add_to(DistributedVector &vector, double factor) const;
  /// Sets the entries of a vector at their places to theirs, times a factor; others stay.
  void copy_to(DistributedVector &vector, double factor = 1.) const;

private:
  std::vector<std::pair<unsigned int, double>> entries;
};
} // namespace Continua

#endif
