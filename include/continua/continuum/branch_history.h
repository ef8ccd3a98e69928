#ifndef continua_continuum_branch_history_h
#define continua_continuum_branch_history_h

#include <continua/continuum/state_visitor.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/materials/deformation.h>
#include <continua/materials/material.h>
#include <continua/time_integration/step.h>

#include <vector>

namespace Continua
{
/**
 * The internal displacements D of all branches as plain vectors like the velocity, so that history
 * needs no storage at quadrature points and moves with the mesh like any field. Branches of the
 * same relaxation time, in whatever material, obey the same equation dD/dt = U - D/tau and share
 * one vector; the vector number 0 never relaxes and is the displacement [m] of the whole body,
 * fluid included. A branch that relaxes is zero but at the nodes of the regions that have it, and
 * there it is kept a second time, node after node: a step touches nothing else, so that ten
 * branches in a thin wall cost next to nothing. The vectors follow when they are asked for.
 */
class BranchHistory
{
public:
  /// `materials` by material id; they must outlive this. In finite deformation the displacement is
  /// all: what relaxes has its memory at quadrature points.
  explicit BranchHistory(const std::vector<Material> &materials,
                         Deformation deformation = Deformation::small);

  /// Zero branches on the present mesh, in vectors like `prototype`, a velocity. The nodes of a
  /// region are the local indices of its entries in it; neighbours may share some.
  void reinit(const DistributedVector &prototype,
              const std::vector<std::vector<unsigned int>> &nodes_of_regions);

  /// sum_k mu_k D_plus_k of a region [Pa m], the part of the branches' force that the step knows in
  /// advance, from the velocity at its start. False, and `mixture` untouched, if the region has no
  /// branches; else `mixture` is set at the region's nodes only, and so by the other functions.
  bool predict(unsigned int region,
               const Step &step,
               const DistributedVector &velocity_old,
               DistributedVector &mixture) const;
  /// D_plus of the displacement [m]: what it is at the balanced level without the velocity there.
  void predict_displacement(const Step &step,
                            const DistributedVector &velocity_old,
                            DistributedVector &displacement) const;
  /// Carries all branches to the end of the step, from the velocity at its start and at the
  /// balanced level.
  void advance(const Step &step,
               const DistributedVector &velocity_old,
               const DistributedVector &velocity);
  /// sum_k mu_k D_k at the balanced level of the step that was made last.
  bool mix_balanced(unsigned int region, const Step &step, DistributedVector &mixture) const;
  /// The same at the present time.
  bool mix(unsigned int region, DistributedVector &mixture) const;

  /// D of a relaxation time at the balanced level of the step that was made last [m]; of one that
  /// is not infinite at the nodes of the regions that have it.
  void balanced_displacement(double relaxation_time,
                             const Step &step,
                             DistributedVector &displacement) const;
  /// U - dD/dt there [m/s]: what of the motion the branch forgets, D / tau where the scheme obeys
  /// the branch's equation at that level.
  void forgotten_velocity(double relaxation_time,
                          const Step &step,
                          const DistributedVector &velocity,
                          DistributedVector &forgotten) const;

  /// sum_k mu_k (velocity coefficient of the branch): the material's share of alpha (equation 7.4)
  /// [Pa s].
  static double step_stiffness(const Material &material, const Step &step);

  /// b of D = D_plus + b U of the displacement [s].
  static double step_displacement(const Step &step);

  /// Whether a region has branches, and none that relaxes.
  bool is_elastic(const unsigned int region) const
  {
    return !materials[region].shear.branches.empty() && regions[region].branches.empty();
  }
  /// Shear modulus of the branches of a region that never relax [Pa].
  double spring(const unsigned int region) const { return regions[region].spring; }
  /// D of a relaxation time, at the present time.
  const DistributedVector &internal_displacement(double relaxation_time) const;
  DistributedVector &displacement() { return branches[0].present; }
  const DistributedVector &displacement() const { return branches[0].present; }
  /// One step before.
  const DistributedVector &displacement_older() const { return branches[0].older; }
  /// Relaxation times for which the step takes the exponential update.
  std::vector<double> exponential_branches(const Step &step) const;

  /// Hands over all that a step changes. What a visitor that takes vectors sets in them is what the
  /// next step starts from.
  void visit(StateVisitor &visitor);

private:
  struct Branch
  {
    double relaxation_time;
    mutable DistributedVector present; ///< D at the step's start; after advance() at its end
    mutable DistributedVector older;   ///< D one step before
  };
  /// A branch that relaxes, at the nodes of its region.
  struct NodalBranch
  {
    unsigned int branch; ///< the number of its vectors
    double shear_modulus, relaxation_time;
    std::vector<double> present, older;
  };
  struct Region
  {
    std::vector<unsigned int> nodes; ///< local indices of its entries
    double spring = 0.;              ///< shear modulus of what never relaxes [Pa]
    std::vector<NodalBranch> branches;
    std::vector<double> sum; ///< work space
  };
  const std::vector<Material> &materials;
  std::vector<Branch> branches;
  mutable std::vector<Region> regions;
  /// Which of the two has the present state: the vectors, what is kept at the nodes, or both.
  mutable bool vectors_are_current = true, nodes_are_current = true;
  std::vector<double> start_at_nodes, balanced_at_nodes; ///< work space

  unsigned int find(double relaxation_time) const;
  /// Bring the one from the other where it is not current.
  void update_vectors() const;
  void update_nodes() const;
  /// Sets `mixture` at the region's nodes to the sum of mu_k (w.present D_k + w.older D_older_k)
  /// over its branches, w = weights(tau_k); false if there are none.
  template <typename WeightsOf>
  bool
  mix_values(unsigned int region, DistributedVector &mixture, const WeightsOf &weights_of) const;
  /// Sets `vector` at the nodes that have the branch to value(present, older, i), i their index.
  template <typename Value>
  void set_at_nodes(double relaxation_time, DistributedVector &vector, const Value &value) const;
};
} // namespace Continua

#endif
