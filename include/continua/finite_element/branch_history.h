#ifndef continua_finite_element_branch_history_h
#define continua_finite_element_branch_history_h

#include <continua/base/archive.h>
#include <continua/finite_element/space.h>
#include <continua/materials/material.h>
#include <continua/time_integration/step.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * The internal displacements D of all branches as plain velocity-space vectors, so that history
 * needs no storage at quadrature points and moves with the mesh like any field. Branches of the
 * same relaxation time, in whatever material, obey the same equation dD/dt = U - D/tau and share
 * one vector; the vector number 0 never relaxes and is the displacement [m] of the whole body,
 * fluid included.
 */
class BranchHistory
{
public:
  explicit BranchHistory(const std::vector<Material> &materials);

  template <int dim>
  void reinit(const Space<dim> &space);

  /// D_plus of every branch for this step, from the state at its start and U there [m].
  void predict(const Step &step, const DistributedVector &velocity_old);
  /// D at the balanced level from U there.
  void correct(const Step &step, const DistributedVector &velocity);
  /// sum_k mu_k D_k of a material [Pa m], of D_plus after predict() and at the balanced level after
  /// correct(); false, and `mixture` untouched, if it has no branches.
  bool mix_balanced(const Material &material, DistributedVector &mixture) const;
  /// Moves on to the end of the step.
  void finish(const Step &step);
  /// The same at the present time.
  bool mix(const Material &material, DistributedVector &mixture) const;

  /// sum_k mu_k (velocity coefficient of the branch): the material's share of alpha (equation 7.4)
  /// [Pa s].
  double step_stiffness(const Material &material, const Step &step) const;

  /// D of a relaxation time, at the present time.
  const DistributedVector &internal_displacement(double relaxation_time) const;
  DistributedVector &displacement() { return branches[0].present; }
  const DistributedVector &displacement() const { return branches[0].present; }
  /// Relaxation times for which the step takes the exponential update.
  std::vector<double> exponential_branches(const Step &step) const;

  /// All vectors that a change of the mesh must carry over.
  std::vector<DistributedVector *> vectors();
  void save(ArchiveWriter &archive) const;
  void load(const ArchiveReader &archive);

private:
  struct Branch
  {
    double relaxation_time;
    DistributedVector present;  ///< D at the step's start; after finish() at its end
    DistributedVector older;    ///< D one step before
    DistributedVector balanced; ///< D_plus, then D at the balanced level
  };
  std::vector<Branch> branches;

  const Branch &find(double relaxation_time) const;
  template <typename Select>
  bool
  mix_vectors(const Material &material, DistributedVector &mixture, const Select &select) const;
};
} // namespace Continua

#endif
