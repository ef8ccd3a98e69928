#ifndef continua_finite_element_solvers_iterative_stiff_regions_h
#define continua_finite_element_solvers_iterative_stiff_regions_h

#include <continua/continuum/system_coefficients.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/linear_algebra/velocity_blocks.h>
#include <continua/linear_algebra/velocity_operator.h>
#include <continua/linear_algebra/velocity_preconditioner.h>

#include <vector>

namespace Continua
{
/**
 * Which regions of a step's system are stiff, and what belongs to them.
 *
 * Regions are stiff where alpha/(a0 rho) is more than `stiff_ratio` times the square of the mesh
 * size (by the diagonals of the matrices), and alpha not below `comparable` of the largest: of a
 * tube the wall, of a body without a fluid all of it.
 */
template <int dim>
class StiffRegions
{
public:
  /// All must outlive it. Collective.
  StiffRegions(const Space<dim> &space,
               const std::vector<RegionOperators> &operators,
               const SystemCoefficients &coefficients);

  /// Whether a region is stiff.
  bool operator[](const unsigned int region) const { return is_stiff_region[region]; }

  /// The velocities of stiff regions, interfaces included, and the others. `velocity`: A. Sets the
  /// mobility D of each velocity, one over what resists a pressure [s/kg], and the largest ratio of
  /// the diagonals of alpha S and a0 rho M of the others [1]. Collective.
  VelocityBlocks velocity_blocks(const VelocityOperator &velocity,
                                 DistributedVector &mobility,
                                 double &fluid_ratio) const;
  /// Local indices of the pressures that belong to stiff regions alone.
  std::vector<unsigned int> pressures() const;
  /// Raises D [s/kg] at the interfaces of stiff regions with others by the compliance of the walls.
  /// Collective.
  void add_wall_compliance(const BoundaryConstraints<dim> &constraints,
                           VelocityPreconditioner &velocity_inverse,
                           DistributedVector &mobility) const;

private:
  /// Largest ratio of the diagonals of alpha S and a0 rho M for which relaxation is enough.
  static constexpr double stiff_ratio = 10.;
  static constexpr double comparable = 1e-3;

  const Space<dim> &space;
  const std::vector<RegionOperators> &operators;
  const SystemCoefficients &coefficients;
  // By region:
  std::vector<DistributedVector> mass_diagonals, stiffness_diagonals;
  std::vector<std::vector<bool>> is_of_region; ///< of each owned velocity
  std::vector<bool> is_stiff_region;
};
} // namespace Continua

#endif
