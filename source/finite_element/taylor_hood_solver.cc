#include <continua/finite_element/taylor_hood_solver.h>

#include <continua/base/input_error.h>
#include <continua/finite_element/traction_jump.h>
#include <continua/finite_element/vector_archive.h>

#include <deal.II/distributed/tria.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/numerics/vector_tools.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
/// Expressions as a deal.II function, component by component.
template <int dim>
class ExpressionFunction : public Function<dim>
{
public:
  explicit ExpressionFunction(const std::vector<Expression> &components)
      : Function<dim>(components.size()), components(components)
  {
  }
  double value(const Point<dim> &point, const unsigned int component) const override
  {
    double coordinates[3] = {0., 0., 0.};
    for (unsigned int c = 0; c < dim; ++c)
      coordinates[c] = point[c];
    return components[component](coordinates, 0.);
  }

private:
  const std::vector<Expression> &components;
};
/// sum M_p / K on the pressures that it determines; the identity on the idle ones (incompressible,
/// or hanging).
template <int dim>
struct PressureCompressibility
{
  const Space<dim> &space;
  const Problem &problem;
  const std::vector<RegionOperators> &operators;
  DistributedVector diagonal;
  std::vector<unsigned int> idle; ///< local indices

  void reinit()
  {
    diagonal = space.pressure_vector();
    for (unsigned int i = 0; i < space.pressure_owned.n_elements(); ++i)
    {
      const auto global = space.pressure_owned.nth_index_in_set(i);
      double &entry = diagonal.begin()[i];
      for (unsigned int region = 0; region < operators.size(); ++region)
        entry += problem.materials[region].inverse_bulk_modulus *
                 operators[region].pressure_mass.diag_element(global);
      if (entry == 0. || space.pressure_hanging.is_constrained(global))
      {
        entry = 1.;
        idle.push_back(i);
      }
    }
  }
  void set_idle_to_zero(DistributedVector &vector) const
  {
    for (const unsigned int i : idle)
      vector.begin()[i] = 0.;
  }
  void vmult(DistributedVector &target, const DistributedVector &source) const
  {
    DistributedVector product(source);
    target = 0.;
    for (unsigned int region = 0; region < operators.size(); ++region)
      if (problem.materials[region].inverse_bulk_modulus > 0.)
      {
        operators[region].pressure_mass.vmult(product, source);
        target.add(problem.materials[region].inverse_bulk_modulus, product);
      }
    set_idle_to_zero(target);
  }
};

/// This rank's part of a scalar product.
double local_product(const DistributedVector &a, const DistributedVector &b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
}

struct DiagonalInverse
{
  const DistributedVector &diagonal;
  void vmult(DistributedVector &target, const DistributedVector &source) const
  {
    for (unsigned int i = 0; i < source.locally_owned_size(); ++i)
      target.begin()[i] = source.begin()[i] / diagonal.begin()[i];
  }
};
} // namespace

template <int dim>
TaylorHoodSolver<dim>::TaylorHoodSolver(parallel::TriangulationBase<dim> &triangulation,
                                        const Problem &problem,
                                        const TaylorHoodParameters &parameters,
                                        Log &log)
    : problem(problem),
      log(log),
      space(triangulation, parameters.space, problem.model, problem.regions.size()),
      operators(problem.regions.size()),
      constraints(space, problem.conditions),
      loads(space, problem),
      history(problem.materials),
      system(space, operators, constraints, parameters.linear_solver),
      evaluation(space, problem),
      output(space, problem, evaluation)
{
}

template <int dim>
void TaylorHoodSolver<dim>::initialise()
{
  setup();
  set_initial_state();
}

