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
#include <continua/finite_element/taylor_hood_nonlinear.h>

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
    return linear_products.pressures_without_history();
  }
  StateNumbering numbering() const override;

  ProductsByRegion &products() override { return linear_products; }
  PrescribedVelocities &prescribed() override { return constraints; }
  LinearSystem &system() override { return systems; }
  NonlinearSystem *nonlinear() override { return terms.empty() ? nullptr : &nonlinear_system; }
  StepVariant &variant() override { return plain_step; }
  const LoadList &loads() const override { return load_list; }
  const LoadList &loads_of(unsigned int region) override;
  Ports &ports() override { return ends_and_cavities; }
  Cavities *cavities() override { return &ends_and_cavities; }
  WallShear *wall_shear() override { return &wall_shear_stress; }

  void set_initial_state(DistributedVector &velocity,
                         DistributedVector &displacement,
                         DistributedVector &pressure) override;
  const DistributedVector *mesh_displacement() const override
  {
    return moving_mesh ? &moving_mesh->displacement() : nullptr;
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
  void finish_step(const StepSolution &solution, const State &state) override;

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
                    ComparedField field,
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
  LinearProducts<dim> linear_products;
  StepVariant plain_step;
  std::unique_ptr<MetricHistory<dim>> metrics; ///< null where nothing relaxes in finite deformation
  std::unique_ptr<MovingMesh<dim>> moving_mesh; ///< null where the mesh stays
  RegionTerms<dim> terms;                       ///< of the regions that are not linear
  LinearSystems<dim> systems;
  TaylorHoodNonlinear<dim> nonlinear_system;
  EndsAndCavities<dim> ends_and_cavities;
  MeshTransfer<dim> mesh_transfer;
  FieldEvaluation<dim> evaluation;
  WallShearStress<dim> wall_shear_stress;
  SolidMotion<dim> motion;
  FieldOutput<dim> output;

  /// Makes the matrices of the regions, with the constraints of the new mesh, and where mass and
  /// stiffness have no matrices, their products.
  void assemble_operators();
};
} // namespace Continua

#endif
