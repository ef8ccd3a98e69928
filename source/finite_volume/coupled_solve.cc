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
CoupledSolve<dim>::CoupledSolve(const CellSystem<dim> &system) : system(system)
{
}

template <int dim>
void CoupledSolve<dim>::reinit()
{
  const CellSpace<dim> &space = system.space;
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
  factor = make_unsymmetric_factor("automatic", space.communicator);
  factor->factorize(matrix, owned);
  residual_is_checked = false;
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
  if (!residual_is_checked)
    check_residual(momentum, mass, velocity, pressure);
}

template <int dim>
void CoupledSolve<dim>::check_residual(const DistributedVector &momentum,
                                       const DistributedVector &mass,
                                       const DistributedVector &velocity,
                                       const DistributedVector &pressure)
{
  DistributedVector momentum_product = system.space.velocity_vector(),
                    mass_product = system.space.pressure_vector();
  system.multiply(velocity, pressure, momentum_product, mass_product);
  system.set_prescribed(velocity, momentum_product);
  momentum_product.sadd(-1., 1., momentum);
  mass_product.sadd(-1., 1., mass);
  const double scale = momentum.l2_norm();
  const double mass_scale = mass.l2_norm();
  const double residual = momentum_product.l2_norm();
  const double mass_residual = system.coefficients().with_pressure ? mass_product.l2_norm() : 0.;
  if (scale == 0. && mass_scale == 0.)
    return;
  residual_is_checked = true;
  // An equation whose right side is nearly nothing is measured by what its terms are.
  DistributedVector nothing = system.space.pressure_vector();
  system.multiply(velocity, nothing, momentum_product, mass_product);
  const double terms = std::max(scale, momentum_product.l2_norm());
  const double mass_terms = std::max(mass_scale, mass_product.l2_norm());
  if (!(residual <= 1e-8 * terms) || !(mass_residual <= 1e-8 * mass_terms))
  {
    std::ostringstream text;
    text << factor->name() << " solved the equations of a step to a relative residual of "
         << residual / terms << " (momentum) and "
         << (mass_terms > 0. ? mass_residual / mass_terms : 0.)
         << " (mass) only: they are singular or nearly so";
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
