#include <continua/finite_volume/cell_wise.h>

#include <continua/base/interruption.h>
#include <continua/continuum/local_product.h>
#include <continua/finite_volume/cell_initial_state.h>
#include <continua/finite_volume/cell_kelly_indicator.h>
#include <continua/finite_volume/cell_traction_jump.h>
#include <continua/finite_volume/cell_vibration.h>
#include <continua/finite_volume/coupled_solve.h>
#include <continua/finite_volume/place_of_row.h>
#include <continua/finite_volume/segregated_solve.h>
#include <continua/linear_algebra/matrix_product.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace Continua
{
using namespace dealii;

namespace
{
/// `end_of_step` [s] and `sink`: kept up to date by the discretisation.
template <int dim>
std::unique_ptr<CellSolve<dim>> make_solve(const CellSystem<dim> &system,
                                           const double &end_of_step,
                                           const std::function<void(const LoopCorrection &)> &sink)
{
  if (!system.parameters.is_segregated())
    return std::make_unique<CoupledSolve<dim>>(system);
  const auto tell = [&end_of_step, &sink](LoopCorrection correction)
  {
    correction.time = end_of_step;
    if (sink)
      sink(correction);
  };
  return std::make_unique<SegregatedSolve<dim>>(system, tell);
}

/// What a solid's increment correction is measured by: 2 mu + lambda; where the stencil does not
/// have that for its own coefficient no more than 4 mu, since the correction would fade away as the
/// solid becomes incompressible [Pa].
double correction_modulus(const Material &material, const CellWiseParameters &parameters)
{
  const double mu = material.instantaneous_shear_modulus();
  const double inverse_bulk = material.inverse_bulk_modulus();
  const bool is_nearly_incompressible = inverse_bulk * 8. / 3. * mu < 1.;
  return is_nearly_incompressible &&
                 parameters.stencil_coefficient != StencilCoefficient::longitudinal
             ? 4. * mu
             : 4. / 3. * mu + 1. / inverse_bulk;
}

/// target = weight times source, entry by entry.
void scale(const DistributedVector &weight,
           DistributedVector &target,
           const DistributedVector &source)
{
  for (unsigned int i = 0; i < weight.locally_owned_size(); ++i)
    target.begin()[i] = weight.begin()[i] * source.begin()[i];
}
} // namespace

template <int dim>
CellWise<dim>::CellWise(parallel::TriangulationBase<dim> &triangulation,
                        const Problem &problem,
                        const CellWiseParameters &parameters,
                        Log &log)
    : problem(problem),
      parameters(parameters),
      formulation(parameters.formulation),
      log(log),
      space(triangulation, problem.model),
      conditions(space, problem.conditions),
      load_list(space, problem, conditions),
      system(space, problem, conditions, operators, closure, this->parameters),
      cell_solve(make_solve(system, end_of_step, correction_sink)),
      loaded_faces(space, problem, conditions, operators, closure, this->parameters),
      displacement_step(system, load_list),
      evaluation(space, problem),
      motion(space, problem, evaluation.reconstruction()),
      output(space, problem, evaluation),
      cell_transfer(space, conditions, problem.conditions, evaluation.reconstruction()),
      excess_velocity(system, evaluation.reconstruction()),
      swept_volumes(space.mesh),
      convection(system, excess_velocity, evaluation.reconstruction(), swept_volumes),
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
  system.reinit();
  loaded_faces.reinit();
  displacement_step.reinit();
  velocity_work = space.velocity_vector();
  pressure_work = space.pressure_vector();
  smallest_distance = std::numeric_limits<double>::max();
  for (const VolumeFace<dim> &surface : space.mesh.faces())
    smallest_distance = std::min(smallest_distance, surface.distance * surface.normal);
  smallest_distance = Utilities::MPI::min(smallest_distance, space.communicator);
  evaluation.build();
  motion.forget();
  excess_velocity.reinit();
  swept_volumes.reset();
  if (!is_nonlinear())
    return;
  convection.reinit();
  measure_operators();
  if (!vertex_motion)
    return;
  vertex_motion->reinit();
  // The sizes of the liquids are those at rest, also where a run goes on.
  motion.set_up();
}

