#include <continua/finite_element/assembly/linear_products.h>

#include <continua/continuum/local_product.h>
#include <continua/linear_algebra/matrix_product.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

template <int dim>
LinearProducts<dim>::LinearProducts(const Space<dim> &space,
                                    const Problem &problem,
                                    const std::vector<RegionOperators> &operators)
    : space(space), problem(problem), operators(operators)
{
}

template <int dim>
void LinearProducts<dim>::reinit()
{
  pressure_work = space.pressure_vector();
  divergence_norm = gradient_norm = 0.;
  for (const RegionOperators &region : operators)
  {
    divergence_norm += region.divergence.linfty_norm();
    gradient_norm += region.divergence.l1_norm();
  }
  node_products.clear();
  for (const RegionOperators &region : operators)
    if (!region.products)
      node_products.push_back(std::make_unique<NodeProduct<dim>>(region.mass, region.stiffness));
}

template <int dim>
std::vector<unsigned int> LinearProducts<dim>::pressures_without_history() const
{
  DistributedVector compressible = space.pressure_vector(), one = compressible,
                    volume = compressible;
  one = 1.;
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (!problem.materials[region].is_incompressible())
    {
      multiply(operators[region].pressure_mass, volume, one);
      compressible.add(1., volume);
    }
  std::vector<unsigned int> indices;
  for (unsigned int i = 0; i < space.pressure_owned.n_elements(); ++i)
    if (compressible.begin()[i] == 0.)
      indices.push_back(i);
  return indices;
}

template <int dim>
void LinearProducts<dim>::multiply_gradient(const unsigned int region,
                                            DistributedVector &force,
                                            const DistributedVector &pressure) const
{
  multiply_transposed(operators[region].divergence, force, pressure);
  force *= -1.;
}

template <int dim>
void LinearProducts<dim>::multiply_divergence(const unsigned int region,
                                              DistributedVector &rate,
                                              const DistributedVector &velocity) const
{
  multiply(operators[region].divergence, rate, velocity);
}

template <int dim>
void LinearProducts<dim>::multiply_pressure_mass(const unsigned int region,
                                                 DistributedVector &product,
                                                 const DistributedVector &pressure) const
{
  multiply(operators[region].pressure_mass, product, pressure);
}

template <int dim>
void LinearProducts<dim>::multiply_support_stiffness(const unsigned int region,
                                                     DistributedVector &force,
                                                     const DistributedVector &displacement) const
{
  if (operators[region].is_supported)
    multiply(operators[region].support_stiffness, force, displacement);
  else
    force = 0.;
}

template <int dim>
void LinearProducts<dim>::multiply_support_damping(const unsigned int region,
                                                   DistributedVector &force,
                                                   const DistributedVector &velocity) const
{
  if (operators[region].is_supported)
    multiply(operators[region].support_damping, force, velocity);
  else
    force = 0.;
}

template <int dim>
double LinearProducts<dim>::pressure_power(const unsigned int region,
                                           const DistributedVector &velocity,
                                           const DistributedVector &pressure)
{
  // Cheaper than a product with the transposed.
  multiply(operators[region].divergence, pressure_work, velocity);
  return -local_product(pressure_work, pressure);
}

template <int dim>
double LinearProducts<dim>::pressure_product(const unsigned int region,
                                             const DistributedVector &p,
                                             const DistributedVector &q)
{
  multiply(operators[region].pressure_mass, pressure_work, p);
  return local_product(pressure_work, q);
}

template <int dim>
double LinearProducts<dim>::divergence(const DistributedVector &velocity)
{
  DistributedVector rate = space.pressure_vector(), volume = rate, one = rate;
  for (const auto index : space.pressure_owned)
    if (!space.pressure_hanging.is_constrained(index))
      one[index] = 1.;
  one.compress(VectorOperation::insert);
  for (const RegionOperators &region : operators)
  {
    multiply(region.divergence, pressure_work, velocity);
    rate.add(1., pressure_work);
    multiply(region.pressure_mass, pressure_work, one);
    volume.add(1., pressure_work);
  }
  double largest = 0.;
  for (unsigned int i = 0; i < rate.locally_owned_size(); ++i)
    if (one.begin()[i] > 0.)
      largest = std::max(largest, std::abs(rate.begin()[i] / volume.begin()[i]));
  return Utilities::MPI::max(largest, space.communicator);
}

template class LinearProducts<2>;
template class LinearProducts<3>;
} // namespace Continua
