#ifndef continua_finite_volume_cell_wise_h
#define continua_finite_volume_cell_wise_h

#include <continua/base/log.h>
#include <continua/continuum/discretisation.h>
#include <continua/continuum/problem.h>
#include <continua/finite_volume/cell_wise_convection.h>
#include <continua/finite_volume/cell_wise_evaluation.h>
#include <continua/finite_volume/cell_wise_linear_system.h>
#include <continua/finite_volume/cell_wise_loads.h>
#include <continua/finite_volume/cell_wise_motion.h>
#include <continua/finite_volume/cell_wise_nonlinear.h>
#include <continua/finite_volume/cell_wise_output.h>
#include <continua/finite_volume/cell_wise_ports.h>
#include <continua/finite_volume/cell_wise_prescribed.h>
#include <continua/finite_volume/cell_wise_products.h>
#include <continua/finite_volume/cell_wise_step_variant.h>
#include <continua/finite_volume/cell_wise_system.h>
#include <continua/finite_volume/cell_wise_transfer.h>
#include <continua/finite_volume/excess_velocity.h>
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
 * cell-wise path in the manual. CellWiseStepVariant has what it does in a step in its own way.
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

  ProductsByRegion &products() override { return cell_products; }
  PrescribedVelocities &prescribed() override { return cell_prescribed; }
  LinearSystem &system() override { return linear_system; }
  NonlinearSystem *nonlinear() override
  {
    return problem.convection.is_on ? &nonlinear_system : nullptr;
  }
  StepVariant &variant() override { return step_variant; }
  const LoadList &loads() const override { return load_list; }
  Ports &ports() override { return cell_ports; }

  void set_initial_state(DistributedVector &velocity,
                         DistributedVector &displacement,
                         DistributedVector &pressure) override;

  void prepare_transfer(const StateVectors &vectors) override;
  void finish_transfer(const StateVectors &vectors) override;
  SolverSizes sizes() const override;

  void visit(StateVisitor &visitor) override;
  /// Moves the mesh to where it is at the end of the step.
  void begin_step(const Step &step, const State &start) override;
  void finish_step(const StepSolution &solution, const State &state) override;
  void start_from(const State &state) override;
  void finish_load() override;

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
                    ComparedField field,
                    const std::vector<Expression> &exact,
                    double time) override;
  void report_corrections(const std::function<void(const LoopCorrection &)> &sink) override
  {
    linear_system.report_corrections(sink);
  }
  std::unique_ptr<VibrationOperator<dim>> vibration(const VibratingState &state) override;

private:
  const Problem &problem;
  const CellWiseParameters parameters;
  Log &log;
  CellWiseSpace<dim> space;
  FaceConditions<dim> conditions;
  CellWiseLoads<dim> load_list;
  std::vector<CellWiseOperators> operators;
  PressureClosure closure;
  CellWiseSystem<dim> equations;
  CellWiseProducts<dim> cell_products;
  CellWiseLinearSystem<dim> linear_system;
  CellWiseEvaluation<dim> evaluation;
  CellWiseMotion<dim> motion;
  CellWiseOutput<dim> output;
  CellWiseTransfer<dim> cell_transfer;
  ExcessVelocity<dim> excess_velocity;
  SweptVolumes<dim> swept_volumes;
  CellWiseConvection<dim> convection;
  CellWisePrescribed<dim> cell_prescribed;
  CellWiseNonlinear<dim> nonlinear_system;
  CellWiseStepVariant<dim> step_variant;
  CellWisePorts<dim> cell_ports;
  std::unique_ptr<VertexMotion<dim>> vertex_motion; ///< null where the mesh stays
  std::vector<bool> is_liquid;                      ///< by material id
  DistributedVector mesh_displacement;              ///< of the vertices, for drawing [m]

  /// Makes what depends on the shapes of cells and faces anew, for the vertices at the end of the
  /// step that is being made.
  void take_shapes();
};
} // namespace Continua

#endif
