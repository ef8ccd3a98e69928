#include <continua/finite_volume/cell_wise_kelly_indicator.h>

#include <cmath>
#include <vector>

namespace Continua
{
using namespace dealii;

namespace
{
/// `square`: of the jump between a face's two cells, by number of the face [unit^2/m^2].
template <int dim, typename Square>
void sum_over_faces(const CellWiseSpace<dim> &space, const Square &square, Vector<float> &per_cell)
{
  const std::vector<FiniteVolume<dim>> &cells = space.mesh.cells();
  std::vector<double> sums(cells.size(), 0.);
  for (const VolumeFace<dim> &face : space.mesh.faces())
    if (!face.has_value())
    {
      const double part = face.area * square(face);
      sums[face.owner] += part;
      sums[face.neighbour] += part;
    }
  per_cell.reinit(space.mesh.triangulation.n_active_cells());
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
    per_cell[cells[cell].iterator->active_cell_index()] =
        std::sqrt(cells[cell].iterator->diameter() / 24. * sums[cell]);
}
} // namespace

template <int dim>
void kelly_indicators_of_velocity(const CellWiseSpace<dim> &space,
                                  const LinearReconstruction<dim> &reconstruction,
                                  const DistributedVector &velocity,
                                  Vector<float> &per_cell)
{
  const DistributedVector ghosted = reconstruction.ghosted_velocity(velocity);
  const auto gradient = [&](const unsigned int cell)
  {
    return LinearReconstruction<dim>::vector_gradient(
        reconstruction.velocity_gradient({cell, CellPlace::none}), ghosted);
  };
  sum_over_faces(
      space,
      [&](const VolumeFace<dim> &face)
      { return ((gradient(face.owner) - gradient(face.neighbour)) * face.normal).norm_square(); },
      per_cell);
}

template <int dim>
void kelly_indicators_of_pressure(const CellWiseSpace<dim> &space,
                                  const LinearReconstruction<dim> &reconstruction,
                                  const DistributedVector &pressure,
                                  Vector<float> &per_cell)
{
  const DistributedVector ghosted = reconstruction.ghosted_pressure(pressure);
  const auto derivative = [&](const unsigned int cell, const VolumeFace<dim> &face)
  {
    Stencil<double> along_normal;
    along_normal.add(face.normal, space.pressure_gradient(cell));
    return LinearReconstruction<dim>::value(along_normal, ghosted);
  };
  sum_over_faces(
      space,
      [&](const VolumeFace<dim> &face)
      { return std::pow(derivative(face.owner, face) - derivative(face.neighbour, face), 2); },
      per_cell);
}

template void kelly_indicators_of_velocity(const CellWiseSpace<2> &,
                                           const LinearReconstruction<2> &,
                                           const DistributedVector &,
                                           Vector<float> &);
template void kelly_indicators_of_velocity(const CellWiseSpace<3> &,
                                           const LinearReconstruction<3> &,
                                           const DistributedVector &,
                                           Vector<float> &);
template void kelly_indicators_of_pressure(const CellWiseSpace<2> &,
                                           const LinearReconstruction<2> &,
                                           const DistributedVector &,
                                           Vector<float> &);
template void kelly_indicators_of_pressure(const CellWiseSpace<3> &,
                                           const LinearReconstruction<3> &,
                                           const DistributedVector &,
                                           Vector<float> &);
} // namespace Continua
