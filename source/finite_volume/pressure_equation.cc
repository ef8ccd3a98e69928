#include <continua/finite_volume/pressure_equation.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

template <int dim>
PressureEquation<dim>::PressureEquation(const CellWiseSystem<dim> &system,
                                        const SplitEquations<dim> &equations,
                                        const FaceLinks<dim> &links,
                                        const FaceBalance<dim> &faces)
    : system(system), equations(equations), links(links), faces(faces), matrix(system.space.mesh)
{
}

template <int dim>
void PressureEquation<dim>::reinit()
{
  const CellWiseMesh<dim> &mesh = system.space.mesh;
  const std::size_t n_owned = mesh.n_owned_cells();
  matrix.reinit(equations.cell_mass().first, 1);
  inverse_diagonal.resize(n_owned);
  cells.resize(n_owned);
  for (std::size_t cell = 0; cell < n_owned; ++cell)
  {
    const FiniteVolume<dim> &volume = mesh.cells()[cell];
    matrix.row_sums()[cell] =
        system.coefficients().compressibility[volume.material_id] * volume.volume;
    inverse_diagonal[cell] = 1. / (system.momentum_diagonal()[cell] * volume.volume);
  }
  following.clear();
  staying.clear();
  const bool by_value = system.parameters.boundary_pressure_as == BoundaryPressureAs::value;
  for (const auto &face : faces.pressures())
    if (face.normal_is_free && by_value)
      staying.push_back(face.pressure);
    else
      following.emplace_back(face.pressure, face.cell);
  find_couplings();
  factor = make_symmetric_factor(DirectSolver::automatic, true, matrix.n_entries(),
                                 system.space.communicator);
  matrix.factorize(0, *factor);
}

template <int dim>
void PressureEquation<dim>::find_couplings()
{
  const CellWiseSpace<dim> &space = system.space;
  const CellWiseMesh<dim> &mesh = space.mesh;
  const std::vector<double> &diagonal = system.momentum_diagonal();
  const bool by_value = system.parameters.boundary_pressure_as == BoundaryPressureAs::value;
  const auto add = [&](const unsigned int f, const double conductance)
  {
    const VolumeFace<dim> &face = mesh.faces()[f];
    matrix.couple(face,
                  {{equations.pressure_index(space.pressures.of_cell(face.cell(0))),
                    equations.pressure_index(space.pressures.of_cell(face.cell(1)))}},
                  conductance);
  };
  for (unsigned int f = 0; f < mesh.faces().size(); ++f)
  {
    const VolumeFace<dim> &surface = mesh.faces()[f];
    const unsigned int region = mesh.cells()[surface.owner].material_id;
    const double normal_distance = surface.distance * surface.normal;
    if (!surface.at_boundary() && !surface.is_interface)
    {
      const double of_increment = 0.25 * normal_distance * normal_distance *
                                  system.coefficients().increment_mobility[region];
      const double of_momentum = surface.owner_weight / diagonal[surface.owner] +
                                 (1. - surface.owner_weight) / diagonal[surface.neighbour];
      add(f, std::max(of_momentum, of_increment) * surface.area / normal_distance);
    }
    else if (surface.at_boundary() && by_value &&
             !system.conditions.of_face(f).normal_is_prescribed)
    {
      const double of_increment = 0.25 * normal_distance * normal_distance *
                                  system.coefficients().increment_mobility[region];
      matrix.row_sums()[surface.owner] +=
          std::max(1. / diagonal[surface.owner], of_increment) * surface.area / normal_distance;
    }
  }
  // The wall between two materials gives way to a difference of pressures: at once by its links,
  // and with the cells beside it.
  for (const auto &link : links.links())
    if (link.n_sides == 2)
    {
      const VolumeFace<dim> &surface = mesh.faces()[link.face];
      double normal_distance = 0., mobility = 0.;
      for (unsigned int side = 0; side < 2; ++side)
      {
        const unsigned int cell = surface.cell(side);
        normal_distance += std::abs((surface.centre - mesh.cells()[cell].centre) * surface.normal);
        mobility += link.share[side] / diagonal[cell];
      }
      add(link.face, surface.area * (surface.area * link.compliance + mobility / normal_distance));
    }
}

template <int dim>
void PressureEquation<dim>::solve(const Vector &residual, Vector &change)
{
  const unsigned int first = equations.cell_mass().first;
  std::copy_n(residual.begin() + first, cells.size(), cells.begin());
  factor->solve(cells);
  std::copy(cells.begin(), cells.end(), change.begin() + first);
  double *const d = change.begin();
  for (const auto &[face, cell] : following)
    d[face] = d[cell];
  for (const unsigned int face : staying)
    d[face] = 0.;
}

template class PressureEquation<2>;
template class PressureEquation<3>;
} // namespace Continua
