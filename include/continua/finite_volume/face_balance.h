#ifndef continua_finite_volume_face_balance_h
#define continua_finite_volume_face_balance_h

#include <continua/finite_volume/face_links.h>

#include <array>
#include <cstddef>
#include <vector>

namespace Continua
{
/**
 * The faces' own equations, solved face by face with what is in the cells and on the other faces
 * as it is. On a boundary whose normal velocity is free the face's pressure answers its velocity as
 * the equation of state does (K times the velocity's normal difference), whatever condition it
 * obeys: without that the velocity of a face overshoots where the bulk modulus is large beside the
 * stencil coefficient, and the loop diverges.
 */
template <int dim>
class FaceBalance
{
public:
  using Vector = typename SplitEquations<dim>::Vector;

  /// A face's pressure on one side.
  struct FacePressure
  {
    unsigned int pressure = 0; ///< its place in the vector
    unsigned int cell = 0;     ///< its cell's pressure's place
    double inverse = 0.;       ///< one over its coefficient in its own equation
    bool normal_is_free = false;
    bool from_definition = false; ///< whether its equation is one of state
  };

  FaceBalance(const CellWiseSystem<dim> &system,
              const SplitEquations<dim> &equations,
              const FaceLinks<dim> &links);

  void reinit();
  const std::vector<FacePressure> &pressures() const { return all_pressures; }

  /// Velocities and pressures of this rank's faces from their own equations; the unknowns' ghosts
  /// up to date before, not after.
  void solve(const Vector &right_side, Vector &unknowns);
  /// The pressures alone, each from its own equation.
  void solve_pressures(const Vector &right_side, Vector &unknowns);

private:
  /// The inverse of a face's equations: those of its velocity and, maybe, its pressure's.
  struct Block
  {
    unsigned int velocity = 0;
    unsigned int pressure = dealii::numbers::invalid_unsigned_int; ///< if it is solved for
    std::array<double, static_cast<std::size_t>(dim + 1) * (dim + 1)> inverse = {};
  };

  const CellWiseSystem<dim> &system;
  const SplitEquations<dim> &equations;
  const FaceLinks<dim> &links;
  std::vector<Block> blocks;
  std::vector<FacePressure> all_pressures;
  Vector residual; ///< work space

  void find_pressures();
  void invert_blocks();
};
} // namespace Continua

#endif
