#ifndef continua_finite_element_solvers_step_system_h
#define continua_finite_element_solvers_step_system_h

#include <continua/base/memory_use.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/solvers/condensed_system.h>
#include <continua/finite_element/solvers/iterative/iterative_step_solver.h>
#include <continua/finite_element/solvers/solver_choice.h>
#include <continua/finite_element/space/linear_solver_parameters.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/block_krylov.h>
#include <continua/linear_algebra/single_precision_factor.h>
#include <continua/linear_algebra/symmetric_factor.h>

#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Continua
{
/**
 * The symmetric system of a step,
 *
 *   [  A   -B^T ] [ U ]   [ f ]       A = sum a0 rho M + alpha S,  C = sum M_p / (K b)
 *   [ -B   -C   ] [ p ] = [ g ]           + supports
 *
 * and its solver: a factor in double or single precision, of which as many are kept as the
 * parameters say, the least recently used goes; or an iterative one. Boundary constraints are
 * eliminated on both sides.
 */
template <int dim>
class StepSystem
{
public:
  /// Of solves with a factor in single precision: the residual relative to the right-hand side, and
  /// the most iterations that it may take.
  static constexpr double single_precision_tolerance = 1e-12;
  static constexpr unsigned int most_single_precision_iterations = 40;

  StepSystem(const Space<dim> &space,
             const std::vector<RegionOperators> &operators,
             const BoundaryConstraints<dim> &constraints,
             const LinearSolverParameters &parameters,
             const SolverOutlook &outlook = {});

  /// Called before a factor of so many unknowns is made that will need so much memory [bytes].
  std::function<void(double n_unknowns, double bytes)> announce;
  /// Called where a factor without pivots has lost its digits, before one with pivots takes its
  /// place.
  std::function<void(const std::string &name_of_factor)> announce_pivots;
  /// Whether n_negative_pivots() will be asked for of factors that are made from here on.
  bool counts_pivots = false;
  /// Is told what the solvers take; null: nothing is.
  MemoryUse *memory_use = nullptr;

  /// Forgets the factor: mesh or constraints have changed.
  void reinit();
  /// Makes the system that of the coefficients, and says whether they are others than before.
  /// Throws RunError.
  bool prepare(const SystemCoefficients &coefficients);
  /// Takes the coefficients for the products alone, and says whether they are others than before;
  /// what prepare() made is then of no use until it is called again.
  bool take(const SystemCoefficients &wanted);
  const SystemCoefficients &present_coefficients() const { return coefficients; }
  /// The solver of the present space's system. The caller excludes vibrations, whose solver is
  /// always direct.
  SolverChoice choice() const;
  /// Whether the last prepare() or prepare_nearby() had to make a factor or a preconditioner.
  bool has_new_factor() const { return made_factor; }
  /// Solves for free dofs; constrained and hanging entries of the result are 0. The right-hand
  /// sides must be restricted. After a new factor the residual is checked once: if it is larger
  /// than 1e-8 of the right-hand side, and stays large after a step of refinement, a factor with
  /// pivots takes the place of one without, and RunError is thrown for any other. RunError if a
  /// solver that iterates does not converge.
  void solve(DistributedVector &momentum,
             DistributedVector &mass,
             DistributedVector &velocity,
             DistributedVector &pressure);
  /// Of the iterative solver alone: the linear terms stay as take() has them, the preconditioner of
  /// solve_tangent() becomes that of a system nearby.
  void prepare_nearby(const SystemCoefficients &wanted);
  /// Of the iterative solver alone: see IterativeStepSolver.
  void precondition_grad_div(const std::vector<double> &viscosities)
  {
    iterative_solver->precondition_grad_div(viscosities);
  }
  /// Of the iterative solver alone. `add_nonlinear_terms` adds what the tangent has beside the
  /// linear terms to the rows of momentum and to minus those of volume; the preconditioner is that
  /// of prepare_nearby().
  void solve_tangent(const SaddlePointSolver::Product &add_nonlinear_terms,
                     TangentTerms kind,
                     double tolerance,
                     DistributedVector &momentum,
                     DistributedVector &mass,
                     DistributedVector &velocity,
                     DistributedVector &pressure);
  /// result += A U, of the unconstrained matrix.
  void add_velocity_product(const DistributedVector &velocity, DistributedVector &result);
  /// result += factor B U and result += factor B^T p.
  void add_divergence(double factor, const DistributedVector &velocity, DistributedVector &result);
  void add_gradient(double factor, const DistributedVector &pressure, DistributedVector &result);
  /// result += C p.
  void add_compression(const DistributedVector &pressure, DistributedVector &result);

  /// Before something that takes much memory for a while: frees the basis of the iterative solver,
  /// two vectors for each iteration. The next solve allocates it again.
  void free_work_space();

  /// The factor in use, of the stiff block alone if the solver is iterative; null if there is none.
  const SymmetricFactor *factor() const;
  /// The number of negative eigenvalues of the system with the present coefficients, constrained
  /// dofs included, by the pivots of a factor: each pressure has one where no mass is negative.
  std::size_t n_negative_pivots() const { return factor()->n_negative_pivots(); }
  /// Of the solver in use; empty before the first prepare().
  std::string name() const;
  StepSolver solver() const { return chosen.solver; }
  bool is_automatic() const { return parameters.type == LinearSolverType::automatic; }
  const std::string &reason() const { return chosen.reason; }
  /// Whether the library that made the factor was chosen by the number of ranks, too.
  bool library_depends_on_ranks() const
  {
    return factor() != nullptr && chosen.solver != StepSolver::single_precision &&
           parameters.direct_solver == DirectSolver::automatic;
  }
  /// Of a solver that iterates, since the last call.
  unsigned int take_iterations();

private:
  struct KeptFactor
  {
    SystemCoefficients coefficients;
    std::unique_ptr<SymmetricFactor> factor;
    SinglePrecisionFactor *single = nullptr; ///< the factor, if that is its kind
    bool may_pivot = false; ///< it was made without pivots, and one with pivots may replace it
    bool residual_is_checked = false;
  };

  const Space<dim> &space;
  const std::vector<RegionOperators> &operators;
  const BoundaryConstraints<dim> &constraints;
  const LinearSolverParameters parameters;
  const SolverOutlook outlook;
  SystemCoefficients coefficients;
  std::optional<SystemCoefficients> nearby; ///< see prepare_nearby()
  std::list<KeptFactor> kept_factors;       ///< the one in use first
  std::unique_ptr<IterativeStepSolver<dim>> iterative_solver;
  BlockKrylov mixed_precision; ///< see solve_in_mixed_precision()
  SolverChoice chosen;
  bool is_prepared = false, made_factor = false, has_checked_blocks = false;
  unsigned int n_iterations = 0;
  std::vector<unsigned int> pressure_hanging; ///< local indices
  DistributedVector velocity_product, pressure_product;
  // Work space of a factor, and of a system nearby: the iterative solver alone needs none of it.
  std::vector<double> packed;
  DistributedVector velocity_residual, pressure_residual, velocity_correction, pressure_correction,
      zero_velocity;

  /// A negative mass is the shift of an eigenvalue problem.
  bool has_negative_mass() const;
  void make_work_space();
  /// Decides on the solver for these coefficients.
  void choose();
  /// `pivots`: by MUMPS with pivots, where a factor without them has lost its digits.
  void factorize(bool pivots = false);
  /// Makes a factor with pivots in the place of one that has lost its digits.
  void take_pivots(std::unique_ptr<SymmetricFactor> failed);
  void solve_packed(const DistributedVector &momentum,
                    const DistributedVector &mass,
                    DistributedVector &velocity,
                    DistributedVector &pressure);
  /// By FGMRES with a factor in single precision. As a preconditioner the factor loses to rounding
  /// alone, so that a few iterations reach the accuracy of a factor in double precision (Arioli and
  /// Duff, ETNA 33 (2009)).
  void solve_in_mixed_precision(const DistributedVector &momentum,
                                const DistributedVector &mass,
                                DistributedVector &velocity,
                                DistributedVector &pressure);
  void prepare_iterative(const SystemCoefficients &of_preconditioner);
  /// Overwrites momentum and mass by the product of the restricted system with a solution that is
  /// zero at constrained dofs.
  void multiply_system(const DistributedVector &velocity,
                       const DistributedVector &pressure,
                       DistributedVector &momentum,
                       DistributedVector &mass);
  /// Residual of the restricted system for a solution that is zero at constrained dofs; returns its
  /// relative size.
  double residual(const DistributedVector &momentum,
                  const DistributedVector &mass,
                  const DistributedVector &velocity,
                  const DistributedVector &pressure);
};
} // namespace Continua

#endif
