#include <continua/finite_element/solvers/step_system.h>

#include <continua/linear_algebra/singular_matrix.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace Continua
{
using namespace dealii;

template <int dim>
StepSystem<dim>::StepSystem(const Space<dim> &space,
                            const std::vector<RegionOperators> &operators,
                            const BoundaryConstraints<dim> &constraints,
                            const LinearSolverParameters &parameters,
                            const SolverOutlook &outlook)
    : space(space),
      operators(operators),
      constraints(constraints),
      parameters(parameters),
      outlook(outlook),
      mixed_precision(BlockKrylov::Method::fgmres, most_single_precision_iterations + 1)
{
}

template <int dim>
void StepSystem<dim>::reinit()
{
  is_prepared = false;
  nearby = std::nullopt;
  kept_factors.clear();
  iterative_solver = nullptr;
  velocity_product = space.velocity_vector();
  pressure_product = space.pressure_vector();
  pressure_hanging.clear();
  for (const auto index : space.pressure_owned)
    if (space.pressure_hanging.is_constrained(index))
      pressure_hanging.push_back(space.pressure_owned.index_within_set(index));
}

template <int dim>
void StepSystem<dim>::make_work_space()
{
  for (DistributedVector *vector : {&velocity_residual, &velocity_correction, &zero_velocity})
    *vector = space.velocity_vector();
  for (DistributedVector *vector : {&pressure_residual, &pressure_correction})
    *vector = space.pressure_vector();
}

template <int dim>
SolverChoice StepSystem<dim>::choice() const
{
  SystemSize size =
      outlook.size.scaled_to(space.velocity_dofs.n_dofs() + space.pressure_dofs.n_dofs());
  size.dim = dim;
  return outlook.is_of_tangents ? choose_tangent_solver(parameters, size, outlook)
                                : choose_step_solver(parameters, size, outlook);
}

template <int dim>
bool StepSystem<dim>::has_negative_mass() const
{
  return std::any_of(coefficients.mass.begin(), coefficients.mass.end(),
                     [](const double mass) { return mass < 0.; });
}

template <int dim>
void StepSystem<dim>::choose()
{
  if (has_negative_mass())
  {
    if (parameters.type == LinearSolverType::iterative)
      throw RunError("the iterative solver does not apply to vibrations, whose matrix is "
                     "indefinite; use Linear solver/Type = direct");
    chosen = {StepSolver::direct, "the matrix of vibrations is indefinite"};
  }
  else
    chosen = choice();
}

template <int dim>
bool StepSystem<dim>::prepare(const SystemCoefficients &wanted)
{
  made_factor = false;
  if (is_prepared && coefficients == wanted)
    return false;
  coefficients = wanted;
  choose();
  if (chosen.solver == StepSolver::iterative)
    prepare_iterative(coefficients);
  else
  {
    const auto kept = std::find_if(kept_factors.begin(), kept_factors.end(),
                                   [this](const KeptFactor &candidate)
                                   {
                                     return candidate.coefficients == coefficients &&
                                            (candidate.single != nullptr) ==
                                                (chosen.solver == StepSolver::single_precision);
                                   });
    if (kept != kept_factors.end())
      kept_factors.splice(kept_factors.begin(), kept_factors, kept);
    else
    {
      factorize();
      if (memory_use != nullptr)
        memory_use->mark("factor");
      made_factor = true;
    }
  }
  is_prepared = true;
  return true;
}

template <int dim>
void StepSystem<dim>::prepare_iterative(const SystemCoefficients &of_preconditioner)
{
  if (!iterative_solver)
    iterative_solver = std::make_unique<IterativeStepSolver<dim>>(space, operators, constraints,
                                                                  parameters, memory_use);
  made_factor = iterative_solver->prepare(of_preconditioner);
  // Only at the start: a later mesh or time step may need what this one does not.
  if (!has_checked_blocks && parameters.fluid_block != FluidBlock::automatic &&
      !iterative_solver->has_fluid_block())
    throw RunError("Linear solver/Fluid block has no effect: every region is stiff at the first "
                   "time step, so that all velocities are in the stiff block. Remove the entry");
  has_checked_blocks = true;
}

template <int dim>
void StepSystem<dim>::prepare_nearby(const SystemCoefficients &wanted)
{
  made_factor = false;
  if (is_prepared && nearby == wanted)
    return;
  nearby = wanted;
  chosen = choice();
  make_work_space();
  prepare_iterative(wanted);
  is_prepared = true;
}

template <int dim>
bool StepSystem<dim>::take(const SystemCoefficients &wanted)
{
  if (coefficients == wanted)
    return false;
  coefficients = wanted;
  is_prepared = false;
  return true;
}

template <int dim>
void StepSystem<dim>::factorize(const bool pivots)
{
  // The oldest goes first: there may be no room for one more.
  while (kept_factors.size() >= parameters.kept_factors)
    kept_factors.pop_back();
  const bool is_shifted = has_negative_mass();
  const bool quasi_definite =
      !pivots && !is_shifted &&
      std::all_of(coefficients.compressibility.begin(), coefficients.compressibility.end(),
                  [](const double c) { return c > 0.; });
  // A shift needs pivots, which CHOLMOD has not; a case may ask for CHOLMOD where it solves without
  // a shift, and count modes with one.
  const DirectSolver library =
      pivots || (is_shifted && parameters.direct_solver == DirectSolver::cholmod)
          ? DirectSolver::mumps
          : parameters.direct_solver;
  make_work_space();
  packed.resize(space.velocity_owned.n_elements() + space.pressure_owned.n_elements());
  std::vector<int> owned;
  owned.reserve(packed.size());
  for (const auto index : space.velocity_owned)
    owned.push_back(index);
  for (const auto index : space.pressure_owned)
    owned.push_back(space.velocity_dofs.n_dofs() + index);
  SymmetricTriplets matrix = condensed_triplets(space, operators, constraints, coefficients);
  KeptFactor made;
  made.coefficients = coefficients;
  if (chosen.solver == StepSolver::single_precision)
  {
    auto single = std::make_unique<SinglePrecisionFactor>(quasi_definite, space.communicator);
    made.single = single.get();
    mixed_precision.reinit(velocity_product, pressure_product);
    made.factor = std::move(single);
  }
  else
    try
    {
      made.factor =
          make_symmetric_factor(library, quasi_definite, matrix.values.size(), space.communicator);
    }
    catch (const std::invalid_argument &error)
    {
      throw RunError(error.what());
    }
  made.factor->counts_pivots = counts_pivots;
  if (announce)
    made.factor->announce = [this, n = matrix.n](const FactorEstimate &estimate)
    { announce(n, estimate.memory); };
  // Who asks for CHOLMOD alone shall have it; UMFPACK has pivots, and so may a factor in single
  // precision.
  made.may_pivot = quasi_definite && chosen.solver == StepSolver::direct &&
                   (parameters.direct_solver == DirectSolver::automatic ||
                    parameters.direct_solver == DirectSolver::mumps);
  try
  {
    made.factor->factorize(std::move(matrix), owned);
  }
  catch (const SingularMatrix &error)
  {
    if (library == DirectSolver::cholmod)
      throw SingularMatrix(std::string(error.what()) +
                           " Linear solver/Direct solver = automatic takes pivots there");
    if (!made.may_pivot)
      throw;
    take_pivots(std::move(made.factor));
    return;
  }
  made.factor->announce = nullptr;
  kept_factors.push_front(std::move(made));
}

template <int dim>
void StepSystem<dim>::take_pivots(std::unique_ptr<SymmetricFactor> failed)
{
  if (announce_pivots)
    announce_pivots(failed->name());
  failed = nullptr; // there may be no room for both
  factorize(true);
  made_factor = true;
}

template <int dim>
const SymmetricFactor *StepSystem<dim>::factor() const
{
  if (!is_prepared)
    return nullptr;
  if (chosen.solver == StepSolver::iterative)
    return iterative_solver->factor();
  return kept_factors.empty() ? nullptr : kept_factors.front().factor.get();
}

template <int dim>
std::string StepSystem<dim>::name() const
{
  if (!is_prepared)
    return "";
  if (chosen.solver == StepSolver::iterative)
    return iterative_solver->name();
  return (chosen.solver == StepSolver::single_precision ? "FGMRES; " : "") + factor()->name();
}

template <int dim>
void StepSystem<dim>::free_work_space()
{
  if (iterative_solver)
    iterative_solver->free_basis();
}

template <int dim>
unsigned int StepSystem<dim>::take_iterations()
{
  return std::exchange(n_iterations, 0);
}

template <int dim>
void StepSystem<dim>::solve_packed(const DistributedVector &momentum,
                                   const DistributedVector &mass,
                                   DistributedVector &velocity,
                                   DistributedVector &pressure)
{
  const auto middle = std::copy(momentum.begin(), momentum.end(), packed.begin());
  std::copy(mass.begin(), mass.end(), middle);
  kept_factors.front().factor->solve(packed);
  std::copy(packed.begin(), middle, velocity.begin());
  std::copy(middle, packed.end(), pressure.begin());
}

template <int dim>
void StepSystem<dim>::solve_tangent(const SaddlePointSolver::Product &add_nonlinear_terms,
                                    const TangentTerms kind,
                                    const double tolerance,
                                    DistributedVector &momentum,
                                    DistributedVector &mass,
                                    DistributedVector &velocity,
                                    DistributedVector &pressure)
{
  for (const unsigned int index : pressure_hanging)
    mass.begin()[index] = 0.;
  const auto tangent_product = [&](const DistributedVector &of_velocity,
                                   const DistributedVector &of_pressure,
                                   DistributedVector &momentum_rows, DistributedVector &mass_rows)
  {
    multiply_system(of_velocity, of_pressure, momentum_rows, mass_rows);
    add_nonlinear_terms(of_velocity, of_pressure, momentum_rows, mass_rows);
  };
  n_iterations += iterative_solver->solve_tangent(tangent_product, kind, tolerance, momentum, mass,
                                                  velocity, pressure);
}

template <int dim>
void StepSystem<dim>::multiply_system(const DistributedVector &velocity,
                                      const DistributedVector &pressure,
                                      DistributedVector &momentum,
                                      DistributedVector &mass)
{
  // velocity is zero at constrained dofs; T u puts the masters' share there.
  velocity_correction.equ(1., velocity);
  constraints.set_constrained(velocity_correction, zero_velocity);
  momentum = 0.;
  add_velocity_product(velocity_correction, momentum);
  add_gradient(-1., pressure, momentum);
  constraints.restrict_to_free(momentum);
  mass = 0.;
  add_divergence(1., velocity_correction, mass);
  add_compression(pressure, mass);
  mass *= -1.;
  for (const unsigned int index : pressure_hanging)
    mass.begin()[index] = 0.;
}

template <int dim>
void StepSystem<dim>::solve_in_mixed_precision(const DistributedVector &momentum,
                                               const DistributedVector &mass,
                                               DistributedVector &velocity,
                                               DistributedVector &pressure)
{
  // With the factor's scale velocities and pressures have one unit.
  const std::vector<double> &scale = kept_factors.front().single->scale();
  const auto middle = scale.begin() + velocity.locally_owned_size();
  std::copy(scale.begin(), middle, mixed_precision.scale.block(0).begin());
  std::copy(middle, scale.end(), mixed_precision.scale.block(1).begin());
  mixed_precision.set_right_hand_side(momentum, mass);
  const KrylovReport report = mixed_precision.solve(
      [this](const DistributedVector &u, const DistributedVector &p, DistributedVector &rows_of_u,
             DistributedVector &rows_of_p) { multiply_system(u, p, rows_of_u, rows_of_p); },
      [&](DistributedVector &rows_of_u, DistributedVector &rows_of_p, DistributedVector &u,
          DistributedVector &p)
      {
        auto of_row = scale.begin();
        for (DistributedVector *rows : {&rows_of_u, &rows_of_p})
          for (double &row : *rows)
            row /= *of_row++;
        solve_packed(rows_of_u, rows_of_p, u, p);
      },
      mixed_precision.scaled_right_hand_side().l2_norm(), single_precision_tolerance,
      most_single_precision_iterations, velocity, pressure);
  n_iterations += report.iterations;
  if (report.converged)
    return;
  std::ostringstream text;
  text << "the factor in single precision is too poor: after " << report.iterations
       << " iterations the residual is " << report.residual
       << " of the right-hand side, and it has to be " << single_precision_tolerance
       << ". Use Linear solver/Factor precision = double, or Type = iterative";
  throw RunError(text.str());
}

template <int dim>
double StepSystem<dim>::residual(const DistributedVector &momentum,
                                 const DistributedVector &mass,
                                 const DistributedVector &velocity,
                                 const DistributedVector &pressure)
{
  // velocity is zero at constrained dofs; T u puts the masters' share there.
  velocity_correction.equ(1., velocity);
  pressure_correction = 0.;
  constraints.set_constrained(velocity_correction, zero_velocity);
  velocity_residual = 0.;
  add_velocity_product(velocity_correction, velocity_residual);
  // What round-off leaves is relative to the terms that cancel. Those within B U and B^T p count:
  // in a motion without change of volume B U itself is nothing but round-off.
  double divergence_size = 0., gradient_size = 0.;
  for (const RegionOperators &region : operators)
  {
    divergence_size += region.divergence.linfty_norm() * velocity_correction.linfty_norm();
    gradient_size += region.divergence.l1_norm() * pressure.linfty_norm();
  }
  const double momentum_scale =
      std::max({momentum.linfty_norm(), velocity_residual.linfty_norm(), gradient_size});
  add_gradient(-1., pressure, velocity_residual);
  constraints.restrict_to_free(velocity_residual);
  velocity_residual.sadd(-1., 1., momentum);
  pressure_residual = 0.;
  add_divergence(1., velocity_correction, pressure_residual);
  const double mass_scale = std::max(mass.linfty_norm(), divergence_size);
  add_compression(pressure, pressure_residual);
  pressure_residual.add(1., mass);
  for (const unsigned int index : pressure_hanging)
    pressure_residual.begin()[index] = 0.;
  // Both halves of the system are in units of their own.
  double relative = momentum_scale > 0. ? velocity_residual.linfty_norm() / momentum_scale : 0.;
  if (mass_scale > 0.)
    relative = std::max(relative, pressure_residual.linfty_norm() / mass_scale);
  return relative;
}

template <int dim>
void StepSystem<dim>::solve(DistributedVector &momentum,
                            DistributedVector &mass,
                            DistributedVector &velocity,
                            DistributedVector &pressure)
{
  for (const unsigned int index : pressure_hanging)
    mass.begin()[index] = 0.;
  if (chosen.solver == StepSolver::iterative)
  {
    n_iterations += iterative_solver->solve(momentum, mass, velocity, pressure);
    return;
  }
  if (chosen.solver == StepSolver::single_precision)
  {
    solve_in_mixed_precision(momentum, mass, velocity, pressure);
    return;
  }
  solve_packed(momentum, mass, velocity, pressure);
  const unsigned int n_refinements =
      std::max(parameters.refinement_steps, coefficients.finds_steady_state ? 1u : 0u);
  for (unsigned int step = 0; step < n_refinements; ++step)
  {
    residual(momentum, mass, velocity, pressure);
    solve_packed(velocity_residual, pressure_residual, velocity_correction, pressure_correction);
    velocity.add(1., velocity_correction);
    pressure.add(1., pressure_correction);
  }
  if (!kept_factors.front().residual_is_checked)
  {
    const double relative = residual(momentum, mass, velocity, pressure);
    if (!(relative < 1e-8))
    {
      // One step of refinement tells a badly scaled right-hand side from a bad factor.
      solve_packed(velocity_residual, pressure_residual, velocity_correction, pressure_correction);
      velocity.add(1., velocity_correction);
      pressure.add(1., pressure_correction);
      const double refined = residual(momentum, mass, velocity, pressure);
      if (!(refined < 1e-6) && kept_factors.front().may_pivot)
      {
        std::unique_ptr<SymmetricFactor> failed = std::move(kept_factors.front().factor);
        kept_factors.pop_front();
        take_pivots(std::move(failed));
        solve(momentum, mass, velocity, pressure);
        return;
      }
      if (!(refined < 1e-6))
      {
        std::ostringstream text;
        text << "the direct solver " << factor()->name() << " left a relative residual of "
             << relative << " (" << refined << " after a step of refinement); "
             << (parameters.direct_solver == DirectSolver::cholmod
                     ? "Linear solver/Direct solver = automatic takes pivots there"
                     : "Linear solver/Direct solver = umfpack, on one rank, may do better");
        throw RunError(text.str());
      }
    }
    kept_factors.front().residual_is_checked = true;
  }
}

template <int dim>
void StepSystem<dim>::add_velocity_product(const DistributedVector &velocity,
                                           DistributedVector &result)
{
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    if (operators[region].products && coefficients.has(region))
    {
      operators[region].products->multiply(region, coefficients.mass[region],
                                           coefficients.stiffness[region], velocity_product,
                                           velocity);
      result.add(1., velocity_product);
    }
    if (!operators[region].products && coefficients.mass[region] != 0.)
    {
      operators[region].multiply_mass(velocity_product, velocity);
      result.add(coefficients.mass[region], velocity_product);
    }
    if (!operators[region].products && coefficients.stiffness[region] != 0.)
    {
      operators[region].multiply_stiffness(velocity_product, velocity);
      result.add(coefficients.stiffness[region], velocity_product);
    }
    if (operators[region].is_supported && coefficients.support_stiffness != 0.)
    {
      multiply(operators[region].support_stiffness, velocity_product, velocity);
      result.add(coefficients.support_stiffness, velocity_product);
    }
    if (operators[region].is_supported && coefficients.support_damping != 0.)
    {
      multiply(operators[region].support_damping, velocity_product, velocity);
      result.add(coefficients.support_damping, velocity_product);
    }
  }
}

template <int dim>
void StepSystem<dim>::add_divergence(const double factor,
                                     const DistributedVector &velocity,
                                     DistributedVector &result)
{
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (coefficients.has(region))
    {
      multiply(operators[region].divergence, pressure_product, velocity);
      result.add(factor, pressure_product);
    }
}

template <int dim>
void StepSystem<dim>::add_gradient(const double factor,
                                   const DistributedVector &pressure,
                                   DistributedVector &result)
{
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (coefficients.has(region))
    {
      multiply_transposed(operators[region].divergence, velocity_product, pressure);
      result.add(factor, velocity_product);
    }
}

template <int dim>
void StepSystem<dim>::add_compression(const DistributedVector &pressure, DistributedVector &result)
{
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (coefficients.compressibility[region] != 0.)
    {
      multiply(operators[region].pressure_mass, pressure_product, pressure);
      result.add(coefficients.compressibility[region], pressure_product);
    }
}

template class StepSystem<2>;
template class StepSystem<3>;
} // namespace Continua
