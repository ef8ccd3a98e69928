#include <continua/continuum/newton_residual.h>

#include <continua/continuum/branch_history.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Continua
{
namespace
{
/// Share of the state by which differences shift it. They are central: the error of terms of the
/// third degree is its square.
constexpr double difference = 1e-6;

/// Its largest entry; no number if one of them is none, over which a maximum may pass.
double largest_of(const DistributedVector &residual)
{
  return residual.linfty_norm() + 0. * residual.l1_norm();
}
} // namespace

NewtonResidual::NewtonResidual(const Problem &problem,
                               NonlinearSystem &terms,
                               LinearSystem &system,
                               const ProductsByRegion &products,
                               OutletCoupling &outlets)
    : problem(problem), terms(terms), system(system), products(products), outlets(outlets)
{
}

void NewtonResidual::reinit(const DistributedVector &zero_velocity,
                            const DistributedVector &zero_pressure)
{
  for (DistributedVector *vector : {&momentum, &past_acceleration, &momentum_work})
    vector->reinit(zero_velocity);
  for (DistributedVector *vector : {&mass, &mass_work, &volumes})
    vector->reinit(zero_pressure);
  DistributedVector one(mass);
  one = 1.;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    products.multiply_pressure_mass(region, mass_work, one);
    volumes.add(1., mass_work);
  }
  if (problem.convection.is_explicit())
  {
    for (DistributedVector *vector : {&first_velocity, &first_momentum, &velocity_from_start})
      vector->reinit(momentum);
    for (DistributedVector *vector : {&first_pressure, &first_mass, &pressure_from_start})
      vector->reinit(mass);
  }
  for (DistributedVector *vector : {&shifted.velocity, &shifted.acceleration})
    vector->reinit(momentum);
  for (DistributedVector *vector : {&shifted.pressure, &shifted.pressure_rate})
    vector->reinit(mass);
  if (problem.has_regions_of(RegionModel::finite_solid))
    shifted.displacement.reinit(momentum);
  if (problem.mesh_moves)
    for (DistributedVector *vector :
         {&shifted.mesh_displacement, &shifted.mesh_velocity, &mesh_change})
      vector->reinit(momentum);
}

void NewtonResidual::set_rates(const NewtonInput &input, StepSolution &solution) const
{
  solution.acceleration.equ(1., past_acceleration);
  solution.acceleration.add(input.step.a0, solution.velocity);
  const double factor = 1. / input.step.pressure_time;
  solution.pressure_rate.equ(factor, solution.pressure);
  solution.pressure_rate.add(-factor, input.predicted_pressure);
  if (problem.has_regions_of(RegionModel::finite_solid))
  {
    solution.displacement.equ(1., input.predicted_displacement);
    solution.displacement.add(BranchHistory::step_displacement(input.step), solution.velocity);
  }
  terms.move_mesh(solution);
  terms.check_mesh(solution);
}

void NewtonResidual::subtract_linear_terms(const SystemCoefficients &coefficients,
                                           const DistributedVector &velocity,
                                           const DistributedVector &pressure,
                                           DistributedVector &momentum_rows,
                                           DistributedVector &mass_rows,
                                           ResidualScales &scales)
{
  const auto subtract = [](const DistributedVector &term, DistributedVector &rows, double &scale)
  {
    scale = std::max(scale, term.linfty_norm());
    rows.add(-1., term);
  };
  momentum_work = 0.;
  system.add_velocity_product(velocity, momentum_work);
  subtract(momentum_work, momentum_rows, scales.momentum);
  mass_work = 0.;
  system.add_divergence(velocity, mass_work);
  subtract(mass_work, mass_rows, scales.mass);
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    if (!coefficients.has(region))
      continue;
    products.multiply_gradient(region, momentum_work, pressure);
    subtract(momentum_work, momentum_rows, scales.momentum);
    const double compressibility = coefficients.compressibility[region];
    if (compressibility == 0.)
      continue;
    products.multiply_pressure_mass(region, mass_work, pressure);
    mass_work *= compressibility;
    subtract(mass_work, mass_rows, scales.mass);
  }
}

