#include <continua/finite_element/streamline_terms.h>

#include <continua/mesh/coordinates.h>

#include <deal.II/base/symmetric_tensor.h>

#include <array>
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
      residual_slopes(space.velocity_element.n_dofs_per_cell()),
      viscous_forces(residual_slopes.size())
{
}

template <int dim>
void StreamlineTerms<dim>::visit(const Cell &cell, const Step &of_step)
{
  values.reinit(static_cast<typename Triangulation<dim>::active_cell_iterator>(cell));
  step = of_step;
  region = cell->material_id();
  size_at_rest = Convection::cell_size<dim>(cell->diameter(), space.degree());
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
void StreamlineTerms<dim>::set_viscous_forces(const unsigned int function,
                                              const CellState<dim> &state,
                                              const double value,
                                              const Tensor<1, dim> &first,
                                              const Tensor<2, dim> &second)
{
  for (unsigned int c = 0; c < dim; ++c)
  {
    // Of the divergence.
    Tensor<1, dim> gradient = second[c];
    double laplacian = trace(second);
    if (space.is_axisymmetric())
    {
      const double radius = place[1];
      laplacian += first[1] / radius;
      if (c == 1)
      {
        laplacian -= value / (radius * radius);
        gradient += first / radius;
        gradient[1] -= value / (radius * radius);
      }
    }
    Tensor<1, dim> &force = viscous_forces[state.place(c, function)];
    force = gradient / 3.;
    force[c] += laplacian;
    force *= viscosity();
  }
}

template <int dim>
void StreamlineTerms<dim>::set_point(const unsigned int q, const CellState<dim> &state)
{
  place = values.quadrature_point(q);
  size = size_at_rest;
  if (state.mesh_displacement == nullptr)
  {
    for (unsigned int a = 0; a < along.size(); ++a)
      set_viscous_forces(a, state, values.shape_value(a, q), values.shape_grad(a, q),
                         values.shape_hessian(a, q));
    return;
  }
  const Vector<double> &displacement = *state.mesh_displacement;
  Tensor<2, dim> deformation = unit_symmetric_tensor<dim>();
  std::array<Tensor<2, dim>, dim> second_of_place;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int a = 0; a < along.size(); ++a)
    {
      const double entry = displacement[state.place(c, a)];
      place[c] += entry * values.shape_value(a, q);
      deformation[c] += entry * values.shape_grad(a, q);
      second_of_place[c] += entry * values.shape_hessian(a, q);
    }
  const Tensor<2, dim> inverse = invert(deformation);
  size *= std::pow(determinant(deformation), 1. / dim);
  for (unsigned int a = 0; a < along.size(); ++a)
  {
    const Tensor<1, dim> first = values.shape_grad(a, q) * inverse;
    // The derivative of F^-1 takes off what the curvature of the motion makes of the gradient.
    Tensor<2, dim> second = values.shape_hessian(a, q);
    for (unsigned int c = 0; c < dim; ++c)
      second -= first[c] * second_of_place[c];
    set_viscous_forces(a, state, values.shape_value(a, q), first,
                       transpose(inverse) * second * inverse);
  }
}

template <int dim>
Tensor<1, dim> StreamlineTerms<dim>::residual(const FlowPoint<dim> &point,
                                              const CellState<dim> &state) const
{
  const Material &material = problem.materials[region];
  const double density = material.density * material.volume_law().density_ratio(point.pressure);
  Tensor<1, dim> force = density * (point.acceleration + point.velocity_gradient * point.carrier) +
                         point.pressure_gradient;
  for (unsigned int i = 0; i < viscous_forces.size(); ++i)
    force -= state.velocity[i] * viscous_forces[i];
  const auto here = coordinates(place);
  const InteriorData &interior = problem.interior;
  for (unsigned int c = 0; c < interior.body_force.size(); ++c)
    force[c] -= step.load_factor * interior.body_force[c](here.data(), step.balance_time);
  for (unsigned int c = 0; c < interior.acceleration.size(); ++c)
    force[c] -= step.load_factor * material.density *
                interior.acceleration[c](here.data(), step.balance_time);
  return force;
}

template <int dim>
Tensor<1, dim> StreamlineTerms<dim>::force(const FlowPoint<dim> &point,
                                           const unsigned int q,
                                           const CellState<dim> &state)
{
  set_point(q, state);
  return point.weight * time_scale(point.carrier.norm()) * residual(point, state);
}

template <int dim>
void StreamlineTerms<dim>::add_derivative(const FlowPoint<dim> &point,
                                          const FlowFunctions<dim> &functions,
                                          const unsigned int q,
                                          const CellState<dim> &state,
                                          FullMatrix<double> &matrix)
{
  set_point(q, state);
  const Material &material = problem.materials[region];
  const VolumeLaw law = material.volume_law();
  const double density = material.density * law.density_ratio(point.pressure);
  const double density_slope = density * law.compressibility(point.pressure);
  const Tensor<1, dim> inertia = point.acceleration + point.velocity_gradient * point.carrier;
  const Tensor<1, dim> force = residual(point, state);
  const double tau = time_scale(point.carrier.norm());
  const double tau_slope = -4. * tau * tau * tau / (size * size); // by what carries, along it
  const double carries = problem.convection.is_on ? 1. : 0.;      // the velocity
  const unsigned int n_velocity = residual_slopes.size(),
                     n_pressure = matrix.n() - residual_slopes.size();
  for (unsigned int b = 0; b < along.size(); ++b)
    along[b] = point.carrier * functions.gradients[b];
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int b = 0; b < along.size(); ++b)
    {
      const double shape = functions.values[b];
      Tensor<1, dim> &slope = residual_slopes[state.place(d, b)];
      slope = -viscous_forces[state.place(d, b)];
      slope[d] += density * (step.a0 * shape + along[b]);
      for (unsigned int c = 0; c < dim; ++c)
        slope[c] += carries * density * shape * point.velocity_gradient[c][d];
    }
  for (unsigned int a = 0; a < along.size(); ++a)
  {
    const double test = point.weight * tau * along[a];
    const Tensor<1, dim> gradient = functions.gradients[a];
    for (unsigned int d = 0; d < dim; ++d)
    {
      const double by_flow =
          carries * point.weight * (tau * gradient[d] + tau_slope * point.carrier[d] * along[a]);
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
