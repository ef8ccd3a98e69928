#include <continua/finite_element/taylor_hood.h>

#include <continua/base/interruption.h>
#include <continua/finite_element/assembly/initial_state.h>
#include <continua/finite_element/looking/kelly_indicator.h>
#include <continua/finite_element/looking/traction_jump.h>
#include <continua/finite_element/products/matrix_free_regions.h>
#include <continua/finite_element/products/supports.h>
#include <continua/finite_element/taylor_hood_harmonic.h>
#include <continua/finite_element/taylor_hood_vibration.h>

namespace Continua
{
using namespace dealii;

template <int dim>
TaylorHood<dim>::TaylorHood(parallel::TriangulationBase<dim> &triangulation,
                            const Problem &problem,
                            const TaylorHoodParameters &parameters,
                            Log &log)
    : problem(problem),
      log(log),
      space(triangulation, parameters.space, problem.model, problem.regions.size()),
      constraints(space, problem.conditions),
      operators(problem.regions.size()),
      load_list(space, problem),
      linear_solver(parameters.linear_solver),
      linear_products(space, problem, operators),
      plain_step(linear_products),
      metrics(MetricHistory<dim>::make(space, problem)),
      moving_mesh(MovingMesh<dim>::make(space, problem, log)),
      terms(space, problem, linear_solver, metrics.get()),
      systems(
          space, problem, operators, constraints, terms, linear_solver, parameters.outlook, log),
      nonlinear_system(space, problem, linear_products, terms, systems, moving_mesh.get()),
      ends_and_cavities(space, problem, load_list),
      mesh_transfer(space),
      evaluation(space, problem, metrics.get()),
      wall_shear_stress(space, problem),
      motion(space, problem),
      output(space, problem, evaluation, wall_shear_stress, metrics.get())
{
}

template <int dim>
void TaylorHood<dim>::setup()
{
  // The products of the old mesh go first: two would need twice the memory.
  for (RegionOperators &region : operators)
    region.products = nullptr;
  systems.forget_derivative();
  space.distribute();
  log.memory_use().mark("numbering and constraints");
  InterruptibleSetUp::end_of_phase(space.communicator, "the numbering");
  assemble_operators();
  for (const std::string &conflict : constraints.conflicts())
    log.warning(conflict);
  load_list.build();
  loads_of_regions.clear();
  systems.reinit();
  if (metrics != nullptr)
    metrics->reinit();
  log.memory_use().mark("loads, ends and evaluation");
  if (moving_mesh)
    moving_mesh->reinit(
        {systems.has_iterative_tangent(), linear_solver.is_matrix_free(space.degree())
                                              ? std::optional(linear_solver.instruction_set)
                                              : std::nullopt});
  terms.reinit(log.memory_use());
  ends_and_cavities.reinit();
  evaluation.rebuild();
  wall_shear_stress.reinit();
  motion.forget();
  linear_products.reinit();
  log.memory_use().mark("loads, ends and evaluation");
}

template <int dim>
void TaylorHood<dim>::assemble_operators()
{
  const bool is_matrix_free = systems.has_products_without_matrix();
  if (is_matrix_free)
    assemble_pressure_operators(space, operators);
  else
    assemble_region_operators(space, operators);
  assemble_supports(space, problem.conditions, operators);
  log.memory_use().mark("matrices of the regions");
  InterruptibleSetUp::end_of_phase(space.communicator, "the assembly");
  constraints.build();
  if (is_matrix_free)
  {
    const auto of_regions = std::make_shared<MatrixFreeRegions<dim>>(
        space, constraints, operators.size(), linear_solver.instruction_set);
    for (unsigned int region = 0; region < operators.size(); ++region)
    {
      operators[region].products = of_regions;
      operators[region].number = region;
    }
  }
  log.memory_use().mark("products without a matrix");
}

template <int dim>
DistributedVector TaylorHood<dim>::internal_metric_vector() const
{
  return metrics != nullptr ? metrics->vector() : DistributedVector();
}

template <int dim>
std::vector<std::vector<unsigned int>> TaylorHood<dim>::velocity_nodes() const
{
  return Continua::velocity_nodes(operators);
}

template <int dim>
std::vector<std::vector<unsigned int>> TaylorHood<dim>::pressure_nodes() const
{
  return Continua::pressure_nodes(operators);
}

template <int dim>
StateNumbering TaylorHood<dim>::numbering() const
{
  StateNumbering numbering{
      VectorNumbering(space.communicator, "velocity", numbers_of_dofs(space.velocity_dofs)),
      VectorNumbering(space.communicator, "pressure", numbers_of_dofs(space.pressure_dofs))};
  if (metrics != nullptr)
    numbering.internal_metrics = metrics->numbering();
  return numbering;
}

template <int dim>
const LoadList &TaylorHood<dim>::loads_of(const unsigned int region)
{
  const auto [entry, is_new] = loads_of_regions.try_emplace(region, space, problem, region);
  if (is_new)
    entry->second.build();
  return entry->second;
}

template <int dim>
void TaylorHood<dim>::set_initial_state(DistributedVector &velocity,
                                        DistributedVector &displacement,
                                        DistributedVector &pressure)
{
  Continua::set_initial_state(space, problem, operators, log, velocity, displacement, pressure);
  terms.start_from(displacement);
  if (moving_mesh)
    moving_mesh->start_from(displacement);
}

template <int dim>
void TaylorHood<dim>::prepare_transfer(const StateVectors &vectors)
{
  mesh_transfer.prepare(vectors.velocities, vectors.pressures);
  if (metrics != nullptr)
    metrics->prepare_transfer(vectors.internal_metrics);
}

template <int dim>
void TaylorHood<dim>::finish_transfer(const StateVectors &vectors)
{
  mesh_transfer.finish(vectors.velocities, vectors.pressures);
  if (metrics != nullptr)
    metrics->finish_transfer(vectors.internal_metrics);
  finish_load();
}

template <int dim>
void TaylorHood<dim>::visit(StateVisitor &visitor)
{
  if (metrics != nullptr)
    metrics->visit(visitor);
  terms.visit(visitor);
  if (moving_mesh)
    moving_mesh->visit(visitor);
}

template <int dim>
void TaylorHood<dim>::finish_load()
{
  terms.take_own_state();
  if (moving_mesh)
    moving_mesh->take_state();
}

template <int dim>
void TaylorHood<dim>::start_from(const State & /*state*/)
{
  if (moving_mesh)
    moving_mesh->begin_run();
}

template <int dim>
void TaylorHood<dim>::begin_step(const Step &step, const State & /*start*/)
{
  if (metrics != nullptr)
    metrics->predict(step);
  if (moving_mesh)
    moving_mesh->begin_step(step);
}

template <int dim>
void TaylorHood<dim>::finish_step(const StepSolution &solution, const State &state)
{
  terms.finish_step(solution, state);
  if (moving_mesh)
    moving_mesh->finish_step(solution);
}

template <int dim>
SolverSizes TaylorHood<dim>::sizes() const
{
  SolverSizes sizes;
  sizes.n_cells = space.triangulation.n_global_active_cells();
  sizes.n_dofs["velocity"] = space.velocity_dofs.n_dofs();
  sizes.n_dofs["pressure"] = space.pressure_dofs.n_dofs();
  systems.set_sizes(sizes);
  return sizes;
}

template <int dim>
std::map<std::string, std::string> TaylorHood<dim>::add_output(const State &state,
                                                               DataOut<dim> &data_out)
{
  // Together with the basis of FGMRES the fields would be the largest memory of a run.
  systems.free_work_space();
  return output.add(state, data_out);
}

template <int dim>
void TaylorHood<dim>::indicators(const IndicatorRequest &request,
                                 const State &state,
                                 const std::vector<double> &port_pressures,
                                 const double time,
                                 Vector<float> &per_cell)
{
  if (request.kind == IndicatorRequest::Kind::traction_jump)
    traction_jump_indicators(space, problem, metrics.get(), state, port_pressures, time, per_cell);
  else if (request.field == IndicatorField::pressure)
    kelly_indicators_of_pressure(space, state.pressure, state.mesh_displacement, per_cell);
  else
    kelly_indicators_of_velocity(
        space,
        request.field == IndicatorField::velocity ? state.velocity : state.displacement_of_shape(),
        state.mesh_displacement, per_cell);
}

template <int dim>
std::unique_ptr<VibrationOperator<dim>> TaylorHood<dim>::vibration(const VibratingState &state)
{
  // The solver of vibrations is direct and needs the matrices.
  if (!operators.empty() && operators.front().products)
    assemble_velocity_operators<dim>(space, all_cells<dim>, operators);
  return std::make_unique<TaylorHoodVibration<dim>>(space, problem, operators, constraints,
                                                    systems.step_system(), state);
}

template <int dim>
std::unique_ptr<HarmonicSystem<dim>> TaylorHood<dim>::harmonic_system(const HarmonicState &state)
{
  // Its solver is direct and needs the matrices.
  if (!operators.empty() && operators.front().products)
    assemble_velocity_operators<dim>(space, all_cells<dim>, operators);
  std::unique_ptr<LoadedBody<dim>> loaded;
  if (!terms.empty())
  {
    LoadedState loaded_state{
        state.displacement, state.velocity, state.pressure, {}, state.time_of_loads};
    if (moving_mesh)
      loaded_state.mesh_displacement = moving_mesh->displacement();
    loaded = std::make_unique<LoadedBody<dim>>(space, problem, terms.of_models(), metrics.get(),
                                               loaded_state);
  }
  return std::make_unique<TaylorHoodHarmonic<dim>>(space, problem, operators, constraints,
                                                   load_list, linear_products, state, evaluation,
                                                   std::move(loaded), moving_mesh.get());
}

template class TaylorHood<2>;
template class TaylorHood<3>;
} // namespace Continua
