#ifndef continua_continuum_bulk_history_h
#define continua_continuum_bulk_history_h

#include <continua/continuum/state_visitor.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/materials/material.h>
#include <continua/time_integration/step.h>

#include <vector>

namespace Continua
{
/**
 * The memory of materials whose volume change relaxes: p = -sum_k K_k e_k with the internal
 * dilatations de_k/dt = div U - e_k/tau_k as vectors like the pressure, the counterpart of
 * BranchHistory. The rate of dilatation d at the nodes is the projection of div U that the mass
 * equation of the region makes: K' d = p_plus - p, with K' = sum_k K_k (velocity coefficient of the
 * branch) and p_plus = -sum_k K_k e_plus_k, so that M_p d = B U. Regions whose volume changes
 * elastically have no part in it.
 */
class BulkHistory
{
public:
  /// `materials` by material id; they must outlive this.
  explicit BulkHistory(const std::vector<Material> &materials);

  /// Zero dilatations on the present mesh, in vectors like `prototype`, a pressure. The nodes of a
  /// region are the local indices of its entries in it.
  void reinit(const DistributedVector &prototype,
              const std::vector<std::vector<unsigned int>> &nodes_of_regions);
  /// The state of a body that was brought to this pressure at once, at rest.
  void start(const DistributedVector &pressure);
  /// The pressure changes at once by this, and the volume with it [Pa].
  void jump(const DistributedVector &pressure_change);

  /// Whether a region's volume change relaxes.
  bool has(const unsigned int region) const
  {
    return !materials[region].compression.bulk_branches().empty();
  }
  /// K' [Pa s].
  static double step_modulus(const Material &material, const Step &step);
  /// 1/(K b) of the step for any material [1/(Pa s)]: of a volume change that relaxes 1/K'.
  static double step_compressibility(const Material &material, const Step &step);
  /// p_plus at the region's nodes [Pa]; elsewhere `pressure` is left as it is.
  void predict(unsigned int region, const Step &step, DistributedVector &pressure) const;
  /// Carries the dilatations to the end of the step, from the pressure at the balanced level.
  void advance(const Step &step, const DistributedVector &pressure);

  /// Internal dilatation of a region's branch [1], at the balanced level of the step that was made
  /// last, and what of the rate of dilatation the branch forgets, d - de/dt [1/s].
  void balanced_dilatation(unsigned int region,
                           unsigned int branch,
                           const Step &step,
                           DistributedVector &dilatation) const;
  void forgotten_rate(unsigned int region,
                      unsigned int branch,
                      const Step &step,
                      DistributedVector &forgotten) const;
  /// Internal dilatation at the present time [1].
  const DistributedVector &internal_dilatation(unsigned int region, unsigned int branch) const
  {
    return of_region[region].dilatations[branch].present;
  }

  /// Hands over all that a step changes.
  void visit(StateVisitor &visitor);

private:
  struct Dilatation
  {
    DistributedVector present, older; ///< as in BranchHistory
  };
  struct Region
  {
    std::vector<unsigned int> nodes;     ///< local indices of its pressures
    std::vector<Dilatation> dilatations; ///< by bulk branch
    DistributedVector rate;              ///< d at the end of the last step [1/s]
    DistributedVector balanced_rate;     ///< d at its balanced level
  };
  const std::vector<Material> &materials;
  std::vector<Region> of_region;
};
} // namespace Continua

#endif
