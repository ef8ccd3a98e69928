#ifndef continua_continuum_products_by_region_h
#define continua_continuum_products_by_region_h

#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
/**
 * The products of the linear terms with the matrices of a region: mass M, stiffness S, gradient G,
 * divergence B and mass of pressures M_p, all free of moduli and of the time step. Products
 * overwrite their target. All are collective; functions that give this rank's part say so.
 */
class ProductsByRegion
{
public:
  virtual ~ProductsByRegion() = default;

  /// M U [kg m/s over density].
  virtual void multiply_mass(unsigned int region,
                             DistributedVector &momentum,
                             const DistributedVector &velocity) const = 0;
  /// S w: minus the forces of the stress 2 dev sym grad w [N for Pa m].
  virtual void multiply_stiffness(unsigned int region,
                                  DistributedVector &force,
                                  const DistributedVector &mixture) const = 0;
  /// Whether the linear terms of a region are these two products, B U and G p, and nothing else, so
  /// that products of sums may be sums of products.
  virtual bool has_level_products() const { return false; }
  /// Sets M v, S v and S w at once, of a velocity and a displacement; null targets are left out.
  virtual void multiply_levels(unsigned int region,
                               const DistributedVector &velocity,
                               const DistributedVector &displacement,
                               DistributedVector *mass_of_velocity,
                               DistributedVector *stiffness_of_velocity,
                               DistributedVector *stiffness_of_displacement) const;
  /// G p: minus the forces of the pressure [N].
  virtual void multiply_gradient(unsigned int region,
                                 DistributedVector &force,
                                 const DistributedVector &pressure) const = 0;
  /// B U: the rate of dilatation, weakly [m^3/s].
  virtual void multiply_divergence(unsigned int region,
                                   DistributedVector &rate,
                                   const DistributedVector &velocity) const = 0;
  /// M_p p [Pa m^3].
  virtual void multiply_pressure_mass(unsigned int region,
                                      DistributedVector &product,
                                      const DistributedVector &pressure) const = 0;
  /// Minus the forces by which what is around a region pushes back, of a displacement and of a
  /// velocity [N]. For discretisations that have supports, with Problem::has_supports().
  virtual void multiply_support_stiffness(unsigned int region,
                                          DistributedVector &force,
                                          const DistributedVector &displacement) const;
  virtual void multiply_support_damping(unsigned int region,
                                        DistributedVector &force,
                                        const DistributedVector &velocity) const;
  /// This rank's part of U . G p [W].
  virtual double pressure_power(unsigned int region,
                                const DistributedVector &velocity,
                                const DistributedVector &pressure) = 0;
  /// This rank's part of the integral of p q over the region [Pa^2 m^3].
  virtual double
  pressure_product(unsigned int region, const DistributedVector &p, const DistributedVector &q) = 0;
  /// Largest |div U| weakly (|B U| over M_p) [1/s].
  virtual double divergence(const DistributedVector &velocity) = 0;
};
} // namespace Continua

#endif
