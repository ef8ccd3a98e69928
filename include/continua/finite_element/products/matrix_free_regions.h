#ifndef continua_finite_element_products_matrix_free_regions_h
#define continua_finite_element_products_matrix_free_regions_h

#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/matrix_free_product.h>
#include <continua/finite_element/products/region_products.h>
#include <continua/finite_element/space/space.h>

#include <memory>
#include <vector>

namespace Continua
{
/// Mass and stiffness of the regions on quadratic velocities, formed anew in each product. The same
/// object also serves for products of a whole step with the boundary constraints, those with the
/// divergence included.
template <int dim>
class MatrixFreeRegions : public RegionProducts
{
public:
  using Product = MatrixFreeProduct<dim, double>;

  /// Space and constraints must outlive it.
  MatrixFreeRegions(const Space<dim> &space,
                    const BoundaryConstraints<dim> &constraints,
                    unsigned int n_regions,
                    InstructionSet instruction_set);

  void multiply(unsigned int region,
                double mass,
                double stiffness,
                DistributedVector &target,
                const DistributedVector &source) const override;
  void mass_diagonal(unsigned int region, DistributedVector &diagonal) const override;
  void stiffness_diagonal(unsigned int region, DistributedVector &diagonal) const override;
  const std::vector<unsigned int> &nodes(const unsigned int region) const override
  {
    return nodes_of_regions[region];
  }
  const std::shared_ptr<Product> &product() const { return cells; }

private:
  const std::shared_ptr<Product> cells;
  std::vector<std::vector<unsigned int>> nodes_of_regions;
  mutable typename Product::Vector source_entries, target_entries;

  void find_nodes(const Space<dim> &space);
};
} // namespace Continua

#endif
