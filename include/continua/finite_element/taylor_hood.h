#ifndef continua_finite_element_taylor_hood_h
#define continua_finite_element_taylor_hood_h

#include <continua/base/log.h>
#include <continua/continuum/discretisation.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/boundary_constraints.h>
#include <continua/finite_element/cavity_volumes.h>
#include <continua/finite_element/deformed_faces.h>
#include <continua/finite_element/field_evaluation.h>
#include <continua/finite_element/field_output.h>
#include <continua/finite_element/liquid_balance.h>
#include <continua/finite_element/loads.h>
#include <continua/finite_element/mesh_motion.h>
#include <continua/finite_element/mesh_transfer.h>
#include <continua/finite_element/metric_history.h>
#include <continua/finite_element/nonlinear_cell_terms.h>
#include <continua/finite_element/region_operators.h>
#include <continua/finite_element/solid_motion.h>
#include <continua/finite_element/space.h>
#include <continua/finite_element/step_system.h>
#include <continua/finite_element/tangent_system.h>
#include <continua/finite_element/wall_shear_stress.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Continua
{
/// What the Taylor-Hood path reads of the parameter file, and what the case knows of the run.
struct TaylorHoodParameters
{
  SpaceParameters space;
  LinearSolverParameters linear_solver;
  SolverOutlook outlook;
};

/**
 * The Taylor-Hood discretisation: the operators of the finite elements. It puts tested parts
 * together: space, operators by region, constraints, loads and the step's system. G = -B^T, so that
 * the system is symmetric.
 */
template <int dim>
class TaylorHood : public Discretisation<dim>
{
public:
  /// `problem` and `log` must outlive it.
  TaylorHood(dealii::parallel::TriangulationBase<dim> &triangulation,
             const Problem &problem,
             const TaylorHoodParameters &parameters,
             Log &log);

  void setup() override;
  DistributedVector velocity_vector() const override { return space.velocity_vector(); }
  DistributedVector pressure_vector() const override { return space.pressure_vector(); }
  DistributedVector internal_metric_vector() const override;
  std::vector<std::vector<unsigned int>> velocity_nodes() const override;
  std::vector<std::vector<unsigned int>> pressure_nodes() const override;
  std::vector<unsigned int> pressures_without_history() const override;
  StateNumbering numbering() const override;

  void multiply_mass(unsigned int region,
                     DistributedVector &momentum,
                     const DistributedVector &velocity) override;
  void multiply_stiffness(unsigned int region,
                          DistributedVector &force,
                          const DistributedVector &mixture) override;
  void multiply_gradient(unsigned int region,
                         DistributedVector &force,
                         const DistributedVector &pressure) override;
  void multiply_divergence(unsigned int region,
                           DistributedVector &rate,
                           const DistributedVector &velocity) override;
  void multiply_pressure_mass(unsigned int region,
                              DistributedVector &product,
                              const DistributedVector &pressure) override;
  void multiply_support_stiffness(unsigned int region,
                                  DistributedVector &force,
                                  const DistributedVector &displacement) override;
  void multiply_support_damping(unsigned int region,
                                DistributedVector &force,
                                const DistributedVector &velocity) override;
  double pressure_power(unsigned int region,
                        const DistributedVector &velocity,
                        const DistributedVector &pressure) override;
  double pressure_product(unsigned int region,
                          const DistributedVector &p,
                          const DistributedVector &q) override;
  double divergence(const DistributedVector &velocity) override;

  const LoadList &loads() const override { return load_list; }
  const LoadList &loads_of(unsigned int region) override;
  bool prescribed_velocity_jumps(double begin, double end) const override;
  bool is_homogeneous() const override { return constraints.is_homogeneous(); }
  void evaluate_prescribed(double time, DistributedVector &values) const override;
  void prescribed_part(const DistributedVector &velocity, DistributedVector &values) const override;
  void clear_prescribed(DistributedVector &velocity) const override;
  void set_initial_state(DistributedVector &velocity,
                         DistributedVector &displacement,
                         DistributedVector &pressure) override;

  SystemChange prepare(const SystemCoefficients &coefficients, double pressure_time) override;
  void eliminate_prescribed(const DistributedVector &prescribed,
                            DistributedVector &momentum,
                            DistributedVector &mass) override;
  void solve(const DistributedVector &prescribed,
             DistributedVector &momentum,
             DistributedVector &mass,
             DistributedVector &velocity,
             DistributedVector &pressure,
             StepReport &report) override;
  bool is_nonlinear() const override { return !terms.empty(); }
  void add_nonlinear_terms(const BalancedStep &state,
                           DistributedVector &momentum,
                           DistributedVector &mass) override;
  void set_nonlinear_forces(unsigned int region,
                            const BalancedStep &state,
                            NonlinearForces &forces) override;
  bool is_nonlinear_in(unsigned int region) const override;
  bool has_whole_terms() const override { return true; }
  void move_mesh(BalancedStep &state) override;
  void set_mesh_change(const Step &step,
                       const DistributedVector &of_velocity,
                       DistributedVector &of_mesh_displacement) override;
  void check_mesh(const BalancedStep &state) override;
  const DistributedVector *mesh_displacement() const override
  {
    return mesh_motion ? &mesh_motion->displacement() : nullptr;
  }
  NonlinearEnergy nonlinear_energy(unsigned int region, const State &state) override;
  double nonlinear_relaxation(unsigned int region) const override;
  void add_load_changes(const BalancedStep &state,
                        std::optional<unsigned int> region,
                        DistributedVector &forces) override;
  std::string place_of_largest(const DistributedVector &momentum,
                               const DistributedVector &mass,
                               bool of_momentum) const override;
  bool linearise(const BalancedStep &state) override;
  bool solves_with_kept_derivative() const override { return has_iterative_tangent(); }
  void forget_linearisation() override;
  bool has_derivative_products() const override { return !has_iterative_tangent(); }
  void keep_derivative(const BalancedStep &state) override;
  void add_derivative_product(const DistributedVector &velocity,
                              const DistributedVector &pressure,
                              DistributedVector &momentum,
                              DistributedVector &mass) override;
  void restrict_residuals(DistributedVector &momentum, DistributedVector &mass) const override;
  ResidualScales residual_scales(const DistributedVector &velocity,
                                 const DistributedVector &pressure) const override;
  void set_prescribed(const DistributedVector &prescribed,
                      DistributedVector &velocity) const override;

  void set_wall_shear_stress(const State &state, DistributedVector &shear) override
  {
    wall_shear.set(state, shear);
  }
  void set_magnitudes_at_walls(const DistributedVector &vectors,
                               DistributedVector &magnitudes) override
  {
    wall_shear.set_magnitudes(vectors, magnitudes);
  }
  void keep_walls_alone(DistributedVector &vector) override { wall_shear.keep_walls_alone(vector); }

  DistributedVector flow_of_velocities(unsigned int condition) const override;
  void set_flow_of_velocities(unsigned int condition,
                              const DistributedVector &mesh_displacement,
                              DistributedVector &flow) override;
  DistributedVector flow_profile(unsigned int condition) const override;
  void add_velocity_product(const DistributedVector &velocity, DistributedVector &result) override;
  void add_divergence(const DistributedVector &velocity, DistributedVector &result) override;
  void set_reaction(const DistributedVector &profile,
                    DistributedVector &of_velocity,
                    DistributedVector &of_pressure,
                    DistributedVector &momentum,
                    DistributedVector &mass) override;

  std::vector<double> cavity_volumes(const DistributedVector &displacement) override
  {
    return cavities.volumes(displacement);
  }
  void linearise_cavity(const unsigned int cavity,
                        const DistributedVector &displacement,
                        DistributedVector &derivative,
                        DistributedVector &force) override
  {
    cavities.linearise(cavity, displacement, derivative, force);
  }

  void prepare_transfer(const StateVectors &vectors) override;
  void finish_transfer(const StateVectors &vectors) override;
  SolverSizes sizes() const override;

  void visit(StateVisitor &visitor) override;
  void finish_load() override;
  const DistributedVector *wall_potentials() const override;
  const DistributedVector *unloaded_displacement() const override;
  void set_unloaded_displacement(const DistributedVector &displacement) override;
  void start_from(const State &state) override;
  void begin_step(const Step &step, const State &start) override;
  void finish_step(const BalancedStep &balanced, const State &state) override;

  const dealii::Mapping<dim> &mapping() const override { return space.mapping; }
  FieldProbes<dim> &probes() override { return evaluation; }
  void take_motion(const State &state, MotionExtremes &extremes) override
  {
    motion.take(state, extremes);
    if (mesh_motion)
    {
      extremes.mesh_volume_ratio = mesh_motion->worst().least_volume_ratio;
      extremes.mesh_volume_time = mesh_motion->worst().time;
    }
  }
  LiquidMass liquid_mass(const State &state) override
  {
    return liquid_balance ? liquid_balance->mass(state) : LiquidMass();
  }
  std::map<std::string, std::string> add_output(const State &state,
                                                dealii::DataOut<dim> &data_out) override;
  void indicators(const IndicatorRequest &request,
                  const State &state,
                  const std::vector<double> &port_pressures,
                  double time,
                  dealii::Vector<float> &per_cell) override;
  double error_norm(const State &state,
                    const std::string &field,
                    const std::vector<Expression> &exact,
                    double time) override;
  std::unique_ptr<VibrationOperator<dim>> vibration(const VibratingState &state) override;

private:
  const Problem &problem;
  Log &log;
  Space<dim> space;
  BoundaryConstraints<dim> constraints; ///< outlives the products of the operators
  std::vector<RegionOperators> operators;
  Loads<dim> load_list;
  std::map<unsigned int, Loads<dim>> loads_of_regions; ///< that were asked for on this mesh
  const LinearSolverParameters linear_solver;
  StepSystem<dim> system;
  std::unique_ptr<MetricHistory<dim>> metrics; ///< null where nothing relaxes in finite deformation
  std::unique_ptr<MeshMotion<dim>> mesh_motion;       ///< null where the mesh stays
  std::unique_ptr<LiquidBalance<dim>> liquid_balance; ///< likewise
  bool mesh_warning_was_given = false;
  const std::vector<unsigned int> ports; ///< of outlets on a mesh that moves: conditions
  DeformedFaces<dim> port_faces;         ///< of these
  NonlinearTerms<dim> terms;             ///< of the regions that are not linear
  bool derivative_is_marked = false;     ///< in MemoryUse, on this mesh
  TangentSystem<dim> tangent;            ///< in the system's place where there are such terms
  CavityVolumes<dim> cavities;
  MeshTransfer<dim> mesh_transfer;
  FieldEvaluation<dim> evaluation;
  WallShearStress<dim> wall_shear;
  SolidMotion<dim> motion;
  FieldOutput<dim> output;
  std::string linear_solver_reported;
  DistributedVector zero_velocity, velocity_work, pressure_work;
  // Of products with the tangent.
  DistributedVector tangent_change, tangent_momentum, tangent_mass;
  /// Of B U by the largest velocity [m^2], and of B^T p by the largest pressure [m^2].
  double divergence_norm = 0., gradient_norm = 0.;

  /// Whether mass and stiffness are products without a matrix on this mesh.
  bool has_products_without_matrix() const;
  /// Those of a region that is not linear.
  NonlinearCellTerms<dim> &terms_of(unsigned int region) const;
  /// Whether the steps of Newton's iteration have the iterative solver on this mesh.
  bool has_iterative_tangent() const;
  void solve_tangent(DistributedVector &momentum,
                     DistributedVector &mass,
                     DistributedVector &velocity,
                     DistributedVector &pressure);
  void report_linear_solver();
};
} // namespace Continua

#endif
