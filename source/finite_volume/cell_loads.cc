#include <continua/finite_volume/cell_loads.h>

#include <continua/mesh/coordinates.h>
#include <continua/signal/jump.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

template <int dim>
CellLoads<dim>::CellLoads(const CellSpace<dim> &space,
                          const Problem &problem,
                          const FaceConditions<dim> &face_conditions)
    : space(space), problem(problem), face_conditions(face_conditions)
{
}

template <int dim>
void CellLoads<dim>::build()
{
  items.clear();
  std::vector<Item> all;
  const auto item = [](const Waveform &waveform, const int condition, const bool normal_part,
                       const int component, const double sign, const bool times_density)
  { return Item{&waveform, condition, normal_part, component, sign, times_density, {}, {}}; };
  for (unsigned int c = 0; c < problem.interior.body_force.size(); ++c)
    all.push_back(item(problem.interior.body_force[c], -1, false, c, 1., false));
  for (unsigned int c = 0; c < problem.interior.acceleration.size(); ++c)
    all.push_back(item(problem.interior.acceleration[c], -1, false, c, 1., true));
  for (unsigned int i = 0; i < problem.conditions.size(); ++i)
    for (const bool normal_part : {true, false})
    {
      const BoundaryPart &part =
          normal_part ? problem.conditions[i].normal : problem.conditions[i].tangential;
      if (part.kind != BoundaryPart::Kind::traction)
        continue;
      for (unsigned int c = 0; c < part.vector.size(); ++c)
        all.push_back(item(part.vector[c], i, normal_part, c, 1., false));
      if (normal_part)
        all.push_back(item(part.along_normal, i, true, -1, part.negative ? -1. : 1., false));
    }

  constant = space.velocity_vector();
  for (Item &candidate : all)
  {
    if (candidate.waveform->is_zero())
      continue;
    if (!candidate.waveform->depends_on_time())
    {
      integrate(candidate, candidate.waveform, 0., constant);
      continue;
    }
    if (!candidate.waveform->depends_on_space())
    {
      candidate.unit = space.velocity_vector();
      integrate(candidate, nullptr, 0., candidate.unit);
    }
    watch_points(candidate);
    items.push_back(candidate);
  }
}

template <int dim>
void CellLoads<dim>::integrate(const Item &item,
                               const Waveform *waveform,
                               const double time,
                               DistributedVector &target) const
{
  double *const values = target.begin();
  const auto amplitude = [&](const Point<dim> &point)
  { return item.sign * (waveform == nullptr ? 1. : (*waveform)(coordinates(point).data(), time)); };
  if (item.condition < 0)
  {
    for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
    {
      const FiniteVolume<dim> &volume = space.mesh.cells()[cell];
      const double density =
          item.times_density ? problem.materials[volume.material_id].density : 1.;
      values[space.local_velocity(space.velocities.of_cell(cell)) + item.component] +=
          amplitude(volume.centre) * density * volume.volume;
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
        values[face.index + c] += amplitude(surface.centre) * face.weight * direction[c];
    }
}

template <int dim>
void CellLoads<dim>::add(const double time, DistributedVector &momentum) const
{
  momentum.add(1., constant);
  const double origin[3] = {0., 0., 0.};
  for (const Item &item : items)
    if (item.waveform->depends_on_space())
      integrate(item, item.waveform, time, momentum);
    else
      momentum.add((*item.waveform)(origin, time), item.unit);
}

template <int dim>
bool CellLoads<dim>::jumps(const double begin, const double end) const
{
  bool found = false;
  for (const Item &item : items)
    for (const std::array<double, 3> &point : item.watched_points)
      found = found ||
              jumps_within([&](const double time) { return (*item.waveform)(point.data(), time); },
                           begin, end);
  return Utilities::MPI::max(found ? 1 : 0, space.communicator) == 1;
}

template <int dim>
void CellLoads<dim>::watch_points(Item &item) const
{
  if (!item.waveform->depends_on_space())
  {
    item.watched_points.push_back({{0., 0., 0.}});
    return;
  }
  constexpr unsigned int n_watched = 8;
  std::vector<std::array<double, 3>> points;
  if (item.condition < 0)
    for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
      points.push_back(coordinates(space.mesh.cells()[cell].centre));
  else
    for (const auto &face : face_conditions.faces())
      if (face.condition == static_cast<unsigned int>(item.condition))
        points.push_back(coordinates(space.mesh.faces()[face.face].centre));
  const std::size_t n_points = std::min<std::size_t>(n_watched, points.size());
  for (std::size_t i = 0; i < n_points; ++i)
    item.watched_points.push_back(points[i * points.size() / n_points]);
}

template class CellLoads<2>;
template class CellLoads<3>;
} // namespace Continua
