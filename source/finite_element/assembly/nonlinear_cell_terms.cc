#include <continua/finite_element/assembly/nonlinear_cell_terms.h>

#include <algorithm>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
/// The unknowns that an unknown of a cell stands for, with their weights.
using Masters = std::vector<std::pair<int, double>>;

void set_masters(const AffineConstraints<double> &constraints,
                 const types::global_dof_index index,
                 const int first,
                 Masters &masters)
{
  masters.clear();
  if (!constraints.is_constrained(index))
    masters.emplace_back(first + static_cast<int>(index), 1.);
  else
    for (const auto &entry : *constraints.get_constraint_entries(index))
      masters.emplace_back(first + static_cast<int>(entry.first), entry.second);
}
} // namespace

template <int dim>
NonlinearCellTerms<dim>::NonlinearCellTerms(const Space<dim> &space,
                                            const Problem &problem,
                                            const Quadrature<dim> &quadrature,
                                            const RegionModel model,
                                            const std::vector<PowerKind> &kinds)
    : space(space),
      problem(problem),
      model(model),
      quadrature(quadrature),
      cells(space, problem, quadrature, model),
      assembly(cells),
      body_forces(space, problem, cells, quadrature),
      faces(space, problem),
      face_points(problem),
      kinds(kinds),
      of_powers_at_points(cells, ValuesAtPoints<dim>::Field::velocity, true)
{
  const unsigned int n_velocity = dim * cells.n_functions(), n_pressure = cells.n_pressures();
  for (Vector<double> *vector : {&cell_change, &cell_product})
    vector->reinit(n_velocity + n_pressure);
  for (Vector<double> *vector : {&cell_momentum, &cell_of_powers})
    vector->reinit(n_velocity);
  cell_volume.reinit(n_pressure);
}

template <int dim>
void NonlinearCellTerms<dim>::reinit()
{
  velocity.reinit(space.velocity_owned, space.velocity_relevant, space.communicator);
  pressure.reinit(space.pressure_owned, space.pressure_relevant, space.communicator);
  velocity_of_powers.reinit(velocity);
  momentum_sums.reinit(velocity, space.velocity_owned, space.velocity_hanging);
  volume_sums.reinit(pressure, space.pressure_owned, space.pressure_hanging);
  forget_derivative();
  cells.reinit();
  faces.reinit(cells.all());
}

template <int dim>
void NonlinearCellTerms<dim>::take(const DistributedVector &of_velocity,
                                   const DistributedVector &of_pressure)
{
  space.copy_velocity(of_velocity, velocity);
  space.copy_pressure(of_pressure, pressure);
}

template <int dim>
void NonlinearCellTerms<dim>::add_rows(const Cell &cell)
{
  momentum_sums.add(cell.velocity_places, cell_momentum);
  volume_sums.add(cell.pressure_places, cell_volume);
}

template <int dim>
void NonlinearCellTerms<dim>::finish_rows(DistributedVector &momentum, DistributedVector &volume)
{
  momentum_sums.add_to(momentum);
  volume_sums.add_to(volume);
}

template <int dim>
void NonlinearCellTerms<dim>::add_powers(const unsigned int region,
                                         const StepSolution &state,
                                         const DistributedVector &of_velocity,
                                         const TermsTaken taken,
                                         NonlinearPowers &powers,
                                         DistributedVector *const momentum)
{
  take(state);
  space.copy_velocity(of_velocity, velocity_of_powers);
  const AskedPowers asked_powers{taken, powers};
  asked = &asked_powers;
  try
  {
    for (const Cell &cell : cells.all())
      if (cell.region == region)
      {
        set_entries(cell.velocity_places, velocity_of_powers, cell_of_powers);
        of_powers_at_points.set(cell_of_powers);
        visit(cell);
        integrate();
        momentum_sums.add(cell.velocity_places, cell_momentum);
      }
  }
  catch (...)
  {
    asked = nullptr;
    throw;
  }
  asked = nullptr;
  if (momentum != nullptr)
    momentum_sums.add_to(*momentum);
  else
    momentum_sums.forget();
}

