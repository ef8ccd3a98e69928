#ifndef continua_linear_algebra_block_krylov_h
#define continua_linear_algebra_block_krylov_h

#include <continua/linear_algebra/distributed_vector.h>

#include <deal.II/lac/trilinos_parallel_block_vector.h>
#include <deal.II/lac/vector_memory.h>

#include <functional>

namespace Continua
{
/// Of a solve by BlockKrylov.
struct KrylovReport
{
  bool converged = true;
  unsigned int iterations = 0;
  double residual = 0.;    ///< relative, as the tolerance; NaN if a product was no number
  double late_factor = 0.; ///< see late_factor()
};

/**
 * GMRES (Saad and Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856) or FGMRES (Saad, SIAM J. Sci.
 * Comput. 14 (1993) 461) for velocity and pressure, preconditioned from the right. The rows of
 * momentum and of volume have different units: a residual r is measured as |s r|, with a scale s of
 * each row.
 *
 * Before a solve `scale` and then the right-hand side are set. Where the right-hand side or a
 * product is no number, the solution is NaN. Whoever takes the solution has to notice.
 */
class BlockKrylov
{
public:
  using BlockVector = dealii::TrilinosWrappers::MPI::BlockVector;
  /// Overwrites rows of momentum and of volume by the product with velocity and pressure.
  using Product = std::function<void(const DistributedVector &velocity,
                                     const DistributedVector &pressure,
                                     DistributedVector &momentum,
                                     DistributedVector &mass)>;
  /// The preconditioner: overwrites velocity and pressure; may change the rows, which are scaled.
  using Inverse = std::function<void(DistributedVector &momentum,
                                     DistributedVector &mass,
                                     DistributedVector &velocity,
                                     DistributedVector &pressure)>;
  enum class Method
  {
    gmres, ///< for a preconditioner that is linear: one vector for each iteration
    fgmres ///< for any preconditioner: two vectors
  };

  /// `basis_size`: iterations between restarts.
  BlockKrylov(Method method, unsigned int basis_size);

  BlockVector scale; ///< s

  /// Changes the method; before reinit().
  void use(const Method other) { method = other; }
  /// Takes the layout of the vectors; allocates.
  void reinit(const DistributedVector &velocity, const DistributedVector &pressure);
  /// The solve starts from zero.
  void set_right_hand_side(const DistributedVector &momentum, const DistributedVector &mass);
  /// The solve starts from these, if their residual is smaller than that of zero: returns whether.
  bool take_guess(const Product &product,
                  const DistributedVector &velocity,
                  const DistributedVector &pressure);
  const BlockVector &scaled_right_hand_side() const { return right_hand_side; }
  /// Solves until the scaled residual is below the tolerance times `size`, or for the largest
  /// number of iterations; sets what they have reached. If `size` is 0, this is zero. Collective.
  KrylovReport solve(const Product &product,
                     const Inverse &inverse,
                     double size,
                     double tolerance,
                     unsigned int maximum_iterations,
                     DistributedVector &velocity,
                     DistributedVector &pressure);
  /// Frees the basis, which is most of what a solve takes. The next solve allocates it again.
  void free_basis() { memory.release_unused_memory(); }

private:
  Method method;
  const unsigned int basis_size;
  BlockVector right_hand_side, solution, rows;
  dealii::GrowingVectorMemory<BlockVector> memory;

  void multiply(const Product &product, BlockVector &target, const BlockVector &source) const;
};
} // namespace Continua

#endif
