#include <continua/base/collective.h>
#include <continua/finite_element/field_evaluation.h>
#include <continua/finite_element/kinematics_at.h>
#include <continua/finite_element/present_cell_point.h>
#include <continua/mesh/cell_point.h>
#include <continua/mesh/cells_in_tree_order.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/mpi.templates.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/cell_id.h>
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

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
    const Tensor<1, dim> whole = traction<dim>(unit, normal);
    factors[k] = (whole * normal) * normal[component] - whole[component];
  }
  return factors;
}
} // namespace

template <int dim>
FieldEvaluation<dim>::FieldEvaluation(const Space<dim> &space,
                                      const Problem &problem,
                                      const MetricHistory<dim> *const metrics)
    : FieldProbes<dim>(problem),
      space(space),
      metrics(metrics),
      sampled_state(space, problem, metrics)
{
}

template <int dim>
bool FieldEvaluation<dim>::needs_samples(const ProbeRequest<dim> &request,
                                         const FieldDefinition<dim> &field) const
{
  using Quantity = typename FieldDefinition<dim>::Quantity;
  if (request.kind == ProbeRequest<dim>::Kind::sign_change || follows_mesh(request, field))
    return true;
  if (problem.has_deformed_regions())
    return field.quantity != Quantity::velocity && field.quantity != Quantity::displacement &&
           field.quantity != Quantity::pressure;
  if (field.quantity == Quantity::stress || field.quantity == Quantity::wall_shear_stress)
  {
    // A viscosity that follows the rate of shear.
    for (unsigned int region = 0; region < problem.materials.size(); ++region)
      if (this->counts(request, region) && problem.materials[region].shear.flow_curve)
        return true;
    return false;
  }
  return field.quantity == Quantity::q_criterion || field.is_average() ||
         field.quantity == Quantity::wall_shear_stress_magnitude;
}

template <int dim>
bool FieldEvaluation<dim>::follows_mesh(const ProbeRequest<dim> &request,
                                        const FieldDefinition<dim> &field) const
{
  using Kind = typename ProbeRequest<dim>::Kind;
  using Quantity = typename FieldDefinition<dim>::Quantity;
  if (request.is_fixed_in_space)
    return true;
  if (!problem.mesh_moves)
    return false;
  switch (request.kind)
  {
  case Kind::section_flow:
    return true;
  case Kind::boundary_mean:
  case Kind::boundary_integral:
  case Kind::section_mean:
  case Kind::section_integral:
  case Kind::volume_mean:
  case Kind::volume_integral:
  case Kind::rim_mean:
    // The mean of a displacement is one over matter.
    return field.quantity != Quantity::displacement &&
           field.quantity != Quantity::unloaded_displacement && field.quantity != Quantity::strain;
  default:
    return false;
  }
}

template <int dim>
void FieldEvaluation<dim>::forget_mesh()
{
  mesh_displacement = DistributedVector();
  has_sampled_state = false;
  flows_of_probes.clear();
}

template <int dim>
void FieldEvaluation<dim>::take_state(const State &state)
{
  if (!samples_of_probes.empty())
    sampled_state.take(state);
  if (state.mesh_displacement != nullptr)
    mesh_displacement = space.ghosted_velocity(*state.mesh_displacement);
}

template <int dim>
SampledShare FieldEvaluation<dim>::share(const ProbeRequest<dim> &request,
                                         const FieldDefinition<dim> &field,
                                         const Tensor<1, dim> &direction) const
{
  using Kind = typename ProbeRequest<dim>::Kind;
  SampledShare result;
  if (!follows_mesh(request, field) || request.kind == Kind::point)
    return result;
  Tensor<1, 3> normal, across;
  for (unsigned int c = 0; c < dim; ++c)
  {
    normal[c] = request.is_section() ? request.normal[c] / request.normal.norm() : direction[c];
    across[c] = direction[c];
  }
  switch (request.kind)
  {
  case Kind::volume_mean:
  case Kind::volume_integral:
    result.kind = SampledShare::Kind::volume;
    break;
  case Kind::rim_mean:
    // In the plane of a model in two dimensions it is a point, whose line runs across the plane.
    result.kind = SampledShare::Kind::line;
    result.direction = cross_product_3d(normal, across);
    break;
  default:
    result.kind = SampledShare::Kind::area;
    result.direction = normal;
  }
  return result;
}

