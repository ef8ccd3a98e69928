#include <continua/finite_volume/cell_wise_linear_system.h>

#include <continua/finite_volume/coupled_solve.h>
#include <continua/finite_volume/segregated_solve.h>
#include <continua/linear_algebra/matrix_product.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace Continua
{
using namespace dealii;

namespace
{
/// `end_of_step` [s] and `sink`: kept up to date by the discretisation.
template <int dim>
std::unique_ptr<CellWiseSolve<dim>>
make_solve(const CellWiseSystem<dim> &system,
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
} // namespace

template <int dim>
CellWiseLinearSystem<dim>::CellWiseLinearSystem(const Problem &problem,
                                                const CellWiseSpace<dim> &space,
                                                const std::vector<CellWiseOperators> &operators,
                                                const PressureClosure &closure,
                                                CellWiseSystem<dim> &system,
                                                Log &log)
    : problem(problem),
      space(space),
      operators(operators),
      closure(closure),
      system(system),
      log(log),
      solver(make_solve(system, end_of_step, correction_sink))
{
}

template <int dim>
CellWiseLinearSystem<dim>::~CellWiseLinearSystem() = default;

template <int dim>
void CellWiseLinearSystem<dim>::reinit()
{
  pressure_work = space.pressure_vector();
  smallest_distance = std::numeric_limits<double>::max();
  for (const VolumeFace<dim> &surface : space.mesh.faces())
    smallest_distance = std::min(smallest_distance, surface.distance * surface.normal);
  smallest_distance = Utilities::MPI::min(smallest_distance, space.communicator);
}

template <int dim>
CellWiseCoefficients
CellWiseLinearSystem<dim>::cell_coefficients(const SystemCoefficients &coefficients,
                                             const double pressure_time) const
{
  CellWiseCoefficients result;
  result.with_pressure = system.parameters.has_pressure();
  result.correct_fluxes = system.parameters.formulation == Formulation::velocity_pressure &&
                          system.parameters.rhie_chow != RhieChow::none;
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
        system.parameters.rhie_chow == RhieChow::increment && !material.shear.branches.empty();
    result.increment_mobility.push_back(
        of_increment ? 1. / (correction_modulus(material, system.parameters) * pressure_time) : 0.);
  }
  return result;
}

template <int dim>
SystemChange CellWiseLinearSystem<dim>::prepare(const SystemCoefficients &coefficients,
                                                const double pressure_time)
{
  return prepare_cells(cell_coefficients(coefficients, pressure_time));
}

template <int dim>
SystemChange CellWiseLinearSystem<dim>::prepare_cells(const CellWiseCoefficients &coefficients)
{
  if (!system.prepare(coefficients) && !conditions_have_turned)
    return SystemChange::none;
  conditions_have_turned = false;
  if (problem.convection.is_on)
    return SystemChange::coefficients;
  solver->reinit();
  log.memory_use().mark("factor");
  return SystemChange::factor;
}

template <int dim>
void CellWiseLinearSystem<dim>::solve(const DistributedVector &prescribed,
                                      DistributedVector &momentum,
                                      DistributedVector &mass,
                                      DistributedVector &velocity,
                                      DistributedVector &pressure,
                                      StepReport &report)
{
  system.set_prescribed(prescribed, momentum);
  solver->solve(momentum, mass, velocity, pressure, report);
}

template <int dim>
void CellWiseLinearSystem<dim>::add_divergence(const DistributedVector &velocity,
                                               DistributedVector &result)
{
  for (const CellWiseOperators &of_region : operators)
  {
    multiply(of_region.divergence, pressure_work, velocity);
    result.add(1., pressure_work);
  }
}

template <int dim>
void CellWiseLinearSystem<dim>::restrict_residuals(DistributedVector &momentum,
                                                   DistributedVector &mass) const
{
  system.conditions.clear_prescribed(momentum);
  for (const unsigned int row : closure.rows)
    mass.begin()[row] = 0.;
}

template <int dim>
void CellWiseLinearSystem<dim>::set_reaction(const DistributedVector &profile,
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
  for (unsigned int region = 0; region < operators.size() && system.parameters.has_pressure();
       ++region)
  {
    multiply_transposed(operators[region].gradient, pressure_work, profile);
    of_pressure.add(-1., pressure_work);
  }
}

template <int dim>
void CellWiseLinearSystem<dim>::linearise(CellWiseConvection<dim> &convection,
                                          const StepSolution &state)
{
  using AddEntry = typename CellWiseSystem<dim>::AddEntry;
  system.set_tangent([&](const AddEntry &momentum_row, const AddEntry &mass_row)
                     { convection.add_derivative(state, momentum_row, mass_row); });
  solver->reinit();
  system.set_tangent({});
}

template <int dim>
void CellWiseLinearSystem<dim>::set_sizes(SolverSizes &sizes) const
{
  sizes.factor_entries = solver->factor_entries();
  sizes.factor_memory = solver->factor_memory();
  sizes.linear_solver = solver->name();
}

template class CellWiseLinearSystem<2>;
template class CellWiseLinearSystem<3>;
} // namespace Continua
