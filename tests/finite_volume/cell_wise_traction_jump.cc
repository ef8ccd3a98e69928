// The jump of the traction as an indicator: none in a body under one stress, the pressure's where
// that jumps, and what a boundary's traction misses.

#include <continua/finite_volume/cell_wise_traction_jump.h>

#include "../unit_test.h"
#include "cell_wise_body.h"

#include <algorithm>

namespace test_of_cell_wise_traction_jump
{
using namespace cell_wise_meshes;
using dealii::Point;
using dealii::Tensor;

namespace
{
template <int dim>
void test()
{
  const std::string name = dim == 2 ? "2-D: " : "3-D: ";
  Body<dim> body(
      [](Triangulation<dim> &mesh)
      {
        make_box(mesh, 4);
        refine_corner(mesh);
      },
      dim == 2 ? Model::plane_strain : Model::three_dimensional);
  FaceConditions<dim> conditions(body.space, body.problem.conditions);
  conditions.build();
  const auto indicators = [&]()
  {
    dealii::Vector<float> per_cell;
    traction_jump_indicators(body.space, body.problem, body.evaluation, conditions, body.state(),
                             std::vector<double>(body.problem.conditions.size(), 0.), 0., per_cell);
    return per_cell;
  };

  // One velocity gradient: the fluid's stress is constant, the solid's zero, so at their interface
  // the traction jumps and nowhere else.
  body.velocity = velocity_field<dim>(body.space,
                                      [](const Point<dim> &x)
                                      {
                                        Tensor<1, dim> result;
                                        result[0] = 3. * x[1];
                                        return result;
                                      });
  const auto on_interface = [&](const unsigned int cell)
  {
    double largest_extent = 0., area = 0.;
    for (const unsigned int face : body.space.mesh.cells()[cell].faces)
      if (body.space.mesh.faces()[face].is_interface)
      {
        area += body.space.mesh.faces()[face].area;
        largest_extent = std::max(largest_extent, body.space.mesh.faces()[face].area);
      }
    return area;
  };
  double elsewhere = 0., at_interface = 0.;
  const auto shear = indicators();
  for (unsigned int cell = 0; cell < body.space.mesh.n_owned_cells(); ++cell)
  {
    const double value = shear[body.space.mesh.cells()[cell].iterator->active_cell_index()];
    (on_interface(cell) > 0. ? at_interface : elsewhere) =
        std::max(on_interface(cell) > 0. ? at_interface : elsewhere, value);
  }
  check::absolute(name + "no jump inside", largest(elsewhere), 0., 1e-5);
  check::is_true(name + "a jump between the regions", largest(at_interface) > 0.1);

  // At rest, p = 2 in the solid and 5 in the fluid: eta^2 = 1/2 sum of h |F| 3^2.
  body.velocity = 0.;
  body.pressure = pressure_field<dim>(body.space, [](const Point<dim> &, const unsigned int region)
                                      { return 2. + 3. * region; });
  double error = 0.;
  const auto pressures = indicators();
  for (unsigned int cell = 0; cell < body.space.mesh.n_owned_cells(); ++cell)
  {
    double square = 0.;
    for (const unsigned int face : body.space.mesh.cells()[cell].faces)
      if (body.space.mesh.faces()[face].is_interface)
      {
        const double area = body.space.mesh.faces()[face].area;
        square += 0.5 * (dim == 2 ? area : std::sqrt(2. * area)) * area * 9.;
      }
    error = std::max(
        error, std::abs(pressures[body.space.mesh.cells()[cell].iterator->active_cell_index()] -
                        std::sqrt(square)));
  }
  check::absolute(name + "jump of the pressure", largest(error), 0., 1e-6);

  // Free boundaries miss the pressure there; held ones do not.
  for (BoundaryCondition &condition : body.problem.conditions)
    if (condition.boundary_id == 1)
      condition.normal.kind = condition.tangential.kind = BoundaryPart::Kind::traction;
  conditions.build();
  error = 0.;
  const auto free_end = indicators();
  for (unsigned int cell = 0; cell < body.space.mesh.n_owned_cells(); ++cell)
  {
    const auto &volume = body.space.mesh.cells()[cell];
    for (const unsigned int face : volume.faces)
    {
      const VolumeFace<dim> &surface = body.space.mesh.faces()[face];
      if (surface.boundary_id != 1)
        continue;
      const double extent = dim == 2 ? surface.area : std::sqrt(2. * surface.area);
      error = std::max(error, std::abs(free_end[volume.iterator->active_cell_index()] -
                                       std::sqrt(extent * surface.area * 4.)));
    }
  }
  check::absolute(name + "a free end under pressure", largest(error), 0., 1e-6);
}
} // namespace

UNIT_TEST(cell_wise_traction_jump)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  test<2>();
  test<3>();
}
} // namespace test_of_cell_wise_traction_jump
