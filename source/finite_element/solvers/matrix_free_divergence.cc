#include <continua/finite_element/solvers/matrix_free_divergence.h>

#include <algorithm>
#include <utility>

namespace Continua
{
template <int dim>
MatrixFreeDivergence<dim>::MatrixFreeDivergence(const Space<dim> &space,
                                                std::shared_ptr<const Product> product_of_cells)
    : space(space),
      product(std::move(product_of_cells)),
      pressure_entries(space.pressure_owned, space.pressure_relevant, space.communicator)
{
  volume_sums.reinit(pressure_entries, space.pressure_owned, space.pressure_hanging);
  product->initialise(velocity_entries);
}

template <int dim>
void MatrixFreeDivergence<dim>::multiply(DistributedVector &target,
                                         const DistributedVector &source) const
{
  std::copy(source.begin(), source.end(), velocity_entries.begin());
  product->add_divergence(volume_sums.by_place(), velocity_entries);
  target = 0.;
  volume_sums.add_to(target);
}

template <int dim>
void MatrixFreeDivergence<dim>::multiply_transposed(DistributedVector &target,
                                                    const DistributedVector &source) const
{
  space.copy_pressure(source, pressure_entries);
  product->multiply_gradient(velocity_entries, pressure_entries.begin());
  std::copy(velocity_entries.begin(), velocity_entries.end(), target.begin());
}

template <int dim>
void MatrixFreeDivergence<dim>::multiply_with(const MatrixFreeVelocity<dim> &a,
                                              DistributedVector &momentum,
                                              DistributedVector &mass,
                                              const DistributedVector &velocity,
                                              const DistributedVector &pressure) const
{
  space.copy_pressure(pressure, pressure_entries);
  a.multiply_coupled(momentum, volume_sums.by_place(), velocity, pressure_entries.begin());
  mass = 0.;
  volume_sums.add_to(mass);
}

template class MatrixFreeDivergence<2>;
template class MatrixFreeDivergence<3>;
} // namespace Continua