template <int dim>
void FieldEvaluation<dim>::begin_samples(const unsigned int probe)
{
  if (!has_sampled_state)
    sampled_state.reinit();
  has_sampled_state = true;
  const auto &definition = this->definition(probe);
  const ProbeRequest<dim> &request = definition.first;
  FieldDefinition<dim> field = definition.second;
  // The flow through a section that has turned or bent is that along its present normal.
  if (request.kind == ProbeRequest<dim>::Kind::section_integral && follows_mesh(request, field) &&
      field.quantity == FieldDefinition<dim>::Quantity::velocity &&
      field.combination == FieldDefinition<dim>::Combination::axial)
    field.combination = FieldDefinition<dim>::Combination::through;
  samples_of_probes.erase(probe);
  samples_to_fill = &samples_of_probes
                         .emplace(probe, Samples{field, request.component,
                                                 FieldSamples<dim>(space, problem, metrics)})
                         .first->second.points;
}

template <int dim>
void FieldEvaluation<dim>::sample(const unsigned int probe, std::vector<Sample> &samples) const
{
  const Samples &of_probe = samples_of_probes.at(probe);
  for (unsigned int i = 0; i < of_probe.points.size(); ++i)
    samples.push_back({of_probe.points.weight(sampled_state, i),
                       of_probe.points.place(sampled_state, i)[of_probe.coordinate],
                       of_probe.points.value(of_probe.field, sampled_state, i)});
}

template <int dim>
bool FieldEvaluation<dim>::has_face(const ProbeRequest<dim> &request,
                                    const CellIterator &cell,
                                    const unsigned int face) const
{
  return cell->face(face)->at_boundary()
             ? request.boundary_ids.count(cell->face(face)->boundary_id()) > 0
             : request.neighbour_ids.count(cell->neighbor(face)->material_id()) > 0;
}

template <int dim>
ProbeWeights::Collector FieldEvaluation<dim>::collector() const
{
  return {space.velocity_vector(), space.pressure_vector(),
          static_cast<unsigned int>(problem.regions.size())};
}

template <int dim>
double FieldEvaluation<dim>::add_point(const ProbeRequest<dim> &request,
                                       const FieldDefinition<dim> &field,
                                       Collector &collector) const
{
  // Of all cells that hold the point, on whatever rank, the first by its identity: stress and
  // pressure do not depend on the partition.
  CellIterator chosen;
  Point<dim> unit_point;
  CellId chosen_id;
  bool found = false;
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned() && this->counts(request, cell->material_id()))
    {
      Point<dim> candidate;
      if ((request.is_fixed_in_space
               ? cell_holds_present_point(space, cell, sampled_state.displacement, request.point,
                                          candidate)
               : cell_holds_point<dim>(space.mapping, cell, request.point, candidate)) &&
          (!found || cell->id() < chosen_id))
      {
        found = true;
        chosen = cell;
        chosen_id = cell->id();
        unit_point = candidate;
      }
    }
  std::string first;
  for (const std::string &of_rank :
       all_gather(space.communicator, found ? chosen_id.to_string() : std::string()))
    if (!of_rank.empty() && (first.empty() || CellId(of_rank) < CellId(first)))
      first = of_rank;
  if (found && CellId(first) == chosen_id)
    add_values(field, chosen, Quadrature<dim>(unit_point), {1.}, collector, {SampledShare()});
  return first.empty() ? 0. : 1.;
}

