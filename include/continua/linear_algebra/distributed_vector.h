#ifndef continua_linear_algebra_distributed_vector_h
#define continua_linear_algebra_distributed_vector_h

#include <deal.II/lac/trilinos_vector.h>

namespace Continua
{
/// A vector of unknowns over all ranks, of any discretisation.
using DistributedVector = dealii::TrilinosWrappers::MPI::Vector;
} // namespace Continua

#endif