void NewtonResidual::set_explicit_terms(const StepSolution &solution)
{
  momentum_work = 0.;
  mass_work = 0.;
  if (!has_first)
  {
    terms.add(solution, momentum_work, mass_work);
    first_velocity.equ(1., solution.velocity);
    first_pressure.equ(1., solution.pressure);
    first_momentum.equ(1., momentum_work);
    first_mass.equ(1., mass_work);
    has_first = true;
    return;
  }
  velocity_from_start.equ(1., solution.velocity);
  velocity_from_start.add(-1., first_velocity);
  pressure_from_start.equ(1., solution.pressure);
  pressure_from_start.add(-1., first_pressure);
  terms.add_derivative_product(velocity_from_start, pressure_from_start, momentum_work, mass_work);
  momentum_work.add(1., first_momentum);
  mass_work.add(1., first_mass);
}

ResidualNorms
NewtonResidual::set(const NewtonInput &input, const StepSolution &solution, const bool is_explicit)
{
  ResidualScales largest{input.momentum.linfty_norm(), input.mass.linfty_norm()};
  momentum.equ(1., input.momentum);
  mass.equ(1., input.mass);
  subtract_linear_terms(input.coefficients, solution.velocity, solution.pressure, momentum, mass,
                        largest);
  // The inertia of a short step is a small difference of large terms, also within whole terms.
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    if (!input.coefficients.has(region))
    {
      products.multiply_mass(region, momentum_work, solution.velocity);
      largest.momentum =
          std::max(largest.momentum,
                   input.step.a0 * problem.materials[region].density * momentum_work.linfty_norm());
    }
  if (is_explicit)
    set_explicit_terms(solution);
  else
  {
    momentum_work = 0.;
    mass_work = 0.;
    terms.add(solution, momentum_work, mass_work);
  }
  system.add_flux_correction(solution.pressure, mass_work);
  largest.momentum = std::max(largest.momentum, momentum_work.linfty_norm());
  momentum.add(-1., momentum_work);
  largest.mass = std::max(largest.mass, mass_work.linfty_norm());
  mass.add(-1., mass_work);

  ResidualNorms norms;
  const ResidualScales scales = terms.residual_scales(solution.velocity, solution.pressure);
  norms.momentum_round_off = ResidualNorms::round_off * std::max(largest.momentum, scales.momentum);
  norms.mass_round_off = ResidualNorms::round_off * std::max(largest.mass, scales.mass);
  // On a mesh that stays each solve has the ports' forces anew.
  if (problem.mesh_moves)
    outlets.add_to_residual(1., momentum);
  momentum_work.equ(1., momentum);
  if (!problem.mesh_moves)
    outlets.add_forces(1., momentum_work);
  mass_work.equ(1., mass);
  restrict_rows(momentum_work, mass_work);
  norms.momentum = largest_of(momentum_work);
  norms.mass = largest_of(mass_work);
  return norms;
}

