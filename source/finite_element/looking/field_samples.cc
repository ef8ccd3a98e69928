#include <continua/finite_element/looking/field_samples.h>

#include <continua/continuum/stress_and_strain.h>
#include <continua/continuum/stress_free_state.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace Continua
{
using namespace dealii;

template <int dim>
void SampledState<dim>::reinit()
{
  mixture = space.velocity_vector();
  velocity = space.ghosted_velocity(mixture);
  pressure = space.ghosted_pressure(space.pressure_vector());
  mixtures.assign(problem.regions.size(), velocity);
  if (problem.has_deformed_regions())
    displacement = velocity;
  if (problem.finds_unloaded_shape())
    unloaded_displacement = velocity;
  if (problem.wall_directions.has_potentials())
    wall_potentials = velocity;
  has_wall_potentials = false;
  if (problem.wall_shear_window.is_kept)
    for (DistributedVector *vector : {&shear_integral, &magnitude_integral})
      *vector = velocity;
}

template <int dim>
void SampledState<dim>::take(const State &state)
{
  space.copy_velocity(state.velocity, velocity);
  space.copy_pressure(state.pressure, pressure);
  for (unsigned int region = 0; region < mixtures.size(); ++region)
  {
    set_mixture(state, region, problem.materials[region], mixture);
    space.copy_velocity(mixture, mixtures[region]);
  }
  if (problem.has_deformed_regions())
    space.copy_velocity(state.displacement_of_shape(), displacement);
  if (state.unloaded_displacement != nullptr)
    space.copy_velocity(*state.unloaded_displacement, unloaded_displacement);
  // They are those of the mesh.
  if (state.wall_potentials != nullptr && !has_wall_potentials)
  {
    space.copy_velocity(*state.wall_potentials, wall_potentials);
    has_wall_potentials = true;
  }
  if (metrics != nullptr)
    metric_mixture = metrics->ghosted_mixture();
  averaged_time = 0.;
  if (state.wall_shear == nullptr)
    return;
  space.copy_velocity(state.wall_shear->integral(), shear_integral);
  space.copy_velocity(state.wall_shear->integral_of_magnitude(), magnitude_integral);
  averaged_time = state.wall_shear->duration();
}

template <int dim>
void FieldSamples<dim>::add_cell(const typename Triangulation<dim>::cell_iterator &cell)
{
  cells.push_back({cell->level(), cell->index(), {}, {}});
  SampledCell &added = cells.back();
  const FiniteElement<dim> &element = space.velocity_element;
  std::vector<types::global_dof_index> indices(element.n_dofs_per_cell());
  typename DoFHandler<dim>::active_cell_iterator(&space.triangulation, cell->level(), cell->index(),
                                                 &space.velocity_dofs)
      ->get_dof_indices(indices);
  added.nodes.resize(element.n_dofs_per_cell() / dim);
  for (unsigned int i = 0; i < indices.size(); ++i)
  {
    const auto [component, node] = element.system_to_component_index(i);
    added.nodes[node][component] = indices[i];
  }
  const typename DoFHandler<dim>::active_cell_iterator pressure_cell(
      &space.triangulation, cell->level(), cell->index(), &space.pressure_dofs);
  added.pressure_indices.resize(pressure_cell->get_fe().n_dofs_per_cell());
  pressure_cell->get_dof_indices(added.pressure_indices);
}

template <int dim>
void FieldSamples<dim>::add(const typename Triangulation<dim>::cell_iterator &cell,
                            const FEValuesBase<dim> &values,
                            const FEValuesBase<dim> &of_pressure,
                            const unsigned int q,
                            const Tensor<1, dim> &normal,
                            const std::array<double, 6> &factors,
                            const double weight,
                            const SampledShare &share)
{
  SamplePoint point;
  point.region = cell->material_id();
  point.weight = weight;
  point.share = share;
  point.place = values.quadrature_point(q);
  point.normal = normal;
  point.factors = factors;

  // The points of a cell come one after the other.
  if (cells.empty() || cell->index() != cells.back().index || cell->level() != cells.back().level)
    add_cell(cell);
  point.cell = cells.size() - 1;
  const FiniteElement<dim> &element = space.velocity_element;
  const unsigned int n_nodes = cells.back().nodes.size();
  point.values.resize(n_nodes);
  point.gradients.resize(n_nodes);
  for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
    if (const auto [component, node] = element.system_to_component_index(i); component == 0)
    {
      point.values[node] = values.shape_value(i, q);
      point.gradients[node] = values.shape_grad(i, q);
    }
  for (unsigned int i = 0; i < cells.back().pressure_indices.size(); ++i)
    point.pressure_values.push_back(of_pressure.shape_value(i, q));
  if (metrics != nullptr)
    point.metric_weights =
        metrics->weights_at(cell, space.mapping.transform_real_to_unit_cell(cell, point.place));
  points.push_back(std::move(point));
}

template <int dim>
Tensor<2, dim> FieldSamples<dim>::gradient(const SamplePoint &point,
                                           const DistributedVector &vector) const
{
  Tensor<2, dim> result;
  const auto &nodes = cells[point.cell].nodes;
  for (unsigned int node = 0; node < nodes.size(); ++node)
    for (unsigned int c = 0; c < dim; ++c)
      result[c] += vector(nodes[node][c]) * point.gradients[node];
  return result;
}

template <int dim>
Tensor<1, dim> FieldSamples<dim>::vector_value(const SamplePoint &point,
                                               const DistributedVector &vector) const
{
  Tensor<1, dim> result;
  const auto &nodes = cells[point.cell].nodes;
  for (unsigned int node = 0; node < nodes.size(); ++node)
    for (unsigned int c = 0; c < dim; ++c)
      result[c] += vector(nodes[node][c]) * point.values[node];
  return result;
}

template <int dim>
double FieldSamples<dim>::hoop(const SamplePoint &point,
                               const DistributedVector &vector,
                               const Tensor<2, dim> &gradient) const
{
  if (!space.is_axisymmetric())
    return 0.;
  // On the axis the hoop strain is the radial one.
  const double r = point.place[1];
  return r > 0. ? vector_value(point, vector)[1] / r : gradient[1][1];
}

template <int dim>
double FieldSamples<dim>::weight(const SampledState<dim> &state, const unsigned int number) const
{
  using Kind = SampledShare::Kind;
  const SamplePoint &point = points[number];
  if (point.share.kind == Kind::undeformed)
    return point.weight;
  const Kinematics motion = kinematics_at(point, state);
  switch (point.share.kind)
  {
  case Kind::line:
    return point.weight * (motion.deformation_gradient() * point.share.direction).norm();
  case Kind::area:
    return point.weight * motion.area(point.share.direction).norm();
  default:
    return point.weight * motion.volume_ratio();
  }
}

template <int dim>
Point<dim> FieldSamples<dim>::place(const SampledState<dim> &state, const unsigned int number) const
{
  const SamplePoint &point = points[number];
  return problem.mesh_moves ? point.place + vector_value(point, state.displacement) : point.place;
}

template <int dim>
Kinematics FieldSamples<dim>::kinematics_at(const SamplePoint &point,
                                            const SampledState<dim> &state) const
{
  const Tensor<2, dim> of_displacement = gradient(point, state.displacement);
  return Kinematics(
      whole_gradient<dim>(of_displacement, hoop(point, state.displacement, of_displacement)));
}

template <int dim>
StressFreeState FieldSamples<dim>::stress_free_state(const SamplePoint &point,
                                                     const SampledState<dim> &state) const
{
  const auto gradient_of = [&](const DistributedVector &vector)
  {
    const Tensor<2, dim> in_place = gradient(point, vector);
    return whole_gradient<dim>(in_place, hoop(point, vector, in_place));
  };
  const Material &material = problem.materials[point.region];
  return stress_free_state_at(
      material,
      has_directions(material)
          ? problem.wall_directions.find(problem.model, point.place,
                                         problem.wall_directions.has_potentials()
                                             ? gradient_of(state.wall_potentials)
                                             : Tensor<2, 3>())
          : TubeDirections(),
      1.,
      problem.finds_unloaded_shape() ? gradient_of(state.unloaded_displacement) : Tensor<2, 3>());
}

template <int dim>
std::array<double, 6> FieldSamples<dim>::stress_at(const SamplePoint &point,
                                                   const SampledState<dim> &state) const
{
  if (problem.is_deformed(point.region))
  {
    const Material &material = problem.materials[point.region];
    const Tensor<2, dim> of_velocity = gradient(point, state.velocity);
    return finite_stress(
        material, stress_free_state(point, state), kinematics_at(point, state),
        whole_gradient<dim>(of_velocity, hoop(point, state.velocity, of_velocity)),
        pressure_at(point, state),
        MetricHistory<dim>::mixture_at(point.metric_weights, state.metric_mixture));
  }
  const DistributedVector &mixture = state.mixtures[point.region];
  Tensor<2, dim> of_mixture = gradient(point, mixture);
  double of_hoop = hoop(point, mixture, of_mixture);
  const Shear &shear = problem.materials[point.region].shear;
  if (shear.flow_curve)
  {
    const double factor = thinning<dim>(*shear.flow_curve, of_mixture, of_hoop, problem.model);
    of_mixture *= factor;
    of_hoop *= factor;
  }
  return stress<dim>(of_mixture, of_hoop, pressure_at(point, state), problem.model);
}

template <int dim>
double FieldSamples<dim>::pressure_at(const SamplePoint &point,
                                      const SampledState<dim> &state) const
{
  const auto &indices = cells[point.cell].pressure_indices;
  double p = 0.;
  for (unsigned int i = 0; i < indices.size(); ++i)
    p += point.pressure_values[i] * state.pressure(indices[i]);
  return p;
}

template <int dim>
Tensor<1, dim> FieldSamples<dim>::traction_at(const SampledState<dim> &state,
                                              const unsigned int number) const
{
  return traction<dim>(stress_at(points[number], state), normal_at(points[number], state));
}

template <int dim>
Tensor<1, dim> FieldSamples<dim>::shear_on_wall(const SampledState<dim> &state,
                                                const unsigned int number) const
{
  const Tensor<1, dim> normal = normal_at(points[number], state),
                       whole = traction_at(state, number);
  return (whole * normal) * normal - whole;
}

template <int dim>
double FieldSamples<dim>::drag_at(const FieldDefinition<dim> &field,
                                  const SamplePoint &point,
                                  const SampledState<dim> &state) const
{
  const auto directions = field.directions(point.place);
  const Kinematics motion = kinematics_at(point, state);
  const Tensor<1, 3> along = motion.deformation_gradient() * directions.axial,
                     normal = motion.area(directions.radial);
  const std::array<double, 6> stress = stress_at(point, state);
  double sum = 0.;
  for (unsigned int k = 0; k < stress.size(); ++k)
  {
    const auto [i, j] = stress_pairs[k];
    sum +=
        stress[k] * (i == j ? along[i] * normal[i] : along[i] * normal[j] + along[j] * normal[i]);
  }
  return -sum / (along.norm() * normal.norm());
}

template <int dim>
double FieldSamples<dim>::velocity_through(const SamplePoint &point,
                                           const SampledState<dim> &state) const
{
  const Tensor<1, 3> area = kinematics_at(point, state).area(point.share.direction);
  const Tensor<1, dim> velocity = vector_value(point, state.velocity);
  double sum = 0.;
  for (unsigned int c = 0; c < dim; ++c)
    sum += velocity[c] * area[c];
  return sum / area.norm();
}

template <int dim>
Tensor<1, dim> FieldSamples<dim>::normal_at(const SamplePoint &point,
                                            const SampledState<dim> &state) const
{
  if (!problem.is_deformed(point.region))
    return point.normal;
  Tensor<1, 3> undeformed;
  for (unsigned int c = 0; c < dim; ++c)
    undeformed[c] = point.normal[c];
  const Tensor<1, 3> area = kinematics_at(point, state).area(undeformed);
  Tensor<1, dim> normal;
  for (unsigned int c = 0; c < dim; ++c)
    normal[c] = area[c] / area.norm();
  return normal;
}

template <int dim>
std::pair<Tensor<2, dim>, double>
FieldSamples<dim>::velocity_gradient_at(const SamplePoint &point,
                                        const SampledState<dim> &state) const
{
  const Tensor<2, dim> by_reference = gradient(point, state.velocity);
  const double of_hoop = hoop(point, state.velocity, by_reference);
  if (!problem.is_deformed(point.region))
    return {by_reference, of_hoop};
  const Tensor<2, 3> whole =
      kinematics_at(point, state).gradient(whole_gradient<dim>(by_reference, of_hoop));
  Tensor<2, dim> present;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int d = 0; d < dim; ++d)
      present[c][d] = whole[c][d];
  return {present, dim == 2 ? whole[2][2] : 0.};
}

