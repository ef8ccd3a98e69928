#include <continua/finite_volume/coupled_solve.h>

#include <continua/base/input_error.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
using namespace dealii;

template <int dim>
CoupledSolve<dim>::CoupledSolve(const CellWiseSystem<dim> &system) : system(system)
{
}

template <int dim>
void CoupledSolve<dim>::reinit()
{
  const CellWiseSpace<dim> &space = system.space;
  const bool with_pressure = system.coefficients().with_pressure;
  Triplets matrix;
  matrix.n = system.n_velocities() + (with_pressure ? space.pressures.n_values() : 0);
  system.for_entries(
      [&](const int row, const int column, const double value)
      {
        matrix.rows.push_back(row);
        matrix.columns.push_back(column);
        matrix.values.push_back(value);
      });
  std::vector<int> owned;
  for (unsigned int i = 0; i < dim * space.velocities.n_owned(); ++i)
    owned.push_back(dim * space.velocities.first_owned() + i);
  if (with_pressure)
    for (unsigned int i = 0; i < space.pressures.n_owned(); ++i)
      owned.push_back(system.n_velocities() + space.pressures.first_owned() + i);
  packed.resize(owned.size());
  factor = make_unsymmetric_factor(DirectSolver::automatic, space.communicator);
  factor->factorize(matrix, owned);
  // The iteration that asks for a tangent looks at what is left of its own equations.
  is_checked = system.has_tangent();
}

template <int dim>
void CoupledSolve<dim>::solve(const DistributedVector &momentum,
                              const DistributedVector &mass,
                              DistributedVector &velocity,
                              DistributedVector &pressure,
                              StepReport &)
{
  const bool with_pressure = system.coefficients().with_pressure;
  const auto middle = std::copy(momentum.begin(), momentum.end(), packed.begin());
  if (with_pressure)
    std::copy(mass.begin(), mass.end(), middle);
  factor->solve(packed);
  std::copy(packed.begin(), middle, velocity.begin());
  if (with_pressure)
    std::copy(middle, packed.end(), pressure.begin());
  if (!is_checked)
    check_solution(momentum, mass, velocity, pressure);
}

template <int dim>
void CoupledSolve<dim>::check_solution(const DistributedVector &momentum,
                                       const DistributedVector &mass,
                                       const DistributedVector &velocity,
                                       const DistributedVector &pressure)
{
  const double velocity_size = velocity.linfty_norm();
  if (velocity_size == 0.)
    return;
  is_checked = true;
  const bool with_pressure = system.coefficients().with_pressure;
  DistributedVector momentum_residual = system.space.velocity_vector(),
                    mass_residual = system.space.pressure_vector();
  system.multiply(velocity, pressure, momentum_residual, mass_residual);
  system.set_prescribed(velocity, momentum_residual);
  momentum_residual.sadd(-1., 1., momentum);
  mass_residual.sadd(-1., 1., mass);
  // The equations have different units; what is left of them counts by what it would change.
  const auto middle = std::copy(momentum_residual.begin(), momentum_residual.end(), packed.begin());
  if (with_pressure)
    std::copy(mass_residual.begin(), mass_residual.end(), middle);
  factor->solve(packed);
  std::copy(packed.begin(), middle, momentum_residual.begin());
  if (with_pressure)
    std::copy(middle, packed.end(), mass_residual.begin());
  double velocity_change = momentum_residual.linfty_norm() / velocity_size;
  // A pressure counts by its force, beside that of the other stresses: it may be nothing. So may a
  // velocity, such as the response of a liquid between walls to a pressure: the next one is looked
  // at.
  double pressure_change = 0.;
  if (with_pressure)
  {
    DistributedVector force = system.space.velocity_vector(), steady = force,
                      other = system.space.pressure_vector(), nothing = other;
    const auto size_of_force = [&](const DistributedVector &u, const DistributedVector &p)
    {
      system.multiply(u, p, force, other);
      return force.l2_norm();
    };
    // Where all forces vanish, as in a uniform flow, round-off is measured by what the terms of one
    // of them are.
    double largest_diagonal = 0.;
    for (unsigned int cell = 0; cell < system.space.mesh.n_owned_cells(); ++cell)
      largest_diagonal = std::max(largest_diagonal, system.momentum_diagonal()[cell] *
                                                        system.space.mesh.cells()[cell].volume);
    largest_diagonal = Utilities::MPI::max(largest_diagonal, system.space.communicator);
    const double of_pressure = size_of_force(steady, pressure),
                 of_velocity = size_of_force(velocity, nothing);
    if (of_velocity <= 1e-10 * of_pressure)
    {
      velocity_change = 0.;
      is_checked = false;
    }
    const double size =
        std::max({of_pressure, of_velocity, 1e-6 * largest_diagonal * velocity_size});
    pressure_change = size_of_force(steady, mass_residual) / size;
  }
  if (!(velocity_change <= 1e-7) || !(pressure_change <= 1e-7))
  {
    std::ostringstream text;
    text << factor->name() << " solved the equations of a step inaccurately: what it left of them "
         << "changes the velocity by " << velocity_change << " of its largest value and the "
         << "pressure's force by " << pressure_change
         << " of the largest force; the equations are singular or nearly so";
    throw RunError(text.str());
  }
}

template <int dim>
double CoupledSolve<dim>::factor_entries() const
{
  return factor ? factor->n_entries() : 0.;
}

template <int dim>
double CoupledSolve<dim>::factor_memory() const
{
  return factor ? factor->memory() : 0.;
}

template <int dim>
std::string CoupledSolve<dim>::name() const
{
  return factor ? factor->name() : "";
}

template class CoupledSolve<2>;
template class CoupledSolve<3>;
} // namespace Continua
