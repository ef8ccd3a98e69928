#ifndef continua_finite_volume_loop_residual_h
#define continua_finite_volume_loop_residual_h

#include <mpi.h>

#include <array>
#include <cstddef>

namespace Continua
{
/**
 * The residual of the linear equations A x = b of each of a few components in the scale of the
 * thesis's code,
 *
 *   r = sum |b - A x| / sum(|A x - A x_mean| + |b - A x_mean|),
 *
 * with x_mean the component's mean in all rows: between 0 and 1. A component that is next to
 * nothing beside the others is measured by a thousandth of the largest scale, since rounding is all
 * it has.
 */
class LoopResidual
{
public:
  static constexpr unsigned int most_components = 3;

  LoopResidual(unsigned int n_components, MPI_Comm communicator);

  /**
   * Of this rank's rows: b - A x, A x, the sums of A's rows, x; a row's components stand one after
   * the other. Collective. `n_rows_global`: over all ranks.
   */
  void evaluate(std::size_t n_rows,
                double n_rows_global,
                const double *residual,
                const double *product,
                const double *row_sums,
                const double *x);

  /// The largest of the components [1]; not finite if the equations are not.
  double largest() const { return largest_residual; }
  /// sum |b - A x| over all components, in the unit of the equations.
  double magnitude() const { return sum; }

private:
  unsigned int n_components;
  MPI_Comm communicator;
  double largest_residual = 0., sum = 0.;
};
} // namespace Continua

#endif
