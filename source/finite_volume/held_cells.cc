#include <continua/finite_volume/held_cells.h>

namespace Continua
{
template <int dim>
void HeldCells<dim>::reinit(const std::vector<bool> &velocity_is_held,
                            const std::vector<bool> &pressure_is_held)
{
  const CellWiseSpace<dim> &space = system.space;
  const bool with_pressure = system.coefficients().with_pressure;
  const unsigned int n_values = space.velocities.n_owned();
  const unsigned int n_pressures = with_pressure ? space.pressures.n_owned() : 0;
  const int first = dim * space.velocities.first_owned();
  const int first_pressure = system.n_velocities() + space.pressures.first_owned();
  std::vector<int> owned;
  is_held.clear();
  for (unsigned int i = 0; i < dim * n_values; ++i)
  {
    owned.push_back(first + i);
    is_held.push_back(i / dim < space.mesh.n_owned_cells() ||
                      (!velocity_is_held.empty() && velocity_is_held[i / dim]));
  }
  for (unsigned int i = 0; i < n_pressures; ++i)
  {
    owned.push_back(first_pressure + i);
    is_held.push_back(!pressure_is_held.empty() && pressure_is_held[i]);
  }
  packed.resize(owned.size());

  Triplets matrix;
  matrix.n = system.n_velocities() + (with_pressure ? space.pressures.n_values() : 0);
  const auto add = [&](const int row, const int column, const double value)
  {
    matrix.rows.push_back(row);
    matrix.columns.push_back(column);
    matrix.values.push_back(value);
  };
  system.for_entries(
      [&](const int row, const int column, const double value)
      {
        const unsigned int local = row < static_cast<int>(system.n_velocities())
                                       ? row - first
                                       : dim * n_values + row - first_pressure;
        if (!is_held[local])
          add(row, column, value);
      });
  for (std::size_t i = 0; i < owned.size(); ++i)
    if (is_held[i])
      add(owned[i], owned[i], 1.);
  factor = make_unsymmetric_factor(DirectSolver::automatic, space.communicator);
  factor->factorize(matrix, owned);
}

template <int dim>
void HeldCells<dim>::solve(const DistributedVector &momentum,
                           const DistributedVector &mass,
                           DistributedVector &velocity,
                           DistributedVector &pressure)
{
  const std::size_t n_velocities = velocity.locally_owned_size();
  for (std::size_t i = 0; i < packed.size(); ++i)
    if (i < n_velocities)
      packed[i] = is_held[i] ? velocity.begin()[i] : momentum.begin()[i];
    else
      packed[i] = is_held[i] ? pressure.begin()[i - n_velocities] : mass.begin()[i - n_velocities];
  factor->solve(packed);
  for (std::size_t i = 0; i < packed.size(); ++i)
    (i < n_velocities ? velocity.begin()[i] : pressure.begin()[i - n_velocities]) = packed[i];
}

template class HeldCells<2>;
template class HeldCells<3>;
} // namespace Continua
