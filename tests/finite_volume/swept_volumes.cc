// The geometric conservation law: what the faces of a cell sweep is the change of its volume, and
// the rates are those of the step's formula, also with steps of two sizes.

#include <continua/finite_volume/swept_volumes.h>

#include "cell_wise_meshes.h"

#include "../unit_test.h"

#include <algorithm>
#include <cmath>

namespace test_of_swept_volumes
{
using namespace cell_wise_meshes;
namespace
{
/// Vertices of the mesh at one of three places; the axis and the origin of x stay planes.
template <int dim>
VertexPlaces<dim> places(const Triangulation<dim> &mesh, const double time)
{
  VertexPlaces<dim> result = mesh.get_vertices();
  for (dealii::Point<dim> &p : result)
  {
    const dealii::Point<dim> undeformed = p;
    for (unsigned int c = 0; c < dim; ++c)
      p[c] += undeformed[c] * (0.2 * time * std::sin(5. * undeformed[0] + 3. * undeformed[1] + c) +
                               0.1 * time * time * std::cos(2. * undeformed[dim - 1] - c));
  }
  return result;
}

template <int dim>
void check_steps(const std::string &name,
                 const std::function<void(Triangulation<dim> &)> &make,
                 const bool axisymmetric)
{
  Triangulation<dim> triangulation(MPI_COMM_WORLD);
  make(triangulation);
  CellWiseMesh<dim> mesh(triangulation, axisymmetric);
  mesh.build();
  // Region 1 moves, and region 0 beside it stays.
  const std::vector<bool> moving = {false, true};
  const double times[3] = {0., 0.4, 1.};
  VertexPlaces<dim> of_time[3];
  std::vector<double> volumes[3];
  for (unsigned int level = 0; level < 3; ++level)
  {
    of_time[level] = places(triangulation, times[level]);
    mesh.move(of_time[level], moving);
    for (unsigned int cell = 0; cell < mesh.n_owned_cells(); ++cell)
      volumes[level].push_back(mesh.cells()[cell].volume);
  }
  SweptVolumes<dim> swept(mesh);
  const Step step = backward_differencing_step(times[1], times[2] - times[1], times[1] - times[0],
                                               Update::implicit);
  swept.measure(step, of_time[0], of_time[1], of_time[2], moving);
  double growth = 0., earlier = 0., rate = 0., least = 1., undeformed = 0.;
  for (unsigned int cell = 0; cell < mesh.n_owned_cells(); ++cell)
  {
    const double size = volumes[0][cell];
    if (!swept.moves(cell))
    {
      undeformed = std::max(undeformed, std::abs(volumes[2][cell] - size) / size);
      continue;
    }
    double outflow = 0.;
    for (const unsigned int f : mesh.cells()[cell].faces)
      outflow += (mesh.side(f, cell) == 0 ? 1. : -1.) * swept.rate(f);
    const double change = volumes[2][cell] - volumes[1][cell];
    growth = std::max(growth, std::abs(swept.growth(cell) - change) / size);
    earlier = std::max(
        earlier,
        std::abs(swept.growth_since_older(cell) - volumes[2][cell] + volumes[0][cell]) / size);
    rate = std::max(rate, std::abs(outflow - step.a0 * volumes[2][cell] -
                                   step.a1 * volumes[1][cell] - step.a2 * volumes[0][cell]) /
                              size);
    least = std::min(least, std::abs(change) / size);
  }
  check::absolute(name + ": growth in the step", largest(growth), 0., 1e-13);
  check::absolute(name + ": growth in both steps", largest(earlier), 0., 1e-13);
  check::absolute(name + ": rate by the formula", largest(rate), 0., 1e-12);
  check::absolute(name + ": what stays", largest(undeformed), 0., 0.);
  check::is_true(name + ": cells grow or shrink",
                 dealii::Utilities::MPI::min(least, MPI_COMM_WORLD) > 1e-4);
}
} // namespace

UNIT_TEST(swept_volumes)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  const auto box_2d = [](Triangulation<2> &mesh)
  {
    make_box(mesh, 4);
    refine_corner(mesh);
  };
  check_steps<2>("2-D", box_2d, false);
  check_steps<2>("axisymmetric", box_2d, true);
  check_steps<3>(
      "3-D",
      [](Triangulation<3> &mesh)
      {
        make_box(mesh, 4);
        refine_corner(mesh);
      },
      false);
}
} // namespace test_of_swept_volumes
