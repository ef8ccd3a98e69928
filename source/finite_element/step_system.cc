#include <continua/finite_element/step_system.h>

#include <continua/base/input_error.h>

#include <deal.II/base/mpi.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
bool nearly_equal(const std::vector<double> &a, const std::vector<double> &b)
{
  if (a.size() != b.size())
    return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::abs(a[i] - b[i]) > 1e-12 * std::abs(a[i]))
      return false;
  return true;
}

/// One row of a Trilinos matrix: calls function(global column, value).
template <typename Function>
void for_row(const TrilinosWrappers::SparseMatrix &matrix,
             const int local_row,
             const Function &function)
{
  const Epetra_CrsMatrix &epetra = matrix.trilinos_matrix();
  int n_entries = 0;
  double *values = nullptr;
  int *columns = nullptr;
  epetra.ExtractMyRowView(local_row, n_entries, values, columns);
  for (int k = 0; k < n_entries; ++k)
    function(epetra.GCID(columns[k]), values[k]);
}

using Entries = std::vector<std::pair<int, double>>;

/// Sorts by column and adds what stands in the same one.
void merge(Entries &entries)
{
  std::sort(entries.begin(), entries.end(),
            [](const auto &a, const auto &b) { return a.first < b.first; });
  std::size_t last = 0;
  for (std::size_t k = 1; k < entries.size(); ++k)
    if (entries[k].first == entries[last].first)
      entries[last].second += entries[k].second;
    else
      entries[++last] = entries[k];
  if (!entries.empty())
    entries.resize(last + 1);
}
} // namespace

void LinearSolverParameters::read(ParameterSection section)
{
  section.add_choice("Type", type, {"automatic", "cholmod", "mumps", "umfpack"},
                     "Direct solver of the step's system: automatic takes cholmod on one rank "
                     "where every material is compressible and the matrix has no more than 2 "
                     "million entries, else mumps; umfpack is there for comparison.");
  section.add("Refinement steps", refinement_steps,
              "Steps of iterative refinement after each solve [1].", 0, 5);
}

bool SystemCoefficients::operator==(const SystemCoefficients &other) const
{
  return nearly_equal(mass, other.mass) && nearly_equal(stiffness, other.stiffness) &&
         nearly_equal(compressibility, other.compressibility);
}

template <int dim>
StepSystem<dim>::StepSystem(const Space<dim> &space,
                            const std::vector<RegionOperators> &operators,
                            const BoundaryConstraints<dim> &constraints,
                            const LinearSolverParameters &parameters)
    : space(space), operators(operators), constraints(constraints), parameters(parameters)
{
}

template <int dim>
void StepSystem<dim>::reinit()
{
  is_factored = false;
  velocity_product = space.velocity_vector();
  velocity_residual = velocity_product;
  velocity_correction = velocity_product;
  pressure_product = space.pressure_vector();
  pressure_residual = pressure_product;
  pressure_correction = pressure_product;
  pressure_hanging.clear();
  for (const auto index : space.pressure_owned)
    if (space.pressure_hanging.is_constrained(index))
      pressure_hanging.push_back(space.pressure_owned.index_within_set(index));
  packed.resize(space.velocity_owned.n_elements() + space.pressure_owned.n_elements());
}

template <int dim>
AffineConstraints<double> StepSystem<dim>::constraints_of_columns() const
{
  IndexSet columns = space.velocity_relevant;
  std::vector<types::global_dof_index> others;
  const auto collect = [&](const TrilinosWrappers::SparseMatrix &matrix, const unsigned int n_rows)
  {
    for (unsigned int i = 0; i < n_rows; ++i)
      for_row(matrix, i,
              [&](const types::global_dof_index j, double)
              {
                if (!space.velocity_relevant.is_element(j))
                  others.push_back(j);
              });
  };
  for (const RegionOperators &region : operators)
  {
    // The stiffness has all the columns that the mass has.
    collect(region.stiffness, space.velocity_owned.n_elements());
    collect(region.divergence, space.pressure_owned.n_elements());
  }
  std::sort(others.begin(), others.end());
  columns.add_indices(others.begin(), std::unique(others.begin(), others.end()));
  columns.compress();

  AffineConstraints<double> lines(columns);
  lines.merge(constraints.all(), AffineConstraints<double>::no_conflicts_allowed, true);
  if (Utilities::MPI::n_mpi_processes(space.communicator) > 1)
    lines.make_consistent_in_parallel(space.velocity_owned, columns, space.communicator);
  lines.close();
  return lines;
}