template <int dim>
void NonlinearCellTerms<dim>::add_derivative(const StepSolution &state,
                                             const AffineConstraints<double> &constraints,
                                             EntrySums &matrix)
{
  take(state);
  const int first_pressure = static_cast<int>(space.velocity_dofs.n_dofs());
  FullMatrix<double> local;
  std::vector<Masters> masters;
  for (const Cell &cell : cells.all())
  {
    set_derivative(cell, local);
    masters.resize(local.m());
    const unsigned int n_velocity = cell.velocity_indices.size();
    for (unsigned int i = 0; i < n_velocity; ++i)
      set_masters(constraints, cell.velocity_indices[i], 0, masters[i]);
    for (unsigned int k = 0; k < cell.pressure_indices.size(); ++k)
      set_masters(space.pressure_hanging, cell.pressure_indices[k], first_pressure,
                  masters[n_velocity + k]);
    const bool has_pressures = couples_pressures(cell);
    for (unsigned int i = 0; i < local.m(); ++i)
      for (unsigned int j = 0; j < (i < n_velocity || has_pressures ? local.n() : n_velocity); ++j)
        for (const auto &[row, row_weight] : masters[i])
          for (const auto &[column, column_weight] : masters[j])
            matrix.add(row, column, row_weight * column_weight * local(i, j));
  }
}

template <int dim>
void NonlinearCellTerms<dim>::visit_derivatives(
    const StepSolution &state,
    const std::function<void(const QuadratureCell<dim> &, const FullMatrix<double> &)> &take_matrix)
{
  take(state);
  FullMatrix<double> local;
  for (const Cell &cell : cells.all())
  {
    set_derivative(cell, local);
    take_matrix(cell, local);
  }
}

template <int dim>
void NonlinearCellTerms<dim>::add_products_with(const DistributedVector &local_velocity,
                                                DistributedVector &momentum,
                                                DistributedVector &volume,
                                                DistributedVector &of_velocity,
                                                DistributedVector &of_pressure)
{
  const DistributedVector ghosted = space.ghosted_velocity(local_velocity);
  FullMatrix<double> local;
  CellSums of_velocity_sums = momentum_sums, of_pressure_sums = volume_sums;
  for (const Cell &cell : cells.all())
  {
    set_entries(cell.velocity_places, ghosted, cell_momentum);
    if (cell_momentum.all_zero())
      continue;
    cell_change = 0.;
    std::copy(cell_momentum.begin(), cell_momentum.end(), cell_change.begin());
    set_derivative(cell, local);
    // The rows of volume are multiplied by -1.
    local.vmult(cell_product, cell_change);
    set_rows(-1.);
    add_rows(cell);
    local.Tvmult(cell_product, cell_change);
    set_rows(1.);
    of_velocity_sums.add(cell.velocity_places, cell_momentum);
    of_pressure_sums.add(cell.pressure_places, cell_volume);
  }
  finish_rows(momentum, volume);
  of_velocity_sums.add_to(of_velocity);
  of_pressure_sums.add_to(of_pressure);
}

template <int dim>
void NonlinearCellTerms<dim>::set_rows(const double sign_of_volume)
{
  const std::size_t n_velocity = cell_momentum.size();
  std::copy_n(cell_product.begin(), n_velocity, cell_momentum.begin());
  for (std::size_t k = 0; k < cell_volume.size(); ++k)
    cell_volume[k] = sign_of_volume * cell_product[n_velocity + k];
}

template <int dim>
void NonlinearCellTerms<dim>::keep_derivative(const StepSolution &state, KeptDerivative /*form*/)
{
  take(state);
  cell_derivatives.resize(cells.all().size());
  for (std::size_t k = 0; k < cell_derivatives.size(); ++k)
    if (needs_matrix(cells.all()[k]))
      set_derivative(cells.all()[k], cell_derivatives[k]);
}

template <int dim>
void NonlinearCellTerms<dim>::add_derivative_product(const DistributedVector &of_velocity,
                                                     const DistributedVector &of_pressure,
                                                     DistributedVector &momentum,
                                                     DistributedVector &volume)
{
  take(of_velocity, of_pressure);
  const double *const velocities = velocity.begin(), *const pressures = pressure.begin();
  for (std::size_t k = 0; k < cell_derivatives.size(); ++k)
  {
    if (cell_derivatives[k].empty())
      continue;
    const Cell &cell = cells.all()[k];
    const unsigned int n_velocity = cell.velocity_places.size(),
                       n_pressure = cell.pressure_places.size();
    for (unsigned int i = 0; i < n_velocity; ++i)
      cell_change[i] = velocities[cell.velocity_places[i]];
    for (unsigned int i = 0; i < n_pressure; ++i)
      cell_change[n_velocity + i] = pressures[cell.pressure_places[i]];
    cell_derivatives[k].vmult(cell_product, cell_change);
    set_rows(-1.);
    add_rows(cell);
  }
  finish_rows(momentum, volume);
}

template class NonlinearCellTerms<2>;
template class NonlinearCellTerms<3>;
} // namespace Continua
