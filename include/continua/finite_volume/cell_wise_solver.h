#ifndef continua_finite_volume_cell_wise_solver_h
#define continua_finite_volume_cell_wise_solver_h

#include <continua/base/log.h>
#include <continua/continuum/branch_history.h>
#include <continua/continuum/bulk_history.h>
#include <continua/continuum/continuum_solver.h>
#include <continua/continuum/kept_state.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state.h>
#include <continua/continuum/state_archive.h>
#include <continua/finite_volume/cell_evaluation.h>
#include <continua/finite_volume/cell_loads.h>
#include <continua/finite_volume/cell_output.h>
#include <continua/finite_volume/cell_power_ledger.h>
#include <continua/finite_volume/cell_system.h>
#include <continua/finite_volume/cell_transfer.h>
#include <continua/finite_volume/displacement_levels.h>
#include <continua/finite_volume/loaded_faces.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace Continua
{
/**
 * The cell-wise discretisation of the continuum, which emulates the thesis's finite volumes (its
 * chapter 3) on the meshes of deal.II. It puts tested parts together: space, operators by region,
 * conditions on faces, loads, branch history, the equations of a step and the way they are solved;
 * see the chapter on the cell-wise path in the manual.
 */
template <int dim>
class CellWiseSolver : public ContinuumSolver<dim>
{
public:
  /// `problem` and `log` must outlive the solver.
  CellWiseSolver(dealii::parallel::TriangulationBase<dim> &triangulation,
                 const Problem &problem,
                 const CellWiseParameters &parameters,
                 Log &log);
  ~CellWiseSolver() override;

  void initialise() override;
  StepReport advance(const Step &step) override;
  StepError step_error() override;
  void keep_state() override;
  void return_to_kept_state() override;
  void solve_steady(double time) override;
  bool steady_is_direct() const override;
  std::unique_ptr<VibrationOperator<dim>> vibration() override;
  bool data_jump(double begin, double end) const override;
  std::vector<FieldComponent> fields() const override;
  unsigned int add_probe(const ProbeRequest<dim> &request) override;
  void evaluate_probes(std::vector<double> &values) override;
  PowerBalance power_balance(bool relaxation) override;
  Energy energy() override;
  double divergence() override;
  std::map<std::string, std::string> add_output(dealii::DataOut<dim> &data_out) override;
  void indicators(const IndicatorRequest &request, dealii::Vector<float> &per_cell) override;
  void prepare_refinement() override;
  void transfer() override;
  void save(ArchiveWriter &archive) const override;
  void load(const ArchiveReader &archive) override;
  double
  error_norm(const std::string &field, const std::vector<Expression> &exact, double time) override;
  SolverSizes sizes() const override;

private:
  const Problem &problem;
  const CellWiseParameters parameters;
  const Formulation formulation;
  Log &log;
  CellSpace<dim> space;
  FaceConditions<dim> conditions;
  CellLoads<dim> loads;
  std::vector<CellOperators> operators;
  PressureClosure closure;
  BranchHistory history;
  BulkHistory bulk_history;
  CellSystem<dim> system;
  std::unique_ptr<CellSolve<dim>> solve;
  LoadedFaces<dim> loaded_faces;
  CellPowerLedger<dim> power_ledger;
  CellEvaluation<dim> evaluation;
  CellOutput<dim> output;
  CellTransfer<dim> cell_transfer;

  // The state: at the present time, and one step before.
  DistributedVector velocity, velocity_older, pressure, pressure_older;
  /// div U as the equations of state have it, at the end of the last step, for the trapezoidal rule
  /// [m^3/s].
  DistributedVector dilatation_rate;
  bool dilatation_rate_is_current = true;
  double smallest_distance = 0.; ///< between two cells, or from a cell to a boundary face [m]
  DisplacementLevels displacement_levels; ///< of the displacement form
  double present_time = 0.;
  bool pressure_is_current = true; ///< where it is computed from the displacement
  BalancedCells balanced;          ///< by the last step
  // The last pressure known at a time of its own, from which that of an incompressible material is
  // extrapolated.
  DistributedVector pressure_known;
  double pressure_known_time = 0.;
  std::vector<unsigned int> pressures_without_history; ///< local indices
  bool some_pressures_without_history = false;         ///< on any rank
  std::set<double> exponential_branches_reported;
  bool undamped_is_reported = false;
  // Work space of the step.
  DistributedVector momentum, mass, velocity_work, mixture, pressure_work, mass_work, prescribed;

  KeptState kept;

  void setup();
  /// The list of the state: what is added here is saved, kept, given back and carried over.
  void visit(StateVisitor &visitor);
  /// The step with the pressure's own update, where one is asked for.
  Step with_pressure_update(const Step &step) const;
  CellCoefficients coefficients(const Step &step) const;
  CellCoefficients steady_coefficients() const;
  /// Makes equations and factor if the coefficients are new; returns whether they are.
  bool prepare(const CellCoefficients &coefficients);
  void report_exponential_branches(const Step &step);
  StepReport advance_displacement(const Step &step);
  void add_history(const Step &step);
  void add_state(const Step &step);
  void set_prescribed(const Step &step);
  void extrapolate_pressure(const Step &step);
  void set_dilatation_rate();
  /// -K div D, where p is no unknown; otherwise nothing.
  void set_pressure_of_displacement();
  void set_initial_state();
  /// Lets the faces take up what is out of balance on them at this time, with the cells where they
  /// are: at the start, where the load is there at once, and on a new mesh.
  void balance_faces(double time);
  /// The same for a load that jumps in the step, where the rule is trapezoidal.
  void take_up_jump(const Step &step);
  /// Of the forces in `momentum`.
  void yield_to_forces();
  State state() const;
  StateNumbering numbering() const;
};
} // namespace Continua

#endif