template <int dim>
void TaylorHoodSolver<dim>::setup()
{
  TimerOutput::Scope scope(log.timer(), "setup");
  space.distribute();
  assemble_region_operators(space, operators);
  constraints.build();
  for (const std::string &conflict : constraints.conflicts())
    log.warning(conflict);
  loads.build();
  history.reinit(space);
  system.reinit();
  for (DistributedVector *vector :
       {&velocity, &velocity_older, &velocity_balanced, &acceleration, &prescribed,
        &prescribed_balanced, &momentum, &velocity_work, &mixture})
    *vector = space.velocity_vector();
  for (DistributedVector *vector :
       {&pressure, &pressure_older, &pressure_balanced, &pressure_known, &mass, &pressure_work})
    *vector = space.pressure_vector();

  // A pressure that no compressible material touches follows from the constraint alone.
  DistributedVector compressible = space.pressure_vector();
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (problem.materials[region].inverse_bulk_modulus > 0.)
    {
      pressure_work = 1.;
      operators[region].pressure_mass.vmult(mass, pressure_work);
      compressible.add(1., mass);
    }
  incompressible_pressures.clear();
  for (unsigned int i = 0; i < space.pressure_owned.n_elements(); ++i)
    if (compressible.begin()[i] == 0.)
      incompressible_pressures.push_back(i);
  evaluation.rebuild();
}

template <int dim>
void TaylorHoodSolver<dim>::set_initial_state()
{
  const InteriorData &data = problem.interior;
  if (!data.initial_velocity.empty())
    VectorTools::interpolate(space.velocity_dofs, ExpressionFunction<dim>(data.initial_velocity),
                             velocity);
  if (!data.initial_displacement.empty())
    VectorTools::interpolate(space.velocity_dofs,
                             ExpressionFunction<dim>(data.initial_displacement),
                             history.displacement());
  if (!data.initial_pressure.empty())
  {
    std::vector<Expression> by_component = data.initial_pressure;
    by_component.resize(space.pressure_elements.n_components());
    VectorTools::interpolate(space.pressure_dofs, ExpressionFunction<dim>(by_component), pressure);
  }
  if (!data.initial_displacement.empty() && data.initial_pressure.empty())
  {
    set_consistent_pressure();
    log.line("Initial pressure: in equilibrium with the initial displacement");
  }
  else if (!data.initial_displacement.empty())
  {
    // What was given must obey p = -K div D, or the body starts with a shock that nobody asked for.
    const DistributedVector given = pressure;
    set_consistent_pressure();
    pressure_work = given;
    pressure_work.add(-1., pressure);
    const double scale = given.l2_norm();
    if (pressure_work.l2_norm() > 0.05 * scale)
    {
      std::ostringstream text;
      text << "the initial pressure is not that of the initial displacement (p = -K div D): they "
              "differ by "
           << 100. * pressure_work.l2_norm() / std::max(scale, 1e-300) << " %";
      log.warning(text.str());
    }
    pressure = given;
  }
  velocity_older = velocity;
  pressure_older = pressure;
  pressure_known = pressure;
}

template <int dim>
void TaylorHoodSolver<dim>::set_consistent_pressure()
{
  PressureCompressibility<dim> matrix{space, problem, operators, {}, {}};
  matrix.reinit();
  mass = 0.;
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    operators[region].divergence.vmult(pressure_work, history.displacement());
    mass.add(-1., pressure_work);
  }
  matrix.set_idle_to_zero(mass);
  pressure = 0.;
  SolverControl control(1000, 1e-14 * mass.l2_norm());
  SolverCG<DistributedVector> solver(control);
  solver.solve(matrix, pressure, mass, DiagonalInverse{matrix.diagonal});
}

template <int dim>
SystemCoefficients TaylorHoodSolver<dim>::coefficients(const Step &step) const
{
  SystemCoefficients result;
  for (const Material &material : problem.materials)
  {
    result.mass.push_back(step.a0 * material.density);
    result.stiffness.push_back(material.viscosity + history.step_stiffness(material, step));
    result.compressibility.push_back(material.inverse_bulk_modulus / step.pressure_time);
  }
  return result;
}

template <int dim>
void TaylorHoodSolver<dim>::report_exponential_branches(const Step &step)
{
  for (const double relaxation_time : history.exponential_branches(step))
    if (exponential_branches_reported.insert(relaxation_time).second)
    {
      std::ostringstream text;
      text << "The time step is longer than the relaxation time " << relaxation_time
           << " s: its branches take the exponential update";
      log.line(text.str());
    }
}

