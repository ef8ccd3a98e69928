// Copies with ghost entries and sums of cells, beside deal.II's own way with the constraints: on
// meshes whose coarser cells lie in many places beside the cuts between the ranks.

#include <continua/finite_element/space/cell_sums.h>
#include <continua/finite_element/space/quadrature_cells.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

#include "../unit_test.h"
#include "small_problem.h"

namespace test_of_ghosted_copy
{
using namespace Continua;
using namespace dealii;

namespace
{
/// The largest difference of any entry that a rank has, ghosts included.
double difference(const DistributedVector &a, const DistributedVector &b)
{
  double result = 0.;
  for (int i = 0; i < a.trilinos_vector().MyLength(); ++i)
    result = std::max(result, std::abs(a.trilinos_vector()[0][i] - b.trilinos_vector()[0][i]));
  return Utilities::MPI::max(result, MPI_COMM_WORLD);
}

/// Divides cells by chance three times: a family of which one cell is divided further may lie on
/// several ranks, and a rank then has ghost cells without the coarser ones behind them.
template <int dim>
void check_mesh(const std::string &name,
                const std::vector<unsigned int> &n_cells,
                const double seed)
{
  small_problem::Mesh<dim> mesh(MPI_COMM_WORLD);
  small_problem::make_box<dim>(mesh, n_cells);
  for (unsigned int time = 0; time < (dim == 2 ? 3 : 2); ++time)
    small_problem::refine<dim>(mesh,
                               [&](const Point<dim> &x)
                               {
                                 double chance = seed + time;
                                 for (unsigned int c = 0; c < dim; ++c)
                                   chance += (c + 7.3) * x[c];
                                 chance = 4375.8 * std::sin(chance);
                                 return chance - std::floor(chance) < 0.3;
                               });
  Space<dim> space(mesh, SpaceParameters(),
                   dim == 2 ? Model::plane_strain : Model::three_dimensional, 1);
  space.distribute();

  DistributedVector velocity = space.velocity_vector(), pressure = space.pressure_vector();
  for (const auto index : space.velocity_owned)
    velocity[index] = std::sin(1. + index);
  for (const auto index : space.pressure_owned)
    pressure[index] = std::cos(2. + index);
  velocity.compress(VectorOperation::insert);
  pressure.compress(VectorOperation::insert);
  const auto expected = [&](const DistributedVector &owned,
                            const AffineConstraints<double> &hanging, const DistributedVector &like)
  {
    DistributedVector complete = owned, ghosted = like;
    hanging.distribute(complete);
    ghosted = complete;
    return ghosted;
  };
  const DistributedVector of_velocity = space.ghosted_velocity(velocity),
                          of_pressure = space.ghosted_pressure(pressure);
  check::absolute(name + ": velocity",
                  difference(of_velocity, expected(velocity, space.velocity_hanging, of_velocity)),
                  0., 1e-14);
  check::absolute(name + ": pressure",
                  difference(of_pressure, expected(pressure, space.pressure_hanging, of_pressure)),
                  0., 1e-14);

  QuadratureCells<dim> cells(space, space.quadrature(1), [](unsigned int) { return true; });
  cells.reinit();
  CellSums sums;
  sums.reinit(of_velocity, space.velocity_owned, space.velocity_hanging);
  DistributedVector rows = velocity, by_constraints = velocity;
  Vector<double> of_cell(dim * cells.n_functions());
  // A second time as after a step.
  for (unsigned int time = 0; time < 2; ++time)
  {
    for (const QuadratureCell<dim> &cell : cells.all())
    {
      for (unsigned int i = 0; i < of_cell.size(); ++i)
        of_cell[i] = std::sin(3. * i + cell.velocity_cell->center()[0] + time);
      sums.add(cell.velocity_places, of_cell);
      space.velocity_hanging.distribute_local_to_global(of_cell, cell.velocity_indices,
                                                        by_constraints);
    }
    sums.add_to(rows);
    by_constraints.compress(VectorOperation::add);
  }
  check::absolute(name + ": sums of cells", difference(rows, by_constraints), 0., 1e-13);
}
} // namespace

UNIT_TEST(ghosted_copy)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  for (const int seed : {1, 2, 3, 4, 5, 6, 7, 8})
    check_mesh<2>("mesh " + std::to_string(seed), {3, 3}, seed);
  check_mesh<3>("in space", {2, 1, 2}, 1.);
}
} // namespace test_of_ghosted_copy
