#ifndef continua_finite_element_solvers_harmonic_solver_h
#define continua_finite_element_solvers_harmonic_solver_h

#include <continua/continuum/harmonic_system.h>
#include <continua/finite_element/solvers/harmonic_equations.h>
#include <continua/finite_element/solvers/harmonic_factors.h>
#include <continua/finite_element/solvers/harmonic_matrix.h>
#include <continua/finite_element/solvers/harmonic_ports.h>
#include <continua/finite_element/solvers/harmonic_residuals.h>
#include <continua/finite_element/space/space.h>

#include <complex>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * Solutions of the equations of a motion exp(s t) with factors of the body without the pressures of
 * its ports; the responses to these are further right-hand sides of the same factor. A solution
 * whose residual is above `tolerance` is corrected with the factor, twice at most, and so is the
 * whole with its ports. What is above `largest_accepted_residual` then, or is no number, is a
 * RunError. What a method does is said in HarmonicSystem under the same name.
 */
template <int dim>
class HarmonicSolver
{
public:
  using Complex = std::complex<double>;
  /// Of the residual, of the largest force at a node. Where a thin wall is much stiffer than what
  /// is around, the forces within it cancel, and round-off leaves no less.
  static constexpr double tolerance = 1e-9;
  static constexpr double largest_accepted_residual = 1e-6;

  /// All must outlive it.
  HarmonicSolver(const Space<dim> &space,
                 const std::vector<RegionOperators> &operators,
                 const BoundaryConstraints<dim> &constraints,
                 HarmonicEquations<dim> &equations,
                 HarmonicPorts &ports);

  void factor(Complex s) { make_factors({s}); }
  std::vector<HarmonicSolution> solve(const std::vector<HarmonicLoad> &loads);
  void solve_at(const std::vector<Complex> &s,
                const std::function<std::vector<HarmonicLoad>(std::size_t number)> &loads_at,
                const std::function<void(std::size_t number,
                                         const std::vector<HarmonicLoad> &loads,
                                         const std::vector<HarmonicSolution> &solutions)> &sink);
  std::vector<HarmonicSolution> solve_further(std::size_t number,
                                              const std::vector<HarmonicLoad> &loads);
  HarmonicDeterminant determinant();
  int n_unknowns() const { return matrix.size(); }
  double factor_memory() const { return factors->memory(); }
  double largest_residual() const { return residual_of_all; }
  std::string name() const;

private:
  HarmonicEquations<dim> &equations;
  HarmonicPorts &ports;
  HarmonicResiduals<dim> residual;
  HarmonicMatrix matrix;
  std::unique_ptr<HarmonicFactors> factors;
  std::vector<Complex> factored;   ///< the s of the factors
  std::size_t number_of_first = 0; ///< of the first of them among those of solve_at()
  double residual_of_all = 0.;

  /// Sets the factors in use. Throws with the frequency.
  void make_factors(const std::vector<Complex> &all_s);
  /// The right-hand sides of loads at s, and behind them those of the ports.
  HarmonicFactors::Columns right_hand_sides(Complex s, const std::vector<HarmonicLoad> &loads);
  /// Whether no further correction is wanted, with the residuals by factor in use. Throws RunError
  /// if the last one leaves too much.
  bool is_solved(const std::vector<double> &residuals, unsigned int correction);
  /// Solves and corrects the columns of the factors in use.
  void solve_columns(std::vector<HarmonicFactors::Columns> &columns);
  /// Corrects solutions with their ports; `columns`: those of loads and ports.
  void correct(const std::vector<std::vector<HarmonicLoad>> &loads,
               const std::vector<HarmonicFactors::Columns> &columns,
               std::vector<std::vector<HarmonicSolution>> &solutions);
  /// `number`: of a factor in use.
  std::vector<HarmonicSolution> complete(std::size_t number,
                                         const std::vector<HarmonicLoad> &loads,
                                         const HarmonicFactors::Columns &columns);
  std::vector<std::vector<HarmonicSolution>>
  solve_in_use(const std::vector<std::vector<HarmonicLoad>> &loads);
};
} // namespace Continua

#endif
