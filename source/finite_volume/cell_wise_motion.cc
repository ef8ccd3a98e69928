#include <continua/finite_volume/cell_wise_motion.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

template <int dim>
bool CellWiseMotion<dim>::is_solid(const unsigned int cell) const
{
  return problem.materials[space.mesh.cells()[cell].material_id].is_solid();
}

template <int dim>
void CellWiseMotion<dim>::set_up()
{
  cells.clear();
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
    if (is_solid(cell))
    {
      const CellPlace place{cell, CellPlace::none};
      cells.push_back({space.mesh.cells()[cell].material_id, linear.velocity_gradient(place),
                       linear.hoop(place)});
    }
  set_up_faces();
  is_set_up = true;
}

template <int dim>
void CellWiseMotion<dim>::set_up_faces()
{
  faces.clear();
  liquid = {};
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
    if (!is_solid(cell))
      liquid.volume += space.mesh.cells()[cell].volume;
  for (unsigned int f = 0; f < space.mesh.faces().size(); ++f)
  {
    const VolumeFace<dim> &face = space.mesh.faces()[f];
    for (unsigned int side = 0; side < face.n_sides(); ++side)
    {
      const unsigned int cell = face.cell(side);
      if (!space.mesh.cells()[cell].is_owned)
        continue;
      if (face.at_boundary())
      {
        if (!is_solid(cell) &&
            is_wall(problem, face.boundary_id, space.mesh.cells()[cell].material_id))
          liquid.area += face.area;
        continue;
      }
      if (is_solid(cell) == is_solid(face.cell(1 - side)))
        continue;
      if (is_solid(cell))
      {
        const FaceShape<dim> &shape = face.shape(side);
        faces.push_back({shape.normal, linear.displacement({cell, f}, shape.centre, shape.centre)});
      }
      else
      {
        liquid.area += face.area;
        liquid.area_of_solids += face.area;
      }
    }
  }
  liquid.sum(space.communicator);
}

template <int dim>
void CellWiseMotion<dim>::take(const State &state, MotionExtremes &extremes)
{
  if (!is_set_up)
    set_up();
  liquid.set(extremes);
  const DistributedVector displacement = linear.ghosted_velocity(state.history.displacement());
  for (const WallFace &face : faces)
    extremes.wall_displacement =
        std::max(extremes.wall_displacement,
                 std::abs(face.normal * linear.vector_value(face.displacement, displacement)));
  for (const SolidCell &cell : cells)
  {
    double hoop = 0.;
    for (const auto &entry : cell.hoop)
      hoop += entry.second * displacement(dim * entry.first + 1);
    take_point_of_solid<dim>(linear.vector_gradient(cell.gradient, displacement), hoop, problem,
                             cell.region, extremes);
  }
}

template class CellWiseMotion<2>;
template class CellWiseMotion<3>;
} // namespace Continua
