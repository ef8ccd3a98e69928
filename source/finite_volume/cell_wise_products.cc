#include <continua/finite_volume/cell_wise_products.h>

#include <continua/continuum/local_product.h>
#include <continua/linear_algebra/matrix_product.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
/// target = weight times source, entry by entry.
void scale(const DistributedVector &weight,
           DistributedVector &target,
           const DistributedVector &source)
{
  for (unsigned int i = 0; i < weight.locally_owned_size(); ++i)
    target.begin()[i] = weight.begin()[i] * source.begin()[i];
}
} // namespace

template <int dim>
CellWiseProducts<dim>::CellWiseProducts(const CellWiseSpace<dim> &space,
                                        const std::vector<CellWiseOperators> &operators,
                                        const CellWiseParameters &parameters)
    : space(space), operators(operators), parameters(parameters)
{
}

template <int dim>
void CellWiseProducts<dim>::reinit()
{
  velocity_work = space.velocity_vector();
  pressure_work = space.pressure_vector();
}

template <int dim>
void CellWiseProducts<dim>::multiply_mass(const unsigned int region,
                                          DistributedVector &momentum,
                                          const DistributedVector &velocity) const
{
  scale(operators[region].volume, momentum, velocity);
}

template <int dim>
void CellWiseProducts<dim>::multiply_stiffness(const unsigned int region,
                                               DistributedVector &force,
                                               const DistributedVector &mixture) const
{
  multiply(operators[region].stiffness, force, mixture);
}

template <int dim>
void CellWiseProducts<dim>::multiply_gradient(const unsigned int region,
                                              DistributedVector &force,
                                              const DistributedVector &pressure) const
{
  if (parameters.has_pressure())
    multiply(operators[region].gradient, force, pressure);
  else
    force = 0.;
}

template <int dim>
void CellWiseProducts<dim>::multiply_divergence(const unsigned int region,
                                                DistributedVector &rate,
                                                const DistributedVector &velocity) const
{
  multiply(operators[region].divergence, rate, velocity);
}

template <int dim>
void CellWiseProducts<dim>::multiply_pressure_mass(const unsigned int region,
                                                   DistributedVector &product,
                                                   const DistributedVector &pressure) const
{
  scale(operators[region].pressure_volume, product, pressure);
}

template <int dim>
double CellWiseProducts<dim>::pressure_power(const unsigned int region,
                                             const DistributedVector &velocity,
                                             const DistributedVector &pressure)
{
  multiply_gradient(region, velocity_work, pressure);
  return local_product(velocity_work, velocity);
}

template <int dim>
double CellWiseProducts<dim>::pressure_product(const unsigned int region,
                                               const DistributedVector &p,
                                               const DistributedVector &q)
{
  double sum = 0.;
  const double *const volume = operators[region].pressure_volume.begin();
  for (unsigned int i = 0; i < space.mesh.n_owned_cells() && parameters.has_pressure(); ++i)
    sum += p.begin()[i] * volume[i] * q.begin()[i];
  return sum;
}

template <int dim>
double CellWiseProducts<dim>::divergence(const DistributedVector &velocity)
{
  double largest = 0.;
  for (const CellWiseOperators &of_region : operators)
  {
    multiply(of_region.divergence, pressure_work, velocity);
    for (unsigned int i = 0; i < space.mesh.n_owned_cells(); ++i)
      if (of_region.pressure_volume.begin()[i] > 0.)
        largest = std::max(
            largest, std::abs(pressure_work.begin()[i] / of_region.pressure_volume.begin()[i]));
  }
  return Utilities::MPI::max(largest, space.communicator);
}

template class CellWiseProducts<2>;
template class CellWiseProducts<3>;
} // namespace Continua