template <int dim>
StepReport TaylorHoodSolver<dim>::advance(const Step &step)
{
  StepReport report;
  {
    const SystemCoefficients wanted = coefficients(step);
    TimerOutput::Scope scope(log.timer(), "factor");
    report.factored = system.prepare(wanted);
  }
  if (report.factored)
    report_exponential_branches(step);
  {
    TimerOutput::Scope scope(log.timer(), "right-hand side");
    // Momentum: inertia of the past, force of the branches, loads.
    velocity_work.equ(-step.a1, velocity);
    if (step.a2 != 0.)
      velocity_work.add(-step.a2, velocity_older);
    acceleration.equ(-1., velocity_work);
    momentum = 0.;
    history.predict(step, velocity);
    for (unsigned int region = 0; region < operators.size(); ++region)
    {
      const Material &material = problem.materials[region];
      operators[region].mass.vmult(velocity_balanced, velocity_work);
      momentum.add(material.density, velocity_balanced);
      if (history.mix_balanced(material, mixture))
      {
        operators[region].stiffness.vmult(velocity_balanced, mixture);
        momentum.add(-1., velocity_balanced);
      }
    }
    loads.add(step.balance_time, momentum);

    // Mass: the pressure of the past.
    pressure_work.equ(step.pressure_old, pressure);
    if (step.pressure_older != 0.)
      pressure_work.add(step.pressure_older, pressure_older);
    mass = 0.;
    for (unsigned int region = 0; region < operators.size(); ++region)
    {
      const double compressibility =
          problem.materials[region].inverse_bulk_modulus / step.pressure_time;
      if (compressibility != 0.)
      {
        operators[region].pressure_mass.vmult(pressure_balanced, pressure_work);
        mass.add(-compressibility, pressure_balanced);
      }
    }
    if (step.divergence_old)
      system.add_divergence(1., velocity, mass);

    if (!constraints.is_homogeneous())
    {
      constraints.evaluate(step.extrapolate ? step.time : step.balance_time, prescribed);
      if (step.extrapolate)
      {
        // The end of the step has what is prescribed there, so its middle the mean of that and of
        // the start.
        constraints.prescribed_part(velocity, prescribed_balanced);
        prescribed_balanced.sadd(0.5, 0.5, prescribed);
      }
      else
        prescribed_balanced = prescribed;
      velocity_balanced = 0.;
      system.add_velocity_product(prescribed_balanced, velocity_balanced);
      momentum.add(-1., velocity_balanced);
      system.add_divergence(1., prescribed_balanced, mass);
    }
    constraints.restrict_to_free(momentum);
  }
  {
    TimerOutput::Scope scope(log.timer(), "solve");
    system.solve(momentum, mass, velocity_balanced, pressure_balanced);
    constraints.set_constrained(velocity_balanced, prescribed_balanced);
  }
  TimerOutput::Scope scope(log.timer(), "update");
  report.largest_velocity = velocity_balanced.linfty_norm();
  if (!std::isfinite(report.largest_velocity) || !std::isfinite(pressure_balanced.linfty_norm()))
  {
    std::ostringstream text;
    text << "the solution is not finite in the step to t = " << step.time << " s";
    throw RunError(text.str());
  }
  acceleration.add(step.a0, velocity_balanced);
  history.correct(step, velocity_balanced);
  history.finish(step);
  velocity_older.swap(velocity);
  pressure_older.swap(pressure);
  if (step.extrapolate)
  {
    velocity.equ(2., velocity_balanced);
    velocity.add(-1., velocity_older);
    pressure.equ(2., pressure_balanced);
    pressure.add(-1., pressure_older);
    extrapolate_pressure(step);
  }
  else
  {
    velocity = velocity_balanced;
    pressure = pressure_balanced;
  }
  if (!incompressible_pressures.empty())
  {
    pressure_known = pressure_balanced;
    pressure_known_time = step.balance_time;
  }
  present_time = step.time;
  last_step = step;
  velocity_work = velocity;
  velocity_work.add(-1., velocity_older);
  report.largest_change = velocity_work.linfty_norm();
  return report;
}