template <int dim>
void CellWise<dim>::measure_operators()
{
  divergence_norm = gradient_norm = 0.;
  face_resistance = std::numeric_limits<double>::max();
  for (const auto &face : conditions.faces())
  {
    const VolumeFace<dim> &surface = space.mesh.faces()[face.face];
    const Material &material = problem.materials[space.mesh.cells()[surface.owner].material_id];
    if (!face.normal_is_prescribed && material.shear.viscosity > 0.)
      face_resistance =
          std::min(face_resistance, material.shear.viscosity / (surface.distance * surface.normal));
  }
  face_resistance = Utilities::MPI::min(face_resistance, space.communicator);
  for (const CellOperators &of_region : operators)
  {
    divergence_norm += of_region.divergence.linfty_norm();
    gradient_norm += of_region.gradient.linfty_norm();
  }
}

template <int dim>
std::vector<std::vector<unsigned int>> CellWise<dim>::velocity_nodes() const
{
  std::vector<std::vector<unsigned int>> nodes;
  for (const CellOperators &of_region : operators)
    nodes.push_back(rows_with_entries(of_region.stiffness));
  return nodes;
}

template <int dim>
std::vector<std::vector<unsigned int>> CellWise<dim>::pressure_nodes() const
{
  std::vector<std::vector<unsigned int>> nodes;
  for (const CellOperators &of_region : operators)
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
void CellWise<dim>::multiply_mass(const unsigned int region,
                                  DistributedVector &momentum,
                                  const DistributedVector &velocity)
{
  scale(operators[region].volume, momentum, velocity);
}

template <int dim>
void CellWise<dim>::multiply_stiffness(const unsigned int region,
                                       DistributedVector &force,
                                       const DistributedVector &mixture)
{
  multiply(operators[region].stiffness, force, mixture);
}

template <int dim>
void CellWise<dim>::multiply_gradient(const unsigned int region,
                                      DistributedVector &force,
                                      const DistributedVector &pressure)
{
  if (parameters.has_pressure())
    multiply(operators[region].gradient, force, pressure);
  else
    force = 0.;
}

template <int dim>
void CellWise<dim>::multiply_divergence(const unsigned int region,
                                        DistributedVector &rate,
                                        const DistributedVector &velocity)
{
  multiply(operators[region].divergence, rate, velocity);
}

template <int dim>
void CellWise<dim>::multiply_pressure_mass(const unsigned int region,
                                           DistributedVector &product,
                                           const DistributedVector &pressure)
{
  scale(operators[region].pressure_volume, product, pressure);
}

template <int dim>
double CellWise<dim>::pressure_power(const unsigned int region,
                                     const DistributedVector &velocity,
                                     const DistributedVector &pressure)
{
  multiply_gradient(region, velocity_work, pressure);
  return local_product(velocity_work, velocity);
}

template <int dim>
double CellWise<dim>::pressure_product(const unsigned int region,
                                       const DistributedVector &p,
                                       const DistributedVector &q)
{
  double sum = 0.;
  const double *const volume = operators[region].pressure_volume.begin();
  for (unsigned int i = 0; i < space.mesh.n_owned_cells() && parameters.has_pressure(); ++i)
    sum += p.begin()[i] * volume[i] * q.begin()[i];
  return sum;
}

template <int dim>
double CellWise<dim>::divergence(const DistributedVector &velocity)
{
  double largest = 0.;
  for (const CellOperators &of_region : operators)
  {
    multiply(of_region.divergence, pressure_work, velocity);
    for (unsigned int i = 0; i < space.mesh.n_owned_cells(); ++i)
      if (of_region.pressure_volume.begin()[i] > 0.)
        largest = std::max(
            largest, std::abs(pressure_work.begin()[i] / of_region.pressure_volume.begin()[i]));
  }
  return Utilities::MPI::max(largest, space.communicator);
}

template <int dim>
bool CellWise<dim>::prescribed_velocity_jumps(const double begin, const double end) const
{
  return conditions.jumps(begin, end);
}

template <int dim>
void CellWise<dim>::evaluate_prescribed(const double time, DistributedVector &values) const
{
  conditions.evaluate(time, values);
  conditions.follow(swept_volumes, values);
}

template <int dim>
void CellWise<dim>::prescribed_part(const DistributedVector &velocity,
                                    DistributedVector &values) const
{
  conditions.prescribed_part(velocity, values);
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
    set_pressure_of_displacement(displacement, pressure);
    log.line("Initial pressure: in equilibrium with the initial displacement");
  }
}