template <int dim>
SymmetricTriplets StepSystem<dim>::triplets() const
{
  const int n_velocity = space.velocity_dofs.n_dofs();
  SymmetricTriplets result;
  result.n = n_velocity + space.pressure_dofs.n_dofs();
  const auto add = [&result](const int row, const int column, const double value)
  {
    if (row >= column)
    {
      result.rows.push_back(row);
      result.columns.push_back(column);
      result.values.push_back(value);
    }
  };
  const AffineConstraints<double> lines = constraints_of_columns();
  // The free dofs that a velocity dof stands for, with their weights: the rows of T. Hanging nodes
  // are condensed already: they stand in no row but their own.
  const auto masters = [&lines](const int index, Entries &entries)
  {
    entries.clear();
    if (!lines.is_constrained(index))
      entries.emplace_back(index, 1.);
    else
      for (const auto &entry : *lines.get_constraint_entries(index))
        entries.emplace_back(entry.first, entry.second);
  };

  Entries row, row_masters, column_masters;
  for (unsigned int i = 0; i < space.velocity_owned.n_elements(); ++i)
  {
    const int global = space.velocity_owned.nth_index_in_set(i);
    if (lines.is_constrained(global))
      add(global, global, 1.);
    if (space.velocity_hanging.is_constrained(global))
      continue;
    masters(global, row_masters);
    if (row_masters.empty())
      continue;
    row.clear();
    for (unsigned int region = 0; region < operators.size(); ++region)
    {
      const double mass = coefficients.mass[region], stiffness = coefficients.stiffness[region];
      if (mass != 0.)
        for_row(operators[region].mass, i,
                [&](const int j, const double value) { row.emplace_back(j, mass * value); });
      if (stiffness != 0.)
        for_row(operators[region].stiffness, i,
                [&](const int j, const double value) { row.emplace_back(j, stiffness * value); });
    }
    merge(row);
    for (const auto &[column, value] : row)
    {
      masters(column, column_masters);
      for (const auto &[to_row, row_weight] : row_masters)
        for (const auto &[to_column, column_weight] : column_masters)
          add(to_row, to_column, row_weight * column_weight * value);
    }
  }
  for (unsigned int k = 0; k < space.pressure_owned.n_elements(); ++k)
  {
    const int global = space.pressure_owned.nth_index_in_set(k);
    if (space.pressure_hanging.is_constrained(global))
    {
      add(n_velocity + global, n_velocity + global, -1.);
      continue;
    }
    for (unsigned int region = 0; region < operators.size(); ++region)
    {
      for_row(operators[region].divergence, k,
              [&](const int j, const double value)
              {
                masters(j, column_masters);
                for (const auto &[to_column, column_weight] : column_masters)
                  add(n_velocity + global, to_column, -column_weight * value);
              });
      const double compressibility = coefficients.compressibility[region];
      if (compressibility != 0.)
        for_row(operators[region].pressure_mass, k,
                [&](const int l, const double value)
                { add(n_velocity + global, n_velocity + l, -compressibility * value); });
    }
  }
  return result;
}

