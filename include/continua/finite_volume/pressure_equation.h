#ifndef continua_finite_volume_pressure_equation_h
#define continua_finite_volume_pressure_equation_h

#include <continua/finite_volume/compact_matrix.h>
#include <continua/finite_volume/face_balance.h>
#include <continua/linear_algebra/symmetric_factor.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * The pressure equation of PISO (equation 3.58): compressibility minus the compact Laplacian with
 * 1/a_P, for the change of the cells' pressure that makes up for what the equation of state lacks.
 * Where the fluxes are corrected by the pressure's increment the coefficient is that correction's
 * if it is the larger one: with 1/a_P, which is small where inertia rules, the loop would leave out
 * more than half of what damps a checkerboard, and diverge.
 */
template <int dim>
class PressureEquation
{
public:
  using Vector = typename SplitEquations<dim>::Vector;

  PressureEquation(const CellWiseSystem<dim> &system,
                   const SplitEquations<dim> &equations,
                   const FaceLinks<dim> &links,
                   const FaceBalance<dim> &faces);

  /// Makes and factors the matrix. Throws RunError.
  void reinit();
  /// Turns the residual of the cells' equations of state into the change of all pressures: the
  /// faces' follow their cells' or stay.
  void solve(const Vector &residual, Vector &change);
  /// product = matrix * x on the cells' entries; x's ghosts up to date.
  void multiply(const Vector &x, Vector &product) const { matrix.multiply(x, product); }
  /// The products of the matrix with ones in all cells.
  const std::vector<double> &row_sums() const { return matrix.row_sums(); }
  /// 1/(a_P V) of this rank's cells, a_P the diagonal of the momentum equations [m s/kg].
  const std::vector<double> &inverse_momentum() const { return inverse_diagonal; }

  /// 0 before reinit().
  double factor_entries() const { return factor ? factor->n_entries() : 0.; }
  double factor_memory() const { return factor ? factor->memory() : 0.; }

private:
  const CellWiseSystem<dim> &system;
  const SplitEquations<dim> &equations;
  const FaceLinks<dim> &links;
  const FaceBalance<dim> &faces;
  CompactMatrix<dim> matrix;
  std::vector<double> inverse_diagonal;
  /// Pressures of faces that follow their cell's: (face, cell), and those that stay.
  std::vector<std::pair<unsigned int, unsigned int>> following;
  std::vector<unsigned int> staying;
  std::unique_ptr<SymmetricFactor> factor;
  std::vector<double> cells; ///< work space

  void find_couplings();
};
} // namespace Continua

#endif
