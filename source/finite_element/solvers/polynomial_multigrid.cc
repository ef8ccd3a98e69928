#include <continua/finite_element/solvers/polynomial_multigrid.h>
#include <continua/finite_element/space/velocity_nodes.h>
#include <continua/linear_algebra/block_factor.h>
#include <continua/linear_algebra/block_multigrid.h>
#include <continua/linear_algebra/matrix_operator.h>
#include <continua/linear_algebra/matrix_product.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
// For cells as long as thick.
constexpr unsigned int least_degree = 3;
/// Of the largest to the smallest eigenvalue that are damped. The linear velocities take the rest.
constexpr double ratio_at_least_degree = 10.;
/// More products than these cost more than the iterations that they save.
constexpr unsigned int largest_degree = 24;

/// Of the cells of a region whose interior velocities are stiff, on all ranks: the geometric mean
/// of the longest over the shortest distance between opposite faces [1]. The largest of all
/// regions; 1 if there are none.
template <int dim>
double mean_cell_shape(const Space<dim> &space,
                       const std::vector<bool> &stiff,
                       const unsigned int n_regions)
{
  std::vector<double> logarithms(n_regions, 0.), n_cells(n_regions, 0.);
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      cell->get_dof_indices(indices);
      // The last ones belong to this cell alone.
      if (!stiff[space.velocity_owned.index_within_set(indices.back())])
        continue;
      double longest = 0., shortest = std::numeric_limits<double>::max();
      for (unsigned int d = 0; d < dim; ++d)
      {
        const double length = cell->face(2 * d)->center().distance(cell->face(2 * d + 1)->center());
        longest = std::max(longest, length);
        shortest = std::min(shortest, length);
      }
      logarithms[cell->material_id()] += std::log(longest / shortest);
      n_cells[cell->material_id()] += 1.;
    }
  Utilities::MPI::sum(logarithms, space.communicator, logarithms);
  Utilities::MPI::sum(n_cells, space.communicator, n_cells);
  double result = 1.;
  for (unsigned int region = 0; region < n_regions; ++region)
    if (n_cells[region] > 0.)
      result = std::max(result, std::exp(logarithms[region] / n_cells[region]));
  return result;
}

/// The linear velocities miss motions whose eigenvalues fall with the square of the shape, and a
/// polynomial damps a range of eigenvalues that grows with the square of its degree.
unsigned int degree_for(const double cell_shape)
{
  // The last digits of the shape depend on the number of ranks, also those of 2.5.
  return std::clamp(static_cast<unsigned int>(std::lround(cell_shape + 1e-6)), least_degree,
                    largest_degree);
}
} // namespace

template <int dim>
PolynomialMultigrid<dim>::PolynomialMultigrid(
    const Product &cells,
    const Space<dim> &space,
    const BoundaryConstraints<dim> &constraints,
    const typename Product::Coefficients &coefficients,
    const std::vector<bool> &stiff,
    const TrilinosWrappers::SparseMatrix &divergence,
    const DistributedVector &weights,
    std::unique_ptr<TrilinosWrappers::SparseMatrix> supports_of_boundaries,
    const double most_factor_bytes)
    : supports(std::move(supports_of_boundaries)),
      linear_velocities(space, constraints, stiff),
      product(cells.share()),
      augmentation(divergence, weights),
      degree(degree_for(mean_cell_shape(space, stiff, coefficients.mass.size()))),
      fine(space.velocity_vector()),
      coarse_source(linear_velocities.vector()),
      coarse_solution(linear_velocities.vector())
{
  product->set({coefficients.mass, coefficients.stiffness, {}});
  product->restrict_to(stiff);
  for (Vector *const vector : {&right_hand_side, &solution, &residual, &correction})
    product->initialise(*vector);

  product->find_diagonal(residual);
  augmentation.add_diagonal(residual);
  if (supports)
  {
    support_force.reinit(fine);
    const MatrixOperator of_supports(*supports);
    for (unsigned int i = 0; i < residual.locally_owned_size(); ++i)
      residual.local_element(i) += static_cast<float>(of_supports.diagonal().begin()[i]);
  }
  Vector inverse_diagonal(residual);
  inverse_diagonal = 0.f;
  for (unsigned int i = 0; i < stiff.size(); ++i)
    if (stiff[i] && residual.local_element(i) > 0.f &&
        !constraints.all().is_constrained(space.velocity_owned.nth_index_in_set(i)))
    {
      stiff_rows.push_back(i);
      inverse_diagonal.local_element(i) = 1.f / residual.local_element(i);
    }
  relaxation = std::make_unique<ChebyshevPolynomial>(
      [this](Vector &target, const Vector &source) { multiply(target, source); }, inverse_diagonal,
      degree,
      ratio_at_least_degree *
          Utilities::fixed_power<2>(static_cast<double>(degree) / least_degree));
  make_coarse_cycle(coefficients, space, most_factor_bytes);
}

