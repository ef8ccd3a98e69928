#include <continua/finite_element/assembly/flow_cell.h>

#include <cstddef>

namespace Continua
{
using namespace dealii;

template <int dim>
FlowCell<dim>::FlowCell(const Problem &problem,
                        const QuadratureCells<dim> &cells,
                        const Vectors &vectors)
    : problem(problem), cells(cells), vectors(vectors)
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
  if (!problem.mesh_moves)
    return;
  set_entries(cell.velocity_places, vectors.mesh_displacement, displacements);
  set_entries(cell.velocity_places, vectors.mesh_velocity, mesh_velocities);
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
  const std::size_t n_functions = cells.n_functions();
  for (unsigned int q = 0; q < moved_points.size(); ++q)
  {
    const typename Cell::Point &at_rest = present->points[q];
    Tensor<2, dim> gradient;
    double radial = 0.;
    for (unsigned int c = 0; c < dim; ++c)
    {
      const double *const entries = displacements.begin() + c * n_functions;
      Tensor<1, dim> slope; // on the reference cell
      for (unsigned int a = 0; a < n_functions; ++a)
        slope += entries[a] * cells.gradients(q)[a];
      gradient[c] = slope * at_rest.inverse_jacobian;
      gradient[c][c] += 1.;
      for (unsigned int a = 0; c == 1 && a < n_functions; ++a)
        radial += entries[a] * cells.values(q)[a];
    }
    const double stretch = 1. + radial * at_rest.hoop;
    moved_points[q].weight = at_rest.weight * determinant(gradient) * stretch;
    moved_points[q].hoop = at_rest.hoop / stretch;
    moved_points[q].inverse_jacobian = at_rest.inverse_jacobian * invert(gradient);
  }
}

template <int dim>
void FlowCell<dim>::set_velocity(const unsigned int q, FlowPoint<dim> &point) const
{
  const typename Cell::Point &geometry = points()[q];
  const std::size_t n_functions = cells.n_functions();
  const double *const values = cells.values(q);
  const Tensor<1, dim> *const gradients = cells.gradients(q);
  for (unsigned int c = 0; c < dim; ++c)
  {
    const double *const of_component = velocities.begin() + c * n_functions,
                        *const rates = accelerations.begin() + c * n_functions;
    double of_velocity = 0., of_acceleration = 0.;
    Tensor<1, dim> slope; // on the reference cell
    for (unsigned int a = 0; a < n_functions; ++a)
    {
      of_velocity += of_component[a] * values[a];
      of_acceleration += rates[a] * values[a];
      slope += of_component[a] * gradients[a];
    }
    point.velocity[c] = of_velocity;
    point.acceleration[c] = of_acceleration;
    point.velocity_gradient[c] = slope * geometry.inverse_jacobian;
    point.carrier[c] = scheme.carries * of_velocity;
    for (unsigned int a = 0; problem.mesh_moves && a < n_functions; ++a)
      point.carrier[c] -= mesh_velocities[c * n_functions + a] * values[a];
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
StreamlinePoint<dim> FlowCell<dim>::point(const unsigned int q) const
{
  const typename Cell::Point &geometry = points()[q];
  const double *const pressure_values = cells.pressure_values(q);
  const Tensor<1, dim> *const pressure_gradients = cells.pressure_gradients(q);
  StreamlinePoint<dim> point;
  point.scheme = scheme;
  point.hoop = geometry.hoop;
  set_velocity(q, point);
  Tensor<1, dim> slope;
  for (unsigned int k = 0; k < cells.n_pressures(); ++k)
  {
    point.pressure += pressures[k] * pressure_values[k];
    point.pressure_rate += pressure_rates[k] * pressure_values[k];
    slope += pressures[k] * pressure_gradients[k];
  }
  point.pressure_gradient = slope * geometry.inverse_jacobian;
  point.set_strain_rate();
  set_material(point);
  point.finish();
  return point;
}

template class FlowCell<2>;
template class FlowCell<3>;
} // namespace Continua
