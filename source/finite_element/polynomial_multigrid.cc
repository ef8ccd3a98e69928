#include <continua/finite_element/polynomial_multigrid.h>
#include <continua/finite_element/velocity_nodes.h>
#include <continua/linear_algebra/matrix_operator.h>
#include <continua/linear_algebra/matrix_product.h>

#include <algorithm>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
constexpr unsigned int polynomial_degree = 3;
/// Of the largest to the smallest eigenvalue that are damped. The linear velocities take the rest.
constexpr double eigenvalue_ratio = 10.;
} // namespace

template <int dim>
PolynomialMultigrid<dim>::PolynomialMultigrid(
    const Space<dim> &space,
    const BoundaryConstraints<dim> &constraints,
    const typename Product::Coefficients &coefficients,
    const std::vector<bool> &stiff,
    const TrilinosWrappers::SparseMatrix &divergence,
    const DistributedVector &weights,
    std::unique_ptr<TrilinosWrappers::SparseMatrix> supports_of_boundaries,
    const InstructionSet instruction_set)
    : supports(std::move(supports_of_boundaries)),
      linear_velocities(space, constraints, stiff),
      product(make_matrix_free_product<dim, float>(
          instruction_set,
          {space.mapping, space.velocity_dofs, constraints.all(), space.is_axisymmetric()})),
      augmentation(divergence, weights),
      fine(space.velocity_vector()),
      support_force(space.velocity_vector()),
      coarse_source(linear_velocities.vector()),
      coarse_solution(linear_velocities.vector())
{
  product->set({coefficients.mass, coefficients.stiffness, {}});
  for (Vector *const vector : {&right_hand_side, &solution, &residual, &correction})
    product->initialise(*vector);

  product->find_diagonal(residual);
  augmentation.add_diagonal(residual);
  if (supports)
  {
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
      polynomial_degree, eigenvalue_ratio);

  TrilinosWrappers::SparseMatrix coarse_matrix;
  linear_velocities.assemble({coefficients.mass, coefficients.stiffness, coefficients.volumetric},
                             supports.get(), coarse_matrix);
  VelocityBlocks blocks;
  blocks.n_components = dim;
  blocks.modes = rigid_motions(space.mapping, linear_velocities.dofs());
  coarse_cycle =
      std::make_unique<BlockMultigrid>(coarse_matrix, linear_velocities.stiff_rows(), blocks);
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
