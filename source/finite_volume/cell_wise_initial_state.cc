#include <continua/finite_volume/cell_wise_initial_state.h>

namespace Continua
{
using namespace dealii;

template <int dim>
void set_initial_values(const CellWiseSpace<dim> &space,
                        const Problem &problem,
                        DistributedVector &velocity,
                        DistributedVector &displacement,
                        DistributedVector &pressure)
{
  const InteriorData &data = problem.interior;
  const auto evaluate = [](const Expression &expression, const Point<dim> &point)
  {
    double x[3] = {0., 0., 0.};
    for (unsigned int c = 0; c < dim; ++c)
      x[c] = point[c];
    return expression(x, 0.);
  };
  // Every value is set at its place: a cell's centre, a face's centre.
  const auto for_values = [&](const auto &function)
  {
    for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
      function(space.velocities.of_cell(cell), space.pressures.of_cell(cell), true,
               space.mesh.cells()[cell].centre, space.mesh.cells()[cell].material_id);
    for (unsigned int face = 0; face < space.mesh.faces().size(); ++face)
    {
      const VolumeFace<dim> &surface = space.mesh.faces()[face];
      for (unsigned int side = 0; surface.has_value() && side < surface.n_sides(); ++side)
        if (space.mesh.cells()[surface.cell(side)].is_owned)
          function(space.velocities.of_face(face, side), space.pressures.of_face(face, side),
                   space.velocities.owns_face(face, side), surface.centre,
                   space.mesh.cells()[surface.cell(side)].material_id);
    }
  };
  for_values(
      [&](const unsigned int value, const unsigned int pressure_value, const bool owned,
          const Point<dim> &point, const unsigned int region)
      {
        for (unsigned int c = 0; c < dim && owned; ++c)
        {
          const unsigned int index = space.local_velocity(value) + c;
          if (!data.initial_velocity.empty())
            velocity.begin()[index] = evaluate(data.initial_velocity[c], point);
          if (!data.initial_displacement.empty())
            displacement.begin()[index] = evaluate(data.initial_displacement[c], point);
        }
        // The mean pressure is given; in plane stress the unknown is another multiple of it.
        if (!data.initial_pressure.empty())
          pressure.begin()[space.local_pressure(pressure_value)] =
              evaluate(data.initial_pressure[region], point) /
              problem.plane_stress(region).pressure_factor;
      });
}

template void set_initial_values(const CellWiseSpace<2> &,
                                 const Problem &,
                                 DistributedVector &,
                                 DistributedVector &,
                                 DistributedVector &);
template void set_initial_values(const CellWiseSpace<3> &,
                                 const Problem &,
                                 DistributedVector &,
                                 DistributedVector &,
                                 DistributedVector &);
} // namespace Continua
