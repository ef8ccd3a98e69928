#include <continua/finite_element/solvers/loaded_cells.h>

#include <continua/base/input_error.h>
#include <continua/finite_element/space/deformed_face_point.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
/// Of the pressure of a liquid at rest.
constexpr double largest_difference = 1e-4;
/// Of a liquid at rest, over the speed sqrt(p/rho) of its pressure.
constexpr double largest_speed = 1e-4;
/// Of the pressures of solids, whose round-off after a search for a steady state the liquids have,
/// too: it counts in the place of the pressure of a liquid that has less.
constexpr double part_of_solids = 1e-3;
/// So short that what grows with it is nothing beside what does not [s].
constexpr double no_time = 1e-100;
constexpr const char *same_pressures =
    "give the pressures at its ends, those behind its outlets, and the Mean pressure of its "
    "absorbing ends the same value";

using Masters = std::vector<std::pair<int, double>>;

Masters masters_of(const AffineConstraints<double> &constraints,
                   const types::global_dof_index index,
                   const int first)
{
  if (!constraints.is_constrained(index))
    return {{first + static_cast<int>(index), 1.}};
  Masters masters;
  for (const auto &entry : *constraints.get_constraint_entries(index))
    masters.emplace_back(first + static_cast<int>(entry.first), entry.second);
  return masters;
}

/// Without inertia, in which the displacement is the velocity times `size` and a solid has its
/// viscosity and its branches.
Step deforming_step(const double size)
{
  Step step = euler_step(0., 2. * size, Update::trapezoidal);
  step.a0 = step.a1 = 0.;
  return step;
}

FullMatrix<double> velocity_block(const FullMatrix<double> &matrix, const unsigned int n)
{
  FullMatrix<double> block(n, n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      block(i, j) = matrix(i, j);
  return block;
}

/// The sum of the moduli of the branches that relax [Pa].
double relaxing_modulus(const Material &material)
{
  double sum = 0.;
  for (const Branch &branch : material.shear.branches)
    if (!std::isinf(branch.relaxation_time))
      sum += branch.shear_modulus;
  return sum;
}

} // namespace

template <int dim>
FEFaceValues<dim> face_values_under_load(const Space<dim> &space)
{
  return FEFaceValues<dim>(space.mapping, space.scalar_element(),
                           space.face_quadrature(space.n_quadrature_points() + 1),
                           update_values | update_gradients | update_quadrature_points |
                               update_normal_vectors | update_JxW_values);
}

template <int dim>
LoadedCells<dim>::LoadedCells(const Space<dim> &space,
                              const Problem &problem,
                              const NonlinearTerms<dim> &terms,
                              MetricHistory<dim> *const metrics,
                              const LoadedState &state)
    : space(space), problem(problem)
{
  displacement.reinit(space.velocity_owned, space.velocity_relevant, space.communicator);
  space.copy_velocity(problem.mesh_moves ? state.mesh_displacement : state.displacement,
                      displacement);
  take_parts(terms, metrics, state);
  take_liquid_pressures(state);
  add_pressures_of_liquids();
}

