#include <continua/finite_volume/liquid_cells.h>

#include <continua/base/input_error.h>

#include <deal.II/base/mpi.h>

#include <sstream>
#include <vector>

namespace Continua
{
using namespace dealii;

template <int dim>
void refuse_soft_liquids(const CellWiseSpace<dim> &space,
                         const Problem &problem,
                         const DistributedVector &pressure)
{
  const std::vector<Material> &materials = problem.materials;
  std::vector<double> stiffening(materials.size(), 1.);
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
  {
    const unsigned int region = space.mesh.cells()[cell].material_id;
    if (problem.materials[region].phase() < 1.)
    {
      const double here = materials[region].volume_law().stiffening(
          pressure.begin()[space.local_pressure(space.pressures.of_cell(cell))]);
      if (!(here >= stiffening[region]))
        stiffening[region] = here;
    }
  }
  Utilities::MPI::min(stiffening, space.communicator, stiffening);
  for (unsigned int region = 0; region < materials.size(); ++region)
    if (!(stiffening[region] > 0.))
    {
      const VolumeLaw law = materials[region].volume_law();
      std::ostringstream text;
      text << "the pressure in the region '" << problem.regions[region]
           << "' is so low that its bulk modulus K + n (p - p0) is not positive: K/n is "
           << 1. / (law.inverse_bulk_modulus * law.exponent)
           << " Pa; use smaller loads, or Volume exponent = 0";
      throw StepFailure(text.str());
    }
}

template <int dim>
NonlinearEnergy energy_of_liquid(const CellWiseSpace<dim> &space,
                                 const Problem &problem,
                                 const unsigned int region,
                                 const DistributedVector &of_velocity,
                                 const DistributedVector &of_pressure)
{
  NonlinearEnergy energy;
  const Material &material = problem.materials[region];
  const VolumeLaw law = material.volume_law();
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
  {
    const FiniteVolume<dim> &volume = space.mesh.cells()[cell];
    if (volume.material_id != region)
      continue;
    const double *const u =
        of_velocity.begin() + space.local_velocity(space.velocities.of_cell(cell));
    const double p = of_pressure.begin()[space.local_pressure(space.pressures.of_cell(cell))];
    double square = 0.;
    for (unsigned int c = 0; c < dim; ++c)
      square += u[c] * u[c];
    energy.kinetic += 0.5 * volume.volume * material.density * law.density_ratio(p) * square;
    energy.compressive += volume.volume * law.energy(p);
  }
  return energy;
}

template void
refuse_soft_liquids(const CellWiseSpace<2> &, const Problem &, const DistributedVector &);
template NonlinearEnergy energy_of_liquid(const CellWiseSpace<2> &,
                                          const Problem &,
                                          unsigned int,
                                          const DistributedVector &,
                                          const DistributedVector &);
template void
refuse_soft_liquids(const CellWiseSpace<3> &, const Problem &, const DistributedVector &);
template NonlinearEnergy energy_of_liquid(const CellWiseSpace<3> &,
                                          const Problem &,
                                          unsigned int,
                                          const DistributedVector &,
                                          const DistributedVector &);
} // namespace Continua
