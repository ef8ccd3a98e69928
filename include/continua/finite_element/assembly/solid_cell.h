#ifndef continua_finite_element_assembly_solid_cell_h
#define continua_finite_element_assembly_solid_cell_h

#include <continua/continuum/problem.h>
#include <continua/finite_element/assembly/metric_history.h>
#include <continua/finite_element/assembly/solid_at_points.h>
#include <continua/finite_element/assembly/stress_free_states.h>
#include <continua/finite_element/space/quadrature_cells.h>
#include <continua/finite_element/space/values_at_points.h>
#include <continua/finite_element/terms/solid_point.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/materials/strain_law.h>
#include <continua/time_integration/step.h>

#include <deal.II/base/tensor.h>
#include <deal.II/lac/vector.h>

#include <optional>

namespace Continua
{
/// The state of a solid in finite deformation in one cell at a time, and at its quadrature points.
template <int dim>
class SolidCell
{
public:
  using Cell = QuadratureCell<dim>;
  /// What a point has of its law.
  enum class Stress
  {
    none,
    alone,
    with_tangent
  };
  /// A state, with ghost entries.
  struct Vectors
  {
    const DistributedVector &velocity, &displacement, &acceleration, &pressure, &pressure_rate;
  };

  /// All must outlive it; `metrics`: null where nothing relaxes.
  SolidCell(const Problem &problem,
            const QuadratureCells<dim> &cells,
            const StressFreeStates<dim> &stress_free_states,
            const MetricHistory<dim> *metrics,
            const Vectors &vectors);

  /// What the terms have in this step.
  void set_step(const Step &step);
  /// Makes the state that of a cell.
  void visit(const Cell &cell);

  const Cell &cell() const { return *present; }
  const Material &material() const { return problem.materials[present->region]; }
  const dealii::Vector<double> &displacement() const { return displacements; }
  /// The largest component of the displacement, or of D0 where it is looked for [m].
  double largest_displacement() const;
  /// b = dD/dU [s].
  double displacement_by_velocity() const { return scheme.displacement_by_velocity; }
  /// The state at all quadrature points, until the next visit(); only where no unloaded shape is
  /// looked for, or for stresses alone.
  SolidAtPoints<dim> all_points() const;
  /// The state at a quadrature point; without stress where it is turned inside out. Makes strain()
  /// that of the point, and keeps what its `unloading` points to until the next call.
  SolidPoint<dim> point(unsigned int q, Stress of_law);
  /// Of the last point.
  const PointStrain &strain() const { return strain_at_point; }
  /// The inverse Jacobian of the present place at a point.
  dealii::Tensor<2, dim> inverse_jacobian(const SolidPoint<dim> &point, unsigned int q) const;
  bool finds_unloaded() const { return finds_unloaded_shape; }
  bool relaxes() const { return metrics != nullptr && metrics->relaxes(present->region); }
  /// The number of the cell among the active ones.
  unsigned int number() const { return present->velocity_cell->active_cell_index(); }

private:
  const Problem &problem;
  const QuadratureCells<dim> &cells;
  const StressFreeStates<dim> &stress_free_states;
  const MetricHistory<dim> *const metrics;
  const Vectors vectors;
  const Cell *present = nullptr;
  SolidScheme scheme; ///< of the cell
  bool finds_steady_state = false, finds_unloaded_shape = false;
  // At the dofs; vectors component by component.
  dealii::Vector<double> velocities, displacements, accelerations, pressures, pressure_rates;
  dealii::Vector<double> unloaded; ///< D0
  ValuesAtPoints<dim> velocity_at_points, displacement_at_points, acceleration_at_points,
      pressure_at_points, pressure_rate_at_points;
  PointStrain strain_at_point;
  std::optional<RightStretch> unloading;

  void set_strain(const StressFreeState *stress_free, const SolidPoint<dim> &point);
  void set_stress(unsigned int q, SolidPoint<dim> &point) const;
  void set_tangent(unsigned int q, SolidPoint<dim> &point) const;
};
} // namespace Continua

#endif
