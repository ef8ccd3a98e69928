#include <continua/finite_element/solvers/matrix_free_relaxation.h>

namespace Continua
{
template <int dim>
MatrixFreeRelaxation<dim>::MatrixFreeRelaxation(
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
}

template <int dim>
void MatrixFreeRelaxation<dim>::set_volumetric_of_cells(const std::vector<double> &volumetric)
{
  coefficients.volumetric_of_cells = volumetric;
  product->set(coefficients);
  product_at_fluid->set(coefficients);
  product->find_diagonal(target_entries);
  make(target_entries);
}

template <int dim>
void MatrixFreeRelaxation<dim>::add_relaxed(DistributedVector &velocity,
                                            const DistributedVector &residual)
{
  for (unsigned int i = 0; i < residual.locally_owned_size(); ++i)
    source_entries.local_element(i) = static_cast<float>(residual.begin()[i]);
  apply(target_entries, source_entries);
  for (unsigned int i = 0; i < residual.locally_owned_size(); ++i)
    velocity.begin()[i] += target_entries.local_element(i);
}

template <int dim>
void MatrixFreeRelaxation<dim>::leave_residual(DistributedVector &residual,
                                               const DistributedVector &velocity,
                                               const DistributedVector &source)
{
  for (unsigned int i = 0; i < velocity.locally_owned_size(); ++i)
    source_entries.local_element(i) = static_cast<float>(velocity.begin()[i]);
  product->multiply(target_entries, source_entries);
  for (unsigned int i = 0; i < residual.locally_owned_size(); ++i)
    residual.begin()[i] = source.begin()[i] - target_entries.local_element(i);
}

template class MatrixFreeRelaxation<2>;
template class MatrixFreeRelaxation<3>;
} // namespace Continua
