#ifndef continua_finite_element_conditions_boundary_constraints_h
#define continua_finite_element_conditions_boundary_constraints_h

#include <continua/boundary/boundary_condition.h>
#include <continua/continuum/prescribed_velocities.h>
#include <continua/finite_element/space/space.h>

#include <deal.II/base/tensor.h>

#include <map>
#include <string>
#include <vector>

namespace Continua
{
/**
 * The prescribed velocities, node by node. At a node the conditions of all faces that meet there
 * give equations d . u = value (d the normal, the tangents, or all axes), which are reduced by
 * Gauss-Jordan elimination to at most dim independent ones; each then expresses one component by
 * the others of the same node. So u = T u_free + g(t), with T local to a node, on straight and
 * inclined faces alike. An equation that depends on earlier ones but asks for another value is a
 * conflict: the condition that stands first in the parameter file holds, and conflicts() says
 * where.
 */
template <int dim>
class BoundaryConstraints : public PrescribedVelocities
{
public:
  BoundaryConstraints(const Space<dim> &space, const std::vector<BoundaryCondition> &conditions);

  /// Makes the constraints on the present mesh.
  void build();

  /// Hanging nodes and the homogeneous boundary constraints, on the locally relevant dofs.
  const dealii::AffineConstraints<double> &all() const { return constraints; }

  /// T^T: adds each constrained entry to its masters and sets it, and those of hanging nodes, to
  /// zero.
  void restrict_to_free(DistributedVector &residual) const;
  /// T u + g: sets the constrained entries from their masters and `values` (owned vectors).
  void set_constrained(DistributedVector &velocity, const DistributedVector &values) const;
  /// T: the same without values.
  void expand_free(DistributedVector &velocity) const;
  /// u - T u: what a velocity that obeys the constraints has as its g, at the constrained dofs.
  void prescribed_part(const DistributedVector &velocity, DistributedVector &values) const override;
  void set_prescribed(const DistributedVector &prescribed,
                      DistributedVector &velocity) const override
  {
    set_constrained(velocity, prescribed);
  }
  void clear_prescribed(DistributedVector &velocity) const override { expand_free(velocity); }
  /// g(t) at the constrained dofs, 0 elsewhere [m/s].
  void evaluate(double time, DistributedVector &values) const override;
  /// The part of one condition in it.
  void
  evaluate_of(const BoundaryCondition &condition, double time, DistributedVector &values) const;

  bool is_homogeneous() const override { return homogeneous; }
  bool jumps(double begin, double end) const override;
  /// One line for each pair of conditions that ask for different velocities at a node.
  const std::vector<std::string> &conflicts() const { return conflict_texts; }

private:
  /// direction . (value of one half of a condition) at a point.
  struct Source
  {
    const BoundaryPart *part;
    dealii::Tensor<1, dim> direction;
    dealii::Tensor<1, dim> normal;
    double point[3];
    std::vector<double> flow_shapes; ///< of a flow rate, at this node
    double value(double time) const;
  };
  struct Master
  {
    unsigned int index; ///< local
    double coefficient;
  };
  struct Constrained
  {
    unsigned int index; ///< local
    std::vector<Master> masters;
    std::vector<std::pair<unsigned int, double>> sources; ///< weights
    bool time_dependent;
  };

  const Space<dim> &space;
  const std::vector<BoundaryCondition> &conditions;
  dealii::AffineConstraints<double> constraints;
  std::vector<Source> sources;
  std::vector<unsigned int> watched_sources; ///< a few that depend on time, for jumps()
  std::vector<Constrained> constrained;
  std::vector<unsigned int> hanging; ///< local indices of owned hanging nodes' dofs
  std::vector<std::string> conflict_texts;
  bool homogeneous = true;
  mutable bool constants_are_set = false;

  /// Whether a sum of sources is zero at all times; `weights` by number of the source.
  bool vanishes(const std::map<unsigned int, double> &weights) const;
};
} // namespace Continua

#endif
