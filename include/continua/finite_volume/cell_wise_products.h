#ifndef continua_finite_volume_cell_wise_products_h
#define continua_finite_volume_cell_wise_products_h

#include <continua/continuum/products_by_region.h>
#include <continua/finite_volume/cell_wise_operators.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <vector>

namespace Continua
{
/// The products of the linear terms with the cell-wise matrices of a region. Where the stress has
/// all of the pressure the forces of a pressure are zero.
template <int dim>
class CellWiseProducts : public ProductsByRegion
{
public:
  /// All must outlive it.
  CellWiseProducts(const CellWiseSpace<dim> &space,
                   const std::vector<CellWiseOperators> &operators,
                   const CellWiseParameters &parameters);

  /// The mesh has changed. Collective.
  void reinit();

  void multiply_mass(unsigned int region,
                     DistributedVector &momentum,
                     const DistributedVector &velocity) const override;
  void multiply_stiffness(unsigned int region,
                          DistributedVector &force,
                          const DistributedVector &mixture) const override;
  void multiply_gradient(unsigned int region,
                         DistributedVector &force,
                         const DistributedVector &pressure) const override;
  void multiply_divergence(unsigned int region,
                           DistributedVector &rate,
                           const DistributedVector &velocity) const override;
  void multiply_pressure_mass(unsigned int region,
                              DistributedVector &product,
                              const DistributedVector &pressure) const override;
  double pressure_power(unsigned int region,
                        const DistributedVector &velocity,
                        const DistributedVector &pressure) override;
  /// Over the cells: faces have equations of state, but no volume.
  double pressure_product(unsigned int region,
                          const DistributedVector &p,
                          const DistributedVector &q) override;
  double divergence(const DistributedVector &velocity) override;

private:
  const CellWiseSpace<dim> &space;
  const std::vector<CellWiseOperators> &operators;
  const CellWiseParameters &parameters;
  DistributedVector velocity_work, pressure_work;
};
} // namespace Continua

#endif
