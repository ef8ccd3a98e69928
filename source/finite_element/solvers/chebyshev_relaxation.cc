#include <continua/finite_element/solvers/chebyshev_relaxation.h>

namespace Continua
{
namespace
{
constexpr unsigned int polynomial_degree = 2;
/// Of the largest to the smallest eigenvalue that are damped.
constexpr double eigenvalue_ratio = 8.;
} // namespace

template <int dim>
ChebyshevRelaxation<dim>::ChebyshevRelaxation(const Product &cells,
                                              const typename Product::Coefficients &coefficients,
                                              const std::vector<unsigned int> &fluid)
    : MatrixFreeRelaxation<dim>(cells, coefficients, fluid)
{
  this->set_volumetric_of_cells({});
}

template <int dim>
void ChebyshevRelaxation<dim>::make(const Vector &diagonal)
{
  Vector inverse_diagonal(diagonal);
  inverse_diagonal = 0.f;
  for (unsigned int i = 0; i < this->is_fluid.size(); ++i)
    if (this->is_fluid[i] && diagonal.local_element(i) > 0.f) // else constrained
      inverse_diagonal.local_element(i) = 1.f / diagonal.local_element(i);
  polynomial =
      std::make_unique<ChebyshevPolynomial>([this](Vector &target, const Vector &source)
                                            { this->product_at_fluid->multiply(target, source); },
                                            inverse_diagonal, polynomial_degree, eigenvalue_ratio);
}

template <int dim>
void ChebyshevRelaxation<dim>::apply(Vector &solution, const Vector &right_hand_side)
{
  polynomial->apply(solution, right_hand_side);
}

template class ChebyshevRelaxation<2>;
template class ChebyshevRelaxation<3>;
} // namespace Continua
