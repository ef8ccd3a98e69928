#ifndef continua_finite_volume_cell_wise_h
#define continua_finite_volume_cell_wise_h

#include <continua/base/log.h>
#include <continua/continuum/discretisation.h>
#include <continua/continuum/problem.h>
#include <continua/finite_volume/cell_convection.h>
#include <continua/finite_volume/cell_evaluation.h>
#include <continua/finite_volume/cell_loads.h>
#include <continua/finite_volume/cell_motion.h>
#include <continua/finite_volume/cell_output.h>
#include <continua/finite_volume/cell_system.h>
#include <continua/finite_volume/cell_transfer.h>
#include <continua/finite_volume/displacement_levels.h>
#include <continua/finite_volume/displacement_step.h>
#include <continua/finite_volume/excess_velocity.h>
#include <continua/finite_volume/loaded_faces.h>
#include <continua/finite_volume/vertex_motion.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * The cell-wise discretisation, which emulates the thesis's finite volumes (its chapter 3) on the
 * meshes of deal.II. It puts tested parts together: space, operators by region, conditions on
 * faces, loads, the equations of a step and the way they are solved; see the chapter on the
 * cell-wise path in the manual. Its hooks in the step are those of the faces, which have no mass
 * and deform at once; of Rhie and Chow's corrections; of the displacement form; and of what the
 * thesis plots of powers.
 */
template <int dim>
class CellWise : public Discretisation<dim>
{
public:
  /// `problem` and `log` must outlive it.
  CellWise(dealii::parallel::TriangulationBase<dim> &triangulation,
           const Problem &problem,
           const CellWiseParameters &parameters,
           Log &log);
  ~CellWise() override;

  void setup() override;
  DistributedVector velocity_vector() const override { return space.velocity_vector(); }
  DistributedVector pressure_vector() const override { return space.pressure_vector(); }
  DistributedVector mesh_vertex_vector() const override;
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
  /// Zero where the stress has all of the pressure.
  void multiply_gradient(unsigned int region,
                         DistributedVector &force,
                         const DistributedVector &pressure) override;
  void multiply_divergence(unsigned int region,
                           DistributedVector &rate,
                           const DistributedVector &velocity) override;
  void multiply_pressure_mass(unsigned int region,
                              DistributedVector &product,
                              const DistributedVector &pressure) override;
  double pressure_power(unsigned int region,
                        const DistributedVector &velocity,
                        const DistributedVector &pressure) override;
  /// Over the cells: faces have equations of state, but no volume.
  double pressure_product(unsigned int region,
                          const DistributedVector &p,
                          const DistributedVector &q) override;
  double divergence(const DistributedVector &velocity) override;

  const LoadList &loads() const override { return load_list; }
  bool prescribed_velocity_jumps(double begin, double end) const override;
  bool is_homogeneous() const override { return conditions.is_homogeneous(); }
  void evaluate_prescribed(double time, DistributedVector &values) const override;
  void prescribed_part(const DistributedVector &velocity, DistributedVector &values) const override;
  /// Nothing: faces have no mass.
  void clear_prescribed(DistributedVector &) const override {}
  void set_initial_state(DistributedVector &velocity,
                         DistributedVector &displacement,
                         DistributedVector &pressure) override;

  SystemChange prepare(const SystemCoefficients &coefficients, double pressure_time) override;
  /// Nothing: prescribed velocities have equations of their own, which solve() sets.
  void
  eliminate_prescribed(const DistributedVector &, DistributedVector &, DistributedVector &) override
  {
  }
  bool starts_from_guess() const override { return true; }
  void solve(const DistributedVector &prescribed,
             DistributedVector &momentum,
             DistributedVector &mass,
             DistributedVector &velocity,
             DistributedVector &pressure,
             StepReport &report) override;

  bool is_nonlinear() const override { return problem.convection.is_on; }
  void add_nonlinear_terms(const BalancedStep &state,
                           DistributedVector &momentum,
                           DistributedVector &mass) override
  {
    convection.add(state, momentum, mass);
  }
  void add_nonlinear_powers(const unsigned int region,
                            const BalancedStep &state,
                            const DistributedVector &of_velocity,
                            const TermsTaken taken,
                            NonlinearPowers &powers,
                            DistributedVector *const momentum) override
  {
    convection.add_powers(region, state, of_velocity, taken, powers, momentum);
  }
  bool is_nonlinear_in(unsigned int region) const override;
  NonlinearEnergy nonlinear_energy(unsigned int region, const State &state) override
  {
    return convection.energy_of(region, state.velocity, state.pressure);
  }
  void add_flux_correction(const DistributedVector &pressure, DistributedVector &mass) override
  {
    system.add_flux_correction(pressure, mass);
  }
  bool linearise(const BalancedStep &state) override;
  /// The equations of faces' pressures that have no volume are linear: each solve meets them.
  void restrict_residuals(DistributedVector &momentum, DistributedVector &mass) const override;
  ResidualScales residual_scales(const DistributedVector &velocity,
                                 const DistributedVector &pressure) const override;
  void set_prescribed(const DistributedVector &prescribed,
                      DistributedVector &velocity) const override;
  std::string place_of_largest(const DistributedVector &momentum,
                               const DistributedVector &mass,
                               bool of_momentum) const override;

