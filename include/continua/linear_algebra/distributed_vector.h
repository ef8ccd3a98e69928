#ifndef continua_linear_algebra_distributed_vector_h
#define continua_linear_algebra_distributed_vector_h

#include <deal.II/lac/trilinos_vector.h>

namespace Continua
{
/**
 * A vector of unknowns over all ranks, of any discretisation.
 *
 * Assignment between two vectors of equal global size keeps the *layout* of the target (which rank
 * owns which entries) and moves the values over. After a change of the mesh the old layout may have
 * the same size as the new one. A vector therefore takes its layout by `vector.reinit(other)`, or
 * from a temporary as in `vector = space.velocity_vector()`, never by `vector = other`. Values pass
 * by `vector.equ(1., other)`.
 */
using DistributedVector = dealii::TrilinosWrappers::MPI::Vector;

/// Whether this rank owns the same entries of both. Not collective. For assertions.
inline bool have_same_layout(const DistributedVector &a, const DistributedVector &b)
{
  return a.size() == b.size() && a.local_range() == b.local_range();
}
} // namespace Continua

#endif
