#include <continua/finite_element/solvers/polynomial_multigrid.h>

#include <continua/linear_algebra/matrix_operator.h>
#include <continua/linear_algebra/matrix_product.h>

#include <algorithm>
#include <utility>

namespace Continua
{
using namespace dealii;

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
      linear_velocities(space, constraints.all(), stiff),
      product(cells.share()),
      augmentation(divergence, weights)
{
  product->set({coefficients.mass, coefficients.stiffness, {}});
  product->restrict_to(stiff);
  for (Vector *const vector : {&right_hand_side, &solution})
    product->initialise(*vector);

  product->find_diagonal(solution);
  augmentation.add_diagonal(solution);
  if (supports)
  {
    for (DistributedVector *const vector : {&support_velocity, &support_force})
      *vector = space.velocity_vector();
    const MatrixOperator of_supports(*supports);
    for (unsigned int i = 0; i < solution.locally_owned_size(); ++i)
      solution.local_element(i) += static_cast<float>(of_supports.diagonal().begin()[i]);
  }
  TrilinosWrappers::SparseMatrix coarse_matrix;
  linear_velocities.assemble({coefficients.mass, coefficients.stiffness, coefficients.volumetric},
                             supports.get(), coarse_matrix);
  cycle = std::make_unique<PolynomialCycle<dim>>(
      space, constraints.all(), linear_velocities, stiff, coefficients.mass.size(),
      [this](Vector &target, const Vector &source) { multiply(target, source); }, solution,
      coarse_matrix, most_factor_bytes);
}

template <int dim>
void PolynomialMultigrid<dim>::multiply(Vector &target, const Vector &source)
{
  product->multiply(target, source);
  augmentation.add_product(target, source);
  if (!supports)
    return;
  std::copy(source.begin(), source.end(), support_velocity.begin());
  Continua::multiply(*supports, support_force, support_velocity);
  for (unsigned int i = 0; i < target.locally_owned_size(); ++i)
    target.local_element(i) += static_cast<float>(support_force.begin()[i]);
}

template <int dim>
void PolynomialMultigrid<dim>::add_cycle(DistributedVector &target, const DistributedVector &source)
{
  for (const unsigned int i : cycle->solved())
    right_hand_side.local_element(i) = static_cast<float>(source.begin()[i]);
  cycle->apply(solution, right_hand_side);
  for (const unsigned int i : cycle->solved())
    target.begin()[i] += solution.local_element(i);
}

template class PolynomialMultigrid<2>;
template class PolynomialMultigrid<3>;
} // namespace Continua