template <int dim>
double FieldEvaluation<dim>::add_boundary(const ProbeRequest<dim> &request,
                                          const FieldDefinition<dim> &field,
                                          Collector &collector) const
{
  const Quadrature<dim - 1> quadrature = space.face_quadrature(space.n_quadrature_points());
  FEFaceValues<dim> values(space.mapping, space.velocity_element, quadrature,
                           update_values | update_gradients | update_quadrature_points |
                               update_JxW_values | update_normal_vectors);
  hp::FEFaceValues<dim> pressure_values(space.mappings, space.pressure_elements,
                                        hp::QCollection<dim - 1>(quadrature), update_values);
  double area = 0.;
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (cell->is_locally_owned() && this->counts(request, cell->material_id()))
      for (const unsigned int f : cell->face_indices())
        if (has_face(request, cell, f))
        {
          values.reinit(cell, f);
          pressure_values.reinit(
              typename DoFHandler<dim>::active_cell_iterator(&space.triangulation, cell->level(),
                                                             cell->index(), &space.pressure_dofs),
              f);
          std::vector<double> weights;
          for (const unsigned int q : values.quadrature_point_indices())
            weights.push_back(values.JxW(q) * space.measure(values.quadrature_point(q)));
          for (const unsigned int q : values.quadrature_point_indices())
          {
            area += weights[q];
            add_value(field, cell, values, pressure_values.get_present_fe_values(), q, weights[q],
                      collector, share(request, field, values.normal_vector(q)),
                      values.normal_vector(q));
          }
        }
  return Utilities::MPI::sum(area, space.communicator);
}

template <int dim>
double FieldEvaluation<dim>::add_section(const ProbeRequest<dim> &request,
                                         const FieldDefinition<dim> &field,
                                         Collector &collector) const
{
  // One more Gauss point than on cells, since the integrand is not a polynomial in the plane.
  const PlaneSection<dim> section(
      space.mapping, space.triangulation, PlaneSection<dim>::Cells::active, request.region_ids,
      request.point, request.normal, space.n_quadrature_points() + 1, request.axis.get());
  const auto parts =
      request.kind == ProbeRequest<dim>::Kind::rim_mean ? section.outer_rim() : section.parts();
  double area = 0.;
  for (const auto &part : parts)
  {
    std::vector<double> weights = part.quadrature.get_weights();
    std::vector<SampledShare> shares;
    for (unsigned int q = 0; q < weights.size(); ++q)
    {
      weights[q] *= space.measure(part.points[q]);
      shares.push_back(
          share(request, field, part.normals.empty() ? Tensor<1, dim>() : part.normals[q]));
    }
    area = std::accumulate(weights.begin(), weights.end(), area);
    add_values(field, part.cell, part.quadrature, weights, collector, shares);
  }
  return Utilities::MPI::sum(area, space.communicator);
}

template <int dim>
double FieldEvaluation<dim>::add_volume(const ProbeRequest<dim> &request,
                                        const FieldDefinition<dim> &field,
                                        Collector &collector) const
{
  const Quadrature<dim> quadrature = space.quadrature(space.n_quadrature_points());
  FEValues<dim> values(space.mapping, space.velocity_element, quadrature,
                       update_values | update_gradients | update_quadrature_points |
                           update_JxW_values);
  hp::FEValues<dim> pressure_values(space.mappings, space.pressure_elements,
                                    hp::QCollection<dim>(quadrature), update_values);
  double volume = 0.;
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (cell->is_locally_owned() && this->counts(request, cell->material_id()))
    {
      values.reinit(cell);
      pressure_values.reinit(typename DoFHandler<dim>::active_cell_iterator(
          &space.triangulation, cell->level(), cell->index(), &space.pressure_dofs));
      std::vector<double> weights;
      for (const unsigned int q : values.quadrature_point_indices())
        weights.push_back(values.JxW(q) * space.measure(values.quadrature_point(q)));
      for (const unsigned int q : values.quadrature_point_indices())
      {
        volume += weights[q];
        add_value(field, cell, values, pressure_values.get_present_fe_values(), q, weights[q],
                  collector, share(request, field, Tensor<1, dim>()));
      }
    }
  return Utilities::MPI::sum(volume, space.communicator);
}

