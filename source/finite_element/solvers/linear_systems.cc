#include <continua/finite_element/solvers/linear_systems.h>

#include <continua/base/memory_limit.h>
#include <continua/continuum/system_coefficients.h>

#include <algorithm>
#include <iomanip>
#include <optional>
#include <sstream>
#include <utility>

namespace Continua
{
namespace
{
/// A factor of this size takes some ten seconds [bytes].
constexpr double least_announced_factor = 0.5e9;
} // namespace

template <int dim>
LinearSystems<dim>::LinearSystems(const Space<dim> &space,
                                  const Problem &problem,
                                  const std::vector<RegionOperators> &operators,
                                  const BoundaryConstraints<dim> &constraints,
                                  RegionTerms<dim> &terms,
                                  const LinearSolverParameters &parameters,
                                  const SolverOutlook &outlook,
                                  Log &log)
    : space(space),
      problem(problem),
      constraints(constraints),
      terms(terms),
      parameters(parameters),
      log(log),
      system(space, operators, constraints, parameters, outlook),
      tangent(space, operators, constraints, parameters.direct_solver)
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
  // A search for a steady state makes many factors; the first one that fails stands for all.
  system.announce_pivots = [&log, is_said = false](const std::string &name) mutable
  {
    if (!std::exchange(is_said, true))
      log.note("The factor without pivots has lost its digits (" + name +
               "): MUMPS with pivots takes its place, and that of each later one that loses them");
  };
  system.memory_use = &log.memory_use();
}

template <int dim>
bool LinearSystems<dim>::has_iterative_tangent() const
{
  return !terms.empty() && system.choice().solver == StepSolver::iterative;
}

template <int dim>
bool LinearSystems<dim>::has_products_without_matrix() const
{
  return parameters.is_matrix_free(space.degree()) &&
         (terms.empty() ? system.choice().solver != StepSolver::direct : has_iterative_tangent());
}

template <int dim>
void LinearSystems<dim>::forget_derivative()
{
  terms.forget_derivative();
  derivative_is_marked = false;
}

template <int dim>
void LinearSystems<dim>::reinit()
{
  system.reinit();
  tangent.reinit();
  velocity_work = space.velocity_vector();
  if (has_iterative_tangent())
  {
    for (DistributedVector *vector : {&tangent_change, &tangent_momentum})
      *vector = space.velocity_vector();
    tangent_mass = space.pressure_vector();
  }
}

template <int dim>
SystemChange LinearSystems<dim>::prepare(const SystemCoefficients &coefficients,
                                         double /*pressure_time*/)
{
  if (!terms.empty())
    return system.take(coefficients) ? SystemChange::coefficients : SystemChange::none;
  if (!system.prepare(coefficients))
    return SystemChange::none;
  report_linear_solver();
  return system.has_new_factor() ? SystemChange::factor : SystemChange::coefficients;
}

template <int dim>
void LinearSystems<dim>::report_linear_solver()
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
void LinearSystems<dim>::eliminate_prescribed(const DistributedVector &prescribed,
                                              DistributedVector &momentum,
                                              DistributedVector &mass)
{
  velocity_work = 0.;
  system.add_velocity_product(prescribed, velocity_work);
  momentum.add(-1., velocity_work);
  system.add_divergence(-1., prescribed, mass);
}

template <int dim>
void LinearSystems<dim>::solve(const DistributedVector &prescribed,
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
    solve_iterative_tangent(momentum, mass, velocity, pressure);
  else if (!terms.empty())
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
void LinearSystems<dim>::solve_iterative_tangent(DistributedVector &momentum,
                                                 DistributedVector &mass,
                                                 DistributedVector &velocity,
                                                 DistributedVector &pressure)
{
  system.solve_tangent(
      [this](const DistributedVector &of_velocity, const DistributedVector &of_pressure,
             DistributedVector &momentum_rows, DistributedVector &mass_rows)
      {
        tangent_change.equ(1., of_velocity);
        constraints.clear_prescribed(tangent_change);
        tangent_momentum = 0.;
        tangent_mass = 0.;
        terms.add_derivative_product(tangent_change, of_pressure, tangent_momentum, tangent_mass);
        restrict_residuals(tangent_momentum, tangent_mass);
        momentum_rows.add(1., tangent_momentum);
        // The symmetric system has the negative of the mass equation.
        mass_rows.add(-1., tangent_mass);
      },
      problem.has_regions_of(RegionModel::finite_solid) ? TangentTerms::finite_deformation
                                                        : TangentTerms::convection,
      problem.newton.krylov_tolerance, momentum, mass, velocity, pressure);
}

template <int dim>
bool LinearSystems<dim>::linearise(const StepSolution &state)
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
  tangent.factorize(system.present_coefficients(), state, terms.of_models());
  log.memory_use().mark_again("factor");
  if (is_first)
    log.detail("Linear solver: direct, of the tangent, as " + system.choice().reason + "; " +
               tangent.factor()->name());
  return true;
}

template <int dim>
void LinearSystems<dim>::keep_derivative(const StepSolution &state)
{
  // Beside a factor the matrices of the cells are small.
  for (const auto &of_model : terms.of_models())
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
void LinearSystems<dim>::restrict_residuals(DistributedVector &momentum,
                                            DistributedVector &mass) const
{
  constraints.restrict_to_free(momentum);
  space.set_hanging_pressures_to_zero(mass);
}

template <int dim>
void LinearSystems<dim>::set_reaction(const DistributedVector &profile,
                                      DistributedVector &of_velocity,
                                      DistributedVector &of_pressure,
                                      DistributedVector &momentum,
                                      DistributedVector &mass)
{
  LinearSystem::set_reaction(profile, of_velocity, of_pressure, momentum, mass);
  terms.add_reaction(profile, of_velocity, of_pressure, momentum, mass);
}

template <int dim>
void LinearSystems<dim>::set_sizes(SolverSizes &sizes) const
{
  if (tangent.factor() != nullptr)
  {
    sizes.factor_entries = tangent.factor()->n_entries();
    sizes.factor_memory = tangent.factor()->memory();
    sizes.linear_solver = tangent.factor()->name();
    sizes.reason_of_linear_solver = system.choice().reason;
    return;
  }
  if (system.factor() != nullptr)
  {
    sizes.factor_entries = system.factor()->n_entries();
    sizes.factor_memory = system.factor()->memory();
  }
  sizes.linear_solver = system.name();
  sizes.reason_of_linear_solver = system.reason();
}

template class LinearSystems<2>;
template class LinearSystems<3>;
} // namespace Continua
