#ifndef continua_finite_element_looking_field_samples_h
#define continua_finite_element_looking_field_samples_h

#include <continua/continuum/field_list.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state.h>
#include <continua/continuum/wall_shear_average.h>
#include <continua/finite_element/assembly/metric_history.h>
#include <continua/finite_element/space/space.h>

#include <deal.II/fe/fe_values.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace Continua
{
/// The vectors of a state with ghosts, for fields at points. The vectors are made once on a mesh.
template <int dim>
class SampledState
{
public:
  /// All must outlive it; `metrics`: null where nothing relaxes in finite deformation.
  SampledState(const Space<dim> &space,
               const Problem &problem,
               const MetricHistory<dim> *metrics = nullptr)
      : space(space), problem(problem), metrics(metrics)
  {
  }

  /// The mesh is another one.
  void reinit();
  /// Collective.
  void take(const State &state);

  DistributedVector velocity, pressure;
  DistributedVector displacement;                           ///< with Deformation::finite
  DistributedVector unloaded_displacement, wall_potentials; ///< where State has them
  std::vector<DistributedVector> mixtures;                  ///< by region, see set_mixture()
  DistributedVector metric_mixture; ///< see MetricHistory::ghosted_mixture()
  /// Of the WallShearAverage, if the run keeps it.
  DistributedVector shear_integral, magnitude_integral;
  double averaged_time = 0.; ///< [s]

private:
  const Space<dim> &space;
  const Problem &problem;
  const MetricHistory<dim> *metrics;
  DistributedVector mixture;        ///< work space
  bool has_wall_potentials = false; ///< of the present mesh
};

/// What the weight of a point is a share of, and by what the motion of a mesh stretches it.
struct SampledShare
{
  enum class Kind
  {
    undeformed, ///< the weight stays
    line,       ///< dx = F dX, of a tangent
    area,       ///< n da = J F^-T N dA, of a normal
    volume      ///< dv = J dV
  };
  Kind kind = Kind::undeformed;
  dealii::Tensor<1, 3> direction; ///< undeformed, of length 1; of a line or an area
};

/// Points at which fields are evaluated that are no linear functions of the state. What does not
/// depend on the state is computed when a point is added.
template <int dim>
class FieldSamples
{
public:
  /// As for SampledState.
  FieldSamples(const Space<dim> &space,
               const Problem &problem,
               const MetricHistory<dim> *metrics = nullptr)
      : space(space), problem(problem), metrics(metrics)
  {
  }

  void clear()
  {
    points.clear();
    cells.clear();
  }
  unsigned int size() const { return points.size(); }
  /// Adds a point of a cell of this rank or of a ghost. `normal`: out of the cell, for fields of
  /// walls; `factors`: of the components of a stress; `weight`: undeformed.
  void add(const typename dealii::Triangulation<dim>::cell_iterator &cell,
           const dealii::FEValuesBase<dim> &values,
           const dealii::FEValuesBase<dim> &pressure_values,
           unsigned int q,
           const dealii::Tensor<1, dim> &normal,
           const std::array<double, 6> &factors,
           double weight,
           const SampledShare &share = {});

  /// Of the present shape, where the share of the point is not the undeformed one.
  double weight(const SampledState<dim> &state, unsigned int point) const;
  /// Undeformed; on a mesh that moves the present one [m].
  dealii::Point<dim> place(const SampledState<dim> &state, unsigned int point) const;
  double value(const FieldDefinition<dim> &field,
               const SampledState<dim> &state,
               unsigned int point) const;
  /// The normal of the point, of the present shape.
  dealii::Tensor<1, dim> normal(const SampledState<dim> &state, const unsigned int point) const
  {
    return normal_at(points[point], state);
  }
  /// n.sigma with that normal [Pa].
  dealii::Tensor<1, dim> traction_at(const SampledState<dim> &state, unsigned int point) const;
  /// What the material exerts on a wall at the point: minus the tangential part of n.sigma [Pa].
  dealii::Tensor<1, dim> shear_on_wall(const SampledState<dim> &state, unsigned int point) const;

private:
  struct SampledCell
  {
    int level, index;
    std::vector<std::array<dealii::types::global_dof_index, dim>> nodes; ///< by component
    std::vector<dealii::types::global_dof_index> pressure_indices;
  };
  struct SamplePoint
  {
    unsigned int region;
    double weight; ///< undeformed
    SampledShare share;
    dealii::Point<dim> place;
    dealii::Tensor<1, dim> normal;
    std::array<double, 6> factors;
    std::size_t cell; ///< in the list
    /// Of the shape functions of a component at the nodes of the cell.
    std::vector<double> values;
    std::vector<dealii::Tensor<1, dim>> gradients;
    std::vector<double> pressure_values;
    typename MetricHistory<dim>::PointWeights metric_weights;
  };

  const Space<dim> &space;
  const Problem &problem;
  const MetricHistory<dim> *metrics;
  std::vector<SampledCell> cells;
  std::vector<SamplePoint> points;

  void add_cell(const typename dealii::Triangulation<dim>::cell_iterator &cell);
  dealii::Tensor<2, dim> gradient(const SamplePoint &point, const DistributedVector &vector) const;
  /// v_r/r, in axisymmetry.
  double hoop(const SamplePoint &point,
              const DistributedVector &vector,
              const dealii::Tensor<2, dim> &gradient) const;
  dealii::Tensor<1, dim> vector_value(const SamplePoint &point,
                                      const DistributedVector &vector) const;
  double pressure_at(const SamplePoint &point, const SampledState<dim> &state) const;
  /// By the present place, with v_r/r of it.
  std::pair<dealii::Tensor<2, dim>, double>
  velocity_gradient_at(const SamplePoint &point, const SampledState<dim> &state) const;
  /// v.n with the present normal of the point's share of an area.
  double velocity_through(const SamplePoint &point, const SampledState<dim> &state) const;
  /// The unit normal of the deformed body.
  dealii::Tensor<1, dim> normal_at(const SamplePoint &point, const SampledState<dim> &state) const;
  StressFreeState stress_free_state(const SamplePoint &point, const SampledState<dim> &state) const;
  Kinematics kinematics_at(const SamplePoint &point, const SampledState<dim> &state) const;
  std::array<double, 6> stress_at(const SamplePoint &point, const SampledState<dim> &state) const;
  /// -t.sigma.n with the axis t and the radial direction n of the field as the motion turns them: a
  /// tangent and the normal of a wall around the axis.
  double drag_at(const FieldDefinition<dim> &field,
                 const SamplePoint &point,
                 const SampledState<dim> &state) const;
};
} // namespace Continua

#endif