template <int dim>
bool StepSystem<dim>::prepare(const SystemCoefficients &wanted)
{
  if (is_factored && coefficients == wanted)
    return false;
  coefficients = wanted;
  // A negative mass is the shift of an eigenvalue problem.
  const bool quasi_definite =
      std::all_of(coefficients.compressibility.begin(), coefficients.compressibility.end(),
                  [](const double c) { return c > 0.; }) &&
      std::all_of(coefficients.mass.begin(), coefficients.mass.end(),
                  [](const double mass) { return mass >= 0.; });
  std::vector<int> owned;
  owned.reserve(packed.size());
  for (const auto index : space.velocity_owned)
    owned.push_back(index);
  for (const auto index : space.pressure_owned)
    owned.push_back(space.velocity_dofs.n_dofs() + index);
  const SymmetricTriplets matrix = triplets();
  try
  {
    symmetric_factor = make_symmetric_factor(parameters.type, quasi_definite, matrix.values.size(),
                                             space.communicator);
  }
  catch (const std::invalid_argument &error)
  {
    throw RunError(error.what());
  }
  symmetric_factor->factorize(matrix, owned);
  is_factored = true;
  residual_is_checked = false;
  return true;
}

template <int dim>
void StepSystem<dim>::solve_packed(const DistributedVector &momentum,
                                   const DistributedVector &mass,
                                   DistributedVector &velocity,
                                   DistributedVector &pressure)
{
  const auto middle = std::copy(momentum.begin(), momentum.end(), packed.begin());
  std::copy(mass.begin(), mass.end(), middle);
  symmetric_factor->solve(packed);
  std::copy(packed.begin(), middle, velocity.begin());
  std::copy(middle, packed.end(), pressure.begin());
}

template <int dim>
double StepSystem<dim>::residual(const DistributedVector &momentum,
                                 const DistributedVector &mass,
                                 const DistributedVector &velocity,
                                 const DistributedVector &pressure)
{
  // velocity is zero at constrained dofs; T u puts the masters' share there.
  velocity_correction = velocity;
  pressure_correction = 0.;
  DistributedVector zero(velocity);
  zero = 0.;
  constraints.set_constrained(velocity_correction, zero);
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
  solve_packed(momentum, mass, velocity, pressure);
  for (unsigned int step = 0; step < parameters.refinement_steps; ++step)
  {
    residual(momentum, mass, velocity, pressure);
    solve_packed(velocity_residual, pressure_residual, velocity_correction, pressure_correction);
    velocity.add(1., velocity_correction);
    pressure.add(1., pressure_correction);
  }
  if (!residual_is_checked)
  {
    const double relative = residual(momentum, mass, velocity, pressure);
    if (!(relative < 1e-8))
    {
      // One step of refinement tells a badly scaled right-hand side from a bad factor.
      solve_packed(velocity_residual, pressure_residual, velocity_correction, pressure_correction);
      velocity.add(1., velocity_correction);
      pressure.add(1., pressure_correction);
      const double refined = residual(momentum, mass, velocity, pressure);
      if (!(refined < 1e-6))
      {
        std::ostringstream text;
        text << "the direct solver " << symmetric_factor->name() << " left a relative residual of "
             << relative << " (" << refined << " after a step of refinement)";
        throw RunError(text.str());
      }
    }
    residual_is_checked = true;
  }
}

template <int dim>
void StepSystem<dim>::add_velocity_product(const DistributedVector &velocity,
                                           DistributedVector &result)
{
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    if (coefficients.mass[region] != 0.)
    {
      multiply(operators[region].mass, velocity_product, velocity);
      result.add(coefficients.mass[region], velocity_product);
    }
    if (coefficients.stiffness[region] != 0.)
    {
      multiply(operators[region].stiffness, velocity_product, velocity);
      result.add(coefficients.stiffness[region], velocity_product);
    }
  }
}

template <int dim>
void StepSystem<dim>::add_divergence(const double factor,
                                     const DistributedVector &velocity,
                                     DistributedVector &result)
{
  for (const RegionOperators &region : operators)
  {
    multiply(region.divergence, pressure_product, velocity);
    result.add(factor, pressure_product);
  }
}

template <int dim>
void StepSystem<dim>::add_gradient(const double factor,
                                   const DistributedVector &pressure,
                                   DistributedVector &result)
{
  for (const RegionOperators &region : operators)
  {
    multiply_transposed(region.divergence, velocity_product, pressure);
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
