#ifndef continua_finite_element_taylor_hood_h
#define continua_finite_element_taylor_hood_h

#include <continua/base/log.h>
#include <continua/continuum/discretisation.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/assembly/linear_products.h>
#include <continua/finite_element/assembly/metric_history.h>
#include <continua/finite_element/assembly/region_terms.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/conditions/ends_and_cavities.h>
#include <continua/finite_element/conditions/loads.h>
#include <continua/finite_element/looking/field_evaluation.h>
#include <continua/finite_element/looking/field_output.h>
#include <continua/finite_element/looking/wall_shear_stress.h>
#include <continua/finite_element/mesh_transfer.h>
#include <continua/finite_element/motion/moving_mesh.h>
#include <continua/finite_element/motion/solid_motion.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/solvers/linear_systems.h>
#include <continua/finite_element/space/space.h>

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
 * together: space, operators by region and their products, constraints, loads, the terms of the
 * regions that are not linear, the linear systems of a step, the mesh that moves, ends and
 * cavities. G = -B^T, so that the system is symmetric.
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
  std::vector<unsigned int> pressures_without_history() const override
  {
    return products.pressures_without_history();
  }
  StateNumbering numbering() const override;

  void multiply_mass(const unsigned int region,
                     DistributedVector &momentum,
                     const DistributedVector &velocity) override
  {
    products.multiply_mass(region, momentum, velocity);
  }
  void multiply_stiffness(const unsigned int region,
                          DistributedVector &force,
                          const DistributedVector &mixture) override
  {
    products.multiply_stiffness(region, force, mixture);
  }
  bool has_level_products() const override { return products.has_matrices(); }
  void multiply_levels(const unsigned int region,
                       const DistributedVector &velocity,
                       const DistributedVector &displacement,
                       DistributedVector *const mass_of_velocity,
                       DistributedVector *const stiffness_of_velocity,
                       DistributedVector *const stiffness_of_displacement) override
  {
    products.multiply_levels(region, velocity, displacement, mass_of_velocity,
                             stiffness_of_velocity, stiffness_of_displacement);
  }
  void multiply_gradient(const unsigned int region,
                         DistributedVector &force,
                         const DistributedVector &pressure) override
  {
    products.multiply_gradient(region, force, pressure);
  }
  void multiply_divergence(const unsigned int region,
                           DistributedVector &rate,
                           const DistributedVector &velocity) override
  {
    products.multiply_divergence(region, rate, velocity);
  }
  void multiply_pressure_mass(const unsigned int region,
                              DistributedVector &product,
                              const DistributedVector &pressure) override
  {
    products.multiply_pressure_mass(region, product, pressure);
  }
  void multiply_support_stiffness(const unsigned int region,
                                  DistributedVector &force,
                                  const DistributedVector &displacement) override
  {
    products.multiply_support_stiffness(region, force, displacement);
  }
  void multiply_support_damping(const unsigned int region,
                                DistributedVector &force,
                                const DistributedVector &velocity) override
  {
    products.multiply_support_damping(region, force, velocity);
  }
  double pressure_power(const unsigned int region,
                        const DistributedVector &velocity,
                        const DistributedVector &pressure) override
  {
    return products.pressure_power(region, velocity, pressure);
  }
  double pressure_product(const unsigned int region,
                          const DistributedVector &p,
                          const DistributedVector &q) override
  {
    return products.pressure_product(region, p, q);
  }
  double divergence(const DistributedVector &velocity) override
  {
    return products.divergence(velocity);
  }

  const LoadList &loads() const override { return load_list; }
  const LoadList &loads_of(unsigned int region) override;
  bool prescribed_velocity_jumps(const double begin, const double end) const override
  {
    return constraints.jumps(begin, end);
  }
  bool is_homogeneous() const override { return constraints.is_homogeneous(); }
  void evaluate_prescribed(const double time, DistributedVector &values) const override
  {
    constraints.evaluate(time, values);
  }
  void prescribed_part(const DistributedVector &velocity, DistributedVector &values) const override
  {
    constraints.prescribed_part(velocity, values);
  }
  void clear_prescribed(DistributedVector &velocity) const override
  {
    systems.clear_prescribed(velocity);
  }
  void set_initial_state(DistributedVector &velocity,
                         DistributedVector &displacement,
                         DistributedVector &pressure) override;

  SystemChange prepare(const SystemCoefficients &coefficients, double /*pressure_time*/) override
  {
    return systems.prepare(coefficients);
  }
  void eliminate_prescribed(const DistributedVector &prescribed,
                            DistributedVector &momentum,
                            DistributedVector &mass) override
  {
    systems.eliminate_prescribed(prescribed, momentum, mass);
  }
  void solve(const DistributedVector &prescribed,
             DistributedVector &momentum,
             DistributedVector &mass,
             DistributedVector &velocity,
             DistributedVector &pressure,
             StepReport &report) override
  {
    systems.solve(prescribed, momentum, mass, velocity, pressure, report);
  }
  bool is_nonlinear() const override { return !terms.empty(); }
  void add_nonlinear_terms(const BalancedStep &state,
                           DistributedVector &momentum,
                           DistributedVector &mass) override
  {
    terms.add(state, momentum, mass);
  }
  void add_nonlinear_powers(const unsigned int region,
                            const BalancedStep &state,
                            const DistributedVector &of_velocity,
                            const TermsTaken taken,
                            NonlinearPowers &powers,
                            DistributedVector *const momentum) override
  {
    terms.add_powers(region, state, of_velocity, taken, powers, momentum);
  }
  bool is_nonlinear_in(const unsigned int region) const override
  {
    return problem.region_model(region) != RegionModel::linear;
  }
  bool has_whole_terms() const override { return true; }
  void move_mesh(BalancedStep &state) override
  {
    if (moving_mesh)
      moving_mesh->move(state);
  }
  void set_mesh_change(const Step &step,
                       const DistributedVector &of_velocity,
                       DistributedVector &of_mesh_displacement) override
  {
    if (moving_mesh)
      moving_mesh->set_change(step, of_velocity, of_mesh_displacement);
  }
  void check_mesh(const BalancedStep &state) override
  {
    if (moving_mesh)
      moving_mesh->check(state);
  }
  const DistributedVector *mesh_displacement() const override
  {
    return moving_mesh ? &moving_mesh->displacement() : nullptr;
  }
  NonlinearEnergy nonlinear_energy(const unsigned int region, const State &state) override
  {
    return terms.energy_of(region, state);
  }
  double nonlinear_relaxation(const unsigned int region) const override
  {
    return terms.relaxation_power(region);
  }
  std::string place_of_largest(const DistributedVector &momentum,
                               const DistributedVector &mass,
                               bool of_momentum) const override;
  bool linearise(const BalancedStep &state) override { return systems.linearise(state); }
  bool solves_with_kept_derivative() const override { return systems.has_iterative_tangent(); }
  void forget_linearisation() override
  {
    systems.forget_linearisation();
    if (moving_mesh)
      moving_mesh->forget_solver();
  }
  bool has_derivative_products() const override { return !systems.has_iterative_tangent(); }
  void keep_derivative(const BalancedStep &state) override { systems.keep_derivative(state); }
  void add_derivative_product(const DistributedVector &velocity,
                              const DistributedVector &pressure,
                              DistributedVector &momentum,
                              DistributedVector &mass) override
  {
    terms.add_derivative_product(velocity, pressure, momentum, mass);
  }
  void restrict_residuals(DistributedVector &momentum, DistributedVector &mass) const override
  {
    systems.restrict_residuals(momentum, mass);
  }
  ResidualScales residual_scales(const DistributedVector &velocity,
                                 const DistributedVector &pressure) const override;
  void set_prescribed(const DistributedVector &prescribed,
                      DistributedVector &velocity) const override
  {
    constraints.set_constrained(velocity, prescribed);
  }

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

  DistributedVector flow_of_velocities(const unsigned int condition) const override
  {
    return load_list.flow_of_velocities(condition);
  }
  void set_flow_of_velocities(const unsigned int condition,
                              const DistributedVector &mesh_displacement,
                              DistributedVector &flow) override
  {
    ends_and_cavities.set_flow_of_velocities(condition, mesh_displacement, flow);
  }
  DistributedVector flow_profile(const unsigned int condition) const override
  {
    return ends_and_cavities.flow_profile(condition);
  }
  void add_velocity_product(const DistributedVector &velocity, DistributedVector &result) override
  {
    systems.add_velocity_product(velocity, result);
  }
  void add_divergence(const DistributedVector &velocity, DistributedVector &result) override
  {
    systems.add_divergence(velocity, result);
  }
  void set_reaction(const DistributedVector &profile,
                    DistributedVector &of_velocity,
                    DistributedVector &of_pressure,
                    DistributedVector &momentum,
                    DistributedVector &mass) override;

  std::vector<double> cavity_volumes(const DistributedVector &displacement) override
  {
    return ends_and_cavities.cavity_volumes(displacement);
  }
  void linearise_cavity(const unsigned int cavity,
                        const DistributedVector &displacement,
                        DistributedVector &derivative,
                        DistributedVector &force) override
  {
    ends_and_cavities.linearise_cavity(cavity, displacement, derivative, force);
  }

  void prepare_transfer(const StateVectors &vectors) override;
  void finish_transfer(const StateVectors &vectors) override;
  SolverSizes sizes() const override;

  void visit(StateVisitor &visitor) override;
  void finish_load() override;
  const DistributedVector *wall_potentials() const override { return terms.wall_potentials(); }
  const DistributedVector *unloaded_displacement() const override
  {
    return terms.unloaded_displacement();
  }
  void set_unloaded_displacement(const DistributedVector &displacement) override
  {
    terms.set_unloaded_displacement(displacement);
  }
  void start_from(const State &state) override;
  void begin_step(const Step &step, const State &start) override;
  void finish_step(const BalancedStep &balanced, const State &state) override;

  const dealii::Mapping<dim> &mapping() const override { return space.mapping; }
  FieldProbes<dim> &probes() override { return evaluation; }
  void take_motion(const State &state, MotionExtremes &extremes) override
  {
    motion.take(state, extremes);
    if (moving_mesh)
      moving_mesh->take_extremes(extremes);
  }
  LiquidMass liquid_mass(const State &state) override
  {
    return moving_mesh ? moving_mesh->liquid_mass(state) : LiquidMass();
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
                    const double time) override
  {
    return evaluation.error_norm(state, field, exact, time);
  }
  std::unique_ptr<VibrationOperator<dim>> vibration(const VibratingState &state) override;
  std::unique_ptr<HarmonicSystem<dim>> harmonic_system(const HarmonicState &state) override;

private:
  const Problem &problem;
  Log &log;
  Space<dim> space;
  BoundaryConstraints<dim> constraints; ///< outlives the products of the operators
  std::vector<RegionOperators> operators;
  Loads<dim> load_list;
  std::map<unsigned int, Loads<dim>> loads_of_regions; ///< that were asked for on this mesh
  const LinearSolverParameters linear_solver;
  LinearProducts<dim> products;
  std::unique_ptr<MetricHistory<dim>> metrics; ///< null where nothing relaxes in finite deformation
  std::unique_ptr<MovingMesh<dim>> moving_mesh; ///< null where the mesh stays
  RegionTerms<dim> terms;                       ///< of the regions that are not linear
  LinearSystems<dim> systems;
  EndsAndCavities<dim> ends_and_cavities;
  MeshTransfer<dim> mesh_transfer;
  FieldEvaluation<dim> evaluation;
  WallShearStress<dim> wall_shear;
  SolidMotion<dim> motion;
  FieldOutput<dim> output;

  /// Makes the matrices of the regions, with the constraints of the new mesh, and where mass and
  /// stiffness have no matrices, their products.
  void assemble_operators();
};
} // namespace Continua

#endif