  DistributedVector flow_of_velocities(unsigned int condition) const override
  {
    return load_list.flow_of_velocities(condition);
  }
  DistributedVector flow_profile(unsigned int condition) const override;
  void add_velocity_product(const DistributedVector &velocity, DistributedVector &result) override
  {
    system.add_velocity_product(velocity, result);
  }
  void add_divergence(const DistributedVector &velocity, DistributedVector &result) override;
  void set_reaction(const DistributedVector &profile,
                    DistributedVector &of_velocity,
                    DistributedVector &of_pressure,
                    DistributedVector &momentum,
                    DistributedVector &mass) override;

  void prepare_transfer(const StateVectors &vectors) override;
  void finish_transfer(const StateVectors &vectors) override;
  SolverSizes sizes() const override;

  void visit(StateVisitor &visitor) override;
  /// With the pressure's own update, where one is asked for.
  Step own_step(const Step &step) override;
  /// Moves the mesh to where it is at the end of the step.
  void begin_step(const Step &step, const State &start) override;
  void finish_step(const BalancedStep &balanced, const State &state) override;
  void start_from(const State &state) override;
  void finish_load() override;
  void multiply_past_stiffness(unsigned int region,
                               DistributedVector &force,
                               const DistributedVector &mixture) override;
  void
  set_past_dilatation(unsigned int region, const State &start, DistributedVector &rate) override;
  bool has_pressure() const override { return parameters.has_pressure(); }
  bool corrects_fluxes() const override { return parameters.has_pressure(); }
  void add_past_flux_correction(const DistributedVector &pressure,
                                DistributedVector &mass) override;
  bool has_massless_velocities() const override;
  bool deform_at_once(DistributedVector &forces,
                      DistributedVector &displacement,
                      DistributedVector &pressure) override;
  void complete_pressure(const DistributedVector &displacement,
                         DistributedVector &pressure) override;
  bool solves_for_displacement() const override { return formulation == Formulation::displacement; }
  void make_displacement_step(const Step &step,
                              const DistributedVector &velocity,
                              DistributedVector &displacement,
                              BalancedStep &balanced,
                              StepReport &report) override;
  void set_reported_stress_force(unsigned int region,
                                 const BalancedStep &step,
                                 DistributedVector &mixture,
                                 DistributedVector &force) override;
  bool reports_change_of_kinetic_energy() const override;

  FieldProbes<dim> &probes() override { return evaluation; }
  void take_motion(const State &state, MotionExtremes &extremes) override;
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
  void report_corrections(const std::function<void(const LoopCorrection &)> &sink) override
  {
    correction_sink = sink;
  }
  std::unique_ptr<VibrationOperator<dim>> vibration(const VibratingState &state) override;

private:
  const Problem &problem;
  const CellWiseParameters parameters;
  const Formulation formulation;
  Log &log;
  CellSpace<dim> space;
  FaceConditions<dim> conditions;
  CellLoads<dim> load_list;
  std::vector<CellOperators> operators;
  PressureClosure closure;
  CellSystem<dim> system;
  double end_of_step = 0.; ///< [s], for the report of corrections
  std::function<void(const LoopCorrection &)> correction_sink; ///< may be empty
  std::unique_ptr<CellSolve<dim>> cell_solve;
  LoadedFaces<dim> loaded_faces;
  DisplacementStep<dim> displacement_step; ///< of the displacement form
  CellEvaluation<dim> evaluation;
  CellMotion<dim> motion;
  CellOutput<dim> output;
  CellTransfer<dim> cell_transfer;
  ExcessVelocity<dim> excess_velocity;
  SweptVolumes<dim> swept_volumes;
  CellConvection<dim> convection;
  std::unique_ptr<VertexMotion<dim>> vertex_motion; ///< null where the mesh stays
  std::vector<bool> is_liquid;                      ///< by material id
  /// Whether the directions in which velocities are prescribed are no longer those of the factor.
  bool conditions_have_turned = false;
  DistributedVector mesh_displacement;             ///< of the vertices, for drawing [m]
  double divergence_norm = 0., gradient_norm = 0.; ///< of B and G
  /// The least viscosity over distance of a face whose traction is given [Pa s/m].
  double face_resistance = 0.;
  Step present_step;             ///< the one that is being made
  double smallest_distance = 0.; ///< between two cells, or from a cell to a boundary face [m]
  bool undamped_is_reported = false;

  // The discretisation's own part of the state.
  /// div U as the equations of state have it, at the end of the last step, for the trapezoidal rule
  /// [m^3/s].
  DistributedVector dilatation_rate;
  bool dilatation_rate_is_current = true;
  DisplacementLevels displacement_levels;         ///< of the displacement form
  DistributedVector velocity_work, pressure_work; ///< work space

  CellCoefficients cell_coefficients(const SystemCoefficients &coefficients,
                                     double pressure_time) const;
  SystemChange prepare_cells(const CellCoefficients &coefficients);
  void set_dilatation_rate(const State &state);
  /// Makes what depends on the shapes of cells and faces anew, for the vertices at the end of the
  /// step that is being made.
  void take_shapes();
  /// What Newton's iteration measures residuals by.
  void measure_operators();
  /// -K div D.
  void set_pressure_of_displacement(const DistributedVector &displacement,
                                    DistributedVector &pressure);
};
} // namespace Continua

#endif