template <int dim>
void TaylorHoodSolver<dim>::extrapolate_pressure(const Step &step)
{
  // Where 1/K = 0 the pressure has no history: the balanced one belongs to the middle of the step,
  // and the line through the last two of them leads to its end.
  const double factor = (step.time - step.balance_time) / (step.balance_time - pressure_known_time);
  for (const unsigned int i : incompressible_pressures)
    pressure.begin()[i] = pressure_balanced.begin()[i] +
                          factor * (pressure_balanced.begin()[i] - pressure_known.begin()[i]);
}

template <int dim>
bool TaylorHoodSolver<dim>::steady_is_direct() const
{
  bool all_solid = true, all_fluid = true;
  for (const Material &material : problem.materials)
    (material.branches.empty() ? all_solid : all_fluid) = false;
  return all_solid || all_fluid;
}

template <int dim>
void TaylorHoodSolver<dim>::solve_steady(const double time)
{
  AssertThrow(steady_is_direct(), ExcInternalError());
  // A solid at rest: displacement for velocity, mu for alpha, 1/K for compressibility. A steady
  // fluid has no dp/dt, so its compressibility plays no part.
  const bool solid = !problem.materials.front().branches.empty();
  SystemCoefficients steady;
  for (const Material &material : problem.materials)
  {
    steady.mass.push_back(0.);
    steady.stiffness.push_back(solid ? material.long_term_shear_modulus() : material.viscosity);
    steady.compressibility.push_back(solid ? material.inverse_bulk_modulus : 0.);
  }
  {
    TimerOutput::Scope scope(log.timer(), "factor");
    system.prepare(steady);
  }
  momentum = 0.;
  mass = 0.;
  loads.add(time, momentum);
  prescribed_balanced = 0.;
  // A solid at rest has no velocity to prescribe: its supports hold.
  if (!solid && !constraints.is_homogeneous())
  {
    constraints.evaluate(time, prescribed);
    prescribed_balanced = prescribed;
    velocity_balanced = 0.;
    system.add_velocity_product(prescribed_balanced, velocity_balanced);
    momentum.add(-1., velocity_balanced);
    system.add_divergence(1., prescribed_balanced, mass);
  }
  constraints.restrict_to_free(momentum);
  {
    TimerOutput::Scope scope(log.timer(), "solve");
    system.solve(momentum, mass, velocity_work, pressure);
  }
  constraints.set_constrained(velocity_work, prescribed_balanced);
  if (!std::isfinite(velocity_work.linfty_norm()))
    throw RunError("the steady solution is not finite");
  (solid ? history.displacement() : velocity) = velocity_work;
  present_time = time;
}

template <int dim>
bool TaylorHoodSolver<dim>::data_jump(const double time, const double step_size) const
{
  return loads.jumps(time, step_size) || constraints.jumps(time, step_size);
}

template <int dim>
State<dim> TaylorHoodSolver<dim>::state() const
{
  return State<dim>{velocity, pressure, history};
}

template <int dim>
std::vector<FieldComponent> TaylorHoodSolver<dim>::fields() const
{
  return FieldEvaluation<dim>::fields();
}

template <int dim>
unsigned int TaylorHoodSolver<dim>::add_probe(const ProbeRequest<dim> &request)
{
  return evaluation.add(request);
}

template <int dim>
void TaylorHoodSolver<dim>::evaluate_probes(std::vector<double> &values)
{
  evaluation.evaluate(state(), values);
}

