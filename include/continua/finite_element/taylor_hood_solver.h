#ifndef continua_finite_element_taylor_hood_solver_h
#define continua_finite_element_taylor_hood_solver_h

#include <continua/base/log.h>
#include <continua/continuum/branch_history.h>
#include <continua/continuum/bulk_history.h>
#include <continua/continuum/continuum_solver.h>
#include <continua/continuum/kept_state.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state_archive.h>
#include <continua/finite_element/boundary_constraints.h>
#include <continua/finite_element/field_evaluation.h>
#include <continua/finite_element/field_output.h>
#include <continua/finite_element/loads.h>
#include <continua/finite_element/mesh_transfer.h>
#include <continua/finite_element/outlet_coupling.h>
#include <continua/finite_element/power_ledger.h>
#include <continua/finite_element/region_operators.h>
#include <continua/finite_element/space.h>
#include <continua/finite_element/step_system.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace Continua
{
/// What the Taylor-Hood path reads of the parameter file.
struct TaylorHoodParameters
{
  SpaceParameters space;
  LinearSolverParameters linear_solver;
};

/**
 * The Taylor-Hood discretisation of the continuum. It puts tested parts together: space, operators
 * by region, constraints, loads, branch history and the step's system; see the chapter on the
 * numerics in the manual.
 */
template <int dim>
class TaylorHoodSolver : public ContinuumSolver<dim>
{
public:
  /// `problem` and `log` must outlive the solver.
  TaylorHoodSolver(dealii::parallel::TriangulationBase<dim> &triangulation,
                   const Problem &problem,
                   const TaylorHoodParameters &parameters,
                   Log &log);

  void initialise() override;
  StepReport advance(const Step &step) override;
  StepError step_error() override;
  void keep_state() override;
  void return_to_kept_state() override;
  void solve_steady(double time) override;
  bool steady_is_direct() const override;
  std::unique_ptr<VibrationOperator<dim>> vibration() override;
  bool data_jump(double begin, double end) const override;
  const dealii::Mapping<dim> &mapping() const override { return space.mapping; }
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
  Log &log;
  Space<dim> space;
  std::vector<RegionOperators> operators;
  BoundaryConstraints<dim> constraints;
  Loads<dim> loads;
  BranchHistory history;
  BulkHistory bulk_history;
  StepSystem<dim> system;
  OutletCoupling<dim> outlets;
  PowerLedger<dim> power_ledger;
  MeshTransfer<dim> mesh_transfer;
  FieldEvaluation<dim> evaluation;
  FieldOutput<dim> output;

  // The state: at the present time, and one step before.
  DistributedVector velocity, velocity_older, pressure, pressure_older;
  double present_time = 0.;
  BalancedStep balanced;        ///< by the last step
  DistributedVector prescribed; ///< velocities at constrained dofs, constants set once [m/s]
  // The last pressure known at a time of its own, from which that of an incompressible material is
  // extrapolated.
  DistributedVector pressure_known;
  double pressure_known_time = 0.;
  std::vector<unsigned int> incompressible_pressures; ///< local indices
  bool some_incompressible_pressures = false;         ///< on any rank
  /// Relaxation times whose exponential update the log has told of.
  std::set<double> exponential_branches_reported;
  std::string linear_solver_reported;
  // Work space of the step.
  SystemCoefficients coefficients;
  DistributedVector momentum, mass, velocity_work, mixture, pressure_work, mass_work;

  KeptState kept;

  void setup();
  /// The list of the state: what is added here is saved, kept, given back and carried over.
  void visit(StateVisitor &visitor);
  void set_coefficients(const Step &step);
  void report_exponential_branches(const Step &step);
  void report_linear_solver();
  void extrapolate_pressure(const Step &step);
  State state() const;
  StateNumbering numbering() const;
};
} // namespace Continua

#endif
