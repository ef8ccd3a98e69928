#include <continua/finite_element/solvers/condensed_system.h>
#include <continua/finite_element/solvers/matrix_free_velocity.h>
#include <continua/linear_algebra/matrix_operator.h>
#include <continua/linear_algebra/matrix_product.h>

#include <algorithm>
#include <utility>

namespace Continua
{
using namespace dealii;

template <int dim>
MatrixFreeVelocity<dim>::MatrixFreeVelocity(const Space<dim> &space,
                                            const std::vector<RegionOperators> &operators,
                                            const BoundaryConstraints<dim> &constraints,
                                            std::shared_ptr<Product> product_of_cells)
    : space(space),
      operators(operators),
      constraints(constraints),
      product(std::move(product_of_cells)),
      diagonal_entries(space.velocity_vector()),
      support_forces(space.velocity_vector())
{
  for (unsigned int i = 0; i < space.velocity_owned.n_elements(); ++i)
    if (constraints.all().is_constrained(space.velocity_owned.nth_index_in_set(i)))
      constrained.push_back(i);
  product->initialise(source_entries);
  product->initialise(target_entries);
}

template <int dim>
void MatrixFreeVelocity<dim>::set(const SystemCoefficients &coefficients)
{
  product->set({coefficients.mass, coefficients.stiffness, {}});
  product->find_diagonal(target_entries);
  std::copy(target_entries.begin(), target_entries.end(), diagonal_entries.begin());
  for (const unsigned int i : constrained)
    diagonal_entries.begin()[i] = 1.;
  is_supported = (coefficients.support_stiffness != 0. || coefficients.support_damping != 0.) &&
                 std::any_of(operators.begin(), operators.end(),
                             [](const RegionOperators &region) { return region.is_supported; });
  if (!is_supported)
    return;
  SystemCoefficients of_supports = coefficients;
  of_supports.mass.assign(operators.size(), 0.);
  of_supports.stiffness.assign(operators.size(), 0.);
  assemble_velocity_block(space, operators, constraints, of_supports, nullptr, nullptr, supports);
  const MatrixOperator support_operator(supports);
  for (unsigned int i = 0; i < diagonal_entries.locally_owned_size(); ++i)
    if (!std::binary_search(constrained.begin(), constrained.end(), i))
      diagonal_entries.begin()[i] += support_operator.diagonal().begin()[i];
}

template <int dim>
void MatrixFreeVelocity<dim>::multiply(DistributedVector &target,
                                       const DistributedVector &source) const
{
  std::copy(source.begin(), source.end(), source_entries.begin());
  product->multiply(target_entries, source_entries);
  finish(target, source);
}

template <int dim>
void MatrixFreeVelocity<dim>::multiply_coupled(DistributedVector &momentum,
                                               double *const volume,
                                               const DistributedVector &velocity,
                                               const double *const pressure) const
{
  std::copy(velocity.begin(), velocity.end(), source_entries.begin());
  product->multiply_coupled(target_entries, volume, source_entries, pressure);
  finish(momentum, velocity);
}

template <int dim>
void MatrixFreeVelocity<dim>::finish(DistributedVector &target,
                                     const DistributedVector &source) const
{
  std::copy(target_entries.begin(), target_entries.end(), target.begin());
  if (is_supported)
  {
    Continua::multiply(supports, support_forces, source);
    target.add(1., support_forces);
  }
  for (const unsigned int i : constrained)
    target.begin()[i] = source.begin()[i];
}

template class MatrixFreeVelocity<2>;
template class MatrixFreeVelocity<3>;
} // namespace Continua
