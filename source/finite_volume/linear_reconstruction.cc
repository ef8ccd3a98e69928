#include <continua/finite_volume/linear_reconstruction.h>

#include <algorithm>
#include <vector>

namespace Continua
{
using namespace dealii;

template <int dim>
void LinearReconstruction<dim>::build()
{
  relevant_velocities = relevant(space.velocities, space.velocity_gradient, dim);
  relevant_pressures = relevant(space.pressures, space.pressure_gradient, 1);
}

template <int dim>
IndexSet LinearReconstruction<dim>::relevant(const ValueSpace<dim> &values,
                                             const GaussGradient<dim> &gradient,
                                             const unsigned int n_components) const
{
  std::vector<types::global_dof_index> indices;
  const auto add = [&](const unsigned int value)
  {
    for (unsigned int c = 0; c < n_components; ++c)
      indices.push_back(n_components * value + c);
  };
  for (unsigned int cell = 0; cell < space.mesh.cells().size(); ++cell)
  {
    add(values.of_cell(cell));
    for (const auto &entry : gradient(cell))
      add(entry.first);
  }
  for (unsigned int face = 0; face < space.mesh.faces().size(); ++face)
  {
    const VolumeFace<dim> &surface = space.mesh.faces()[face];
    for (unsigned int side = 0; surface.has_value() && side < surface.n_sides(); ++side)
      add(values.of_face(face, side));
  }
  std::sort(indices.begin(), indices.end());
  IndexSet set(n_components * values.n_values());
  set.add_indices(indices.begin(), std::unique(indices.begin(), indices.end()));
  set.add_indices(values.owned(n_components));
  set.compress();
  return set;
}

template <int dim>
Stencil<double> LinearReconstruction<dim>::at_point(const ValueSpace<dim> &values,
                                                    const GaussGradient<dim> &gradient,
                                                    const CellPlace &place,
                                                    const Point<dim> &point) const
{
  if (place.face == CellPlace::none)
  {
    Stencil<double> result(values.of_cell(place.cell), 1.);
    result.add(point - space.mesh.cells()[place.cell].centre, gradient(place.cell));
    return result;
  }
  const unsigned int side = space.mesh.side(place.face, place.cell);
  const FaceShape<dim> &face = space.mesh.faces()[place.face].shape(side);
  Tensor<1, dim> offset = point - face.centre;
  offset -= (offset * face.normal) * face.normal;
  Stencil<double> result(values.of_face(place.face, side), 1.);
  result.add(offset, gradient(place.cell));
  return result;
}

template <int dim>
Stencil<double> LinearReconstruction<dim>::velocity(const CellPlace &place,
                                                    const Point<dim> &point) const
{
  return at_point(space.velocities, space.velocity_gradient, place, point);
}

template <int dim>
unsigned int LinearReconstruction<dim>::owner_along(const unsigned int face,
                                                    const unsigned int cell) const
{
  const VolumeFace<dim> &surface = space.mesh.faces()[face];
  if (!surface.is_interface || is_solid(cell))
    return cell;
  const unsigned int other = surface.cell(1 - space.mesh.side(face, cell));
  return is_solid(other) ? other : cell;
}

template <int dim>
bool LinearReconstruction<dim>::is_solid(const unsigned int cell) const
{
  return problem.materials[space.mesh.cells()[cell].material_id].is_solid();
}

template <int dim>
Stencil<double> LinearReconstruction<dim>::displacement(const CellPlace &place,
                                                        const Point<dim> &point,
                                                        const Point<dim> &undeformed) const
{
  if (place.face == CellPlace::none)
    return velocity(place, point);
  const unsigned int owner = owner_along(place.face, place.cell);
  if (!is_solid(owner) && is_held(place.face))
    return {space.velocities.of_face(place.face, space.mesh.side(place.face, owner)), 1.};
  return velocity({owner, place.face}, is_solid(owner) ? undeformed : point);
}

template <int dim>
bool LinearReconstruction<dim>::is_held(const unsigned int face) const
{
  const VolumeFace<dim> &surface = space.mesh.faces()[face];
  const unsigned int region = space.mesh.cells()[surface.owner].material_id;
  return surface.at_boundary() &&
         std::any_of(problem.conditions.begin(), problem.conditions.end(),
                     [&](const BoundaryCondition &condition)
                     {
                       return condition.boundary_id == surface.boundary_id &&
                              condition.region_ids.count(region) > 0 &&
                              condition.normal.kind == BoundaryPart::Kind::velocity &&
                              condition.tangential.kind == BoundaryPart::Kind::velocity;
                     });
}

template <int dim>
Stencil<double> LinearReconstruction<dim>::pressure(const CellPlace &place,
                                                    const Point<dim> &point) const
{
  return at_point(space.pressures, space.pressure_gradient, place, point);
}

template <int dim>
Stencil<Tensor<1, dim>> LinearReconstruction<dim>::velocity_gradient(const CellPlace &place) const
{
  if (place.face == CellPlace::none)
    return space.velocity_gradient(place.cell);
  return space.velocity_face_gradient(place.face, space.mesh.side(place.face, place.cell), true);
}

template <int dim>
Stencil<double> LinearReconstruction<dim>::hoop(const CellPlace &place) const
{
  if (place.face == CellPlace::none)
    return space.cell_hoop(place.cell);
  return space.face_hoop(place.face, space.mesh.side(place.face, place.cell));
}

template <int dim>
DistributedVector LinearReconstruction<dim>::ghosted_velocity(const DistributedVector &owned) const
{
  DistributedVector ghosted(space.velocities.owned(dim), relevant_velocities, space.communicator);
  ghosted = owned;
  return ghosted;
}

template <int dim>
DistributedVector LinearReconstruction<dim>::ghosted_pressure(const DistributedVector &owned) const
{
  DistributedVector ghosted(space.pressures.owned(1), relevant_pressures, space.communicator);
  ghosted = owned;
  return ghosted;
}

template <int dim>
Tensor<1, dim> LinearReconstruction<dim>::vector_value(const Stencil<double> &stencil,
                                                       const DistributedVector &velocity)
{
  Tensor<1, dim> result;
  for (const auto &entry : stencil)
    for (unsigned int c = 0; c < dim; ++c)
      result[c] += entry.second * velocity(dim * entry.first + c);
  return result;
}

template <int dim>
double LinearReconstruction<dim>::value(const Stencil<double> &stencil,
                                        const DistributedVector &pressure)
{
  double result = 0.;
  for (const auto &entry : stencil)
    result += entry.second * pressure(entry.first);
  return result;
}

template <int dim>
Tensor<2, dim> LinearReconstruction<dim>::vector_gradient(const Stencil<Tensor<1, dim>> &stencil,
                                                          const DistributedVector &velocity)
{
  Tensor<2, dim> result;
  for (const auto &entry : stencil)
    for (unsigned int c = 0; c < dim; ++c)
      result[c] += velocity(dim * entry.first + c) * entry.second;
  return result;
}

template class LinearReconstruction<2>;
template class LinearReconstruction<3>;
} // namespace Continua