template <int dim>
CellCoefficients CellWise<dim>::cell_coefficients(const SystemCoefficients &coefficients,
                                                  const double pressure_time) const
{
  CellCoefficients result;
  result.with_pressure = parameters.has_pressure();
  result.correct_fluxes =
      formulation == Formulation::velocity_pressure && parameters.rhie_chow != RhieChow::none;
  result.mass = coefficients.mass;
  result.compressibility = coefficients.compressibility;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    const Material &material = problem.materials[region];
    // A fluid without viscosity gets next to none, so that its faces have an equation for the
    // motion along them.
    const double least = 1e-12 * coefficients.mass[region] * smallest_distance * smallest_distance;
    result.stiffness.push_back(std::max(coefficients.stiffness[region], least));
    const bool of_increment =
        parameters.rhie_chow == RhieChow::increment && !material.shear.branches.empty();
    result.increment_mobility.push_back(
        of_increment ? 1. / (correction_modulus(material, parameters) * pressure_time) : 0.);
  }
  return result;
}

template <int dim>
SystemChange CellWise<dim>::prepare(const SystemCoefficients &coefficients,
                                    const double pressure_time)
{
  return prepare_cells(cell_coefficients(coefficients, pressure_time));
}

template <int dim>
SystemChange CellWise<dim>::prepare_cells(const CellCoefficients &coefficients)
{
  if (!system.prepare(coefficients) && !conditions_have_turned)
    return SystemChange::none;
  conditions_have_turned = false;
  if (is_nonlinear())
    return SystemChange::coefficients;
  cell_solve->reinit();
  log.memory_use().mark("factor");
  return SystemChange::factor;
}

template <int dim>
void CellWise<dim>::solve(const DistributedVector &prescribed,
                          DistributedVector &momentum,
                          DistributedVector &mass,
                          DistributedVector &velocity,
                          DistributedVector &pressure,
                          StepReport &report)
{
  system.set_prescribed(prescribed, momentum);
  cell_solve->solve(momentum, mass, velocity, pressure, report);
}

template <int dim>
bool CellWise<dim>::is_nonlinear_in(const unsigned int region) const
{
  return is_nonlinear() && problem.materials[region].phase() < 1.;
}

template <int dim>
bool CellWise<dim>::linearise(const BalancedStep &state)
{
  using AddEntry = typename CellSystem<dim>::AddEntry;
  system.set_tangent([&](const AddEntry &momentum_row, const AddEntry &mass_row)
                     { convection.add_derivative(state, momentum_row, mass_row); });
  cell_solve->reinit();
  system.set_tangent({});
  return true;
}

template <int dim>
void CellWise<dim>::restrict_residuals(DistributedVector &momentum, DistributedVector &mass) const
{
  conditions.clear_prescribed(momentum);
  for (const unsigned int row : closure.rows)
    mass.begin()[row] = 0.;
}

