#include <continua/finite_element/solvers/chebyshev_relaxation.h>

namespace Continua
{
using namespace dealii;

namespace
{
constexpr unsigned int polynomial_degree = 2;
/// Of the largest to the smallest eigenvalue that are damped.
constexpr double eigenvalue_ratio = 8.;
} // namespace

template <int dim>
ChebyshevRelaxation<dim>::ChebyshevRelaxation(
    const Product &cells,
    const typename Product::Coefficients &coefficients_of_regions,
    const std::vector<unsigned int> &fluid)
    : product(cells.share()), product_at_fluid(cells.share()), coefficients(coefficients_of_regions)
{
  product->initialise(source_entries);
  product->initialise(target_entries);
  is_fluid.assign(source_entries.locally_owned_size(), false);
  for (const unsigned int i : fluid)
    is_fluid[i] = true;
  product_at_fluid->restrict_to(is_fluid);
  set_volumetric_of_cells({});
}

template <int dim>
void ChebyshevRelaxation<dim>::set_volumetric_of_cells(const std::vector<double> &volumetric)
{
  coefficients.volumetric_of_cells = volumetric;
  product->set(coefficients);
  product_at_fluid->set(coefficients);
  product->find_diagonal(target_entries);
  source_entries = 0.f;
  for (unsigned int i = 0; i < is_fluid.size(); ++i)
    if (is_fluid[i] && target_entries.local_element(i) > 0.f) // else constrained
      source_entries.local_element(i) = 1.f / target_entries.local_element(i);
  polynomial = std::make_unique<ChebyshevPolynomial>(
      [this](Vector &target, const Vector &source) { product_at_fluid->multiply(target, source); },
      source_entries, polynomial_degree, eigenvalue_ratio);
}

template <int dim>
void ChebyshevRelaxation<dim>::add_relaxed(DistributedVector &velocity,
                                           const DistributedVector &residual)
{
  for (unsigned int i = 0; i < residual.locally_owned_size(); ++i)
    source_entries.local_element(i) = static_cast<float>(residual.begin()[i]);
  polynomial->apply(target_entries, source_entries);
  for (unsigned int i = 0; i < residual.locally_owned_size(); ++i)
    velocity.begin()[i] += target_entries.local_element(i);
}

template <int dim>
void ChebyshevRelaxation<dim>::leave_residual(DistributedVector &residual,
                                              const DistributedVector &velocity,
                                              const DistributedVector &source)
{
  for (unsigned int i = 0; i < velocity.locally_owned_size(); ++i)
    source_entries.local_element(i) = static_cast<float>(velocity.begin()[i]);
  product->multiply(target_entries, source_entries);
  for (unsigned int i = 0; i < residual.locally_owned_size(); ++i)
    residual.begin()[i] = source.begin()[i] - target_entries.local_element(i);
}

template class ChebyshevRelaxation<2>;
template class ChebyshevRelaxation<3>;
} // namespace Continua
