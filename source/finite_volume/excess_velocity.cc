#include <continua/finite_volume/excess_velocity.h>

#include <utility>

namespace Continua
{
using namespace dealii;

template <int dim>
ExcessVelocity<dim>::ExcessVelocity(const CellWiseSystem<dim> &system,
                                    const LinearReconstruction<dim> &reconstruction)
    : system(system), reconstruction(reconstruction)
{
}

template <int dim>
void ExcessVelocity<dim>::reinit()
{
  faces.clear();
  some_region = false;
  for (unsigned int region = 0; region < system.problem.materials.size(); ++region)
    some_region = some_region || system.has_excess_velocity(region);
  if (!some_region)
    return;
  const CellWiseSpace<dim> &space = system.space;
  const CellWiseMesh<dim> &mesh = space.mesh;
  number_of.assign(mesh.faces().size(), VolumeFace<dim>::none);
  for (unsigned int f = 0; f < mesh.faces().size(); ++f)
  {
    const VolumeFace<dim> &surface = mesh.faces()[f];
    const unsigned int region = mesh.cells()[surface.owner].material_id;
    if (surface.has_value() || !system.has_excess_velocity(region))
      continue;
    Face face;
    face.face = f;
    face.density = system.problem.materials[region].density;
    face.difference = system.pressure_difference(f);
    std::array<int, 2> level;
    for (unsigned int side = 0; side < 2; ++side)
      level[side] = mesh.cells()[surface.cell(side)].iterator->level();
    for (unsigned int side = 0; side < 2; ++side)
    {
      const unsigned int number = surface.number_in_cell[side];
      const double sign = (number % 2 == 0 ? -1. : 1.) * (side == 0 ? 1. : -1.);
      const bool is_coarse = level[side] >= level[1 - side];
      face.weight[side] = !is_coarse ? 0. : level[0] == level[1] ? 0.5 * sign : sign;
      double area = 0.;
      for (const unsigned int other : mesh.cells()[surface.cell(side)].faces)
      {
        const VolumeFace<dim> &piece = mesh.faces()[other];
        if (piece.number_in_cell[mesh.side(other, surface.cell(side))] == number)
          area += piece.plane_area;
      }
      face.share[side] = sign * surface.plane_area / area;
    }
    number_of[f] = faces.size();
    faces.push_back(face);
  }
}

template <int dim>
void ExcessVelocity<dim>::visit(StateVisitor &visitor)
{
  visitor.levels("excess velocity of lower faces", StateKind::velocity, present[0], older[0]);
  visitor.levels("excess velocity of upper faces", StateKind::velocity, present[1], older[1]);
}

template <int dim>
unsigned int ExcessVelocity<dim>::entry(const Face &face, const unsigned int side) const
{
  const VolumeFace<dim> &surface = system.space.mesh.faces()[face.face];
  return dim * system.space.velocities.of_cell(surface.cell(side)) +
         surface.number_in_cell[side] / 2;
}

template <int dim>
double ExcessVelocity<dim>::value(const Face &face, const Slots &ghosted) const
{
  double result = 0.;
  for (unsigned int side = 0; side < 2; ++side)
    if (face.weight[side] != 0.)
      result += face.weight[side] * ghosted[slot(face, side)](entry(face, side));
  return result;
}

template <int dim>
typename ExcessVelocity<dim>::Slots ExcessVelocity<dim>::ghosted(const Slots &slots) const
{
  return {{reconstruction.ghosted_velocity(slots[0]), reconstruction.ghosted_velocity(slots[1])}};
}

template <int dim>
void ExcessVelocity<dim>::add_to_cells(const Face &face,
                                       const double velocity,
                                       DistributedVector &target) const
{
  const CellWiseSpace<dim> &space = system.space;
  const VolumeFace<dim> &surface = space.mesh.faces()[face.face];
  for (unsigned int side = 0; side < 2; ++side)
    if (space.mesh.cells()[surface.cell(side)].is_owned)
      target.begin()[space.local_pressure(space.pressures.of_cell(surface.cell(side)))] +=
          (side == 0 ? 1. : -1.) * surface.area * velocity;
}

template <int dim>
void ExcessVelocity<dim>::add_past(const Step &step, DistributedVector &mass)
{
  const Slots values = ghosted(present);
  const Slots older_values = step.a2 != 0. ? ghosted(older) : Slots();
  for (Face &face : faces)
  {
    face.old = value(face, values);
    face.past = step.a1 * face.old;
    if (step.a2 != 0.)
      face.past += step.a2 * value(face, older_values);
    face.past *= face.density;
    add_to_cells(face, system.flux_mobility(face.face) * face.past, mass);
  }
}

template <int dim>
void ExcessVelocity<dim>::advance(const Step &step, const DistributedVector &pressure)
{
  const DistributedVector ghosted_pressure = reconstruction.ghosted_pressure(pressure);
  std::swap(present, older);
  for (DistributedVector &vector : present)
    vector = 0.;
  const CellWiseSpace<dim> &space = system.space;
  const unsigned int first = dim * space.velocities.first_owned();
  for (const Face &face : faces)
  {
    double velocity =
        -system.flux_mobility(face.face) *
        (LinearReconstruction<dim>::value(face.difference, ghosted_pressure) + face.past);
    if (step.extrapolate)
      velocity = 2. * velocity - face.old;
    const VolumeFace<dim> &surface = space.mesh.faces()[face.face];
    for (unsigned int side = 0; side < 2; ++side)
      if (space.mesh.cells()[surface.cell(side)].is_owned)
        present[slot(face, side)].begin()[entry(face, side) - first] += face.share[side] * velocity;
  }
}

template <int dim>
void ExcessVelocity<dim>::add_outflow(const DistributedVector &pressure,
                                      DistributedVector &target) const
{
  const DistributedVector ghosted_pressure = reconstruction.ghosted_pressure(pressure);
  const Slots values = ghosted(present);
  for (const Face &face : faces)
    add_to_cells(face,
                 value(face, values) +
                     system.flux_mobility(face.face) *
                         LinearReconstruction<dim>::value(face.difference, ghosted_pressure),
                 target);
}

template class ExcessVelocity<2>;
template class ExcessVelocity<3>;
} // namespace Continua
