#ifndef continua_linear_algebra_mixed_precision_solver_h
#define continua_linear_algebra_mixed_precision_solver_h

#include <continua/linear_algebra/distributed_vector.h>
#include <continua/linear_algebra/saddle_point_solver.h>
#include <continua/linear_algebra/single_precision_factor.h>

#include <deal.II/lac/trilinos_parallel_block_vector.h>
#include <deal.II/lac/vector_memory.h>

#include <functional>
#include <vector>

namespace Continua
{
/**
 * FGMRES in double precision for velocity and pressure (Saad, SIAM J. Sci. Comput. 14 (1993)),
 * preconditioned with the matrix' own factor in single precision. As a preconditioner the factor
 * loses to rounding alone, so that a few iterations reach the accuracy of a factor in double
 * precision (Arioli and Duff, ETNA 33 (2009)). Residuals r are measured as |s r| with the
 * factor's scale s, in which velocities and pressures have one unit.
 */
class MixedPrecisionSolver
{
public:
  /// Overwrites rows of momentum and of volume by the product of the factored matrix with
  /// velocity and pressure.
  using Product = std::function<void(const DistributedVector &velocity,
                                     const DistributedVector &pressure,
                                     DistributedVector &momentum,
                                     DistributedVector &mass)>;

  /// Takes the layout of the vectors; the factor's owned entries are those of the velocity and then
  /// those of the pressure.
  void reinit(const DistributedVector &velocity, const DistributedVector &pressure);
  /// Solves from zero until the residual is below the tolerance times the right-hand side, or for
  /// the largest number of iterations. Collective.
  KrylovReport solve(const Product &product,
                     SinglePrecisionFactor &factor,
                     const DistributedVector &momentum,
                     const DistributedVector &mass,
                     DistributedVector &velocity,
                     DistributedVector &pressure,
                     double tolerance,
                     unsigned int maximum_iterations);

private:
  using BlockVector = dealii::TrilinosWrappers::MPI::BlockVector;

  BlockVector right_hand_side, solution;
  std::vector<double> packed;
  dealii::GrowingVectorMemory<BlockVector> memory;
};
} // namespace Continua

#endif
