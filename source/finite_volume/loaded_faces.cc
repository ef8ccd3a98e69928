#include <continua/finite_volume/loaded_faces.h>

namespace Continua
{
template <int dim>
LoadedFaces<dim>::LoadedFaces(const CellWiseSpace<dim> &space,
                              const Problem &problem,
                              const FaceConditions<dim> &conditions,
                              const std::vector<CellWiseOperators> &operators,
                              const PressureClosure &closure,
                              const CellWiseParameters &parameters)
    : space(space),
      problem(problem),
      conditions(conditions),
      closure(closure),
      system(space, problem, conditions, operators, closure, parameters)
{
}

template <int dim>
void LoadedFaces<dim>::reinit()
{
  held.reset();
}

template <int dim>
bool LoadedFaces<dim>::deforms_at_once(const unsigned int region) const
{
  const Material &material = problem.materials[region];
  return !material.shear.branches.empty() && material.shear.viscosity == 0.;
}

template <int dim>
bool LoadedFaces<dim>::exist() const
{
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    if (deforms_at_once(region))
      return true;
  return false;
}

template <int dim>
void LoadedFaces<dim>::make()
{
  CellWiseCoefficients steady;
  steady.with_pressure = system.parameters.has_pressure();
  steady.correct_fluxes = false;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    const Material &material = problem.materials[region];
    steady.mass.push_back(0.);
    steady.stiffness.push_back(deforms_at_once(region) ? material.instantaneous_shear_modulus()
                                                       : 0.);
    steady.compressibility.push_back(material.inverse_bulk_modulus());
    steady.increment_mobility.push_back(0.);
  }
  system.reinit();
  system.prepare(steady);

  // What stays as it is: the faces of regions that do not deform at once, and the pressures that
  // follow from no displacement.
  std::vector<bool> velocity_stays(space.velocities.n_owned(), true),
      pressure_stays(space.pressures.n_owned(), true);
  for (unsigned int face = 0; face < space.mesh.faces().size(); ++face)
  {
    const VolumeFace<dim> &surface = space.mesh.faces()[face];
    for (unsigned int side = 0; surface.has_value() && side < surface.n_sides(); ++side)
    {
      const FiniteVolume<dim> &cell = space.mesh.cells()[surface.cell(side)];
      if (!deforms_at_once(cell.material_id))
        continue;
      if (space.velocities.owns_face(face, side))
        velocity_stays[space.local_velocity(space.velocities.of_face(face, side)) / dim] = false;
      if (cell.is_owned)
        pressure_stays[space.local_pressure(space.pressures.of_face(face, side))] = false;
    }
  }
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
  {
    const unsigned int region = space.mesh.cells()[cell].material_id;
    pressure_stays[space.local_pressure(space.pressures.of_cell(cell))] =
        !deforms_at_once(region) || problem.materials[region].is_incompressible();
  }
  for (const unsigned int row : closure.rows)
    pressure_stays[row] = false;
  held = std::make_unique<HeldCells<dim>>(system);
  held->reinit(velocity_stays, pressure_stays);
}

template <int dim>
void LoadedFaces<dim>::respond(DistributedVector &forces,
                               DistributedVector &displacement,
                               DistributedVector &pressure)
{
  if (!held)
    make();
  conditions.clear_prescribed(forces);
  displacement = 0.;
  pressure = 0.;
  const DistributedVector nothing(pressure);
  held->solve(forces, nothing, displacement, pressure);
}

template class LoadedFaces<2>;
template class LoadedFaces<3>;
} // namespace Continua
