#include <continua/finite_volume/cell_wise.h>

#include <continua/base/interruption.h>
#include <continua/finite_volume/cell_wise_initial_state.h>
#include <continua/finite_volume/cell_wise_kelly_indicator.h>
#include <continua/finite_volume/cell_wise_traction_jump.h>
#include <continua/finite_volume/cell_wise_vibration.h>
#include <continua/linear_algebra/matrix_product.h>

#include <deal.II/base/mpi.h>

namespace Continua
{
using namespace dealii;

template <int dim>
CellWise<dim>::CellWise(parallel::TriangulationBase<dim> &triangulation,
                        const Problem &problem,
                        const CellWiseParameters &parameters,
                        Log &log)
    : problem(problem),
      parameters(parameters),
      log(log),
      space(triangulation, problem.model),
      conditions(space, problem.conditions),
      load_list(space, problem, conditions),
      equations(space, problem, conditions, operators, closure, this->parameters),
      cell_products(space, operators, this->parameters),
      linear_system(problem, space, operators, closure, equations, log),
      evaluation(space, problem),
      motion(space, problem, evaluation.reconstruction()),
      output(space, problem, evaluation),
      cell_transfer(space, conditions, problem.conditions, evaluation.reconstruction()),
      excess_velocity(equations, evaluation.reconstruction()),
      swept_volumes(space.mesh),
      convection(equations, excess_velocity, evaluation.reconstruction(), swept_volumes),
      cell_prescribed(conditions, swept_volumes),
      nonlinear_system(equations, operators, convection, linear_system),
      step_variant(problem,
                   conditions,
                   load_list,
                   operators,
                   closure,
                   cell_products,
                   equations,
                   linear_system,
                   excess_velocity,
                   log),
      cell_ports(space, conditions, load_list),
      vertex_motion(
          problem.mesh_moves_between_steps
              ? std::make_unique<VertexMotion<dim>>(space, problem, evaluation.reconstruction())
              : nullptr)
{
  for (const Material &material : problem.materials)
    is_liquid.push_back(!material.is_solid());
}

template <int dim>
CellWise<dim>::~CellWise() = default;

template <int dim>
void CellWise<dim>::setup()
{
  space.distribute();
  log.memory_use().mark("numbering and constraints");
  InterruptibleSetUp::end_of_phase(space.communicator, "the numbering");
  conditions.build();
  assemble_cell_operators(space, problem, conditions, parameters,
                          std::vector<bool>(problem.materials.size(), true), operators, closure);
  log.memory_use().mark("matrices of the regions");
  InterruptibleSetUp::end_of_phase(space.communicator, "the assembly");
  load_list.build();
  equations.reinit();
  cell_products.reinit();
  linear_system.reinit();
  step_variant.reinit();
  evaluation.build();
  motion.forget();
  excess_velocity.reinit();
  swept_volumes.reset();
  if (!this->is_nonlinear())
    return;
  convection.reinit();
  nonlinear_system.reinit();
  if (!vertex_motion)
    return;
  vertex_motion->reinit();
  // The sizes of the liquids are the undeformed ones, also where a run goes on.
  motion.set_up();
}

template <int dim>
std::vector<std::vector<unsigned int>> CellWise<dim>::velocity_nodes() const
{
  std::vector<std::vector<unsigned int>> nodes;
  for (const CellWiseOperators &of_region : operators)
    nodes.push_back(rows_with_entries(of_region.stiffness));
  return nodes;
}

template <int dim>
std::vector<std::vector<unsigned int>> CellWise<dim>::pressure_nodes() const
{
  std::vector<std::vector<unsigned int>> nodes;
  for (const CellWiseOperators &of_region : operators)
    nodes.push_back(rows_with_entries(of_region.divergence));
  return nodes;
}

template <int dim>
std::vector<unsigned int> CellWise<dim>::pressures_without_history() const
{
  // A face's goes with its cell's.
  std::vector<bool> has_history(space.pressures.n_owned(), false);
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (!problem.materials[region].is_incompressible())
      for (unsigned int i = 0; i < has_history.size(); ++i)
        if (operators[region].pressure_volume.begin()[i] > 0.)
          has_history[i] = true;
  for (unsigned int face = 0; face < space.mesh.faces().size(); ++face)
  {
    const VolumeFace<dim> &surface = space.mesh.faces()[face];
    for (unsigned int side = 0; surface.has_value() && side < surface.n_sides(); ++side)
    {
      const FiniteVolume<dim> &cell = space.mesh.cells()[surface.cell(side)];
      if (cell.is_owned && !problem.materials[cell.material_id].is_incompressible())
        has_history[space.local_pressure(space.pressures.of_face(face, side))] = true;
    }
  }
  std::vector<unsigned int> indices;
  for (unsigned int i = 0; i < has_history.size(); ++i)
    if (!has_history[i])
      indices.push_back(i);
  return indices;
}

template <int dim>
DistributedVector CellWise<dim>::mesh_vertex_vector() const
{
  return vertex_motion ? vertex_motion->vector() : DistributedVector();
}

template <int dim>
StateNumbering CellWise<dim>::numbering() const
{
  StateNumbering numbering{
      VectorNumbering(space.communicator, "velocity", space.velocities.numbers(dim)),
      VectorNumbering(space.communicator, "pressure", space.pressures.numbers(1))};
  if (vertex_motion)
    numbering.mesh_vertices = vertex_motion->numbering();
  return numbering;
}

template <int dim>
void CellWise<dim>::set_initial_state(DistributedVector &velocity,
                                      DistributedVector &displacement,
                                      DistributedVector &pressure)
{
  const InteriorData &data = problem.interior;
  set_initial_values(space, problem, velocity, displacement, pressure);
  // What is held does not move from the start on.
  if (conditions.is_homogeneous())
    conditions.clear_prescribed(velocity);
  if (!data.initial_displacement.empty() && data.initial_pressure.empty() &&
      parameters.has_pressure())
  {
    step_variant.set_pressure_of_displacement(displacement, pressure);
    log.line("Initial pressure: in equilibrium with the initial displacement");
  }
}

template <int dim>
void CellWise<dim>::prepare_transfer(const StateVectors &vectors)
{
  cell_transfer.prepare(vectors.velocities, vectors.pressures);
}

template <int dim>
void CellWise<dim>::finish_transfer(const StateVectors &vectors)
{
  cell_transfer.finish(vectors.velocities, vectors.pressures);
  step_variant.forget_dilatation_rate();
}

template <int dim>
SolverSizes CellWise<dim>::sizes() const
{
  SolverSizes sizes;
  sizes.n_cells = space.mesh.triangulation.n_global_active_cells();
  sizes.n_dofs[step_variant.solves_for_displacement() ? "displacement" : "velocity"] =
      dim * space.velocities.n_values();
  if (parameters.has_pressure())
    sizes.n_dofs["pressure"] = space.pressures.n_values();
  linear_system.set_sizes(sizes);
  return sizes;
}

template <int dim>
void CellWise<dim>::visit(StateVisitor &visitor)
{
  step_variant.visit(visitor);
  if (vertex_motion)
    vertex_motion->visit(visitor);
}

template <int dim>
void CellWise<dim>::begin_step(const Step &step, const State &start)
{
  if (!vertex_motion)
    return;
  SectionTimer::Scope scope(log.timer(), "mesh motion");
  vertex_motion->begin_step(step, start);
  vertex_motion->check();
  take_shapes();
  // On the way to a steady state nothing depends on how the mesh came to its place.
  if (step.finds_steady_state)
    swept_volumes.reset();
  else
    swept_volumes.measure(step, vertex_motion->older_places(), vertex_motion->places_at_start(),
                          vertex_motion->places(), is_liquid);
  convection.begin_step(start.velocity);
}

template <int dim>
void CellWise<dim>::take_shapes()
{
  space.move(vertex_motion->places(), is_liquid);
  const int have_turned = conditions.take_shapes() ? 1 : 0;
  if (Utilities::MPI::max(have_turned, space.communicator) == 1)
    linear_system.turn_conditions();
  assemble_cell_operators(space, problem, conditions, parameters, is_liquid, operators, closure);
  load_list.build();
  equations.remeasure();
  step_variant.take_shapes();
  evaluation.take_shapes();
  excess_velocity.reinit();
  convection.reinit();
  nonlinear_system.reinit();
}

template <int dim>
void CellWise<dim>::start_from(const State &state)
{
  if (vertex_motion)
  {
    vertex_motion->start_from(state);
    take_shapes();
  }
  step_variant.start_from(state);
}

template <int dim>
void CellWise<dim>::finish_load()
{
  if (!vertex_motion)
    return;
  vertex_motion->take_state();
  take_shapes();
}

template <int dim>
void CellWise<dim>::take_motion(const State &state, MotionExtremes &extremes)
{
  motion.take(state, extremes);
  if (!vertex_motion)
    return;
  extremes.mesh_volume_ratio = vertex_motion->worst().least_volume_ratio;
  extremes.mesh_volume_time = vertex_motion->worst().time;
}

template <int dim>
void CellWise<dim>::finish_step(const StepSolution &solution, const State &state)
{
  step_variant.finish_step(solution, state);
  if (!vertex_motion)
    return;
  const std::string warning = vertex_motion->finish_step(solution.step.time);
  if (!warning.empty())
    log.warning(warning);
}

template <int dim>
std::map<std::string, std::string> CellWise<dim>::add_output(const State &state,
                                                             DataOut<dim> &data_out)
{
  auto units = output.add(state, data_out);
  if (vertex_motion)
  {
    mesh_displacement = vertex_motion->ghosted_displacement();
    data_out.add_data_vector(vertex_motion->dofs(), mesh_displacement,
                             std::vector<std::string>(dim, "mesh_displacement"),
                             std::vector<DataComponentInterpretation::DataComponentInterpretation>(
                                 dim, DataComponentInterpretation::component_is_part_of_vector));
    units["mesh_displacement"] = "m";
  }
  return units;
}

template <int dim>
void CellWise<dim>::indicators(const IndicatorRequest &request,
                               const State &state,
                               const std::vector<double> &port_pressures,
                               const double time,
                               Vector<float> &per_cell)
{
  const LinearReconstruction<dim> &reconstruction = evaluation.reconstruction();
  if (request.kind == IndicatorRequest::Kind::traction_jump)
    traction_jump_indicators(space, problem, evaluation, conditions, state, port_pressures, time,
                             per_cell);
  else if (request.field == IndicatorField::pressure)
    kelly_indicators_of_pressure(space, reconstruction, state.pressure, per_cell);
  else
    kelly_indicators_of_velocity(
        space, reconstruction,
        request.field == IndicatorField::velocity ? state.velocity : state.history.displacement(),
        per_cell);
}

template <int dim>
double CellWise<dim>::error_norm(const State &state,
                                 const ComparedField field,
                                 const std::vector<Expression> &exact,
                                 const double time)
{
  return evaluation.error_norm(state, field, exact, time);
}

template <int dim>
std::unique_ptr<VibrationOperator<dim>> CellWise<dim>::vibration(const VibratingState &state)
{
  SystemCoefficients steady;
  steady.set_steady(problem);
  return std::make_unique<CellWiseVibration<dim>>(
      equations, linear_system.cell_coefficients(steady, 1.), state);
}

template class CellWise<2>;
template class CellWise<3>;
} // namespace Continua