template <int dim>
void LoadedCells<dim>::take_parts(const NonlinearTerms<dim> &terms,
                                  MetricHistory<dim> *const metrics,
                                  const LoadedState &loaded)
{
  StepSolution solution;
  solution.velocity = solution.acceleration = space.velocity_vector();
  solution.pressure = loaded.pressure;
  solution.pressure_rate = space.pressure_vector();
  solution.displacement = loaded.displacement;
  solution.mesh_displacement = loaded.mesh_displacement;
  solution.mesh_velocity = space.velocity_vector();
  solution.boundary_pressures.assign(std::count_if(problem.conditions.begin(),
                                                   problem.conditions.end(),
                                                   [](const BoundaryCondition &condition)
                                                   { return condition.has_unknown_pressure(); }),
                                     0.);
  double smallest = std::numeric_limits<double>::max();
  for (const auto &of_model : terms)
  {
    const std::size_t first = cells.size();
    const auto visit = [&](const Step &step, const auto &take_matrix)
    {
      solution.step = step;
      solution.step.balance_time = loaded.time_of_loads;
      std::size_t number = first;
      of_model->visit_derivatives(solution,
                                  [&](const QuadratureCell<dim> &cell, const Matrix &matrix)
                                  { take_matrix(number++, cell, matrix); });
    };
    of_model->start_from(loaded.displacement);
    const Step steady_step = static_step(1., false);
    if (metrics != nullptr)
      metrics->predict(steady_step);
    visit(steady_step,
          [&](std::size_t, const QuadratureCell<dim> &cell, const Matrix &matrix)
          {
            cells.emplace_back();
            cells.back().at = &cell;
            cells.back().stiffness = matrix;
            smallest = std::min(smallest, cell.velocity_cell->diameter());
            if (problem.materials[cell.region].is_solid())
              return;
            // A step towards a steady state keeps the viscosity of a liquid, which has no
            // stiffness.
            const unsigned int n = cell.velocity_indices.size();
            cells.back().viscosity = velocity_block(matrix, n);
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int j = 0; j < n; ++j)
                cells.back().stiffness(i, j) = 0.;
          });
    visit(static_step(no_time, true),
          [&](const std::size_t number, const QuadratureCell<dim> &cell, const Matrix &matrix)
          {
            cells[number].mass = velocity_block(matrix, cell.velocity_indices.size());
            cells[number].mass *= no_time;
          });
    const bool is_viscous =
        std::any_of(problem.materials.begin(), problem.materials.end(),
                    [](const Material &material)
                    { return material.is_solid() && material.shear.viscosity > 0.; });
    if (is_viscous)
      visit(deforming_step(no_time),
            [&](const std::size_t number, const QuadratureCell<dim> &cell, const Matrix &matrix)
            {
              const Material &material = problem.materials[cell.region];
              if (material.is_solid() && material.shear.viscosity > 0.)
                cells[number].viscosity = velocity_block(matrix, cell.velocity_indices.size());
            });
    if (metrics == nullptr)
      continue;
    metrics->predict(deforming_step(no_time));
    visit(deforming_step(1.),
          [&](const std::size_t number, const QuadratureCell<dim> &cell, const Matrix &matrix)
          {
            const double modulus = relaxing_modulus(problem.materials[cell.region]);
            if (modulus == 0.)
              return;
            Cell &kept = cells[number];
            const unsigned int n = cell.velocity_indices.size();
            kept.relaxation = velocity_block(matrix, n);
            kept.relaxation.add(-1., velocity_block(kept.stiffness, n));
            if (!kept.viscosity.empty())
              kept.relaxation.add(-1., kept.viscosity);
            kept.relaxation /= modulus;
          });
  }
  smallest_cell = Utilities::MPI::min(smallest, space.communicator);
}

template <int dim>
void LoadedCells<dim>::take_liquid_pressures(const LoadedState &loaded)
{
  DistributedVector pressure(space.pressure_owned, space.pressure_relevant, space.communicator);
  space.copy_pressure(loaded.pressure, pressure);
  const std::size_t n_regions = problem.regions.size();
  std::vector<double> least(n_regions, std::numeric_limits<double>::max()), most(n_regions);
  std::fill(most.begin(), most.end(), -std::numeric_limits<double>::max());
  double largest = 0.;
  for (const Cell &cell : cells)
    for (const int place : cell.at->pressure_places)
    {
      const double value = pressure.begin()[place];
      const bool is_solid = problem.materials[cell.at->region].is_solid();
      largest = std::max(largest, (is_solid ? part_of_solids : 1.) * std::abs(value));
      if (is_solid)
        continue;
      least[cell.at->region] = std::min(least[cell.at->region], value);
      most[cell.at->region] = std::max(most[cell.at->region], value);
    }
  Utilities::MPI::min(least, space.communicator, least);
  Utilities::MPI::max(most, space.communicator, most);
  largest = Utilities::MPI::max(largest, space.communicator);
  refuse_streams(loaded.velocity, largest);
  liquid_pressures.assign(n_regions, 0.);
  for (unsigned int region = 0; region < n_regions; ++region)
  {
    if (problem.materials[region].is_solid())
      continue;
    if (most[region] - least[region] > largest_difference * largest)
    {
      std::ostringstream text;
      text << "the pressure of the liquid '" << problem.regions[region]
           << "' is not uniform in the state about which the motion is small: it is between "
           << least[region] << " and " << most[region]
           << " Pa. The liquid flows there, has a weight, or fills vessels of different pressures; "
           << same_pressures << ", and each vessel a region of its own";
      throw RunError(text.str());
    }
    liquid_pressures[region] = 0.5 * (least[region] + most[region]);
  }
}

