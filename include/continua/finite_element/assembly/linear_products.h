#ifndef continua_finite_element_assembly_linear_products_h
#define continua_finite_element_assembly_linear_products_h

#include <continua/continuum/nonlinear_system.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/products_by_region.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/linear_algebra/node_product.h>

#include <memory>
#include <vector>

namespace Continua
{
/// The products of the linear terms with the matrices of a region of finite elements. G = -B^T.
template <int dim>
class LinearProducts : public ProductsByRegion
{
public:
  /// All must outlive it.
  LinearProducts(const Space<dim> &space,
                 const Problem &problem,
                 const std::vector<RegionOperators> &operators);

  /// The matrices are those of a new mesh. Collective.
  void reinit();

  std::vector<unsigned int> pressures_without_history() const;
  void multiply_mass(const unsigned int region,
                     DistributedVector &momentum,
                     const DistributedVector &velocity) const override
  {
    operators[region].multiply_mass(momentum, velocity);
  }
  void multiply_stiffness(const unsigned int region,
                          DistributedVector &force,
                          const DistributedVector &mixture) const override
  {
    operators[region].multiply_stiffness(force, mixture);
  }
  /// Where mass and stiffness have matrices, which serve several vectors in one pass.
  bool has_level_products() const override { return !node_products.empty(); }
  void multiply_levels(unsigned int region,
                       const DistributedVector &velocity,
                       const DistributedVector &displacement,
                       DistributedVector *mass_of_velocity,
                       DistributedVector *stiffness_of_velocity,
                       DistributedVector *stiffness_of_displacement) const override
  {
    node_products[region]->multiply(velocity, &displacement, mass_of_velocity,
                                    stiffness_of_velocity, stiffness_of_displacement);
  }
  void multiply_gradient(unsigned int region,
                         DistributedVector &force,
                         const DistributedVector &pressure) const override;
  void multiply_divergence(unsigned int region,
                           DistributedVector &rate,
                           const DistributedVector &velocity) const override;
  void multiply_pressure_mass(unsigned int region,
                              DistributedVector &product,
                              const DistributedVector &pressure) const override;
  void multiply_support_stiffness(unsigned int region,
                                  DistributedVector &force,
                                  const DistributedVector &displacement) const override;
  void multiply_support_damping(unsigned int region,
                                DistributedVector &force,
                                const DistributedVector &velocity) const override;
  double pressure_power(unsigned int region,
                        const DistributedVector &velocity,
                        const DistributedVector &pressure) override;
  double pressure_product(unsigned int region,
                          const DistributedVector &p,
                          const DistributedVector &q) override;
  double divergence(const DistributedVector &velocity) override;

  /// The largest row of B^T p of pressures, and of B U of velocities, by the largest stress [Pa]
  /// and the largest velocity [m/s].
  ResidualScales scales(const double stress, const double velocity) const
  {
    return {gradient_norm * stress, divergence_norm * velocity};
  }

private:
  const Space<dim> &space;
  const Problem &problem;
  const std::vector<RegionOperators> &operators;
  std::vector<std::unique_ptr<NodeProduct<dim>>> node_products; ///< none without matrices
  DistributedVector pressure_work;
  /// Of B U by the largest velocity [m^2], and of B^T p by the largest pressure [m^2].
  double divergence_norm = 0., gradient_norm = 0.;
};
} // namespace Continua

#endif
