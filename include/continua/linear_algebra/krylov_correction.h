#ifndef continua_linear_algebra_krylov_correction_h
#define continua_linear_algebra_krylov_correction_h

#include <continua/linear_algebra/distributed_vector.h>

#include <deal.II/lac/trilinos_parallel_block_vector.h>
#include <deal.II/lac/vector_memory.h>

#include <functional>

namespace Continua
{
/**
 * Solves for a correction of velocity and pressure by GMRES (Saad and Schultz, SIAM J. Sci. Stat.
 * Comput. 7 (1986) 856), preconditioned from the right with the factor F of a matrix that is near
 * the derivative T:
 *
 *   T F^-1 z = r,     (U, p) = F^-1 z.
 *
 * The rows of momentum and of volume have different units, and therefore a scale each in which
 * their residuals are measured.
 */
class KrylovCorrection
{
public:
  /// T: overwrites rows of momentum [N] and of volume [m^3/s] by its product with changes of
  /// velocity [m/s] and pressure [Pa].
  using Derivative = std::function<void(const DistributedVector &velocity,
                                        const DistributedVector &pressure,
                                        DistributedVector &momentum,
                                        DistributedVector &mass)>;
  /// F^-1: overwrites changes of velocity and pressure; may change the rows.
  using Inverse = std::function<void(DistributedVector &momentum,
                                     DistributedVector &mass,
                                     DistributedVector &velocity,
                                     DistributedVector &pressure)>;
  /// Of the equations, and the sizes in which each is measured, above 0.
  struct Residuals
  {
    const DistributedVector &momentum, &mass;
    double momentum_scale, mass_scale;
  };

  /// Takes the layout of the vectors; allocates.
  void reinit(const DistributedVector &velocity, const DistributedVector &pressure);
  /// Solves until the scaled residual is below the tolerance times that at the start, or for the
  /// largest number of iterations; sets what they have reached. Returns their number. Collective.
  unsigned int solve(const Derivative &derivative,
                     const Inverse &inverse,
                     const Residuals &residuals,
                     double tolerance,
                     unsigned int maximum_iterations,
                     DistributedVector &velocity_change,
                     DistributedVector &pressure_change);

private:
  using BlockVector = dealii::TrilinosWrappers::MPI::BlockVector;

  dealii::GrowingVectorMemory<BlockVector> memory;
  BlockVector right_hand_side, solution, scaled_back;
  DistributedVector velocity_work, pressure_work;
};
} // namespace Continua

#endif
