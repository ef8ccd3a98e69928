#include <continua/finite_volume/cell_wise_traction_jump.h>

#include <continua/continuum/stress_and_strain.h>

#include <cmath>
#include <vector>

namespace Continua
{
using namespace dealii;

template <int dim>
void traction_jump_indicators(const CellWiseSpace<dim> &space,
                              const Problem &problem,
                              const CellWiseEvaluation<dim> &evaluation,
                              const FaceConditions<dim> &conditions,
                              const State &state,
                              const std::vector<double> &outlet_pressures,
                              const double time,
                              Vector<float> &per_cell)
{
  const DistributedVector pressure = evaluation.reconstruction().ghosted_pressure(state.pressure);
  std::vector<DistributedVector> mixtures;
  for (unsigned int region = 0; region < problem.regions.size(); ++region)
    mixtures.push_back(evaluation.ghosted_mixture(state, region));
  const std::vector<FiniteVolume<dim>> &cells = space.mesh.cells();

  std::vector<double> squares(cells.size(), 0.);
  for (unsigned int number = 0; number < space.mesh.faces().size(); ++number)
  {
    const VolumeFace<dim> &face = space.mesh.faces()[number];
    const auto of_cell = [&](const unsigned int side)
    {
      const unsigned int cell = face.cell(side);
      return traction<dim>(evaluation.stress_at({cell, CellPlace::none}, face.centre,
                                                mixtures[cells[cell].material_id], pressure),
                           face.normal);
    };
    // The diagonal of a square of that area.
    const double extent = dim == 2 ? face.plane_area : std::sqrt(2. * face.plane_area);
    if (face.at_boundary())
    {
      if (!cells[face.owner].is_owned)
        continue;
      const auto &condition = conditions.of_face(number);
      const Tensor<1, dim> present = of_cell(0);
      // Only the directions in which it is given can be missed.
      const Tensor<1, dim> given = conditions.traction(condition, time) -
                                   outlet_pressures[condition.condition] * face.normal;
      const Tensor<1, dim> difference = present - given - condition.prescribed * (present - given);
      squares[face.owner] += extent * face.area * difference.norm_square();
      continue;
    }
    const double square = 0.5 * extent * face.area * (of_cell(0) - of_cell(1)).norm_square();
    squares[face.owner] += square;
    squares[face.neighbour] += square;
  }
  per_cell.reinit(space.mesh.triangulation.n_active_cells());
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
    per_cell[cells[cell].iterator->active_cell_index()] = std::sqrt(squares[cell]);
}

template void traction_jump_indicators(const CellWiseSpace<2> &,
                                       const Problem &,
                                       const CellWiseEvaluation<2> &,
                                       const FaceConditions<2> &,
                                       const State &,
                                       const std::vector<double> &,
                                       double,
                                       Vector<float> &);
template void traction_jump_indicators(const CellWiseSpace<3> &,
                                       const Problem &,
                                       const CellWiseEvaluation<3> &,
                                       const FaceConditions<3> &,
                                       const State &,
                                       const std::vector<double> &,
                                       double,
                                       Vector<float> &);
} // namespace Continua