template <int dim>
double FieldEvaluation<dim>::add_interface(const ProbeRequest<dim> &request,
                                           Collector &collector) const
{
  FEFaceValues<dim> values(
      space.mapping, space.velocity_element, space.face_quadrature(space.n_quadrature_points()),
      update_values | update_normal_vectors | update_quadrature_points | update_JxW_values);
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  double area = 0.;
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (cell->is_locally_owned() && this->counts(request, cell->material_id()))
      for (const unsigned int f : cell->face_indices())
      {
        if (cell->at_boundary(f) || this->counts(request, cell->neighbor(f)->material_id()))
          continue;
        values.reinit(cell, f);
        cell->get_dof_indices(indices);
        for (const unsigned int q : values.quadrature_point_indices())
        {
          const double weight = values.JxW(q) * space.measure(values.quadrature_point(q));
          area += weight;
          for (unsigned int i = 0; i < indices.size(); ++i)
          {
            const unsigned int c = space.velocity_element.system_to_component_index(i).first;
            const double factor = weight * values.normal_vector(q)[c] * values.shape_value(i, q);
            if (factor != 0.)
              space.velocity_hanging.distribute_local_to_global(
                  indices[i], factor, collector.weights(Source::displacement));
          }
        }
      }
  return Utilities::MPI::sum(area, space.communicator);
}

template <int dim>
double FieldEvaluation<dim>::add_force(const ProbeRequest<dim> &request, Collector &collector) const
{
  // Each node once, also one of several faces or boundaries. The rows of hanging nodes are part of
  // those that they hang on, which may belong to larger faces on the other side alone. A node of
  // this rank may be on faces of another one's cells only.
  DistributedVector &weights = collector.weights(Source::force);
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_face());
  double n_nodes = 0.;
  const auto take = [&](const types::global_dof_index index)
  {
    if (!space.velocity_owned.is_element(index))
      return;
    // Minus: the force on what holds the node.
    weights.begin()[space.velocity_owned.index_within_set(index)] = -1.;
    n_nodes += 1.;
  };
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (!cell->is_artificial() && this->counts(request, cell->material_id()))
      for (const unsigned int f : cell->face_indices())
      {
        if (!has_face(request, cell, f))
          continue;
        cell->face(f)->get_dof_indices(indices, cell->active_fe_index());
        for (unsigned int i = 0; i < indices.size(); ++i)
          if (space.velocity_element.face_system_to_component_index(i, f).first !=
              request.component)
            continue;
          else if (!space.velocity_hanging.is_constrained(indices[i]))
            take(indices[i]);
          else
            for (const auto &entry : *space.velocity_hanging.get_constraint_entries(indices[i]))
              take(entry.first);
      }
  return Utilities::MPI::sum(n_nodes, space.communicator);
}

template <int dim>
double FieldEvaluation<dim>::add_flow(const ProbeRequest<dim> &request, Collector &collector) const
{
  const auto make = [&]
  {
    return std::make_unique<SectionFlow<dim>>(space, request.region_ids, request.point,
                                              request.normal, request.axis);
  };
  DistributedVector &weights = collector.weights(Source::velocity);
  if (!problem.mesh_moves)
    return make()->add_weights(weights) ? 1. : 0.;
  std::unique_ptr<SectionFlow<dim>> &flow = flows_of_probes[this->present_probe()];
  if (flow == nullptr)
    flow = make();
  return flow->add_weights(weights, mesh_displacement.size() > 0 ? &mesh_displacement : nullptr)
             ? 1.
             : 0.;
}

template <int dim>
void FieldEvaluation<dim>::add_values(const FieldDefinition<dim> &field,
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
    add_value(field, cell, values, pressure_values.get_present_fe_values(), q, weights[q],
              collector, shares[q]);
}

