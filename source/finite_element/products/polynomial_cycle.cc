#include <continua/finite_element/products/polynomial_cycle.h>

#include <continua/finite_element/space/velocity_nodes.h>
#include <continua/linear_algebra/block_factor.h>
#include <continua/linear_algebra/block_multigrid.h>
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
PolynomialCycle<dim>::PolynomialCycle(const Space<dim> &space,
                                      const AffineConstraints<double> &constraints,
                                      const LinearVelocities<dim> &linear_velocities,
                                      const std::vector<bool> &taken,
                                      const unsigned int n_regions,
                                      ChebyshevPolynomial::Product product_of_matrix,
                                      const Vector &diagonal,
                                      const TrilinosWrappers::SparseMatrix &coarse_matrix,
                                      const double most_factor_bytes)
    : linear_velocities(linear_velocities),
      product(std::move(product_of_matrix)),
      degree(degree_for(mean_cell_shape(space, taken, n_regions))),
      residual(diagonal),
      correction(diagonal),
      fine(space.velocity_vector()),
      coarse_source(linear_velocities.vector()),
      coarse_solution(linear_velocities.vector())
{
  Vector inverse_diagonal(diagonal);
  inverse_diagonal = 0.f;
  for (unsigned int i = 0; i < taken.size(); ++i)
    if (taken[i] && diagonal.local_element(i) > 0.f &&
        !constraints.is_constrained(space.velocity_owned.nth_index_in_set(i)))
    {
      rows.push_back(i);
      inverse_diagonal.local_element(i) = 1.f / diagonal.local_element(i);
    }
  relaxation = std::make_unique<ChebyshevPolynomial>(
      product, inverse_diagonal, degree,
      ratio_at_least_degree *
          Utilities::fixed_power<2>(static_cast<double>(degree) / least_degree));
  make_coarse_cycle(space, coarse_matrix, most_factor_bytes);
}

template <int dim>
void PolynomialCycle<dim>::make_coarse_cycle(const Space<dim> &space,
                                             const TrilinosWrappers::SparseMatrix &coarse_matrix,
                                             const double most_factor_bytes)
{
  const std::vector<unsigned int> &coarse_rows = linear_velocities.stiff_rows();
  if (most_factor_bytes > 0.)
    try
    {
      auto factor = std::make_unique<BlockFactor>(coarse_matrix, coarse_rows, most_factor_bytes);
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
  coarse_cycle = std::make_unique<BlockMultigrid>(coarse_matrix, coarse_rows, blocks);
  coarse_name = "algebraic multigrid";
}

template <int dim>
std::string PolynomialCycle<dim>::name() const
{
  return "polynomial multigrid (degree " + std::to_string(degree) +
         ", linear velocities: " + coarse_name + ")";
}

template <int dim>
void PolynomialCycle<dim>::leave_residual(const Vector &solution, const Vector &right_hand_side)
{
  product(residual, solution);
  residual.sadd(-1.f, 1.f, right_hand_side);
}

template <int dim>
void PolynomialCycle<dim>::apply(Vector &solution, const Vector &right_hand_side)
{
  relaxation->apply(solution, right_hand_side);

  leave_residual(solution, right_hand_side);
  std::copy(residual.begin(), residual.end(), fine.begin());
  multiply_transposed(linear_velocities.interpolation(), coarse_source, fine);
  coarse_solution = 0.;
  coarse_cycle->add_cycle(coarse_solution, coarse_source);
  multiply(linear_velocities.interpolation(), fine, coarse_solution);
  for (const unsigned int i : rows)
    solution.local_element(i) += static_cast<float>(fine.begin()[i]);

  leave_residual(solution, right_hand_side);
  relaxation->apply(correction, residual);
  for (const unsigned int i : rows)
    solution.local_element(i) += correction.local_element(i);
}

template class PolynomialCycle<2>;
template class PolynomialCycle<3>;
} // namespace Continua