template <int dim>
void LoadedCells<dim>::refuse_streams(const DistributedVector &of_state,
                                      const double largest_pressure) const
{
  DistributedVector velocity(space.velocity_owned, space.velocity_relevant, space.communicator);
  space.copy_velocity(of_state, velocity);
  for (unsigned int region = 0; region < problem.regions.size(); ++region)
  {
    if (problem.materials[region].is_solid())
      continue;
    double largest = 0.;
    for (const Cell &cell : cells)
      if (cell.at->region == region)
        for (const int place : cell.at->velocity_places)
          largest = std::max(largest, std::abs(velocity.begin()[place]));
    largest = Utilities::MPI::max(largest, space.communicator);
    const double speed = std::sqrt(largest_pressure / problem.materials[region].density);
    if (largest <= largest_speed * speed)
      continue;
    std::ostringstream text;
    text << "the liquid '" << problem.regions[region]
         << "' flows in the state about which the motion is small, with up to " << largest
         << " m/s; " << same_pressures;
    throw RunError(text.str());
  }
}

template <int dim>
void LoadedCells<dim>::add_pressures_of_liquids()
{
  FEFaceValues<dim> values = face_values_under_load(space);
  Vector<double> displacements(dim * values.dofs_per_cell);
  for (Cell &cell : cells)
  {
    const auto &at = cell.at->velocity_cell;
    if (!problem.materials[cell.at->region].is_solid())
      continue;
    for (const unsigned int face : at->face_indices())
    {
      if (at->at_boundary(face))
        continue;
      const double liquid_pressure = liquid_pressures[at->neighbor(face)->material_id()];
      if (liquid_pressure == 0.)
        continue;
      set_entries(cell.at->velocity_places, displacement, displacements);
      values.reinit(static_cast<typename Triangulation<dim>::active_cell_iterator>(at), face);
      for (const DeformedFacePoint<dim> &point : deformed_face_points(space, values))
      {
        const Kinematics motion = point.kinematics(displacements);
        const Tensor<1, 3> area = motion.area(point.area);
        const unsigned int n_functions = point.n_functions();
        for (unsigned int b = 0; b < n_functions; ++b)
        {
          const std::array<Tensor<1, 3>, dim> change = point.area_derivatives(motion, area, b);
          for (unsigned int a = 0; a < n_functions; ++a)
            for (unsigned int c = 0; c < dim && point.values[a] != 0.; ++c)
              for (unsigned int d = 0; d < dim; ++d)
                cell.stiffness(c * n_functions + a, d * n_functions + b) +=
                    liquid_pressure * point.values[a] * change[d][c];
        }
      }
    }
  }
}

template <int dim>
const FullMatrix<double> &LoadedCells<dim>::matrix_of(const LoadedPart part, const Cell &cell)
{
  switch (part)
  {
  case LoadedPart::mass:
    return cell.mass;
  case LoadedPart::viscosity:
    return cell.viscosity;
  case LoadedPart::relaxation:
    return cell.relaxation;
  default:
    return cell.stiffness;
  }
}

template <int dim>
void LoadedCells<dim>::add_entries(const LoadedPart part,
                                   const unsigned int region,
                                   const AffineConstraints<double> &constraints,
                                   Triplets &entries) const
{
  const int first_pressure = static_cast<int>(space.velocity_dofs.n_dofs());
  std::vector<Masters> masters;
  for (const Cell &cell : cells)
  {
    const Matrix &matrix = matrix_of(part, cell);
    if (cell.at->region != region || matrix.empty())
      continue;
    masters.clear();
    for (const auto index : cell.at->velocity_indices)
      masters.push_back(masters_of(constraints, index, 0));
    for (const auto index : cell.at->pressure_indices)
      masters.push_back(masters_of(space.pressure_hanging, index, first_pressure));
    for (unsigned int i = 0; i < matrix.m(); ++i)
      for (unsigned int j = 0; j < matrix.n(); ++j)
        for (const auto &[row, row_weight] : masters[i])
          for (const auto &[column, column_weight] : masters[j])
            if (matrix(i, j) != 0.)
            {
              entries.rows.push_back(row);
              entries.columns.push_back(column);
              entries.values.push_back(row_weight * column_weight * matrix(i, j));
            }
  }
}

template FEFaceValues<2> face_values_under_load(const Space<2> &);
template FEFaceValues<3> face_values_under_load(const Space<3> &);
template class LoadedCells<2>;
template class LoadedCells<3>;
} // namespace Continua
