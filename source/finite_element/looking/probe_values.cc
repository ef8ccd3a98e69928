#include <continua/finite_element/looking/probe_values.h>

#include <continua/continuum/stress_and_strain.h>

#include <deal.II/hp/fe_values.h>

#include <numeric>

namespace Continua
{
using namespace dealii;

namespace
{
/// Of the components of the stress: minus a component of the tangential part of n.sigma.
template <int dim>
std::array<double, 6> wall_shear_factors(const Tensor<1, dim> &normal, const unsigned int component)
{
  std::array<double, 6> factors;
  for (unsigned int k = 0; k < factors.size(); ++k)
  {
    std::array<double, 6> unit = {{0., 0., 0., 0., 0., 0.}};
    unit[k] = 1.;
    const Tensor<1, dim> full_traction = traction<dim>(unit, normal);
    factors[k] = (full_traction * normal) * normal[component] - full_traction[component];
  }
  return factors;
}

/// The sum of the components with their factors.
double combine(const std::array<double, 6> &factors, const std::array<double, 6> &components)
{
  return std::inner_product(factors.begin(), factors.end(), components.begin(), 0.);
}
} // namespace

template <int dim>
void ProbeValues<dim>::add_at(const FieldDefinition<dim> &field,
                              const CellIterator &cell,
                              const Quadrature<dim> &points,
                              const std::vector<double> &weights,
                              Collector &collector,
                              const std::vector<SampledShare> &shares) const
{
  FEValues<dim> values(space.mapping, space.velocity_element, points,
                       update_values | update_gradients | update_quadrature_points);
  values.reinit(typename DoFHandler<dim>::active_cell_iterator(
      &space.triangulation, cell->level(), cell->index(), &space.velocity_dofs));
  hp::FEValues<dim> pressure_values(space.mappings, space.pressure_elements,
                                    hp::QCollection<dim>(points), update_values);
  pressure_values.reinit(typename DoFHandler<dim>::active_cell_iterator(
      &space.triangulation, cell->level(), cell->index(), &space.pressure_dofs));
  for (unsigned int q = 0; q < weights.size(); ++q)
    add(field, cell, values, pressure_values.get_present_fe_values(), q, weights[q], collector,
        shares[q]);
}

template <int dim>
void ProbeValues<dim>::add(const FieldDefinition<dim> &field,
                           const CellIterator &cell,
                           const FEValuesBase<dim> &values,
                           const FEValuesBase<dim> &pressure_values,
                           const unsigned int q,
                           const double weight,
                           Collector &collector,
                           const SampledShare &share,
                           const Tensor<1, dim> &normal) const
{
  const bool is_wall_shear = field.quantity == Quantity::wall_shear_stress;
  const Factors factors = is_wall_shear ? wall_shear_factors<dim>(normal, field.component)
                                        : field.factors(values.quadrature_point(q));
  if (samples_to_fill != nullptr)
  {
    samples_to_fill->add(cell, values, pressure_values, q, normal, factors, weight, share);
    return;
  }
  if (field.quantity == Quantity::velocity || field.quantity == Quantity::displacement)
  {
    add_vector(field.quantity, cell, values, q, weight, factors, collector);
    return;
  }
  double pressure_weight = problem.plane_stress(cell->material_id()).pressure_factor;
  if (field.quantity != Quantity::pressure)
  {
    add_gradient(field.quantity, cell, values, q, weight, factors, collector);
    // The pressure has no tangential part.
    if (field.quantity == Quantity::strain || field.quantity == Quantity::vorticity ||
        is_wall_shear)
      return;
    pressure_weight = combine(factors, stress<dim>(Tensor<2, dim>(), 0., 1., problem.model));
  }
  add_pressure(cell, pressure_values, q, weight * pressure_weight, collector);
}

template <int dim>
std::vector<types::global_dof_index>
ProbeValues<dim>::velocity_indices(const CellIterator &cell) const
{
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  typename DoFHandler<dim>::active_cell_iterator(&space.triangulation, cell->level(), cell->index(),
                                                 &space.velocity_dofs)
      ->get_dof_indices(indices);
  return indices;
}

template <int dim>
void ProbeValues<dim>::add_vector(const Quantity quantity,
                                  const CellIterator &cell,
                                  const FEValuesBase<dim> &values,
                                  const unsigned int q,
                                  const double weight,
                                  const Factors &factors,
                                  Collector &collector) const
{
  const std::vector<types::global_dof_index> indices = velocity_indices(cell);
  const Source source = quantity == Quantity::velocity ? Source::velocity : Source::displacement;
  for (unsigned int i = 0; i < indices.size(); ++i)
  {
    const double factor = factors[space.velocity_element.system_to_component_index(i).first];
    if (factor != 0.)
      space.velocity_hanging.distribute_local_to_global(
          indices[i], weight * factor * values.shape_value(i, q), collector.weights(source));
  }
}

template <int dim>
void ProbeValues<dim>::add_gradient(const Quantity quantity,
                                    const CellIterator &cell,
                                    const FEValuesBase<dim> &values,
                                    const unsigned int q,
                                    const double weight,
                                    const Factors &factors,
                                    Collector &collector) const
{
  const unsigned int region = cell->material_id();
  const std::vector<types::global_dof_index> indices = velocity_indices(cell);
  // The stress is linear in the mixture and the pressure, the strain in the displacement, the
  // vorticity in the velocity, so the weights are those of unit entries.
  const bool is_strain = quantity == Quantity::strain,
             is_vorticity = quantity == Quantity::vorticity;
  DistributedVector &target = is_strain      ? collector.weights(Source::displacement)
                              : is_vorticity ? collector.weights(Source::velocity)
                                             : collector.weights(Source::mixture, region);
  const double r = space.is_axisymmetric() ? values.quadrature_point(q)[1] : 1.;
  for (unsigned int i = 0; i < indices.size(); ++i)
  {
    const unsigned int c = space.velocity_element.system_to_component_index(i).first;
    Tensor<2, dim> gradient;
    gradient[c] = values.shape_grad(i, q);
    double hoop = 0.;
    if (space.is_axisymmetric() && c == 1)
      hoop = r > 0. ? values.shape_value(i, q) / r : gradient[1][1];
    const double unit =
        combine(factors,
                is_strain ? strain<dim>(gradient, hoop, problem.model, problem.plane_stress(region))
                : is_vorticity ? vorticity<dim>(gradient)
                               : stress<dim>(gradient, hoop, 0., problem.model));
    if (unit != 0.)
      space.velocity_hanging.distribute_local_to_global(indices[i], weight * unit, target);
  }
}

template <int dim>
void ProbeValues<dim>::add_pressure(const CellIterator &cell,
                                    const FEValuesBase<dim> &pressure_values,
                                    const unsigned int q,
                                    const double weight,
                                    Collector &collector) const
{
  const typename DoFHandler<dim>::active_cell_iterator pressure_cell(
      &space.triangulation, cell->level(), cell->index(), &space.pressure_dofs);
  std::vector<types::global_dof_index> indices(pressure_cell->get_fe().n_dofs_per_cell());
  pressure_cell->get_dof_indices(indices);
  for (unsigned int i = 0; i < indices.size(); ++i)
    space.pressure_hanging.distribute_local_to_global(indices[i],
                                                      weight * pressure_values.shape_value(i, q),
                                                      collector.weights(Source::pressure));
}

template class ProbeValues<2>;
template class ProbeValues<3>;
} // namespace Continua
