#include <continua/finite_element/matrix_free_regions.h>
#include <continua/finite_element/taylor_hood.h>

#include <continua/base/interruption.h>
#include <continua/base/memory_limit.h>
#include <continua/continuum/local_product.h>
#include <continua/finite_element/convective_terms.h>
#include <continua/finite_element/deformation_terms.h>
#include <continua/finite_element/flow_shapes.h>
#include <continua/finite_element/initial_state.h>
#include <continua/finite_element/kelly_indicator.h>
#include <continua/finite_element/place_of_entry.h>
#include <continua/finite_element/supports.h>
#include <continua/finite_element/taylor_hood_vibration.h>
#include <continua/finite_element/traction_jump.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
/// A factor of this size takes some ten seconds [bytes].
constexpr double least_announced_factor = 0.5e9;
/// Of the mesh: below it cells are flat.
constexpr double least_good_volume_ratio = 0.2;

template <int dim>
NonlinearTerms<dim> make_nonlinear_terms(const Space<dim> &space,
                                         const Problem &problem,
                                         const LinearSolverParameters &solver,
                                         MetricHistory<dim> *const metrics)
{
  NonlinearTerms<dim> terms;
  if (problem.has_regions_of(RegionModel::finite_solid))
    terms.push_back(std::make_unique<DeformationTerms<dim>>(space, problem, metrics));
  if (problem.has_regions_of(RegionModel::flow))
    terms.push_back(std::make_unique<ConvectiveTerms<dim>>(
        space, problem,
        solver.is_matrix_free(space.degree()) && !problem.mesh_moves
            ? std::optional(solver.instruction_set)
            : std::nullopt));
  return terms;
}

/// The conditions of the ports of outlets whose faces move.
std::vector<unsigned int> moving_ports(const Problem &problem)
{
  std::vector<unsigned int> conditions;
  for (const Outlet &outlet : problem.outlets)
    if (problem.mesh_moves)
      conditions.insert(conditions.end(), outlet.conditions.begin(), outlet.conditions.end());
  return conditions;
}
} // namespace

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
      system(space, operators, constraints, parameters.linear_solver, parameters.outlook),
      metrics(MetricHistory<dim>::make(space, problem)),
      mesh_motion(problem.mesh_moves ? std::make_unique<MeshMotion<dim>>(space, problem) : nullptr),
      liquid_balance(problem.mesh_moves ? std::make_unique<LiquidBalance<dim>>(space, problem)
                                        : nullptr),
      ports(moving_ports(problem)),
      port_faces(space, problem, ports),
      terms(make_nonlinear_terms(space, problem, linear_solver, metrics.get())),
      tangent(space, operators, constraints, parameters.linear_solver.direct_solver),
      cavities(space, problem),
      mesh_transfer(space),
      evaluation(space, problem, metrics.get()),
      wall_shear(space, problem),
      motion(space, problem),
      output(space, problem, evaluation, wall_shear, metrics.get())
{
  system.announce = [&log](const double n_unknowns, const double bytes)
  {
    if (bytes < least_announced_factor)
      return;
    std::ostringstream text;
    text << "Factoring " << std::fixed << std::setprecision(0) << n_unknowns << " unknowns, about "
         << memory_text(bytes);
    log.note(text.str());
  };
  // A search for rest makes many factors; the first one that fails stands for all.
  system.announce_pivots = [&log, is_said = false](const std::string &name) mutable
  {
    if (!std::exchange(is_said, true))
      log.note("The factor without pivots has lost its digits (" + name +
               "): MUMPS with pivots takes its place, and that of each later one that loses them");
  };
  system.memory_use = &log.memory_use();
}

template <int dim>
bool TaylorHood<dim>::has_products_without_matrix() const
{
  return linear_solver.is_matrix_free(space.degree()) &&
         (is_nonlinear() ? has_iterative_tangent() : system.choice().solver != StepSolver::direct);
}