template <int dim>
double FieldSamples<dim>::value(const FieldDefinition<dim> &field,
                                const SampledState<dim> &state,
                                const unsigned int number) const
{
  using Quantity = typename FieldDefinition<dim>::Quantity;
  const SamplePoint &point = points[number];
  const auto product = [&point](const Tensor<1, dim> &vector)
  {
    double sum = 0.;
    for (unsigned int c = 0; c < dim; ++c)
      sum += point.factors[c] * vector[c];
    return sum;
  };
  switch (field.quantity)
  {
  case Quantity::velocity:
    if (field.combination == FieldDefinition<dim>::Combination::through)
      return velocity_through(point, state);
    return product(vector_value(point, state.velocity));
  case Quantity::displacement:
    return product(vector_value(point, state.displacement));
  case Quantity::unloaded_displacement:
    return product(vector_value(point, state.unloaded_displacement));
  case Quantity::pressure:
    return problem.plane_stress(point.region).pressure_factor * pressure_at(point, state);
  case Quantity::vorticity:
    return vorticity<dim>(velocity_gradient_at(point, state).first)[field.component];
  case Quantity::q_criterion:
  {
    const auto [of_velocity, of_hoop] = velocity_gradient_at(point, state);
    return q_criterion<dim>(of_velocity, of_hoop, problem.model);
  }
  case Quantity::strain:
  {
    const Kinematics kinematics = kinematics_at(point, state);
    if (field.combination == FieldDefinition<dim>::Combination::trace)
      return kinematics.volume_ratio() - 1.;
    const std::array<double, 6> components = green_strain(kinematics);
    return std::inner_product(components.begin(), components.end(), point.factors.begin(), 0.);
  }
  case Quantity::wall_shear_stress:
    return shear_on_wall(state, number)[field.component];
  case Quantity::wall_shear_stress_magnitude:
    return shear_on_wall(state, number).norm();
  case Quantity::average_wall_shear_stress:
    return state.averaged_time > 0.
               ? vector_value(point, state.magnitude_integral)[0] / state.averaged_time
               : 0.;
  case Quantity::oscillatory_shear_index:
  {
    const double magnitude = vector_value(point, state.magnitude_integral)[0];
    // Between the nodes both integrals are interpolated, the vector and its magnitude, by functions
    // that have negative parts: there the magnitude may be less than the norm of the vector.
    return magnitude > 0.
               ? std::max(0.,
                          0.5 * (1. - vector_value(point, state.shear_integral).norm() / magnitude))
               : 0.;
  }
  case Quantity::relative_residence_time:
  {
    const double norm = vector_value(point, state.shear_integral).norm();
    return norm > 0. ? state.averaged_time / norm : 0.;
  }
  default:
  {
    if (field.combination == FieldDefinition<dim>::Combination::drag &&
        problem.is_deformed(point.region))
      return drag_at(field, point, state);
    const std::array<double, 6> components = stress_at(point, state);
    return std::inner_product(components.begin(), components.end(), point.factors.begin(), 0.);
  }
  }
}

template class SampledState<2>;
template class SampledState<3>;
template class FieldSamples<2>;
template class FieldSamples<3>;
} // namespace Continua
