#ifndef continua_case_before_the_run_cost_estimate_h
#define continua_case_before_the_run_cost_estimate_h

#include <continua/finite_element/solvers/solver_choice.h>
#include <continua/mesh/mesh_extent.h>

#include <string>
#include <vector>

namespace Continua
{
/// What the cost of a run depends on.
struct CostInput
{
  unsigned int dim = 2;
  MeshExtent coarse;                ///< of the coarse mesh
  unsigned int refinements = 0;     ///< of all its cells
  unsigned int n_regions = 1;       ///< that have pressures of their own
  unsigned int degree = 2;          ///< of the velocity of Taylor-Hood elements
  bool cell_wise = false;           ///< the other discretisation
  bool has_pressure = true;         ///< of the cell-wise one: whether it is an unknown
  bool segregated = false;          ///< of the cell-wise one: solved component by component
  bool pivots = false;              ///< the factor does: a material is incompressible
  bool is_nonlinear = false;        ///< the matrix is unsymmetric, and steps are iterated
  bool has_tangents = false;        ///< nonlinear, not cell-wise
  bool is_finite = false;           ///< finite deformation
  bool mesh_moves = false;          ///< of liquids
  bool has_supg = false;            ///< convection, with this stabilisation
  bool convects_explicitly = false; ///< steps of a matrix that is unsymmetric are linear
  bool is_of_vibrations = false;
  LinearSolverParameters linear_solver;
  double memory_limit = 1e300; ///< for the choice of the solver, on one machine [bytes]
  unsigned int n_factors = 1;  ///< kept at one time
  /// Each solve has a factor of its own, of a complex matrix that each rank holds as a whole.
  bool is_harmonic = false;
  double n_steps = 1.; ///< solves of the step's system
  /// The run looks for a state at rest: where it is not linear by some steps, which are not
  /// n_steps.
  bool finds_steady_state = false;
  unsigned int n_ranks = 1;
  /// Columns of probes, of which each rank keeps the values of all steps.
  double n_histories = 0.;
  /// Of wave theory beside the run: see TubeWaveTheory::Work.
  double n_wave_roots = 0., n_wave_segment_solves = 0.;
};

/**
 * How large a run is and what it costs, from formulas that need no mesh: within a factor of two of
 * what was measured on the runs that doc/estimates.md lists, on one core of the machine named
 * there. The fit of absorbing ends, fields that are written, and meshes that adapt are not part of
 * it.
 */
struct CostEstimate
{
  explicit CostEstimate(const CostInput &input);

  double n_cells = 0.;
  double n_unknowns = 0.;
  /// Of a linear step of finite elements; of others there is always a factor.
  StepSolver solver = StepSolver::direct;
  double factor_entries = 0.; ///< of one factor; 0 of the iterative solver
  double memory = 0.;         ///< the most that all ranks together hold [bytes]
  double history_memory = 0.; ///< of it, the histories of probes [bytes]
  double set_up_time = 0.;    ///< mesh, matrices and factors, on one core [s]
  double step_time = 0.;      ///< one solve and what belongs to it, on one core [s]
  double theory_time = 0.;    ///< of wave theory beside the run, on one core [s]
  double time = 0.;           ///< of the run, on one core [s]

  /// "48034 unknowns in 4800 cells, 390 MB of memory, 1 min 20 s on one core".
  std::string text() const;
};

/// What the choice of a linear step's solver depends on, of a case.
SolverOutlook solver_outlook(const CostInput &input);

/// Refinements, not more than those of `input`, with which the run fits into `bytes`; -1 if it does
/// with none.
int fitting_refinements(CostInput input, double bytes);

/// Why so many ranks will be slower than one, in words; empty if they will not.
std::string advice_on_ranks(const CostInput &input, unsigned int n_processors);
} // namespace Continua

#endif
