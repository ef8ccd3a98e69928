#ifndef continua_finite_element_assembly_metric_history_h
#define continua_finite_element_assembly_metric_history_h

#include <continua/continuum/problem.h>
#include <continua/continuum/state_visitor.h>
#include <continua/continuum/vector_numbering.h>
#include <continua/finite_element/space/solution_transfer.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/materials/internal_metric.h>
#include <continua/time_integration/step.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/hp/fe_collection.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * The memory of solids that relax in finite deformation, at the quadrature points: the internal
 * metric A of each branch and Cb^-1 of the last strain (internal_metric.h), all of them 1. They are
 * vectors of a discontinuous element whose nodes are the quadrature points, so that the history
 * moves with the mesh like any field. Branch k of all regions has the vector k. Points are those of
 * QuadratureCells; a cell is named by its number among the active ones.
 */
template <int dim>
class MetricHistory
{
public:
  using Tensor = dealii::SymmetricTensor<2, 3>;

  /// Null where nothing relaxes in finite deformation.
  static std::unique_ptr<MetricHistory> make(const Space<dim> &space, const Problem &problem);

  /// The mesh has changed. The vectors get their size by the visitor of the state.
  void reinit();
  /// Zeros.
  DistributedVector vector() const;
  VectorNumbering numbering() const;
  /// Hands over all that a step changes.
  void visit(StateVisitor &visitor);

  bool relaxes(const unsigned int region) const { return !branches[region].empty(); }
  /// Makes a point that has this Cb^-1 relaxed: without stress of its branches.
  void start(unsigned int cell, unsigned int q, const Tensor &inverse);
  /// Makes one branch of a point relaxed at this Cb^-1.
  void set_branch(unsigned int branch, unsigned int cell, unsigned int q, const Tensor &inverse)
  {
    set(metrics[branch], cell, q, inverse);
  }
  /// Sets what the step knows beforehand. On the way to a steady state all branches have relaxed.
  void predict(const Step &step);
  /// M = sum_k mu_k A_plus_k of the step that was predicted last [Pa], see MetricStress.
  const Tensor &predicted(const unsigned int cell, const unsigned int q) const
  {
    return predictions[cell][q];
  }
  /// What a region's branches turn into heat at the level that the step balances, of the strain
  /// there [W/m^3]. Before advance().
  double dissipation(unsigned int region,
                     unsigned int cell,
                     unsigned int q,
                     const PointStrain &strain) const;
  /// Carries a point to the end of the step, where it has this Cb^-1.
  void advance(unsigned int region, unsigned int cell, unsigned int q, const Tensor &inverse);
  /// Energy of the branches at the present time [J/m^3].
  double
  energy(unsigned int region, unsigned int cell, unsigned int q, const PointStrain &strain) const;

  /// Call when cells are flagged and before the triangulation changes.
  void prepare_transfer(const std::vector<DistributedVector *> &vectors);
  /// Call after reinit() on the new mesh; fills the vectors (of the new size) in the same order.
  /// Where that leaves a tensor that is not positive definite, its cell gets the mean over its
  /// points, or 1 if that is not positive definite either.
  void finish_transfer(const std::vector<DistributedVector *> &vectors);

  /// sum_k mu_k A_k at the present time [Pa] with ghost entries: of its tensor at any point of a
  /// cell the stress is made there.
  DistributedVector ghosted_mixture() const;
  /// Its dofs in a cell and their weights at a point of the unit cell, for mixture_at().
  struct PointWeights
  {
    /// By component of the tensor; empty where nothing relaxes.
    std::vector<std::vector<dealii::types::global_dof_index>> indices;
    std::vector<double> weights;
  };
  PointWeights weights_at(const typename dealii::Triangulation<dim>::cell_iterator &cell,
                          const dealii::Point<dim> &unit_point) const;
  static Tensor mixture_at(const PointWeights &weights, const DistributedVector &mixture);

private:
  MetricHistory(const Space<dim> &space, const Problem &problem);

  const Space<dim> &space;
  unsigned int n_points; ///< of a cell
  /// Of each region, those that relax.
  std::vector<std::vector<Branch>> branches;
  dealii::hp::FECollection<dim> elements; ///< nothing, and the tensor at the points
  dealii::DoFHandler<dim> dof_handler;
  dealii::IndexSet owned, relevant;
  std::vector<DistributedVector> metrics; ///< A of each branch
  DistributedVector inverses;             ///< Cb^-1
  /// [active cell][point, component]: local indices of owned entries; empty where nothing relaxes.
  std::vector<std::vector<unsigned int>> places;
  std::vector<std::vector<Tensor>> predictions;
  /// [region][branch], of the step that was predicted last.
  std::vector<std::vector<MetricWeights>> balanced_weights, step_weights;

  using Transfer = SolutionTransfer<dim, DistributedVector>;
  std::unique_ptr<Transfer> transfer;
  std::vector<DistributedVector> old_vectors;

  void restore_positivity(DistributedVector &vector) const;
  Tensor get(const DistributedVector &vector, unsigned int cell, unsigned int q) const;
  void
  set(DistributedVector &vector, unsigned int cell, unsigned int q, const Tensor &tensor) const;
};
} // namespace Continua

#endif