template <int dim>
ResidualScales CellWise<dim>::residual_scales(const DistributedVector &velocity,
                                              const DistributedVector &pressure) const
{
  // A face's balance of tractions makes round-off of the pressure one of the face's velocity.
  const double pressure_size = pressure.linfty_norm();
  return {gradient_norm * pressure_size,
          divergence_norm * (velocity.linfty_norm() + pressure_size / face_resistance)};
}

template <int dim>
void CellWise<dim>::set_prescribed(const DistributedVector &prescribed,
                                   DistributedVector &velocity) const
{
  conditions.set_prescribed(prescribed, velocity);
}

template <int dim>
std::string CellWise<dim>::place_of_largest(const DistributedVector &momentum,
                                            const DistributedVector &mass,
                                            const bool of_momentum) const
{
  return place_of_largest_row(space, of_momentum ? momentum : mass, of_momentum, problem.regions);
}

template <int dim>
DistributedVector CellWise<dim>::flow_profile(const unsigned int condition) const
{
  DistributedVector profile = space.velocity_vector();
  for (const auto &face : conditions.faces())
    if (face.condition == condition)
      for (unsigned int c = 0; c < dim; ++c)
        profile.begin()[face.index + c] =
            face.flow_shapes.front() * space.mesh.faces()[face.face].normal[c];
  return profile;
}

template <int dim>
void CellWise<dim>::add_divergence(const DistributedVector &velocity, DistributedVector &result)
{
  for (const CellOperators &of_region : operators)
  {
    multiply(of_region.divergence, pressure_work, velocity);
    result.add(1., pressure_work);
  }
}