template <int dim>
void FieldEvaluation<dim>::add_value(const FieldDefinition<dim> &field,
                                     const CellIterator &cell,
                                     const FEValuesBase<dim> &values,
                                     const FEValuesBase<dim> &pressure_values,
                                     const unsigned int q,
                                     const double weight,
                                     Collector &collector,
                                     const SampledShare &share,
                                     const Tensor<1, dim> &normal) const
{
  using Quantity = typename FieldDefinition<dim>::Quantity;
  const unsigned int region = cell->material_id();
  const bool is_wall_shear = field.quantity == Quantity::wall_shear_stress;
  const std::array<double, 6> factors = is_wall_shear
                                            ? wall_shear_factors<dim>(normal, field.component)
                                            : field.factors(values.quadrature_point(q));
  if (samples_to_fill != nullptr)
  {
    samples_to_fill->add(cell, values, pressure_values, q, normal, factors, weight, share);
    return;
  }
  const auto combine = [&factors](const std::array<double, 6> &components)
  { return std::inner_product(factors.begin(), factors.end(), components.begin(), 0.); };

  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  typename DoFHandler<dim>::active_cell_iterator(&space.triangulation, cell->level(), cell->index(),
                                                 &space.velocity_dofs)
      ->get_dof_indices(indices);
  if (field.quantity == Quantity::velocity || field.quantity == Quantity::displacement)
  {
    const Source source =
        field.quantity == Quantity::velocity ? Source::velocity : Source::displacement;
    for (unsigned int i = 0; i < indices.size(); ++i)
    {
      const double factor = factors[space.velocity_element.system_to_component_index(i).first];
      if (factor != 0.)
        space.velocity_hanging.distribute_local_to_global(
            indices[i], weight * factor * values.shape_value(i, q), collector.weights(source));
    }
    return;
  }
  double pressure_weight = problem.plane_stress(region).pressure_factor;
  if (field.quantity != Quantity::pressure)
  {
    // The stress is linear in the mixture and the pressure, the strain in the displacement, the
    // vorticity in the velocity, so the weights are those of unit entries.
    const bool is_strain = field.quantity == Quantity::strain,
               is_vorticity = field.quantity == Quantity::vorticity;
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
      const double unit = combine(
          is_strain      ? strain<dim>(gradient, hoop, problem.model, problem.plane_stress(region))
          : is_vorticity ? vorticity<dim>(gradient)
                         : stress<dim>(gradient, hoop, 0., problem.model));
      if (unit != 0.)
        space.velocity_hanging.distribute_local_to_global(indices[i], weight * unit, target);
    }
    // The pressure has no tangential part.
    if (is_strain || is_vorticity || is_wall_shear)
      return;
    pressure_weight = combine(stress<dim>(Tensor<2, dim>(), 0., 1., problem.model));
  }
  const typename DoFHandler<dim>::active_cell_iterator pressure_cell(
      &space.triangulation, cell->level(), cell->index(), &space.pressure_dofs);
  indices.resize(pressure_cell->get_fe().n_dofs_per_cell());
  pressure_cell->get_dof_indices(indices);
  for (unsigned int i = 0; i < indices.size(); ++i)
    space.pressure_hanging.distribute_local_to_global(
        indices[i], weight * pressure_weight * pressure_values.shape_value(i, q),
        collector.weights(Source::pressure));
}

template <int dim>
DistributedVector FieldEvaluation<dim>::ghosted_mixture(const State &state,
                                                        const unsigned int region) const
{
  DistributedVector mixture = space.velocity_vector();
  set_mixture(state, region, problem.materials[region], mixture);
  return space.ghosted_velocity(mixture);
}