template <int dim>
void PolynomialMultigrid<dim>::make_coarse_cycle(const typename Product::Coefficients &coefficients,
                                                 const Space<dim> &space,
                                                 const double most_factor_bytes)
{
  TrilinosWrappers::SparseMatrix coarse_matrix;
  linear_velocities.assemble({coefficients.mass, coefficients.stiffness, coefficients.volumetric},
                             supports.get(), coarse_matrix);
  const std::vector<unsigned int> &rows = linear_velocities.stiff_rows();
  if (most_factor_bytes > 0.)
    try
    {
      auto factor = std::make_unique<BlockFactor>(coarse_matrix, rows, most_factor_bytes);
      coarse_name = factor->factor().name();
      coarse_cycle = std::move(factor);
      is_factored = true;
      return;
    }
    catch (const FactorTooLarge &)
    {
      // Multigrid takes its place.
    }
  VelocityBlocks blocks;
  blocks.n_components = dim;
  blocks.modes = rigid_motions(space.mapping, linear_velocities.dofs());
  coarse_cycle = std::make_unique<BlockMultigrid>(coarse_matrix, rows, blocks);
  coarse_name = "algebraic multigrid";
}

template <int dim>
std::string PolynomialMultigrid<dim>::name() const
{
  return "polynomial multigrid (degree " + std::to_string(degree) +
         ", linear velocities: " + coarse_name + ")";
}

template <int dim>
void PolynomialMultigrid<dim>::multiply(Vector &target, const Vector &source)
{
  product->multiply(target, source);
  augmentation.add_product(target, source);
  if (!supports)
    return;
  std::copy(source.begin(), source.end(), fine.begin());
  Continua::multiply(*supports, support_force, fine);
  for (unsigned int i = 0; i < target.locally_owned_size(); ++i)
    target.local_element(i) += static_cast<float>(support_force.begin()[i]);
}

template <int dim>
void PolynomialMultigrid<dim>::leave_residual()
{
  multiply(residual, solution);
  residual.sadd(-1.f, 1.f, right_hand_side);
}

template <int dim>
void PolynomialMultigrid<dim>::add_cycle(DistributedVector &target, const DistributedVector &source)
{
  for (const unsigned int i : stiff_rows)
    right_hand_side.local_element(i) = static_cast<float>(source.begin()[i]);
  relaxation->apply(solution, right_hand_side);

  leave_residual();
  std::copy(residual.begin(), residual.end(), fine.begin());
  multiply_transposed(linear_velocities.interpolation(), coarse_source, fine);
  coarse_solution = 0.;
  coarse_cycle->add_cycle(coarse_solution, coarse_source);
  Continua::multiply(linear_velocities.interpolation(), fine, coarse_solution);
  for (const unsigned int i : stiff_rows)
    solution.local_element(i) += static_cast<float>(fine.begin()[i]);

  leave_residual();
  relaxation->apply(correction, residual);
  for (const unsigned int i : stiff_rows)
    target.begin()[i] += solution.local_element(i) + correction.local_element(i);
}

template class PolynomialMultigrid<2>;
template class PolynomialMultigrid<3>;
} // namespace Continua
