#ifndef continua_finite_element_solvers_solver_choice_h
#define continua_finite_element_solvers_solver_choice_h

#include <continua/finite_element/space/linear_solver_parameters.h>

#include <string>

namespace Continua
{
/// The ways to solve the symmetric system of a step.
enum class StepSolver
{
  direct,           ///< a factor in double precision
  single_precision, ///< a factor in single precision, and FGMRES
  iterative
};

/// Of the system of a step: what the cost of a solver depends on.
struct SystemSize
{
  unsigned int dim = 2;
  unsigned int degree = 2; ///< of the velocity
  double n_unknowns = 0.;
  double factor_entries = 0.; ///< of one factor, estimated
  unsigned int n_factors = 1; ///< kept at one time
  unsigned int n_regions = 1; ///< that have pressures of their own
  bool takes_cholmod = false; ///< for a factor in double precision
  bool is_matrix_free = true; ///< the velocities' products need no matrix
  /// Products with the tangent of convection or of finite deformation need a matrix of each cell.
  bool has_matrices_of_cells = false;

  /// The same body with other cells. Of a factor in space the entries grow with the power 4/3 of
  /// the unknowns (nested dissection: George, SIAM J. Numer. Anal. 10 (1973)).
  SystemSize scaled_to(double other_unknowns) const;
};

/// What a solver takes, on one core; within a factor of two (doc/estimates.md).
struct SolverCost
{
  double memory = 0.;      ///< with matrices and vectors, without the program [bytes]
  double set_up_time = 0.; ///< with the assembly [s]
  double factor_time = 0.; ///< of it, of one factor [s]; 0 of what has none
  double solve_time = 0.;  ///< [s]
};
SolverCost cost_of_solver(StepSolver solver, const SystemSize &size);

/// What a run is about to do.
struct SolverOutlook
{
  SystemSize size;               ///< estimated; no unknowns: it is not known
  double n_solves = 1e9;         ///< of the whole run, or many
  double memory_limit = 1e300;   ///< what the run may take on one machine [bytes]
  double memory_of_program = 0.; ///< of this [bytes]
  bool is_of_tangents = false;   ///< see choose_tangent_solver()
  bool is_finite = false;        ///< tangents of finite deformation
  bool is_of_vibrations = false; ///< whose solver is always a factor in double precision
};

struct SolverChoice
{
  StepSolver solver = StepSolver::direct;
  std::string reason; ///< continues "as"
};

/// Up to so many unknowns `automatic` takes a factor in any case that it fits.
constexpr double largest_small_system_in_space = 30000.;
/// Beyond so many unknowns `automatic` takes no factor: in a plane, in space in double precision
/// and in single precision.
constexpr double largest_direct_system_in_plane = 1e6;
constexpr double largest_direct_system_in_space = 150000.;
constexpr double largest_single_precision_system_in_space = 300000.;

/**
 * The solver of a step's system, by the parameters, or where those are `automatic`:
 *
 * 1. The factor is in double precision up to its largest system and where it fits into the memory,
 *    else in single precision where that fits and the library is MUMPS.
 * 2. Beyond the largest systems, and where no factor fits, the solver is iterative.
 * 3. In space above the small systems the solver is iterative if set-up and solves then take less
 *    time, as estimated.
 *
 * It depends on nothing but its arguments, and not on the number of ranks.
 */
SolverChoice choose_step_solver(const LinearSolverParameters &parameters,
                                const SystemSize &size,
                                const SolverOutlook &outlook);

/// Of the tangents of Newton's iteration, which are unsymmetric: the same with one factor in double
/// precision or the iterative solver.
SolverCost cost_of_tangents(StepSolver solver, const SystemSize &size);
/// Where the parameters are `automatic`: a factor up to its largest system and where it fits into
/// the memory, else the iterative solver. On the way to a steady state and in finite deformation a
/// factor has no largest system.
SolverChoice choose_tangent_solver(const LinearSolverParameters &parameters,
                                   const SystemSize &size,
                                   const SolverOutlook &outlook);
} // namespace Continua

#endif
