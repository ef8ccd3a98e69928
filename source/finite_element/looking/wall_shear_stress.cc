#include <continua/finite_element/looking/wall_shear_stress.h>

#include <continua/continuum/motion_extremes.h>
#include <continua/mesh/cells_in_tree_order.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
const UpdateFlags wall_flags =
    update_values | update_gradients | update_quadrature_points | update_inverse_jacobians;
} // namespace

template <int dim>
bool WallShearStress<dim>::is_wall(const Cell &cell, const unsigned int face) const
{
  const unsigned int region = cell->material_id();
  if (problem.materials[region].is_solid())
    return false;
  if (!cell->at_boundary(face))
    return problem.materials[cell->neighbor(face)->material_id()].is_solid();
  return Continua::is_wall(problem, cell->face(face)->boundary_id(), region);
}

template <int dim>
Tensor<1, dim> WallShearStress<dim>::normal_of(const FEValues<dim> &values,
                                               const unsigned int q,
                                               const unsigned int face)
{
  // A face of the unit cell is that of a coordinate, whose gradient is along the normal.
  Tensor<1, dim> normal;
  for (unsigned int d = 0; d < dim; ++d)
    normal[d] = (face % 2 == 0 ? -1. : 1.) * values.inverse_jacobian(q)[face / 2][d];
  return normal / normal.norm();
}

template <int dim>
void WallShearStress<dim>::add_sample(const Cell &cell,
                                      const unsigned int face,
                                      const FEValues<dim> &values,
                                      const FEValuesBase<dim> &pressure_values,
                                      const unsigned int q,
                                      const std::array<types::global_dof_index, dim> &indices)
{
  if (!space.velocity_owned.is_element(indices[0]) ||
      space.velocity_hanging.is_constrained(indices[0]))
    return;
  const auto [entry, is_new] = number_of_node.emplace(indices[0], nodes.size());
  if (is_new)
  {
    nodes.emplace_back();
    for (unsigned int c = 0; c < dim; ++c)
      nodes.back().indices[c] = space.velocity_owned.index_within_set(indices[c]);
  }
  nodes[entry->second].samples.push_back(samples.size());
  samples.add(cell, values, pressure_values, q, normal_of(values, q, face), {}, 1.);
}

template <int dim>
std::vector<std::array<types::global_dof_index, dim>>
WallShearStress<dim>::nodes_of(const Cell &cell) const
{
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  cell->get_dof_indices(indices);
  std::vector<std::array<types::global_dof_index, dim>> result(indices.size() / dim);
  for (unsigned int i = 0; i < indices.size(); ++i)
  {
    const auto [component, node] = space.velocity_element.system_to_component_index(i);
    result[node][component] = indices[i];
  }
  return result;
}

template <int dim>
void WallShearStress<dim>::add_nodes_of_coarser_neighbour(const Cell &cell, const unsigned int face)
{
  // On a face with hanging nodes the vectors have their values at the nodes of the solid's cell.
  const Cell neighbour = cell->neighbor(face);
  if (neighbour->is_artificial())
    return;
  const FiniteElement<dim> &base = space.velocity_element.base_element(0);
  const unsigned int face_of_neighbour = cell->neighbor_of_coarser_neighbor(face).first;
  const auto own_nodes = nodes_of(cell), other_nodes = nodes_of(neighbour);
  for (unsigned int node = 0; node < other_nodes.size(); ++node)
  {
    const std::array<types::global_dof_index, dim> &indices = other_nodes[node];
    if (!base.has_support_on_face(node, face_of_neighbour) ||
        std::find(own_nodes.begin(), own_nodes.end(), indices) != own_nodes.end())
      continue;
    Point<dim> unit_point = space.mapping.transform_real_to_unit_cell(
        cell, space.mapping.transform_unit_to_real_cell(neighbour, base.unit_support_point(node)));
    // A curved face of the neighbour need not be that of the cell.
    unit_point[face / 2] = face % 2;
    constexpr double tolerance = 1e-8;
    if (GeometryInfo<dim>::distance_to_unit_cell(unit_point) > tolerance)
      continue;
    const Quadrature<dim> point(unit_point);
    FEValues<dim> values(space.mapping, space.velocity_element, point, wall_flags);
    hp::FEValues<dim> pressure_values(space.mappings, space.pressure_elements,
                                      hp::QCollection<dim>(point), update_values);
    values.reinit(cell);
    pressure_values.reinit(pressure_cell(cell));
    add_sample(cell, face, values, pressure_values.get_present_fe_values(), 0, indices);
  }
}

template <int dim>
typename DoFHandler<dim>::active_cell_iterator
WallShearStress<dim>::pressure_cell(const Cell &cell) const
{
  return {&space.triangulation, cell->level(), cell->index(), &space.pressure_dofs};
}

template <int dim>
void WallShearStress<dim>::reinit()
{
  samples.clear();
  nodes.clear();
  number_of_node.clear();
  if (!problem.further_fields.wall_shear_stress && !problem.wall_shear_window.is_kept)
    return;
  state.reinit();
  const FiniteElement<dim> &base = space.velocity_element.base_element(0);
  const Quadrature<dim> support(base.get_unit_support_points());
  FEValues<dim> values(space.mapping, space.velocity_element, support, wall_flags);
  hp::FEValues<dim> pressure_values(space.mappings, space.pressure_elements,
                                    hp::QCollection<dim>(support), update_values);
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
  {
    if (cell->is_artificial())
      continue;
    for (const unsigned int f : cell->face_indices())
    {
      if (!is_wall(cell, f))
        continue;
      values.reinit(cell);
      pressure_values.reinit(pressure_cell(cell));
      const auto own_nodes = nodes_of(cell);
      for (unsigned int node = 0; node < own_nodes.size(); ++node)
        if (base.has_support_on_face(node, f))
          add_sample(cell, f, values, pressure_values.get_present_fe_values(), node,
                     own_nodes[node]);
      if (!cell->at_boundary(f) && cell->neighbor_is_coarser(f))
        add_nodes_of_coarser_neighbour(cell, f);
    }
  }
}

template <int dim>
void WallShearStress<dim>::set(const State &present, DistributedVector &shear)
{
  state.take(present);
  shear = 0.;
  for (const WallNode &node : nodes)
  {
    Tensor<1, dim> mean;
    for (const unsigned int sample : node.samples)
      mean += samples.shear_on_wall(state, sample);
    for (unsigned int c = 0; c < dim; ++c)
      shear.begin()[node.indices[c]] = mean[c] / node.samples.size();
  }
}

template <int dim>
void WallShearStress<dim>::set_magnitudes(const DistributedVector &vectors,
                                          DistributedVector &magnitudes) const
{
  magnitudes = 0.;
  for (const WallNode &node : nodes)
  {
    double square = 0.;
    for (const unsigned int index : node.indices)
      square += vectors.begin()[index] * vectors.begin()[index];
    for (const unsigned int index : node.indices)
      magnitudes.begin()[index] = std::sqrt(square);
  }
}

template <int dim>
void WallShearStress<dim>::keep_walls_alone(DistributedVector &vector) const
{
  kept.clear();
  for (const WallNode &node : nodes)
    for (const unsigned int index : node.indices)
      kept.push_back(vector.begin()[index]);
  vector = 0.;
  std::size_t next = 0;
  for (const WallNode &node : nodes)
    for (const unsigned int index : node.indices)
      vector.begin()[index] = kept[next++];
}

template class WallShearStress<2>;
template class WallShearStress<3>;
} // namespace Continua