template <int dim>
PowerBalance TaylorHoodSolver<dim>::power_balance()
{
  PowerBalance balance;
  balance.time = last_step.balance_time;
  balance.materials.resize(operators.size());
  // Numbers of this rank; all are summed over the ranks at once.
  std::vector<double> sums;

  // What the equations leave at the nodes - inertia + inner forces - loads - is the force that
  // moves those of prescribed velocity; without such nodes nobody asks for it.
  const bool reactions = !constraints.is_homogeneous();
  momentum = 0.;
  loads.add(last_step.balance_time, momentum);
  sums.push_back(local_product(momentum, velocity_balanced));
  momentum *= -1.;
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    const Material &material = problem.materials[region];
    // The power of the nodal forces in velocity_work.
    const auto add_power = [&](const double factor)
    {
      sums.push_back(factor * local_product(velocity_work, velocity_balanced));
      if (reactions)
        momentum.add(factor, velocity_work);
    };
    operators[region].mass.vmult(velocity_work, acceleration);
    add_power(material.density);
    if (history.mix_balanced(material, mixture))
      operators[region].stiffness.vmult(velocity_work, mixture);
    else
      velocity_work = 0.;
    add_power(1.);
    if (material.viscosity != 0.)
      operators[region].stiffness.vmult(velocity_work, velocity_balanced);
    else
      velocity_work = 0.;
    add_power(material.viscosity);
    if (reactions)
    {
      operators[region].divergence.Tvmult(velocity_work, pressure_balanced);
      add_power(-1.);
    }
    else
    {
      operators[region].divergence.vmult(pressure_work, velocity_balanced);
      sums.push_back(-local_product(pressure_work, pressure_balanced));
    }
  }
  sums.push_back(reactions ? local_product(momentum, prescribed_balanced) : 0.);
  Utilities::MPI::sum(sums, space.communicator, sums);

  balance.external = sums.front() + sums.back();
  balance.residual = balance.external;
  balance.exchanged = std::abs(balance.external);
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    const double *const of_region = &sums[1 + 4 * region];
    balance.materials[region] = {of_region[0], of_region[1], of_region[2], of_region[3]};
    balance.residual -= balance.materials[region].sum();
    for (unsigned int i = 0; i < 4; ++i)
      balance.exchanged += std::abs(of_region[i]);
  }
  return balance;
}

template <int dim>
Energy TaylorHoodSolver<dim>::energy()
{
  std::vector<double> sums(3, 0.);
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    const Material &material = problem.materials[region];
    operators[region].mass.vmult(velocity_work, velocity);
    sums[0] += 0.5 * material.density * local_product(velocity_work, velocity);
    for (const Branch &branch : material.branches)
    {
      const DistributedVector &internal = history.internal_displacement(branch.relaxation_time);
      operators[region].stiffness.vmult(velocity_work, internal);
      sums[1] += 0.5 * branch.shear_modulus * local_product(velocity_work, internal);
    }
    operators[region].pressure_mass.vmult(pressure_work, pressure);
    sums[2] += 0.5 * material.inverse_bulk_modulus * local_product(pressure_work, pressure);
  }
  Utilities::MPI::sum(sums, space.communicator, sums);
  return {sums[0], sums[1], sums[2]};
}

template <int dim>
double TaylorHoodSolver<dim>::divergence()
{
  mass = 0.;
  system.add_divergence(1., velocity, mass);
  DistributedVector volume = space.pressure_vector(), one = volume;
  for (const auto index : space.pressure_owned)
    if (!space.pressure_hanging.is_constrained(index))
      one[index] = 1.;
  one.compress(VectorOperation::insert);
  for (const RegionOperators &region : operators)
  {
    region.pressure_mass.vmult(pressure_work, one);
    volume.add(1., pressure_work);
  }
  double largest = 0.;
  for (unsigned int i = 0; i < mass.locally_owned_size(); ++i)
    if (one.begin()[i] > 0.)
      largest = std::max(largest, std::abs(mass.begin()[i] / volume.begin()[i]));
  return Utilities::MPI::max(largest, space.communicator);
}

template <int dim>
std::map<std::string, std::string> TaylorHoodSolver<dim>::add_output(DataOut<dim> &data_out)
{
  return output.add(state(), data_out);
}

template <int dim>
void TaylorHoodSolver<dim>::indicators(Vector<float> &per_cell)
{
  traction_jump_indicators(space, problem, evaluation, state(), present_time, per_cell);
}

template <int dim>
std::vector<DistributedVector *> TaylorHoodSolver<dim>::velocity_vectors()
{
  std::vector<DistributedVector *> vectors = history.vectors();
  vectors.push_back(&velocity);
  vectors.push_back(&velocity_older);
  return vectors;
}

template <int dim>
std::vector<DistributedVector *> TaylorHoodSolver<dim>::pressure_vectors()
{
  return {&pressure, &pressure_older, &pressure_known};
}

