#include <continua/base/collective.h>
#include <continua/finite_volume/split_equations.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

template <int dim>
SplitEquations<dim>::SplitEquations(const CellWiseSystem<dim> &system) : system(system)
{
}

template <int dim>
unsigned int SplitEquations<dim>::global_index(const unsigned int number) const
{
  const unsigned int n_velocities = first_velocities.back();
  const bool is_velocity = number < n_velocities;
  const std::vector<unsigned int> &firsts = is_velocity ? first_velocities : first_pressures;
  const unsigned int of_kind = is_velocity ? number : number - n_velocities;
  const unsigned int rank =
      std::upper_bound(firsts.begin(), firsts.end(), of_kind) - firsts.begin() - 1;
  // A rank has its velocities first, then its pressures.
  return is_velocity ? first_pressures[rank] + of_kind : first_velocities[rank + 1] + of_kind;
}

template <int dim>
void SplitEquations<dim>::reinit()
{
  const CellWiseSpace<dim> &space = system.space;
  const bool with_pressure = system.coefficients().with_pressure;
  n_cells = space.mesh.n_owned_cells();
  first_pressure = dim * space.velocities.n_owned();
  n_rows = first_pressure + (with_pressure ? space.pressures.n_owned() : 0);
  first_velocities = all_gather(space.communicator, dim * space.velocities.first_owned());
  first_velocities.push_back(system.n_velocities());
  first_pressures.assign(first_velocities.size(), 0);
  if (with_pressure)
  {
    first_pressures = all_gather(space.communicator, space.pressures.first_owned());
    first_pressures.push_back(space.pressures.n_values());
  }

  const unsigned int first_velocity = dim * space.velocities.first_owned();
  const unsigned int first = global_index(first_velocity);
  std::vector<std::vector<std::pair<unsigned int, double>>> rows(n_rows);
  system.for_entries(
      [&](const int row, const int column, const double value)
      { rows[global_index(row) - first].emplace_back(global_index(column), value); });

  IndexSet owned(first_velocities.back() + first_pressures.back()), ghosts(owned.size());
  owned.add_range(first, first + n_rows);
  for (auto &row : rows)
  {
    std::sort(row.begin(), row.end());
    for (const auto &entry : row)
      if (!owned.is_element(entry.first))
        ghosts.add_index(entry.first);
  }
  // Two cells beside a face between materials are coupled by the loop, not by these rows.
  const auto need = [&](const unsigned int number)
  {
    const unsigned int index = global_index(number);
    if (!owned.is_element(index))
      ghosts.add_index(index);
  };
  for (unsigned int face = 0; face < space.mesh.faces().size(); ++face)
  {
    const VolumeFace<dim> &surface = space.mesh.faces()[face];
    for (unsigned int side = 0; surface.is_interface && side < surface.n_sides(); ++side)
    {
      for (unsigned int c = 0; c < dim; ++c)
      {
        need(dim * space.velocities.of_cell(surface.cell(side)) + c);
        need(dim * space.velocities.of_face(face, side) + c);
      }
      if (with_pressure)
        need(system.n_velocities() + space.pressures.of_cell(surface.cell(side)));
    }
  }
  layout = std::make_shared<Utilities::MPI::Partitioner>(owned, ghosts, space.communicator);

  // Pressures among the ghosts are told by their number.
  const auto is_pressure = [&](const unsigned int index)
  {
    for (std::size_t rank = 0; rank + 1 < first_velocities.size(); ++rank)
      if (index < first_velocities[rank + 1] + first_pressures[rank + 1])
        return index >= first_velocities[rank + 1] + first_pressures[rank];
    return false;
  };
  row_starts.assign(1, 0);
  pressure_starts.clear();
  columns.clear();
  values.clear();
  for (auto &row : rows)
  {
    for (const bool of_pressures : {false, true})
    {
      if (of_pressures)
        pressure_starts.push_back(columns.size());
      unsigned int previous = numbers::invalid_unsigned_int;
      for (const auto &[index, value] : row)
      {
        if (is_pressure(index) != of_pressures)
          continue;
        if (index == previous)
          values.back() += value;
        else
        {
          columns.push_back(layout->global_to_local(index));
          values.push_back(value);
        }
        previous = index;
      }
    }
    row_starts.push_back(columns.size());
  }
}

template <int dim>
typename SplitEquations<dim>::Vector SplitEquations<dim>::vector() const
{
  return Vector(layout);
}

template <int dim>
unsigned int SplitEquations<dim>::velocity_index(const unsigned int value) const
{
  return layout->global_to_local(global_index(dim * value));
}

template <int dim>
unsigned int SplitEquations<dim>::pressure_index(const unsigned int value) const
{
  return layout->global_to_local(global_index(system.n_velocities() + value));
}

template <int dim>
void SplitEquations<dim>::pack(const DistributedVector &velocity,
                               const DistributedVector &pressure,
                               Vector &unknowns) const
{
  std::copy(velocity.begin(), velocity.end(), unknowns.begin());
  if (has_pressure())
    std::copy(pressure.begin(), pressure.end(), unknowns.begin() + first_pressure);
}

template <int dim>
void SplitEquations<dim>::unpack(const Vector &unknowns,
                                 DistributedVector &velocity,
                                 DistributedVector &pressure) const
{
  std::copy(unknowns.begin(), unknowns.begin() + first_pressure, velocity.begin());
  if (has_pressure())
    std::copy(unknowns.begin() + first_pressure, unknowns.begin() + n_rows, pressure.begin());
}

template <int dim>
void SplitEquations<dim>::residual(const Rows &rows,
                                   const Vector &right_side,
                                   const Vector &unknowns,
                                   Vector &result) const
{
  const double *const x = unknowns.begin();
  const double *const b = right_side.begin();
  double *const r = result.begin();
  for (unsigned int row = rows.first; row < rows.second; ++row)
  {
    double sum = b[row];
    for (std::size_t k = row_starts[row]; k < row_starts[row + 1]; ++k)
      sum -= values[k] * x[columns[k]];
    r[row] = sum;
  }
}

template <int dim>
void SplitEquations<dim>::add_pressure_gradient(const Rows &rows,
                                                const double factor,
                                                const Vector &unknowns,
                                                Vector &target) const
{
  const double *const x = unknowns.begin();
  double *const y = target.begin();
  for (unsigned int row = rows.first; row < rows.second; ++row)
  {
    double sum = 0.;
    for (std::size_t k = pressure_starts[row]; k < row_starts[row + 1]; ++k)
      sum += values[k] * x[columns[k]];
    y[row] += factor * sum;
  }
}

template <int dim>
double SplitEquations<dim>::entry(const unsigned int row, const unsigned int column) const
{
  for (std::size_t k = row_starts[row]; k < row_starts[row + 1]; ++k)
    if (columns[k] == column)
      return values[k];
  return 0.;
}

template class SplitEquations<2>;
template class SplitEquations<3>;
} // namespace Continua
