#include <continua/finite_element/assembly/flow_cell.h>

namespace Continua
{
using namespace dealii;

template <int dim>
FlowCell<dim>::FlowCell(const Problem &problem,
                        const QuadratureCells<dim> &cells,
                        const Vectors &vectors)
    : problem(problem),
      cells(cells),
      vectors(vectors),
      velocity_at_points(cells, ValuesAtPoints<dim>::Field::velocity, true),
      acceleration_at_points(cells, ValuesAtPoints<dim>::Field::velocity, false),
      pressure_at_points(cells, ValuesAtPoints<dim>::Field::pressure, true),
      pressure_rate_at_points(cells, ValuesAtPoints<dim>::Field::pressure, false),
      displacement_at_points(cells, ValuesAtPoints<dim>::Field::velocity, true),
      mesh_velocity_at_points(cells, ValuesAtPoints<dim>::Field::velocity, false)
{
  for (Vector<double> *of_cell : {&velocities, &accelerations, &displacements, &mesh_velocities})
    of_cell->reinit(dim * cells.n_functions());
  for (Vector<double> *of_cell : {&pressures, &pressure_rates})
    of_cell->reinit(cells.n_pressures());
  if (problem.mesh_moves)
    moved_points.resize(cells.n_points());
}

template <int dim>
void FlowCell<dim>::set_step(const Step &step)
{
  const Convection &convection = problem.convection;
  scheme.carries = convection.is_on ? 1. : 0.;
  scheme.skew = convection.is_on && convection.term == ConvectiveTerm::skew ? 0.5 : 0.;
  scheme.grad_div_viscosity = convection.constant_viscosity();
  scheme.rate_by_velocity = step.a0;
  scheme.pressure_rate_by_pressure = 1. / step.pressure_time;
}

template <int dim>
void FlowCell<dim>::visit(const Cell &cell)
{
  present = &cell;
  set_entries(cell.velocity_places, vectors.velocity, velocities);
  set_entries(cell.velocity_places, vectors.acceleration, accelerations);
  set_entries(cell.pressure_places, vectors.pressure, pressures);
  set_entries(cell.pressure_places, vectors.pressure_rate, pressure_rates);
  velocity_at_points.set(velocities);
  acceleration_at_points.set(accelerations);
  pressure_at_points.set(pressures);
  pressure_rate_at_points.set(pressure_rates);
  if (!problem.mesh_moves)
    return;
  set_entries(cell.velocity_places, vectors.mesh_displacement, displacements);
  set_entries(cell.velocity_places, vectors.mesh_velocity, mesh_velocities);
  displacement_at_points.set(displacements);
  mesh_velocity_at_points.set(mesh_velocities);
  move_points();
}

template <int dim>
CellState<dim> FlowCell<dim>::state() const
{
  return {velocities, pressures, problem.mesh_moves ? &displacements : nullptr,
          problem.mesh_moves ? &mesh_velocities : nullptr};
}

template <int dim>
void FlowCell<dim>::move_points()
{
  for (unsigned int q = 0; q < moved_points.size(); ++q)
  {
    const typename Cell::Point &undeformed = present->points[q];
    Tensor<2, dim> gradient;
    for (unsigned int c = 0; c < dim; ++c)
    {
      gradient[c] = displacement_at_points.gradient(c, q, undeformed.inverse_jacobian);
      gradient[c][c] += 1.;
    }
    const double stretch = 1. + displacement_at_points.value(1, q) * undeformed.hoop;
    moved_points[q].weight = undeformed.weight * determinant(gradient) * stretch;
    moved_points[q].hoop = undeformed.hoop / stretch;
    moved_points[q].inverse_jacobian = undeformed.inverse_jacobian * invert(gradient);
  }
}

template <int dim>
void FlowCell<dim>::set_velocity(const unsigned int q, FlowPoint<dim> &point) const
{
  const Tensor<2, dim> &inverse_jacobian = points()[q].inverse_jacobian;
  for (unsigned int c = 0; c < dim; ++c)
  {
    point.velocity[c] = velocity_at_points.value(c, q);
    point.acceleration[c] = acceleration_at_points.value(c, q);
    point.velocity_gradient[c] = velocity_at_points.gradient(c, q, inverse_jacobian);
    point.carrier[c] = scheme.carries * point.velocity[c];
    if (problem.mesh_moves)
      point.carrier[c] -= mesh_velocity_at_points.value(c, q);
  }
}

template <int dim>
void FlowCell<dim>::set_material(FlowPoint<dim> &point) const
{
  const Material &liquid = material();
  const VolumeLaw law = liquid.volume_law();
  point.density = liquid.density * law.density_ratio(point.pressure);
  point.compressibility = law.compressibility(point.pressure);
  point.compressibility_slope = law.compressibility_slope(point.pressure);
  point.grad_div_over_speed =
      problem.convection.viscosity_over_speed(liquid.density, present->size);
  const Shear &shear = liquid.shear;
  point.viscosity = shear.viscosity;
  if (!shear.flow_curve)
    return;
  const double rate = point.shear_rate();
  point.viscosity = shear.flow_curve->viscosity(rate);
  point.viscosity_slope = shear.flow_curve->slope_over_rate(rate);
}

template <int dim>
FlowAtPoints<dim> FlowCell<dim>::all_points() const
{
  const Material &liquid = material();
  FlowAtPoints<dim> all;
  all.n_points = cells.n_points();
  all.geometry = points().data();
  all.scheme = scheme;
  all.density = liquid.density;
  all.viscosity = liquid.shear.viscosity;
  all.grad_div_over_speed = problem.convection.viscosity_over_speed(liquid.density, present->size);
  all.volume_law = liquid.volume_law();
  all.flow_curve = liquid.shear.flow_curve ? &*liquid.shear.flow_curve : nullptr;
  all.velocity = velocity_at_points.numbers();
  all.acceleration = acceleration_at_points.numbers();
  all.pressure = pressure_at_points.numbers();
  all.pressure_rate = pressure_rate_at_points.numbers();
  if (problem.mesh_moves)
    all.mesh_velocity = mesh_velocity_at_points.numbers();
  return all;
}

template <int dim>
StreamlinePoint<dim> FlowCell<dim>::point(const unsigned int q) const
{
  const typename Cell::Point &geometry = points()[q];
  StreamlinePoint<dim> point;
  point.scheme = scheme;
  point.hoop = geometry.hoop;
  set_velocity(q, point);
  point.pressure = pressure_at_points.value(0, q);
  point.pressure_rate = pressure_rate_at_points.value(0, q);
  point.pressure_gradient = pressure_at_points.gradient(0, q, geometry.inverse_jacobian);
  point.set_strain_rate();
  set_material(point);
  point.finish();
  return point;
}

template class FlowCell<2>;
template class FlowCell<3>;
} // namespace Continua