void NewtonResidual::add_differences(const StepSolution &solution,
                                     const DistributedVector &of_velocity,
                                     const DistributedVector &of_pressure,
                                     DistributedVector &momentum_rows,
                                     DistributedVector &mass_rows)
{
  // Velocity and pressure each change by no more than a small part of what they are, or of the
  // change itself: of a body at rest what they are may be round-off. Of a body in finite
  // deformation the velocity stands for the displacement, too, beside which it may be nothing.
  const auto share = [](const double change, const double value)
  { return change > 0. ? change / std::max(change, value) : 0.; };
  double velocity = solution.velocity.linfty_norm();
  if (problem.has_regions_of(RegionModel::finite_solid))
  {
    const DistributedVector &of_body = problem.mesh_moves && !solution.step.finds_unloaded_shape
                                           ? solution.mesh_displacement
                                           : solution.displacement;
    velocity =
        std::max(velocity, of_body.linfty_norm() / BranchHistory::step_displacement(solution.step));
  }
  const double largest =
      std::max(share(of_velocity.linfty_norm(), velocity),
               share(of_pressure.linfty_norm(), solution.pressure.linfty_norm()));
  if (largest == 0.)
    return;
  const double distance = difference / largest;
  shifted.step = solution.step;
  shifted.boundary_pressures = solution.boundary_pressures;
  if (problem.mesh_moves)
    terms.set_mesh_change(solution.step, of_velocity, mesh_change);
  for (const double sign : {1., -1.})
  {
    const auto shift = [&](DistributedVector &target, const DistributedVector &value,
                           const double factor, const DistributedVector &change)
    {
      target.equ(1., value);
      target.add(sign * distance * factor, change);
    };
    shift(shifted.velocity, solution.velocity, 1., of_velocity);
    shift(shifted.acceleration, solution.acceleration, solution.step.a0, of_velocity);
    shift(shifted.pressure, solution.pressure, 1., of_pressure);
    shift(shifted.pressure_rate, solution.pressure_rate, 1. / solution.step.pressure_time,
          of_pressure);
    if (problem.has_regions_of(RegionModel::finite_solid))
      shift(shifted.displacement, solution.displacement,
            BranchHistory::step_displacement(solution.step), of_velocity);
    if (problem.mesh_moves)
    {
      // The motion of the mesh is linear within a step.
      shift(shifted.mesh_displacement, solution.mesh_displacement, 1., mesh_change);
      shift(shifted.mesh_velocity, solution.mesh_velocity,
            1. / BranchHistory::step_displacement(solution.step), mesh_change);
    }
    momentum_work = 0.;
    mass_work = 0.;
    terms.add(shifted, momentum_work, mass_work);
    if (problem.mesh_moves)
    {
      outlets.measure(shifted);
      outlets.add_to_residual(-1., momentum_work);
    }
    momentum_rows.add(0.5 * sign / distance, momentum_work);
    mass_rows.add(0.5 * sign / distance, mass_work);
  }
  if (problem.mesh_moves)
    outlets.measure(solution);
}

void NewtonResidual::set_derivative_product(const NewtonInput &input,
                                            const StepSolution &solution,
                                            const DistributedVector &of_velocity,
                                            const DistributedVector &of_pressure,
                                            DistributedVector &momentum_rows,
                                            DistributedVector &mass_rows)
{
  momentum_rows = 0.;
  mass_rows = 0.;
  ResidualScales unused;
  subtract_linear_terms(input.coefficients, of_velocity, of_pressure, momentum_rows, mass_rows,
                        unused);
  momentum_rows *= -1.;
  mass_rows *= -1.;
  if (takes_differences())
    add_differences(solution, of_velocity, of_pressure, momentum_rows, mass_rows);
  else
  {
    momentum_work = 0.;
    mass_work = 0.;
    terms.add_derivative_product(of_velocity, of_pressure, momentum_work, mass_work);
    momentum_rows.add(1., momentum_work);
    mass_rows.add(1., mass_work);
  }
  restrict_rows(momentum_rows, mass_rows);
}

void NewtonResidual::restrict_rows(DistributedVector &momentum_rows,
                                   DistributedVector &mass_rows) const
{
  if (!problem.mesh_moves || outlets.is_empty())
  {
    system.restrict_residuals(momentum_rows, mass_rows);
    return;
  }
  const std::vector<double> of_ports = outlets.port_rows(momentum_rows);
  system.restrict_residuals(momentum_rows, mass_rows);
  outlets.set_port_rows(of_ports, momentum_rows);
}

bool NewtonResidual::takes_differences() const
{
  return problem.mesh_moves || problem.newton.tangent_products == TangentProducts::differences;
}

double NewtonResidual::lost_volume(const Step &step) const
{
  double largest = 0.;
  for (unsigned int i = 0; i < volumes.locally_owned_size(); ++i)
    if (volumes.begin()[i] > 0.) // a hanging node has none
      largest = std::max(largest, std::abs(mass_work.begin()[i]) / volumes.begin()[i]);
  return step.size() * dealii::Utilities::MPI::max(largest, problem.communicator);
}
} // namespace Continua