template <int dim>
void CellWise<dim>::set_reaction(const DistributedVector &profile,
                                 DistributedVector &of_velocity,
                                 DistributedVector &of_pressure,
                                 DistributedVector &momentum,
                                 DistributedVector &mass)
{
  momentum = 0.;
  mass = 0.;
  eliminate_prescribed(profile, momentum, mass);
  of_velocity = 0.;
  system.add_transposed_velocity_product(profile, of_velocity);
  of_pressure = 0.;
  for (unsigned int region = 0; region < operators.size() && parameters.has_pressure(); ++region)
  {
    multiply_transposed(operators[region].gradient, pressure_work, profile);
    of_pressure.add(-1., pressure_work);
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
  // The flux corrections of the new mesh belong to the next step's equations.
  dilatation_rate_is_current = false;
}

template <int dim>
SolverSizes CellWise<dim>::sizes() const
{
  SolverSizes sizes;
  sizes.n_cells = space.mesh.triangulation.n_global_active_cells();
  sizes.n_dofs[solves_for_displacement() ? "displacement" : "velocity"] =
      dim * space.velocities.n_values();
  if (parameters.has_pressure())
    sizes.n_dofs["pressure"] = space.pressures.n_values();
  sizes.factor_entries = cell_solve->factor_entries();
  sizes.factor_memory = cell_solve->factor_memory();
  sizes.linear_solver = cell_solve->name();
  return sizes;
}

template <int dim>
void CellWise<dim>::visit(StateVisitor &visitor)
{
  if (solves_for_displacement())
    displacement_levels.visit(visitor);
  visitor.vector("rate of dilatation", StateKind::pressure, dilatation_rate);
  visitor.value("rate of dilatation is current", dilatation_rate_is_current);
  if (excess_velocity.exists())
    excess_velocity.visit(visitor);
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
  // On the way to rest nothing depends on how the mesh came to its place.
  if (step.is_towards_rest)
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
  conditions_have_turned =
      Utilities::MPI::max(have_turned, space.communicator) == 1 || conditions_have_turned;
  assemble_cell_operators(space, problem, conditions, parameters, is_liquid, operators, closure);
  load_list.build();
  system.remeasure();
  loaded_faces.reinit();
  evaluation.take_shapes();
  excess_velocity.reinit();
  convection.reinit();
  measure_operators();
}

template <int dim>
void CellWise<dim>::start_from(const State &state)
{
  if (vertex_motion)
  {
    vertex_motion->start_from(state);
    take_shapes();
  }
  set_dilatation_rate(state);
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
Step CellWise<dim>::own_step(const Step &step)
{
  end_of_step = step.time;
  present_step = step;
  if (solves_for_displacement())
    return step;
  if (step.extrapolate && !undamped_is_reported)
    log.warning("crank-nicolson damps nothing, and the cell-wise operator is not symmetric beside "
                "boundaries: a few of its highest modes may grow in a long run");
  undamped_is_reported = undamped_is_reported || step.extrapolate;
  Step result = step;
  if (parameters.pressure_update == PressureUpdate::as_displacement || step.extrapolate ||
      step.is_towards_rest)
    return result;
  const bool trapezoidal = parameters.pressure_update == PressureUpdate::trapezoidal;
  result.pressure_time = (trapezoidal ? 0.5 : 1.) * step.size();
  result.pressure_old = 1.;
  result.pressure_older = 0.;
  result.divergence_old = trapezoidal;
  return result;
}

template <int dim>
void CellWise<dim>::finish_step(const BalancedStep &balanced, const State &state)
{
  if (excess_velocity.exists())
    excess_velocity.advance(balanced.step, balanced.pressure);
  if (balanced.step.divergence_old && !solves_for_displacement())
    set_dilatation_rate(state);
  if (!vertex_motion)
    return;
  const std::string warning = vertex_motion->finish_step(balanced.step.time);
  if (!warning.empty())
    log.warning(warning);
}

template <int dim>
void CellWise<dim>::set_dilatation_rate(const State &state)
{
  dilatation_rate = 0.;
  for (const CellOperators &of_region : operators)
  {
    multiply(of_region.divergence, pressure_work, state.velocity);
    dilatation_rate.add(1., pressure_work);
  }
  // What Rhie and Chow's correction of a pressure lets through a face has flowed.
  system.add_pressure_correction(-1., state.pressure, dilatation_rate);
  if (excess_velocity.exists())
    excess_velocity.add_outflow(state.pressure, dilatation_rate);
  dilatation_rate_is_current = true;
}

template <int dim>
void CellWise<dim>::multiply_past_stiffness(const unsigned int region,
                                            DistributedVector &force,
                                            const DistributedVector &mixture)
{
  multiply(parameters.accumulated_term == AccumulatedTerm::inconsistent
               ? operators[region].wide_stiffness
               : operators[region].stiffness,
           force, mixture);
}

template <int dim>
void CellWise<dim>::set_past_dilatation(const unsigned int region,
                                        const State &start,
                                        DistributedVector &rate)
{
  if (!dilatation_rate_is_current)
    set_dilatation_rate(start);
  const double *const volume = operators[region].pressure_volume.begin();
  for (unsigned int i = 0; i < rate.locally_owned_size(); ++i)
    rate.begin()[i] = volume[i] != 0. ? dilatation_rate.begin()[i] : 0.;
}

template <int dim>
void CellWise<dim>::add_past_flux_correction(const DistributedVector &pressure,
                                             DistributedVector &mass)
{
  system.add_increment_correction(-1., pressure, mass);
  if (excess_velocity.exists())
    excess_velocity.add_past(present_step, mass);
}

template <int dim>
bool CellWise<dim>::has_massless_velocities() const
{
  return !solves_for_displacement() && loaded_faces.exist();
}

template <int dim>
bool CellWise<dim>::deform_at_once(DistributedVector &forces,
                                   DistributedVector &displacement,
                                   DistributedVector &pressure)
{
  for (unsigned int i = 0; i < dim * space.mesh.n_owned_cells(); ++i)
    forces.begin()[i] = 0.;
  if (forces.linfty_norm() == 0.)
    return false;
  loaded_faces.respond(forces, displacement, pressure);
  if (!parameters.has_pressure())
    pressure = 0.;
  return true;
}

template <int dim>
void CellWise<dim>::complete_pressure(const DistributedVector &displacement,
                                      DistributedVector &pressure)
{
  if (!parameters.has_pressure())
    set_pressure_of_displacement(displacement, pressure);
}

template <int dim>
void CellWise<dim>::set_pressure_of_displacement(const DistributedVector &displacement,
                                                 DistributedVector &pressure)
{
  pressure = 0.;
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    const CellOperators &of_region = operators[region];
    multiply(of_region.divergence, pressure_work, displacement);
    for (unsigned int i = 0; i < pressure_work.locally_owned_size(); ++i)
      if (of_region.pressure_volume.begin()[i] != 0. &&
          !problem.materials[region].is_incompressible())
        pressure.begin()[i] -= pressure_work.begin()[i] / of_region.pressure_volume.begin()[i] /
                               problem.materials[region].inverse_bulk_modulus();
  }
  // Faces without an equation of state have the pressure of their cell, extrapolated.
  multiply(closure.matrix, pressure_work, pressure);
  for (const unsigned int i : closure.rows)
    pressure.begin()[i] -=
        pressure_work.begin()[i] / closure.matrix.diag_element(space.pressures.first_owned() + i);
}

template <int dim>
void CellWise<dim>::make_displacement_step(const Step &step,
                                           const DistributedVector &velocity,
                                           DistributedVector &displacement,
                                           BalancedStep &balanced,
                                           StepReport &report)
{
  if (!displacement_levels.is_started())
    displacement_levels.start(displacement, velocity, step.size());
  const auto derivatives = displacement_levels.derivatives(step, step.a2 != 0.);
  {
    SectionTimer::Scope scope(log.timer(), "factor");
    if (prepare_cells(displacement_step.coefficients(derivatives)) == SystemChange::factor)
      ++report.factors;
  }
  {
    SectionTimer::Scope scope(log.timer(), "right-hand side");
    displacement_step.set_right_side(step, displacement_levels, derivatives, balanced);
  }
  SectionTimer::Scope scope(log.timer(), "solve");
  displacement_step.solve(*cell_solve, derivatives, displacement, balanced, report);
  displacement_levels.advance(step, displacement);
}

template <int dim>
void CellWise<dim>::set_reported_stress_force(const unsigned int region,
                                              const BalancedStep &step,
                                              DistributedVector &mixture,
                                              DistributedVector &force)
{
  const CellOperators &of_region = operators[region];
  if (parameters.power_operator == PowerOperator::wide)
    multiply(of_region.wide_stiffness, force, mixture);
  else if (parameters.power_operator == PowerOperator::scheme &&
           parameters.accumulated_term == AccumulatedTerm::inconsistent)
  {
    // What the step has added to the mixture acts by the narrow stencil, the past by the wide one.
    const double own = BranchHistory::step_stiffness(problem.materials[region], step.step);
    mixture.add(-own, step.velocity);
    multiply(of_region.stiffness, force, step.velocity);
    force *= own;
    multiply(of_region.wide_stiffness, velocity_work, mixture);
    force.add(1., velocity_work);
  }
  else
    multiply(of_region.stiffness, force, mixture);
}

template <int dim>
bool CellWise<dim>::reports_change_of_kinetic_energy() const
{
  return parameters.power_operator != PowerOperator::scheme;
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
                                 const std::string &field,
                                 const std::vector<Expression> &exact,
                                 const double time)
{
  return evaluation.error_norm(state, field, exact, time);
}

template <int dim>
std::unique_ptr<VibrationOperator<dim>> CellWise<dim>::vibration(const VibratingState &state)
{
  SystemCoefficients at_rest;
  at_rest.set_steady(problem);
  return std::make_unique<CellVibration<dim>>(system, cell_coefficients(at_rest, 1.), state);
}

template class CellWise<2>;
template class CellWise<3>;
} // namespace Continua
