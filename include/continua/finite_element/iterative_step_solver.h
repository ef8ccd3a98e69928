#ifndef continua_finite_element_iterative_step_solver_h
#define continua_finite_element_iterative_step_solver_h

#include <continua/base/memory_use.h>
#include <continua/finite_element/boundary_constraints.h>
#include <continua/finite_element/condensed_system.h>
#include <continua/finite_element/linear_solver_parameters.h>
#include <continua/finite_element/matrix_free_product.h>
#include <continua/finite_element/matrix_free_velocity.h>
#include <continua/finite_element/region_divergence.h>
#include <continua/finite_element/region_operators.h>
#include <continua/finite_element/space.h>
#include <continua/finite_element/stalled_block.h>
#include <continua/linear_algebra/matrix_operator.h>
#include <continua/linear_algebra/saddle_point_solver.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Continua
{
template <int dim>
class ChebyshevRelaxation;

/**
 * FGMRES on a step's system, with a preconditioner that knows its physics.
 *
 * Regions are stiff where alpha/(a0 rho) is more than `stiff_ratio` times the square of the mesh
 * size (by the diagonals of the matrices), and alpha not below `comparable` of the largest: of a
 * tube the wall, of a body without a fluid all of it. The velocities of stiff regions, interfaces
 * included, are one block of the VelocityPreconditioner; the others are relaxed, or, where they are
 * viscous on the scale of the mesh, have algebraic multigrid of their own.
 *
 * A alone takes no work for a change of volume; thin walls have many motions whose only work that
 * is. A direct stiff block therefore contains the pressures of the stiff regions, too. Where they
 * are incompressible it has a bulk modulus of 1e3 alpha instead, since its factor does not pivot.
 *
 * Where `Stiff block` is automatic, StiffBlockLimits decide between a factor and multigrid.
 *
 * With multigrid on the stiff block, and with the Schur complement of SIMPLE, the pressures of the
 * stiff regions stay in the Schur complement. With multigrid the preconditioner there has the
 * system augmented by the bulk modulus alpha (see SaddlePointSolver). PolynomialMultigrid takes its
 * B^T W B as it is, algebraic multigrid int alpha div u div v in its place. An error in the
 * pressure's Schur complement S^-1 = (1 + alpha s)/(s + 1/(K b)) then is at most a factor of two
 * for every s >= 1/alpha.
 *
 * The stabilisation grad-div of a flow has a part in the relaxation of the fluid and in the mass
 * form (see precondition_grad_div()). Like an augmentation it adds gamma to 1/s.
 */
template <int dim>
class IterativeStepSolver
{
public:
  /// All must outlive it.
  IterativeStepSolver(const Space<dim> &space,
                      const std::vector<RegionOperators> &operators,
                      const BoundaryConstraints<dim> &constraints,
                      const LinearSolverParameters &parameters,
                      MemoryUse *memory_use = nullptr);

  /**
   * Assembles the blocks of new coefficients. The preconditioner is made anew if there is none yet,
   * if a coefficient has changed by more than a factor of two since it was made, or if a solve has
   * taken more than 1.5 times as many iterations as its first one, and 5. Returns whether it was.
   */
  bool prepare(const SystemCoefficients &coefficients);
  /// Solves to the tolerance from the last solution. Throws RunError if that takes too many
  /// iterations. Returns how many it took.
  unsigned int solve(const DistributedVector &momentum,
                     const DistributedVector &mass,
                     DistributedVector &velocity,
                     DistributedVector &pressure);

  /// Gives the preconditioner a part of int gamma div v div u, which is among what a tangent has
  /// beside the linear terms: where the fluid is relaxed by products without a matrix, and with the
  /// mass form of the Schur complement. A change below `smallest_change` is left out.
  /// `viscosities`: the mean gamma in each cell, by active_cell_index() [Pa s]; empty: nothing is
  /// done. Not before prepare(). Collective.
  void precondition_grad_div(const std::vector<double> &viscosities);
  /// The same for a tangent, whose product is given (see SaddlePointSolver::Blocks): from zero,
  /// until the residual is below `tolerance` times that at the start. `kind`: for the message.
  /// Throws StepFailure if that takes too many iterations.
  unsigned int solve_tangent(const SaddlePointSolver::Product &whole,
                             FurtherTerms kind,
                             double tolerance,
                             const DistributedVector &momentum,
                             const DistributedVector &mass,
                             DistributedVector &velocity,
                             DistributedVector &pressure);

  /// See SaddlePointSolver.
  void free_basis() { solver.free_basis(); }

  /// "FGMRES; stiff block: ..., fluid block: ..., Schur complement: ...".
  std::string name() const;
  /// Of the stiff block; null if it has none.
  const SymmetricFactor *factor() const;
  /// Whether some velocities are not in the stiff block, after prepare().
  bool has_fluid_block() const { return preconditioner->has_fluid; }

private:
  /// Largest ratio of the diagonals of alpha S and a0 rho M for which relaxation is enough.
  static constexpr double stiff_ratio = 10.;
  static constexpr double viscous_ratio = 100.;
  static constexpr double comparable = 1e-3;
  /// Of the stiff block: 1/(K b) is at least so many 1/alpha.
  static constexpr double least_compressibility = 1e-3;

  /// Part of gamma that the preconditioner has [1]. With more of it the pressure gains, but the
  /// relaxation loses: in a bend FGMRES takes 27, 12, 11, 12 and 14 iterations with 0, 0.3, 0.5,
  /// 0.7 and 1 of it.
  static constexpr double share_of_grad_div = 0.5;
  /// Of gamma: the sum of |change| V over the liquid's cells, over that of (gamma + alpha) V [1].
  static constexpr double smallest_change = 0.3;

  struct Preconditioner
  {
    SystemCoefficients coefficients;
    /// A where something needs its entries later on, else empty.
    dealii::TrilinosWrappers::SparseMatrix velocity_matrix;
    std::unique_ptr<VelocityPreconditioner> velocity;
    std::unique_ptr<SchurComplement> schur_complement;
    /// A part of the above; null: the fluid is not relaxed by products without a matrix.
    ChebyshevRelaxation<dim> *chebyshev = nullptr;
    DistributedVector augmentation; ///< W
    std::vector<bool> is_stiff;     ///< of each owned velocity
    bool has_stiff = false, stiff_is_direct = true, fluid_is_viscous = false, has_inertia = true;
    bool has_polynomial_multigrid = false; ///< on the stiff block, else algebraic if not direct
    unsigned int first_iterations = 0;
    bool is_used = false, is_worn = false, has_fluid = true;
    std::string name, multigrid_name;
  };

  const Space<dim> &space;
  const std::vector<RegionOperators> &operators;
  const BoundaryConstraints<dim> &constraints;
  const LinearSolverParameters parameters;
  MemoryUse *const memory_use;
  SystemCoefficients coefficients;
  // Of the present coefficients: A in one of the two forms, B and C.
  std::unique_ptr<MatrixFreeVelocity<dim>> matrix_free_velocity;
  std::unique_ptr<MatrixFreeProduct<dim, float>> single_precision_product;
  dealii::TrilinosWrappers::SparseMatrix velocity_matrix;
  std::unique_ptr<MatrixOperator> assembled_velocity;
  RegionDivergence<dim> divergence;
  dealii::TrilinosWrappers::SparseMatrix compression;
  std::unique_ptr<Preconditioner> preconditioner;
  /// A stiff block whose factor was refused on this mesh.
  struct RefusedFactor
  {
    unsigned int n_stiff; ///< velocities of the block on all ranks
    double bytes;         ///< of its entries, by an estimate or the analysis
  };
  std::optional<RefusedFactor> refused_factor;
  SaddlePointSolver solver;
  DistributedVector last_velocity, last_pressure;
  /// gamma of each cell, of which the preconditioner has a part [Pa s]; empty: none.
  std::vector<double> grad_div;
  // While a preconditioner is made, by region:
  std::vector<std::vector<bool>> is_of_region; ///< of each owned velocity
  std::vector<DistributedVector> mass_diagonals, stiffness_diagonals;
  unsigned int n_stiff_of_all = 0;                ///< velocities of the stiff block on all ranks
  unsigned int n_stiff_without_linear_factor = 0; ///< with so many it was too large
  unsigned int n_stiff_with_small_estimate = 0;   ///< with so many no estimate is needed any more

  bool is_near(const SystemCoefficients &others) const;
  /// With multigrid where the factor of the stiff block turns out too large.
  void make_preconditioner();
  std::unique_ptr<Preconditioner> new_preconditioner();
  /// Most bytes of the factor of a stiff block of so many velocities; zero if it has multigrid.
  double most_factor_bytes(unsigned int n_stiff) const;
  /// Throws FactorTooLarge if an estimate of the stiff block's factor, before any of its entries
  /// is assembled, is more than it may have. Collective.
  void refuse_large_factor(const VelocityBlocks &parts);
  /// Gives the preconditioner the present gamma.
  void add_grad_div();
  void mark_memory(const std::string &part) const;
  /// From the last solution, or from zero for a correction; once more with a new preconditioner if
  /// it was one of other coefficients that failed. The report counts the iterations of both.
  KrylovReport solve_by_krylov(const SaddlePointSolver::Blocks &system,
                               double tolerance,
                               bool is_correction,
                               const DistributedVector &momentum,
                               const DistributedVector &mass,
                               DistributedVector &velocity,
                               DistributedVector &pressure);
  /// Measures each block of the preconditioner alone, with the velocities' block of the matrix that
  /// was to be solved, names the one that stalls, and says what to do. Takes as long as 40
  /// iterations.
  std::string describe_failure(const SaddlePointSolver::Blocks &system,
                               FurtherTerms kind,
                               const KrylovReport &report);
  /// Of a solve that has converged: whether the preconditioner is worn.
  void record_use(unsigned int iterations);
  /// Which regions are stiff, by the rule above; also finds the velocities of each region.
  std::vector<bool> find_stiff_regions();
  /// Whether the velocities outside the stiff block are relaxed by products without a matrix.
  bool relaxes_without_matrix(const std::vector<bool> &stiff_regions,
                              const VelocityBlocks &parts) const;
  /// Mass, stiffness and supports as matrices, complete in some rows (by local index).
  std::vector<RegionOperators> assembled_at(const std::vector<bool> &rows) const;
  /// Gives the block its entries of A, cell by cell. No matrix is made.
  void add_velocities(SaddlePointBlock &block, const std::vector<unsigned int> &stiff) const;
  void make_velocity_inverse(Preconditioner &made,
                             const std::vector<bool> &stiff_regions,
                             const std::vector<unsigned int> &stiff_pressures,
                             const VelocityBlocks &parts,
                             bool has_joint_block);
  /// A, with the volumetric stiffness, in some rows (by local index); null means all of them.
  void assemble_rows(const std::vector<unsigned int> *wanted,
                     VolumetricStiffness &volumetric,
                     dealii::TrilinosWrappers::SparseMatrix &matrix) const;
  /// The preconditioners' products share its cells. Made once.
  const MatrixFreeProduct<dim, float> &single_precision_cells();
  std::unique_ptr<VelocityCycle>
  make_polynomial_multigrid(Preconditioner &made,
                            const std::vector<double> &volumetric,
                            const dealii::TrilinosWrappers::SparseMatrix &divergence_matrix);
  double n_unknowns() const; ///< of all ranks
  VelocityBlocks velocity_blocks(const std::vector<bool> &stiff_regions,
                                 DistributedVector &mobility,
                                 double &fluid_ratio) const;
  /// Local indices of the pressures that belong to stiff regions alone.
  std::vector<unsigned int> find_stiff_pressures(const std::vector<bool> &stiff_regions) const;
  /// Raises D at the interfaces of stiff regions with others.
  void let_walls_yield(const std::vector<bool> &stiff_regions,
                       VelocityPreconditioner &velocity_inverse,
                       DistributedVector &mobility) const;
  const VelocityOperator &velocity_operator() const;
  SaddlePointSolver::Blocks blocks() const
  {
    return {velocity_operator(), divergence, compression, nullptr};
  }
};
} // namespace Continua

#endif
