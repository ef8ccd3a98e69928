#include <continua/finite_volume/cell_wise_space.h>

namespace Continua
{
using namespace dealii;

template <int dim>
CellWiseSpace<dim>::CellWiseSpace(parallel::TriangulationBase<dim> &triangulation,
                                  const Model model)
    : communicator(triangulation.get_communicator()),
      mesh(triangulation, model == Model::axisymmetric),
      velocities(mesh, InterfaceValue::common),
      pressures(mesh, InterfaceValue::broken),
      velocity_gradient(mesh, velocities),
      pressure_gradient(mesh, pressures),
      velocity_normal_gradient(mesh, velocities, velocity_gradient),
      pressure_normal_gradient(mesh, pressures, pressure_gradient)
{
}

template <int dim>
void CellWiseSpace<dim>::distribute()
{
  mesh.build();
  velocities.distribute();
  pressures.distribute();
  velocity_gradient.build();
  pressure_gradient.build();
}

template <int dim>
void CellWiseSpace<dim>::move(const VertexPlaces<dim> &places,
                              const std::vector<bool> &materials_that_move)
{
  mesh.move(places, materials_that_move);
  velocity_gradient.build();
  pressure_gradient.build();
}

template <int dim>
Stencil<Tensor<1, dim>> CellWiseSpace<dim>::velocity_face_gradient(const unsigned int face,
                                                                   const unsigned int side,
                                                                   const bool replaced) const
{
  Stencil<Tensor<1, dim>> result = velocity_gradient.on_face(face, side);
  const VolumeFace<dim> &surface = mesh.faces()[face];
  if (!surface.has_value() || !replaced)
    return result;
  const Tensor<1, dim> normal = surface.outward(side);
  Stencil<double> change = velocity_normal_gradient(face, side);
  for (const auto &entry : result)
    change.add(entry.first, -(entry.second * normal));
  result.add(normal, change);
  return result;
}

template <int dim>
Stencil<double> CellWiseSpace<dim>::cell_hoop(const unsigned int cell) const
{
  if (!is_axisymmetric())
    return {};
  return {velocities.of_cell(cell), 1. / mesh.cells()[cell].radius};
}

template <int dim>
Stencil<double> CellWiseSpace<dim>::face_hoop(const unsigned int face,
                                              const unsigned int side) const
{
  Stencil<double> result;
  if (!is_axisymmetric())
    return result;
  const VolumeFace<dim> &surface = mesh.faces()[face];
  if (!surface.has_value())
  {
    result.add(surface.owner_weight, cell_hoop(surface.owner));
    result.add(1. - surface.owner_weight, cell_hoop(surface.neighbour));
  }
  else if (surface.shape(side).area > 0.)
    result.add(velocities.of_face(face, side), 1. / surface.shape(side).centre[1]);
  else
    result = cell_hoop(surface.cell(side));
  return result;
}

template class CellWiseSpace<2>;
template class CellWiseSpace<3>;
} // namespace Continua
