#include <continua/finite_element/terms/streamline_terms.h>

#include <continua/finite_element/conditions/following_loads.h>

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
      values(space.mapping,
             space.scalar_element(),
             quadrature,
             update_values | update_gradients | update_hessians | update_quadrature_points),
      forces(space.velocity_element.n_dofs_per_cell())
{
}

template <int dim>
void StreamlineTerms<dim>::visit(const Cell &cell, const Step &of_step)
{
  values.reinit(static_cast<typename Triangulation<dim>::active_cell_iterator>(cell));
  step = of_step;
  region = cell->material_id();
  undeformed_size = Convection::cell_size<dim>(cell->diameter(), space.degree());
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
void StreamlineTerms<dim>::set_viscous_forces_of(const unsigned int function,
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
    Tensor<1, dim> &force = forces[state.place(c, function)];
    force = gradient / 3.;
    force[c] += laplacian;
    force *= viscosity();
  }
}

template <int dim>
void StreamlineTerms<dim>::set_viscous_forces(const unsigned int q, const CellState<dim> &state)
{
  place = values.quadrature_point(q);
  size = undeformed_size;
  if (state.mesh_displacement == nullptr)
  {
    for (unsigned int a = 0; a < space.scalar_element().n_dofs_per_cell(); ++a)
      set_viscous_forces_of(a, state, values.shape_value(a, q), values.shape_grad(a, q),
                            values.shape_hessian(a, q));
    return;
  }
  const Vector<double> &displacement = *state.mesh_displacement;
  Tensor<2, dim> deformation = unit_symmetric_tensor<dim>();
  std::array<Tensor<2, dim>, dim> second_of_place;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int a = 0; a < space.scalar_element().n_dofs_per_cell(); ++a)
    {
      const double entry = displacement[state.place(c, a)];
      place[c] += entry * values.shape_value(a, q);
      deformation[c] += entry * values.shape_grad(a, q);
      second_of_place[c] += entry * values.shape_hessian(a, q);
    }
  const Tensor<2, dim> inverse = invert(deformation);
  size *= std::pow(determinant(deformation), 1. / dim);
  for (unsigned int a = 0; a < space.scalar_element().n_dofs_per_cell(); ++a)
  {
    const Tensor<1, dim> first = values.shape_grad(a, q) * inverse;
    // The derivative of F^-1 takes off what the curvature of the motion makes of the gradient.
    Tensor<2, dim> second = values.shape_hessian(a, q);
    for (unsigned int c = 0; c < dim; ++c)
      second -= first[c] * second_of_place[c];
    set_viscous_forces_of(a, state, values.shape_value(a, q), first,
                          transpose(inverse) * second * inverse);
  }
}

template <int dim>
void StreamlineTerms<dim>::set_point(const unsigned int q,
                                     const CellState<dim> &state,
                                     StreamlinePoint<dim> &point)
{
  set_viscous_forces(q, state);
  point.body_force = body_force_at(problem, region, place, step);
  point.viscous_force = 0.;
  for (unsigned int i = 0; i < forces.size(); ++i)
    point.viscous_force += state.velocity[i] * forces[i];
  point.time_scale = time_scale(point.carrier.norm());
  point.time_scale_slope =
      -4. * point.time_scale * point.time_scale * point.time_scale / (size * size);
}

template class StreamlineTerms<2>;
template class StreamlineTerms<3>;
} // namespace Continua
