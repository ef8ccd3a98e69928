#ifndef continua_finite_volume_momentum_predictor_h
#define continua_finite_volume_momentum_predictor_h

#include <continua/finite_volume/compact_matrix.h>
#include <continua/finite_volume/face_links.h>
#include <continua/linear_algebra/symmetric_factor.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * The implicit part of the momentum equations, component by component: mass and the Laplacian on
 * the compact stencil with the coefficient c alpha (equations 3.36 to 3.41), symmetric, the faces'
 * own velocities eliminated or, where they are prescribed, on the right side. Components share
 * their matrix and its factor unless conditions on oblique faces or axisymmetry (the hoop term)
 * tell them apart.
 */
template <int dim>
class MomentumPredictor
{
public:
  using Vector = typename SplitEquations<dim>::Vector;

  MomentumPredictor(const CellWiseSystem<dim> &system,
                    const SplitEquations<dim> &equations,
                    const FaceLinks<dim> &links);

  /// Makes and factors the matrices. Throws RunError.
  void reinit();

  /// Turns the cells' residual, all components, into the change of their velocities.
  void solve(const Vector &residual, Vector &change);
  /// product = matrix * x on the cells' entries, each component with its own; x's ghosts up to
  /// date.
  void multiply(const Vector &x, Vector &product) const { matrix.multiply(x, product); }
  /// The products of each component's matrix with ones in all cells, by cell and component.
  const std::vector<double> &row_sums() const { return matrix.row_sums(); }
  double factor_entries() const;
  double factor_memory() const;
  std::string name() const;

private:
  const CellWiseSystem<dim> &system;
  const SplitEquations<dim> &equations;
  const FaceLinks<dim> &links;
  CompactMatrix<dim> matrix;
  std::vector<std::unique_ptr<SymmetricFactor>> factors;
  std::array<unsigned int, dim> factor_of; ///< by component
  std::vector<double> component;           ///< work space

  void find_couplings();
  void set_row_sums();
};
} // namespace Continua

#endif
