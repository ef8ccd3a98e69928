#include <continua/finite_element/motion/mesh_multigrid.h>

#include <continua/linear_algebra/conjugate_gradients.h>
#include <continua/linear_algebra/function_as_matrix.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

namespace
{
/// Of a factor of the linear displacements, for each unknown of the mesh [bytes].
constexpr double most_bytes_of_factor = 250.;
/// With P of MeshStress in the undeformed mesh, 2 k dev eps + lambda div d: lambda over k.
constexpr double mean_of_hyperelastic = 2. / 3., mean_of_elastic = 2. / 3. + 2.;
} // namespace

template <int dim>
MeshMultigrid<dim>::MeshMultigrid(const Space<dim> &space, const Input &input)
    : product(make_matrix_free_mesh<dim>(
          input.instruction_set,
          {space.mapping, space.velocity_dofs, input.constraints, space.velocity_hanging,
           space.is_axisymmetric(), input.is_hyperelastic, input.stiffness, input.has_given})),
      undeformed_product(make_matrix_free_product<dim, float>(
          input.instruction_set,
          {space.mapping, space.velocity_dofs, input.constraints, space.is_axisymmetric()}))
{
  for (Vector *const vector : {&given_entries, &given_rows})
    product->initialise_given(*vector);
  for (Vector *const vector : {&source, &target})
    product->initialise_free(*vector);
  make_cycle(space, input);
}

template <int dim>
void MeshMultigrid<dim>::make_cycle(const Space<dim> &space, const Input &input)
{
  // The nodes of the body.
  DistributedVector marks = space.velocity_vector();
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  const std::vector<double> ones(indices.size(), 1.);
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned() && input.stiffness[cell->active_cell_index()] > 0.)
    {
      cell->get_dof_indices(indices);
      marks.add(indices, ones);
    }
  marks.compress(VectorOperation::add);
  std::vector<bool> is_of_body(marks.locally_owned_size());
  for (unsigned int i = 0; i < is_of_body.size(); ++i)
    is_of_body[i] = marks.begin()[i] > 0. && !space.velocity_hanging.is_constrained(
                                                 space.velocity_owned.nth_index_in_set(i));

  typename Product::Coefficients coefficients;
  coefficients.mass.assign(input.n_regions, 0.);
  coefficients.stiffness = coefficients.mass;
  coefficients.stiffness_of_cells = coefficients.volumetric_of_cells = input.stiffness;
  for (double &lambda : coefficients.volumetric_of_cells)
    lambda *= input.is_hyperelastic ? mean_of_hyperelastic : mean_of_elastic;
  undeformed_product->set(coefficients);
  undeformed_product->restrict_to(is_of_body);
  for (typename Product::Vector *const vector : {&cycle_source, &cycle_solution})
    undeformed_product->initialise(*vector);
  undeformed_product->find_diagonal(cycle_solution);

  linear = std::make_unique<LinearVelocities<dim>>(space, input.constraints, is_of_body);
  TrilinosWrappers::SparseMatrix coarse_matrix;
  typename MatrixFreeProduct<dim, double>::Coefficients of_linear;
  of_linear.mass = coefficients.mass;
  of_linear.stiffness = coefficients.stiffness;
  of_linear.stiffness_of_cells = coefficients.stiffness_of_cells;
  of_linear.volumetric_of_cells = coefficients.volumetric_of_cells;
  linear->assemble(of_linear, nullptr, coarse_matrix);
  cycle = std::make_unique<PolynomialCycle<dim>>(
      space, input.constraints, *linear, is_of_body, input.n_regions,
      [this](typename Product::Vector &to, const typename Product::Vector &from)
      { undeformed_product->multiply(to, from); },
      cycle_solution, coarse_matrix,
      most_bytes_of_factor * static_cast<double>(space.velocity_dofs.n_dofs()));
}

template <int dim>
void MeshMultigrid<dim>::linearise(const DistributedVector &displacement, DistributedVector &rows)
{
  std::copy(displacement.begin(), displacement.end(), given_entries.begin());
  product->set(given_entries);
  product->set_residual(given_rows, given_entries);
  for (unsigned int i = 0; i < rows.locally_owned_size(); ++i)
    rows.begin()[i] = -given_rows.local_element(i);
}

template <int dim>
void MeshMultigrid<dim>::subtract_product(const DistributedVector &given, DistributedVector &rows)
{
  std::copy(given.begin(), given.end(), given_entries.begin());
  product->multiply_given(given_rows, given_entries);
  for (unsigned int i = 0; i < rows.locally_owned_size(); ++i)
    rows.begin()[i] -= given_rows.local_element(i);
}

template <int dim>
void MeshMultigrid<dim>::precondition(Vector &to, const Vector &from)
{
  // Single precision has no small numbers.
  const double size = from.linfty_norm();
  if (size == 0.)
  {
    to = 0.;
    return;
  }
  for (const unsigned int i : cycle->solved())
    cycle_source.local_element(i) = static_cast<float>(from.local_element(i) / size);
  cycle->apply(cycle_solution, cycle_source);
  to = 0.;
  for (const unsigned int i : cycle->solved())
    to.local_element(i) = size * cycle_solution.local_element(i);
}

template <int dim>
void MeshMultigrid<dim>::solve(DistributedVector &solution,
                               const DistributedVector &right_hand_side,
                               const double tolerance)
{
  const auto multiply = [this](Vector &to, const Vector &from) { product->multiply(to, from); };
  const auto cycle_once = [this](Vector &to, const Vector &from) { precondition(to, from); };
  const FunctionAsMatrix<decltype(multiply)> matrix{multiply};
  const FunctionAsMatrix<decltype(cycle_once)> preconditioner{cycle_once};
  std::copy(right_hand_side.begin(), right_hand_side.end(), source.begin());
  std::copy(solution.begin(), solution.end(), target.begin());
  iterations = solve_mesh_by_conjugate_gradients(matrix, preconditioner, target, source, tolerance);
  std::copy(target.begin(), target.end(), solution.begin());
}

template class MeshMultigrid<2>;
template class MeshMultigrid<3>;
} // namespace Continua