template <int dim>
double FieldEvaluation<dim>::error_norm(const State &state,
                                        const std::string &field,
                                        const std::vector<Expression> &exact,
                                        const double time) const
{
  const bool is_pressure = field == "pressure";
  const bool is_stress = field == "stress";
  if (!is_pressure && !is_stress && field != "velocity" && field != "displacement")
    throw std::invalid_argument("there is no field '" + field + "'");
  const DistributedVector pressure = space.ghosted_pressure(state.pressure);
  std::vector<DistributedVector> vectors;
  if (is_stress)
    for (unsigned int region = 0; region < problem.regions.size(); ++region)
      vectors.push_back(ghosted_mixture(state, region));
  else if (!is_pressure)
    vectors.push_back(space.ghosted_velocity(field == "velocity" ? state.velocity
                                                                 : state.displacement_of_shape()));

  // Well above the degree of the fields, so that the number is the error and not the quadrature's.
  const Quadrature<dim> quadrature = space.quadrature(space.degree() + 3);
  FEValues<dim> values(space.mapping, space.velocity_element, quadrature,
                       update_values | update_gradients | update_quadrature_points |
                           update_JxW_values);
  hp::FEValues<dim> hp_pressure_values(space.mappings, space.pressure_elements,
                                       hp::QCollection<dim>(quadrature), update_values);
  // What a mesh that moves shows is compared where it is; displacements are those of matter.
  const bool moves = state.mesh_displacement != nullptr && field != "displacement";
  const DistributedVector displacement =
      moves ? space.ghosted_velocity(*state.mesh_displacement) : DistributedVector();
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  std::vector<Vector<double>> ways(quadrature.size(), Vector<double>(dim));
  std::vector<Vector<double>> vector_values(quadrature.size(), Vector<double>(dim));
  std::vector<std::vector<Tensor<1, dim>>> gradients(quadrature.size(),
                                                     std::vector<Tensor<1, dim>>(dim));
  std::vector<Vector<double>> pressures(quadrature.size(),
                                        Vector<double>(space.pressure_elements.n_components()));
  double sum = 0.;
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (cell->is_locally_owned())
    {
      const unsigned int region = cell->material_id();
      values.reinit(cell);
      if (is_pressure || is_stress)
      {
        hp_pressure_values.reinit(typename DoFHandler<dim>::active_cell_iterator(
            &space.triangulation, cell->level(), cell->index(), &space.pressure_dofs));
        hp_pressure_values.get_present_fe_values().get_function_values(pressure, pressures);
      }
      if (!is_pressure)
        values.get_function_values(vectors[is_stress ? region : 0], vector_values);
      if (is_stress)
        values.get_function_gradients(vectors[region], gradients);
      if (moves)
      {
        values.get_function_values(displacement, ways);
        cell->get_dof_indices(indices);
      }
      for (const unsigned int q : values.quadrature_point_indices())
      {
        const Point<dim> &point = values.quadrature_point(q);
        double coordinates[3] = {0., 0., 0.};
        for (unsigned int c = 0; c < dim; ++c)
          coordinates[c] = point[c] + ways[q][c];
        const double stretch =
            moves ? kinematics_at(space, values, q, indices, displacement).volume_ratio() : 1.;
        std::array<double, 6> present = {{0., 0., 0., 0., 0., 0.}};
        const double p = pressures[q][space.pressure_component(region)];
        if (is_pressure)
          present[0] = problem.plane_stress(region).pressure_factor * p;
        else if (is_stress)
        {
          Tensor<2, dim> gradient;
          for (unsigned int c = 0; c < dim; ++c)
            gradient[c] = gradients[q][c];
          const double hoop = space.is_axisymmetric() ? vector_values[q][1] / point[1] : 0.;
          present = stress<dim>(gradient, hoop, p, problem.model);
        }
        else
          for (unsigned int c = 0; c < dim; ++c)
            present[c] = vector_values[q][c];
        double square = 0.;
        for (unsigned int c = 0; c < exact.size(); ++c)
        {
          const double difference = present[c] - exact[c](coordinates, time);
          square += difference * difference;
        }
        sum += square * stretch * values.JxW(q) * space.measure(point);
      }
    }
  return std::sqrt(Utilities::MPI::sum(sum, space.communicator));
}

template class FieldEvaluation<2>;
template class FieldEvaluation<3>;
} // namespace Continua
