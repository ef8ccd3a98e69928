#ifndef continua_linear_algebra_single_precision_factor_h
#define continua_linear_algebra_single_precision_factor_h

#include <continua/linear_algebra/mumps_solver.h>
#include <continua/linear_algebra/symmetric_factor.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * MUMPS's L D L^T in single precision, on any number of ranks: half the memory of MumpsFactor. A
 * solve has the error of single precision times the matrix' condition, so it serves as a
 * preconditioner of BlockKrylov.
 *
 * The matrix K is scaled on both sides, since the numbers of single precision end at 1e38: rows
 * with a positive diagonal to a unit diagonal, the others (pressures) to a largest entry of one in
 * size. All entries of a saddle-point matrix are then at most about one.
 */
class SinglePrecisionFactor : public SymmetricFactor
{
public:
  /// Without pivoting a pressure may be eliminated before its velocities. Its pivot then adds
  /// entries of the size of the inverse pivot to those of the velocities, whose digits are lost if
  /// the pivot is small. Below this size of a scaled pivot MUMPS pivots.
  static constexpr double smallest_pivot = 1e-3;

  /// `quasi_definite`: there is a factor in every order of elimination. MUMPS does not pivot then,
  /// unless a scaled diagonal entry is below `smallest_pivot`.
  SinglePrecisionFactor(bool quasi_definite, MPI_Comm communicator);

  void factorize(SymmetricTriplets matrix, const std::vector<int> &owned) override;
  void solve(std::vector<double> &x) override;
  double n_entries() const override { return solver->n_entries(); }
  double memory() const override { return solver->memory(); }
  std::string name() const override;
  /// The factors s of the rows and columns, in the order of `owned`: s K s is what is factored.
  const std::vector<double> &scale() const { return owned_scale; }

private:
  const bool quasi_definite;
  const MPI_Comm communicator;
  bool pivots = false;
  std::unique_ptr<MumpsSolver<float>> solver;
  std::vector<double> owned_scale;
  std::vector<float> single; ///< right-hand side and solution, scaled
};
} // namespace Continua

#endif