template <int dim>
void TaylorHood<dim>::setup()
{
  // Those of the old mesh go first: two would need twice the memory.
  for (RegionOperators &region : operators)
    region.products = nullptr;
  for (const auto &of_model : terms)
    of_model->forget_derivative();
  derivative_is_marked = false;
  space.distribute();
  log.memory_use().mark("numbering and constraints");
  InterruptibleSetUp::end_of_phase(space.communicator, "the numbering");
  const bool is_matrix_free = has_products_without_matrix();
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
    const auto products = std::make_shared<MatrixFreeRegions<dim>>(
        space, constraints, operators.size(), linear_solver.instruction_set);
    for (unsigned int region = 0; region < operators.size(); ++region)
    {
      operators[region].products = products;
      operators[region].number = region;
    }
  }
  log.memory_use().mark("products without a matrix");
  for (const std::string &conflict : constraints.conflicts())
    log.warning(conflict);
  load_list.build();
  loads_of_regions.clear();
  system.reinit();
  if (metrics != nullptr)
    metrics->reinit();
  log.memory_use().mark("loads, ends and evaluation");
  if (mesh_motion)
  {
    mesh_motion->reinit(has_iterative_tangent());
    liquid_balance->reinit();
  }
  port_faces.reinit();
  for (const auto &of_model : terms)
  {
    of_model->reinit();
    log.memory_use().mark("cells of the terms that are not linear");
  }
  tangent.reinit();
  cavities.reinit();
  evaluation.rebuild();
  wall_shear.reinit();
  motion.forget();
  for (DistributedVector *vector : {&zero_velocity, &velocity_work})
    *vector = space.velocity_vector();
  pressure_work = space.pressure_vector();
  if (has_iterative_tangent())
  {
    for (DistributedVector *vector : {&tangent_change, &tangent_momentum})
      *vector = space.velocity_vector();
    tangent_mass = space.pressure_vector();
  }
  divergence_norm = gradient_norm = 0.;
  for (const RegionOperators &region : operators)
  {
    divergence_norm += region.divergence.linfty_norm();
    gradient_norm += region.divergence.l1_norm();
  }
  log.memory_use().mark("loads, ends and evaluation");
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
std::vector<unsigned int> TaylorHood<dim>::pressures_without_history() const
{
  DistributedVector compressible = space.pressure_vector(), one = compressible,
                    volume = compressible;
  one = 1.;
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (!problem.materials[region].is_incompressible())
    {
      multiply(operators[region].pressure_mass, volume, one);
      compressible.add(1., volume);
    }
  std::vector<unsigned int> indices;
  for (unsigned int i = 0; i < space.pressure_owned.n_elements(); ++i)
    if (compressible.begin()[i] == 0.)
      indices.push_back(i);
  return indices;
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
void TaylorHood<dim>::multiply_mass(const unsigned int region,
                                    DistributedVector &momentum,
                                    const DistributedVector &velocity)
{
  operators[region].multiply_mass(momentum, velocity);
}

template <int dim>
void TaylorHood<dim>::multiply_stiffness(const unsigned int region,
                                         DistributedVector &force,
                                         const DistributedVector &mixture)
{
  operators[region].multiply_stiffness(force, mixture);
}

template <int dim>
void TaylorHood<dim>::multiply_gradient(const unsigned int region,
                                        DistributedVector &force,
                                        const DistributedVector &pressure)
{
  multiply_transposed(operators[region].divergence, force, pressure);
  force *= -1.;
}

template <int dim>
void TaylorHood<dim>::multiply_divergence(const unsigned int region,
                                          DistributedVector &rate,
                                          const DistributedVector &velocity)
{
  multiply(operators[region].divergence, rate, velocity);
}

template <int dim>
void TaylorHood<dim>::multiply_pressure_mass(const unsigned int region,
                                             DistributedVector &product,
                                             const DistributedVector &pressure)
{
  multiply(operators[region].pressure_mass, product, pressure);
}

template <int dim>
void TaylorHood<dim>::multiply_support_stiffness(const unsigned int region,
                                                 DistributedVector &force,
                                                 const DistributedVector &displacement)
{
  if (operators[region].is_supported)
    multiply(operators[region].support_stiffness, force, displacement);
  else
    force = 0.;
}

template <int dim>
void TaylorHood<dim>::multiply_support_damping(const unsigned int region,
                                               DistributedVector &force,
                                               const DistributedVector &velocity)
{
  if (operators[region].is_supported)
    multiply(operators[region].support_damping, force, velocity);
  else
    force = 0.;
}

template <int dim>
double TaylorHood<dim>::pressure_power(const unsigned int region,
                                       const DistributedVector &velocity,
                                       const DistributedVector &pressure)
{
  // Cheaper than a product with the transposed.
  multiply(operators[region].divergence, pressure_work, velocity);
  return -local_product(pressure_work, pressure);
}

template <int dim>
double TaylorHood<dim>::pressure_product(const unsigned int region,
                                         const DistributedVector &p,
                                         const DistributedVector &q)
{
  multiply(operators[region].pressure_mass, pressure_work, p);
  return local_product(pressure_work, q);
}

template <int dim>
double TaylorHood<dim>::divergence(const DistributedVector &velocity)
{
  DistributedVector rate = space.pressure_vector(), volume = rate, one = rate;
  for (const auto index : space.pressure_owned)
    if (!space.pressure_hanging.is_constrained(index))
      one[index] = 1.;
  one.compress(VectorOperation::insert);
  for (const RegionOperators &region : operators)
  {
    multiply(region.divergence, pressure_work, velocity);
    rate.add(1., pressure_work);
    multiply(region.pressure_mass, pressure_work, one);
    volume.add(1., pressure_work);
  }
  double largest = 0.;
  for (unsigned int i = 0; i < rate.locally_owned_size(); ++i)
    if (one.begin()[i] > 0.)
      largest = std::max(largest, std::abs(rate.begin()[i] / volume.begin()[i]));
  return Utilities::MPI::max(largest, space.communicator);
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
bool TaylorHood<dim>::prescribed_velocity_jumps(const double begin, const double end) const
{
  return constraints.jumps(begin, end);
}

template <int dim>
void TaylorHood<dim>::evaluate_prescribed(const double time, DistributedVector &values) const
{
  constraints.evaluate(time, values);
}

template <int dim>
void TaylorHood<dim>::prescribed_part(const DistributedVector &velocity,
                                      DistributedVector &values) const
{
  constraints.prescribed_part(velocity, values);
}

template <int dim>
void TaylorHood<dim>::clear_prescribed(DistributedVector &velocity) const
{
  constraints.set_constrained(velocity, zero_velocity);
}

template <int dim>
void TaylorHood<dim>::set_initial_state(DistributedVector &velocity,
                                        DistributedVector &displacement,
                                        DistributedVector &pressure)
{
  Continua::set_initial_state(space, problem, operators, log, velocity, displacement, pressure);
  for (const auto &of_model : terms)
    of_model->start_from(displacement);
  if (mesh_motion)
    mesh_motion->start_from(displacement);
}

template <int dim>
SystemChange TaylorHood<dim>::prepare(const SystemCoefficients &coefficients, double)
{
  if (is_nonlinear())
    return system.take(coefficients) ? SystemChange::coefficients : SystemChange::none;
  if (!system.prepare(coefficients))
    return SystemChange::none;
  report_linear_solver();
  return system.has_new_factor() ? SystemChange::factor : SystemChange::coefficients;
}

template <int dim>
void TaylorHood<dim>::report_linear_solver()
{
  const std::string text =
      std::string("Linear solver: ") +
      (system.solver() == StepSolver::iterative          ? "iterative"
       : system.solver() == StepSolver::single_precision ? "direct, in single precision"
                                                         : "direct") +
      ", as " + system.reason();
  if (text == linear_solver_reported)
    return;
  linear_solver_reported = text;
  if (system.solver() == StepSolver::direct || !system.is_automatic())
    log.detail(text);
  else
    log.line(text);
  log.detail(system.name());
  if (system.library_depends_on_ranks())
    log.detail("The library of a factor depends on the number of ranks: CHOLMOD works on one rank "
               "only");
}

template <int dim>
void TaylorHood<dim>::eliminate_prescribed(const DistributedVector &prescribed,
                                           DistributedVector &momentum,
                                           DistributedVector &mass)
{
  velocity_work = 0.;
  system.add_velocity_product(prescribed, velocity_work);
  momentum.add(-1., velocity_work);
  system.add_divergence(-1., prescribed, mass);
}

template <int dim>
void TaylorHood<dim>::solve(const DistributedVector &prescribed,
                            DistributedVector &momentum,
                            DistributedVector &mass,
                            DistributedVector &velocity,
                            DistributedVector &pressure,
                            StepReport &report)
{
  constraints.restrict_to_free(momentum);
  // The symmetric system has the negative of the mass equation.
  mass *= -1.;
  if (has_iterative_tangent())
    solve_tangent(momentum, mass, velocity, pressure);
  else if (is_nonlinear())
  {
    space.set_hanging_pressures_to_zero(mass);
    tangent.solve(momentum, mass, velocity, pressure);
  }
  else
    system.solve(momentum, mass, velocity, pressure);
  constraints.set_constrained(velocity, prescribed);
  report.linear_iterations += system.take_iterations();
}

template <int dim>
void TaylorHood<dim>::move_mesh(BalancedStep &state)
{
  if (mesh_motion)
    mesh_motion->move(state);
}

template <int dim>
void TaylorHood<dim>::set_mesh_change(const Step &step,
                                      const DistributedVector &of_velocity,
                                      DistributedVector &of_mesh_displacement)
{
  if (mesh_motion)
    mesh_motion->set_change(step, of_velocity, of_mesh_displacement);
}

template <int dim>
void TaylorHood<dim>::forget_linearisation()
{
  tangent.forget_analysis();
  if (mesh_motion)
    mesh_motion->forget_solver();
}

template <int dim>
void TaylorHood<dim>::check_mesh(const BalancedStep &state)
{
  if (!mesh_motion)
    return;
  const MeshQuality quality = mesh_motion->quality(state.mesh_displacement);
  if (quality.least_volume_ratio > 0.)
    return;
  std::ostringstream text;
  text << "the mesh is turned inside out " << quality.place
       << ": the ratio of its volume to that at rest is " << quality.least_volume_ratio
       << " there; a smaller time step, loads that begin smoothly, Mesh = slides on "
          "a plane boundary along which it moves, another Mesh motion or a coarser mesh beside "
          "what moves help";
  throw StepFailure(text.str());
}

template <int dim>
void TaylorHood<dim>::add_nonlinear_terms(const BalancedStep &state,
                                          DistributedVector &momentum,
                                          DistributedVector &mass)
{
  for (const auto &of_model : terms)
    of_model->add(state, momentum, mass);
}

template <int dim>
void TaylorHood<dim>::set_nonlinear_forces(const unsigned int region,
                                           const BalancedStep &state,
                                           NonlinearForces &forces)
{
  terms_of(region).set_forces_of(region, state, forces);
}

template <int dim>
bool TaylorHood<dim>::is_nonlinear_in(const unsigned int region) const
{
  return problem.region_model(region) != RegionModel::linear;
}

template <int dim>
NonlinearCellTerms<dim> &TaylorHood<dim>::terms_of(const unsigned int region) const
{
  const auto found =
      std::find_if(terms.begin(), terms.end(),
                   [region](const auto &of_model) { return of_model->are_of(region); });
  AssertThrow(found != terms.end(), ExcInternalError());
  return **found;
}

template <int dim>
NonlinearEnergy TaylorHood<dim>::nonlinear_energy(const unsigned int region, const State &state)
{
  return terms_of(region).energy_of(region, state);
}

template <int dim>
double TaylorHood<dim>::nonlinear_relaxation(const unsigned int region) const
{
  return is_nonlinear_in(region) ? terms_of(region).relaxation_power(region) : 0.;
}

template <int dim>
void TaylorHood<dim>::add_load_changes(const BalancedStep &state,
                                       const std::optional<unsigned int> region,
                                       DistributedVector &forces)
{
  for (const auto &of_model : terms)
    of_model->add_loads(state, region, forces);
}

template <int dim>
std::string TaylorHood<dim>::place_of_largest(const DistributedVector &momentum,
                                              const DistributedVector &mass,
                                              const bool of_momentum) const
{
  return of_momentum ? place_of_largest_entry(space, space.velocity_dofs, momentum, problem.regions)
                     : place_of_largest_entry(space, space.pressure_dofs, mass, problem.regions);
}

template <int dim>
bool TaylorHood<dim>::has_iterative_tangent() const
{
  return is_nonlinear() && system.choice().solver == StepSolver::iterative;
}

template <int dim>
void TaylorHood<dim>::solve_tangent(DistributedVector &momentum,
                                    DistributedVector &mass,
                                    DistributedVector &velocity,
                                    DistributedVector &pressure)
{
  system.solve_tangent(
      [this](const DistributedVector &of_velocity, const DistributedVector &of_pressure,
             DistributedVector &momentum_rows, DistributedVector &mass_rows)
      {
        tangent_change.equ(1., of_velocity);
        constraints.set_constrained(tangent_change, zero_velocity);
        tangent_momentum = 0.;
        tangent_mass = 0.;
        add_derivative_product(tangent_change, of_pressure, tangent_momentum, tangent_mass);
        restrict_residuals(tangent_momentum, tangent_mass);
        momentum_rows.add(1., tangent_momentum);
        // The symmetric system has the negative of the mass equation.
        mass_rows.add(-1., tangent_mass);
      },
      problem.has_regions_of(RegionModel::finite_solid) ? FurtherTerms::finite_deformation
                                                        : FurtherTerms::convection,
      problem.newton.krylov_tolerance, momentum, mass, velocity, pressure);
}

template <int dim>
bool TaylorHood<dim>::linearise(const BalancedStep &state)
{
  if (has_iterative_tangent())
  {
    // Of small strains without convection.
    SystemCoefficients linear;
    linear.set(problem, state.step);
    system.prepare_nearby(linear);
    report_linear_solver();
    keep_derivative(state);
    return system.has_new_factor();
  }
  const bool is_first = tangent.factor() == nullptr;
  tangent.factorize(system.present_coefficients(), state, terms);
  log.memory_use().mark_again("factor");
  if (is_first)
    log.detail("Linear solver: direct, of the tangent, as " + system.choice().reason + "; " +
               tangent.factor()->name());
  return true;
}

template <int dim>
void TaylorHood<dim>::keep_derivative(const BalancedStep &state)
{
  // A factor's result is the same on every processor, and so is that of its slow iterations.
  for (const auto &of_model : terms)
  {
    of_model->keep_derivative(state, has_iterative_tangent() ? KeptDerivative::without_matrix
                                                             : KeptDerivative::matrices);
    if (has_iterative_tangent())
      system.precondition_grad_div(of_model->grad_div_viscosities(state));
  }
  if (!derivative_is_marked)
    log.memory_use().mark("derivative for products");
  derivative_is_marked = true;
}

template <int dim>
void TaylorHood<dim>::add_derivative_product(const DistributedVector &velocity,
                                             const DistributedVector &pressure,
                                             DistributedVector &momentum,
                                             DistributedVector &mass)
{
  for (const auto &of_model : terms)
    of_model->add_derivative_product(velocity, pressure, momentum, mass);
}

template <int dim>
void TaylorHood<dim>::restrict_residuals(DistributedVector &momentum, DistributedVector &mass) const
{
  constraints.restrict_to_free(momentum);
  space.set_hanging_pressures_to_zero(mass);
}

template <int dim>
ResidualScales TaylorHood<dim>::residual_scales(const DistributedVector &velocity,
                                                const DistributedVector &pressure) const
{
  // B U of a motion without change of volume and B^T p of a uniform pressure are nothing but
  // round-off of their terms.
  typename NonlinearCellTerms<dim>::Sizes sizes{pressure.linfty_norm(), velocity.linfty_norm()};
  for (const auto &of_model : terms)
  {
    const typename NonlinearCellTerms<dim>::Sizes of_terms = of_model->sizes_of_terms();
    sizes.stress = std::max(sizes.stress, of_terms.stress);
    sizes.velocity = std::max(sizes.velocity, of_terms.velocity);
  }
  return {gradient_norm * sizes.stress, divergence_norm * sizes.velocity};
}

template <int dim>
void TaylorHood<dim>::set_prescribed(const DistributedVector &prescribed,
                                     DistributedVector &velocity) const
{
  constraints.set_constrained(velocity, prescribed);
}

template <int dim>
DistributedVector TaylorHood<dim>::flow_of_velocities(const unsigned int condition) const
{
  return load_list.flow_of_velocities(condition);
}

template <int dim>
void TaylorHood<dim>::set_flow_of_velocities(const unsigned int condition,
                                             const DistributedVector &mesh_displacement,
                                             DistributedVector &flow)
{
  port_faces.take(mesh_displacement);
  port_faces.set_flow(std::find(ports.begin(), ports.end(), condition) - ports.begin(), flow);
}

template <int dim>
DistributedVector TaylorHood<dim>::flow_profile(const unsigned int condition) const
{
  DistributedVector profile = space.velocity_vector();
  for (const auto &[dof, shape] : nodal_flow_shapes(space, problem.conditions[condition]))
    profile[dof] = shape.front();
  profile.compress(VectorOperation::insert);
  return profile;
}

template <int dim>
void TaylorHood<dim>::add_velocity_product(const DistributedVector &velocity,
                                           DistributedVector &result)
{
  system.add_velocity_product(velocity, result);
}

template <int dim>
void TaylorHood<dim>::add_divergence(const DistributedVector &velocity, DistributedVector &result)
{
  system.add_divergence(1., velocity, result);
}

template <int dim>
void TaylorHood<dim>::set_reaction(const DistributedVector &profile,
                                   DistributedVector &of_velocity,
                                   DistributedVector &of_pressure,
                                   DistributedVector &momentum,
                                   DistributedVector &mass)
{
  Operators::set_reaction(profile, of_velocity, of_pressure, momentum, mass);
  if (terms.empty())
    return;
  DistributedVector rows = space.velocity_vector(), columns = rows;
  DistributedVector volumes = space.pressure_vector(), pressures = volumes;
  for (const auto &of_model : terms)
    of_model->add_products_with(profile, rows, volumes, columns, pressures);
  momentum.add(-1., rows);
  mass.add(-1., volumes);
  of_velocity.add(1., columns);
  of_pressure.add(-1., pressures);
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
  for (const auto &of_model : terms)
    of_model->visit_state(visitor);
  if (mesh_motion)
  {
    mesh_motion->visit(visitor);
    liquid_balance->visit(visitor);
  }
}

template <int dim>
void TaylorHood<dim>::finish_load()
{
  for (const auto &of_model : terms)
    of_model->take_own_state();
  if (mesh_motion)
    mesh_motion->take_state();
}

template <int dim>
const DistributedVector *TaylorHood<dim>::wall_potentials() const
{
  for (const auto &of_model : terms)
    if (of_model->wall_potentials() != nullptr)
      return of_model->wall_potentials();
  return nullptr;
}

template <int dim>
const DistributedVector *TaylorHood<dim>::unloaded_displacement() const
{
  for (const auto &of_model : terms)
    if (of_model->unloaded_displacement() != nullptr)
      return of_model->unloaded_displacement();
  return nullptr;
}

template <int dim>
void TaylorHood<dim>::set_unloaded_displacement(const DistributedVector &displacement)
{
  for (const auto &of_model : terms)
    of_model->set_unloaded_displacement(displacement);
}

template <int dim>
void TaylorHood<dim>::start_from(const State & /*state*/)
{
  if (mesh_motion)
    mesh_motion->begin_run();
}

template <int dim>
void TaylorHood<dim>::begin_step(const Step &step, const State & /*start*/)
{
  if (metrics != nullptr)
    metrics->predict(step);
  if (mesh_motion)
  {
    TimerOutput::Scope scope(log.timer(), "mesh motion");
    mesh_motion->begin_step(step);
  }
}

template <int dim>
void TaylorHood<dim>::finish_step(const BalancedStep &balanced, const State &state)
{
  for (const auto &of_model : terms)
    of_model->finish_step(balanced, state);
  if (!mesh_motion)
    return;
  mesh_motion->finish_step(balanced);
  liquid_balance->finish_step(balanced);
  const MeshQuality &worst = mesh_motion->worst();
  if (worst.least_volume_ratio >= least_good_volume_ratio || mesh_warning_was_given)
    return;
  mesh_warning_was_given = true;
  std::ostringstream text;
  text << "at t = " << balanced.step.time << " s the mesh is compressed " << worst.place
       << (worst.place.empty() ? "to " : " to ") << worst.least_volume_ratio
       << " of its volume at rest; below " << least_good_volume_ratio
       << " results there lose digits, and at 0 the run ends";
  log.warning(text.str());
}

template <int dim>
SolverSizes TaylorHood<dim>::sizes() const
{
  SolverSizes sizes;
  sizes.n_cells = space.triangulation.n_global_active_cells();
  sizes.n_dofs["velocity"] = space.velocity_dofs.n_dofs();
  sizes.n_dofs["pressure"] = space.pressure_dofs.n_dofs();
  if (tangent.factor() != nullptr)
  {
    sizes.factor_entries = tangent.factor()->n_entries();
    sizes.factor_memory = tangent.factor()->memory();
    sizes.linear_solver = tangent.factor()->name();
    sizes.reason_of_linear_solver = system.choice().reason;
    return sizes;
  }
  if (system.factor() != nullptr)
  {
    sizes.factor_entries = system.factor()->n_entries();
    sizes.factor_memory = system.factor()->memory();
  }
  sizes.linear_solver = system.name();
  sizes.reason_of_linear_solver = system.reason();
  return sizes;
}

template <int dim>
std::map<std::string, std::string> TaylorHood<dim>::add_output(const State &state,
                                                               DataOut<dim> &data_out)
{
  // Together with the basis of FGMRES the fields would be the largest memory of a run.
  system.free_work_space();
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
double TaylorHood<dim>::error_norm(const State &state,
                                   const std::string &field,
                                   const std::vector<Expression> &exact,
                                   const double time)
{
  return evaluation.error_norm(state, field, exact, time);
}

template <int dim>
std::unique_ptr<VibrationOperator<dim>> TaylorHood<dim>::vibration(const VibratingState &state)
{
  // The solver of vibrations is direct and needs the matrices.
  if (!operators.empty() && operators.front().products)
    assemble_velocity_operators<dim>(space, all_cells<dim>, operators);
  return std::make_unique<TaylorHoodVibration<dim>>(space, problem, operators, constraints, system,
                                                    state);
}

template class TaylorHood<2>;
template class TaylorHood<3>;
} // namespace Continua
