#include <continua/finite_element/streamline_terms.h>

#include <continua/mesh/coordinates.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

template <int dim>
StreamlineTerms<dim>::StreamlineTerms(const Space<dim> &space,
                                      const Problem &problem,
                                      const Quadrature<dim> &quadrature)
    : space(space),
      problem(problem),
      scalar_element(space.degree()),
      values(space.mapping,
             scalar_element,
             quadrature,
             update_values | update_gradients | update_hessians | update_quadrature_points),
      along(scalar_element.n_dofs_per_cell()),
      residual_slopes(space.velocity_element.n_dofs_per_cell())
{
}

template <int dim>
void StreamlineTerms<dim>::visit(const Cell &cell, const Step &of_step)
{
  values.reinit(static_cast<typename Triangulation<dim>::active_cell_iterator>(cell));
  step = of_step;
  region = cell->material_id();
  size = Convection::cell_size<dim>(cell->diameter(), space.degree());
}

template <int dim>
double StreamlineTerms<dim>::time_scale(const double speed) const
{
  // A steady flow, whose equations have no inertia, has no step either.
  const double by_time = step.a0 == 0. ? 0. : 2. / step.size(), by_flow = 2. * speed / size,
               by_viscosity = 12. * viscosity() / (problem.materials[region].density * size * size);
  return 1. / std::sqrt(by_time * by_time + by_flow * by_flow + by_viscosity * by_viscosity);
}

template <int dim>
Tensor<1, dim> StreamlineTerms<dim>::viscous_force(const unsigned int component,
                                                   const unsigned int function,
                                                   const unsigned int q) const
{
  const Tensor<2, dim> second = values.shape_hessian(function, q);
  // Of the divergence.
  Tensor<1, dim> gradient = second[component];
  double laplacian = trace(second);
  if (space.is_axisymmetric())
  {
    const double radius = values.quadrature_point(q)[1];
    const Tensor<1, dim> first = values.shape_grad(function, q);
    const double value = values.shape_value(function, q);
    laplacian += first[1] / radius;
    if (component == 1)
    {
      laplacian -= value / (radius * radius);
      gradient += first / radius;
      gradient[1] -= value / (radius * radius);
    }
  }
  Tensor<1, dim> force = gradient / 3.;
  force[component] += laplacian;
  return viscosity() * force;
}

template <int dim>
Tensor<1, dim> StreamlineTerms<dim>::residual(const FlowPoint<dim> &point,
                                              const unsigned int q,
                                              const CellState<dim> &state) const
{
  const Material &material = problem.materials[region];
  const double density = material.density * material.volume_law().density_ratio(point.pressure);
  Tensor<1, dim> force = density * (point.acceleration + point.velocity_gradient * point.velocity) +
                         point.pressure_gradient;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int a = 0; a < along.size(); ++a)
      force -= state.velocity[state.place(c, a)] * viscous_force(c, a, q);
  const auto place = coordinates(values.quadrature_point(q));
  const InteriorData &interior = problem.interior;
  for (unsigned int c = 0; c < interior.body_force.size(); ++c)
    force[c] -= step.load_factor * interior.body_force[c](place.data(), step.balance_time);
  for (unsigned int c = 0; c < interior.acceleration.size(); ++c)
    force[c] -= step.load_factor * material.density *
                interior.acceleration[c](place.data(), step.balance_time);
  return force;
}

template <int dim>
Tensor<1, dim> StreamlineTerms<dim>::force(const FlowPoint<dim> &point,
                                           const unsigned int q,
                                           const CellState<dim> &state) const
{
  return point.weight * time_scale(point.velocity.norm()) * residual(point, q, state);
}

template <int dim>
void StreamlineTerms<dim>::add_derivative(const FlowPoint<dim> &point,
                                          const FlowFunctions<dim> &functions,
                                          const unsigned int q,
                                          const CellState<dim> &state,
                                          FullMatrix<double> &matrix)
{
  const Material &material = problem.materials[region];
  const VolumeLaw law = material.volume_law();
  const double density = material.density * law.density_ratio(point.pressure);
  const double density_slope = density * law.compressibility(point.pressure);
  const Tensor<1, dim> inertia = point.acceleration + point.velocity_gradient * point.velocity;
  const Tensor<1, dim> force = residual(point, q, state);
  const double tau = time_scale(point.velocity.norm());
  const double tau_slope = -4. * tau * tau * tau / (size * size); // by U, along U
  const unsigned int n_velocity = residual_slopes.size(),
                     n_pressure = matrix.n() - residual_slopes.size();
  for (unsigned int b = 0; b < along.size(); ++b)
    along[b] = point.velocity * functions.gradients[b];
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int b = 0; b < along.size(); ++b)
    {
      const double shape = functions.values[b];
      Tensor<1, dim> &slope = residual_slopes[state.place(d, b)];
      slope = -viscous_force(d, b, q);
      slope[d] += density * (step.a0 * shape + along[b]);
      for (unsigned int c = 0; c < dim; ++c)
        slope[c] += density * shape * point.velocity_gradient[c][d];
    }
  for (unsigned int a = 0; a < along.size(); ++a)
  {
    const double test = point.weight * tau * along[a];
    const Tensor<1, dim> gradient = functions.gradients[a];
    for (unsigned int d = 0; d < dim; ++d)
    {
      const double by_flow =
          point.weight * (tau * gradient[d] + tau_slope * point.velocity[d] * along[a]);
      for (unsigned int b = 0; b < along.size(); ++b)
      {
        const unsigned int j = state.place(d, b);
        const double moved = by_flow * functions.values[b];
        for (unsigned int c = 0; c < dim; ++c)
          matrix(state.place(c, a), j) += test * residual_slopes[j][c] + moved * force[c];
      }
    }
    for (unsigned int l = 0; l < n_pressure; ++l)
    {
      const Tensor<1, dim> slope =
          density_slope * functions.pressure_values[l] * inertia + functions.pressure_gradients[l];
      for (unsigned int c = 0; c < dim; ++c)
        matrix(state.place(c, a), n_velocity + l) += test * slope[c];
    }
  }
}

template class StreamlineTerms<2>;
template class StreamlineTerms<3>;
} // namespace Continua
