#ifndef continua_finite_element_assembly_flow_cell_h
#define continua_finite_element_assembly_flow_cell_h

#include <continua/continuum/problem.h>
#include <continua/finite_element/assembly/flow_at_points.h>
#include <continua/finite_element/space/quadrature_cells.h>
#include <continua/finite_element/space/values_at_points.h>
#include <continua/finite_element/terms/cell_state.h>
#include <continua/finite_element/terms/streamline.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/time_integration/step.h>

#include <deal.II/lac/vector.h>

#include <vector>

namespace Continua
{
/// The state of a liquid in one cell at a time, and at its quadrature points: by the present place
/// where the mesh moves.
template <int dim>
class FlowCell
{
public:
  using Cell = QuadratureCell<dim>;

  /// A state, with ghost entries; that of the mesh is not read where the mesh stays.
  struct Vectors
  {
    const DistributedVector &velocity, &acceleration, &pressure, &pressure_rate;
    const DistributedVector &mesh_displacement, &mesh_velocity;
  };

  /// All must outlive it.
  FlowCell(const Problem &problem, const QuadratureCells<dim> &cells, const Vectors &vectors);

  /// What the terms have in this step.
  void set_step(const Step &step);
  /// Makes the state that of a cell.
  void visit(const Cell &cell);

  const Cell &cell() const { return *present; }
  const Material &material() const { return problem.materials[present->region]; }
  /// The values at the dofs.
  CellState<dim> state() const;
  /// The geometry at the quadrature points, of the present place.
  const std::vector<typename Cell::Point> &points() const
  {
    return problem.mesh_moves ? moved_points : present->points;
  }
  const dealii::Vector<double> &mesh_displacement() const { return displacements; }
  /// The state at all quadrature points, until the next visit().
  FlowAtPoints<dim> all_points() const;
  /// The state at a quadrature point; what is a StreamlinePoint's alone is not set.
  StreamlinePoint<dim> point(unsigned int q) const;

private:
  const Problem &problem;
  const QuadratureCells<dim> &cells;
  const Vectors vectors;
  const Cell *present = nullptr;
  FlowScheme scheme;
  // At the dofs; velocities component by component.
  dealii::Vector<double> velocities, accelerations, pressures, pressure_rates;
  dealii::Vector<double> displacements, mesh_velocities;
  std::vector<typename Cell::Point> moved_points;
  ValuesAtPoints<dim> velocity_at_points, acceleration_at_points, pressure_at_points,
      pressure_rate_at_points, displacement_at_points, mesh_velocity_at_points;

  void move_points();
  void set_velocity(unsigned int q, FlowPoint<dim> &point) const;
  void set_material(FlowPoint<dim> &point) const;
};
} // namespace Continua

#endif