template <int dim>
void TaylorHoodSolver<dim>::prepare_refinement()
{
  using Transfer = parallel::distributed::SolutionTransfer<dim, DistributedVector>;
  velocities_in_transfer.clear();
  pressures_in_transfer.clear();
  std::vector<const DistributedVector *> velocities, pressures;
  for (const DistributedVector *vector : velocity_vectors())
    velocities_in_transfer.push_back(space.ghosted_velocity(*vector));
  for (const DistributedVector *vector : pressure_vectors())
    pressures_in_transfer.push_back(space.ghosted_pressure(*vector));
  for (const DistributedVector &vector : velocities_in_transfer)
    velocities.push_back(&vector);
  for (const DistributedVector &vector : pressures_in_transfer)
    pressures.push_back(&vector);
  velocity_transfer = std::make_unique<Transfer>(space.velocity_dofs);
  pressure_transfer = std::make_unique<Transfer>(space.pressure_dofs);
  velocity_transfer->prepare_for_coarsening_and_refinement(velocities);
  pressure_transfer->prepare_for_coarsening_and_refinement(pressures);
}

template <int dim>
void TaylorHoodSolver<dim>::transfer()
{
  setup();
  std::vector<DistributedVector> velocities(velocities_in_transfer.size(), space.velocity_vector());
  std::vector<DistributedVector> pressures(pressures_in_transfer.size(), space.pressure_vector());
  std::vector<DistributedVector *> velocity_pointers, pressure_pointers;
  for (DistributedVector &vector : velocities)
    velocity_pointers.push_back(&vector);
  for (DistributedVector &vector : pressures)
    pressure_pointers.push_back(&vector);
  velocity_transfer->interpolate(velocity_pointers);
  pressure_transfer->interpolate(pressure_pointers);
  velocity_transfer.reset();
  pressure_transfer.reset();
  velocities_in_transfer.clear();
  pressures_in_transfer.clear();
  const auto targets = velocity_vectors();
  for (unsigned int i = 0; i < targets.size(); ++i)
    *targets[i] = velocities[i];
  const auto pressure_targets = pressure_vectors();
  for (unsigned int i = 0; i < pressure_targets.size(); ++i)
    *pressure_targets[i] = pressures[i];
}

template <int dim>
void TaylorHoodSolver<dim>::save(ArchiveWriter &archive) const
{
  archive.add("present time", present_time);
  archive.add("time of the known pressure", pressure_known_time);
  save_vector(archive, "velocity", velocity);
  save_vector(archive, "velocity older", velocity_older);
  save_vector(archive, "pressure", pressure);
  save_vector(archive, "pressure older", pressure_older);
  save_vector(archive, "pressure known", pressure_known);
  history.save(archive);
}

template <int dim>
void TaylorHoodSolver<dim>::load(const ArchiveReader &archive)
{
  present_time = archive.value("present time");
  pressure_known_time = archive.value("time of the known pressure");
  load_vector(archive, "velocity", velocity);
  load_vector(archive, "velocity older", velocity_older);
  load_vector(archive, "pressure", pressure);
  load_vector(archive, "pressure older", pressure_older);
  load_vector(archive, "pressure known", pressure_known);
  history.load(archive);
}

template <int dim>
double TaylorHoodSolver<dim>::error_norm(const std::string &field,
                                         const std::vector<Expression> &exact,
                                         const double time)
{
  return evaluation.error_norm(state(), field, exact, time);
}

template <int dim>
SolverSizes TaylorHoodSolver<dim>::sizes() const
{
  SolverSizes sizes;
  sizes.n_cells = space.triangulation.n_global_active_cells();
  sizes.n_dofs["velocity"] = space.velocity_dofs.n_dofs();
  sizes.n_dofs["pressure"] = space.pressure_dofs.n_dofs();
  if (system.factor() != nullptr)
  {
    sizes.factor_entries = system.factor()->n_entries();
    sizes.factor_memory = system.factor()->memory();
    sizes.linear_solver = system.factor()->name();
  }
  return sizes;
}

template class TaylorHoodSolver<2>;
template class TaylorHoodSolver<3>;
} // namespace Continua
