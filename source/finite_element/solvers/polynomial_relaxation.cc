#include <continua/finite_element/solvers/polynomial_relaxation.h>

namespace Continua
{
using namespace dealii;

template <int dim>
PolynomialRelaxation<dim>::PolynomialRelaxation(const Product &cells,
                                                const Space<dim> &space,
                                                const BoundaryConstraints<dim> &constraints,
                                                const typename Product::Coefficients &coefficients,
                                                const std::vector<unsigned int> &fluid,
                                                const double most_factor_bytes)
    : MatrixFreeRelaxation<dim>(cells, coefficients, fluid),
      space(space),
      constraints(constraints),
      most_factor_bytes(most_factor_bytes),
      linear_velocities(space, constraints.all(), this->is_fluid)
{
  this->set_volumetric_of_cells({});
}

template <int dim>
void PolynomialRelaxation<dim>::make(const Vector &diagonal)
{
  const auto &given = this->coefficients;
  typename MatrixFreeProduct<dim, double>::Coefficients of_linear{
      given.mass, given.stiffness, given.volumetric, given.volumetric_of_cells};
  TrilinosWrappers::SparseMatrix coarse_matrix;
  linear_velocities.assemble(of_linear, nullptr, coarse_matrix);
  cycle = nullptr; // two factors would need twice the memory
  cycle = std::make_unique<PolynomialCycle<dim>>(
      space, constraints.all(), linear_velocities, this->is_fluid, given.mass.size(),
      [this](Vector &target, const Vector &source)
      { this->product_at_fluid->multiply(target, source); },
      diagonal, coarse_matrix, most_factor_bytes);
}

template <int dim>
void PolynomialRelaxation<dim>::apply(Vector &solution, const Vector &right_hand_side)
{
  cycle->apply(solution, right_hand_side);
}

template class PolynomialRelaxation<2>;
template class PolynomialRelaxation<3>;
} // namespace Continua
