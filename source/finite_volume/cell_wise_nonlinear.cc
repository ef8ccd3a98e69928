#include <continua/finite_volume/cell_wise_nonlinear.h>

#include <continua/finite_volume/place_of_row.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace Continua
{
using namespace dealii;

template <int dim>
CellWiseNonlinear<dim>::CellWiseNonlinear(const CellWiseSystem<dim> &system,
                                          const std::vector<CellWiseOperators> &operators,
                                          CellWiseConvection<dim> &convection,
                                          CellWiseLinearSystem<dim> &linear_system)
    : system(system), operators(operators), convection(convection), linear_system(linear_system)
{
}

template <int dim>
void CellWiseNonlinear<dim>::reinit()
{
  divergence_norm = gradient_norm = 0.;
  face_resistance = std::numeric_limits<double>::max();
  for (const auto &face : system.conditions.faces())
  {
    const VolumeFace<dim> &surface = system.space.mesh.faces()[face.face];
    const Material &material =
        system.problem.materials[system.space.mesh.cells()[surface.owner].material_id];
    if (!face.normal_is_prescribed && material.shear.viscosity > 0.)
      face_resistance =
          std::min(face_resistance, material.shear.viscosity / (surface.distance * surface.normal));
  }
  face_resistance = Utilities::MPI::min(face_resistance, system.space.communicator);
  for (const CellWiseOperators &of_region : operators)
  {
    divergence_norm += of_region.divergence.linfty_norm();
    gradient_norm += of_region.gradient.linfty_norm();
  }
}

template <int dim>
bool CellWiseNonlinear<dim>::is_in(const unsigned int region) const
{
  return system.problem.materials[region].phase() < 1.;
}

template <int dim>
ResidualScales CellWiseNonlinear<dim>::residual_scales(const DistributedVector &velocity,
                                                       const DistributedVector &pressure) const
{
  // A face's balance of tractions makes round-off of the pressure one of the face's velocity.
  const double pressure_size = pressure.linfty_norm();
  return {gradient_norm * pressure_size,
          divergence_norm * (velocity.linfty_norm() + pressure_size / face_resistance)};
}

template <int dim>
std::string CellWiseNonlinear<dim>::place_of_largest(const DistributedVector &momentum,
                                                     const DistributedVector &mass,
                                                     const bool of_momentum) const
{
  return place_of_largest_row(system.space, of_momentum ? momentum : mass, of_momentum,
                              system.problem.regions);
}

template <int dim>
bool CellWiseNonlinear<dim>::linearise(const StepSolution &state)
{
  linear_system.linearise(convection, state);
  return true;
}

template class CellWiseNonlinear<2>;
template class CellWiseNonlinear<3>;
} // namespace Continua
