#include <continua/finite_element/looking/field_evaluation.h>

#include <continua/finite_element/looking/cell_of_point.h>
#include <continua/finite_element/looking/field_error.h>
#include <continua/finite_element/looking/moving_share.h>
#include <continua/mesh/cells_in_tree_order.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace Continua
{
using namespace dealii;

template <int dim>
FieldEvaluation<dim>::FieldEvaluation(const Space<dim> &space,
                                      const Problem &problem,
                                      const MetricHistory<dim> *const metrics)
    : FieldProbes<dim>(problem),
      space(space),
      metrics(metrics),
      probe_values(space, problem),
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
  if (!follows_mesh(request, field) || request.kind == ProbeRequest<dim>::Kind::point)
    return {};
  return moving_share(request, direction);
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
  probe_values.fill(&samples_of_probes
                         .emplace(probe, Samples{field, request.component,
                                                 FieldSamples<dim>(space, problem, metrics)})
                         .first->second.points);
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
  const CellOfPoint<dim> found = find_cell_of_point<dim>(space, request, sampled_state.displacement,
                                                         [&](const unsigned int region)
                                                         { return this->counts(request, region); });
  if (found.is_here)
    probe_values.add_at(field, found.cell, Quadrature<dim>(found.unit_point), {1.}, collector,
                        {SampledShare()});
  return found.is_anywhere ? 1. : 0.;
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
            weights.push_back(values.JxW(q) * space.circumference(values.quadrature_point(q)));
          for (const unsigned int q : values.quadrature_point_indices())
          {
            area += weights[q];
            probe_values.add(field, cell, values, pressure_values.get_present_fe_values(), q,
                             weights[q], collector, share(request, field, values.normal_vector(q)),
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
      weights[q] *= space.circumference(part.points[q]);
      shares.push_back(
          share(request, field, part.normals.empty() ? Tensor<1, dim>() : part.normals[q]));
    }
    area = std::accumulate(weights.begin(), weights.end(), area);
    probe_values.add_at(field, part.cell, part.quadrature, weights, collector, shares);
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
        weights.push_back(values.JxW(q) * space.circumference(values.quadrature_point(q)));
      for (const unsigned int q : values.quadrature_point_indices())
      {
        volume += weights[q];
        probe_values.add(field, cell, values, pressure_values.get_present_fe_values(), q,
                         weights[q], collector, share(request, field, Tensor<1, dim>()));
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
          const double weight = values.JxW(q) * space.circumference(values.quadrature_point(q));
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
DistributedVector FieldEvaluation<dim>::ghosted_mixture(const State &state,
                                                        const unsigned int region) const
{
  DistributedVector mixture = space.velocity_vector();
  set_mixture(state, region, problem.materials[region], mixture);
  return space.ghosted_velocity(mixture);
}

template <int dim>
double FieldEvaluation<dim>::error_norm(const State &state,
                                        const ComparedField field,
                                        const std::vector<Expression> &exact,
                                        const double time) const
{
  std::vector<DistributedVector> vectors = vectors_of(
      field, problem, state.velocity, state.displacement_of_shape(),
      [this](const DistributedVector &vector) { return space.ghosted_velocity(vector); },
      [this, &state](const unsigned int region) { return ghosted_mixture(state, region); });
  return FieldError<dim>(space, problem, state, field, std::move(vectors)).norm(exact, time);
}

template class FieldEvaluation<2>;
template class FieldEvaluation<3>;
} // namespace Continua
