#include <continua/finite_volume/cell_wise_loads.h>

#include <continua/mesh/coordinates.h>

namespace Continua
{
using namespace dealii;

template <int dim>
void CellWiseLoads<dim>::integrate(const Item &item,
                                   const Waveform *waveform,
                                   const double time,
                                   DistributedVector &forces) const
{
  double *const values = forces.begin();
  const auto amplitude = [&](const std::array<double, 3> &point)
  { return item.sign * (waveform == nullptr ? 1. : (*waveform)(point.data(), time)); };
  if (item.condition < 0)
  {
    for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
    {
      const FiniteVolume<dim> &volume = space.mesh.cells()[cell];
      const double density =
          item.times_density ? problem.materials[volume.material_id].density : 1.;
      values[space.local_velocity(space.velocities.of_cell(cell)) + item.component] +=
          amplitude(coordinates(volume.centre)) * density * volume.volume;
    }
    return;
  }
  for (const auto &face : face_conditions.faces())
    if (face.condition == static_cast<unsigned int>(item.condition))
    {
      const VolumeFace<dim> &surface = space.mesh.faces()[face.face];
      Tensor<1, dim> direction;
      if (item.component < 0)
        direction = surface.normal;
      else
      {
        direction[item.component] = 1.;
        const Tensor<1, dim> along = (direction * surface.normal) * surface.normal;
        direction = item.normal_part ? along : direction - along;
      }
      for (unsigned int c = 0; c < dim; ++c)
        values[face.index + c] += amplitude(face.place) * face.weight * direction[c];
    }
}

template <int dim>
DistributedVector CellWiseLoads<dim>::flow_of_velocities(const unsigned int condition) const
{
  DistributedVector flow = space.velocity_vector();
  integrate(LoadList::along_normal(condition), nullptr, 0., flow);
  return flow;
}

template <int dim>
std::vector<std::array<double, 3>> CellWiseLoads<dim>::places(const Item &item) const
{
  std::vector<std::array<double, 3>> points;
  if (item.condition < 0)
    for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
      points.push_back(coordinates(space.mesh.cells()[cell].centre));
  else
    for (const auto &face : face_conditions.faces())
      if (face.condition == static_cast<unsigned int>(item.condition))
        points.push_back(face.place);
  return points;
}

template class CellWiseLoads<2>;
template class CellWiseLoads<3>;
} // namespace Continua
