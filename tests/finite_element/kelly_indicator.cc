// Kelly's indicator on one region is that of deal.II's KellyErrorEstimator, hanging nodes included;
// a kink counts inside a region and not at an interface. By a displacement of the mesh it is that
// of the library on the mesh that has moved.

#include <continua/finite_element/looking/kelly_indicator.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/numerics/error_estimator.h>

#include "../unit_test.h"
#include "small_problem.h"

namespace test_of_kelly_indicator
{
using namespace Continua;
using namespace dealii;

namespace
{
template <int dim>
std::vector<unsigned int> cells_of_box()
{
  return dim == 2 ? std::vector<unsigned int>{4, 3} : std::vector<unsigned int>{4, 2, 2};
}

template <int dim>
double largest_difference(const Triangulation<dim> &mesh,
                          const Vector<float> &one,
                          const Vector<float> &other)
{
  double largest = 0., scale = 0.;
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const unsigned int i = cell->active_cell_index();
      largest = std::max<double>(largest, std::abs(one[i] - other[i]));
      scale = std::max<double>(scale, other[i]);
    }
  return Utilities::MPI::max(largest, MPI_COMM_WORLD) / Utilities::MPI::max(scale, MPI_COMM_WORLD);
}

template <int dim>
void compare_with_library()
{
  const std::string name = dim == 2 ? "2-D: " : "3-D: ";
  small_problem::Mesh<dim> mesh(MPI_COMM_WORLD,
                                Triangulation<dim>::limit_level_difference_at_vertices);
  small_problem::make_box<dim>(mesh, cells_of_box<dim>());
  small_problem::refine<dim>(mesh, [](const Point<dim> &x) { return x[0] < 2. && x[1] < 1.; });
  Space<dim> space(mesh, SpaceParameters(),
                   dim == 2 ? Model::plane_strain : Model::three_dimensional, 1);
  space.distribute();
  const DistributedVector velocity = small_problem::interpolated<dim>(
      space,
      [](const Point<dim> &x)
      {
        Tensor<1, dim> value;
        for (unsigned int c = 0; c < dim; ++c)
          value[c] = std::sin(x[0] + 2. * c) * std::exp(x[1] - x[dim - 1] * c);
        return value;
      });
  const DistributedVector pressure = small_problem::interpolated_pressure<dim>(
      space, [](const Point<dim> &x, unsigned int) { return std::cos(2. * x[0]) + x[1] * x[1]; });
  const hp::QCollection<dim - 1> points(QGauss<dim - 1>(space.degree() + 1));
  Vector<float> own, library(mesh.n_active_cells());
  kelly_indicators_of_velocity(space, velocity, nullptr, own);
  KellyErrorEstimator<dim>::estimate(space.mapping, space.velocity_dofs, points, {},
                                     space.ghosted_velocity(velocity), library);
  check::absolute(name + "velocity", largest_difference(mesh, own, library), 0., 1e-5);
  kelly_indicators_of_pressure(space, pressure, nullptr, own);
  KellyErrorEstimator<dim>::estimate(space.mapping, space.pressure_dofs, points, {},
                                     space.ghosted_pressure(pressure), library);
  check::absolute(name + "pressure", largest_difference(mesh, own, library), 0., 1e-5);
}

/// An undeformed mesh with a displacement, against the library on the mesh that the displacement
/// makes.
template <int dim>
void compare_moved_mesh()
{
  const std::string name = dim == 2 ? "2-D, moved: " : "3-D, moved: ";
  const Model model = dim == 2 ? Model::plane_strain : Model::three_dimensional;
  Tensor<2, dim> change = unit_symmetric_tensor<dim>();
  change[0][0] += 0.5;
  change[0][1] += 0.3;
  change[1][0] -= 0.2;
  change[dim - 1][dim - 1] += 0.25;
  const Tensor<2, dim> back = invert(change);
  small_problem::Mesh<dim> mesh(MPI_COMM_WORLD,
                                Triangulation<dim>::limit_level_difference_at_vertices),
      moved(MPI_COMM_WORLD, Triangulation<dim>::limit_level_difference_at_vertices);
  small_problem::make_box<dim>(mesh, cells_of_box<dim>());
  small_problem::make_box<dim>(moved, cells_of_box<dim>());
  GridTools::transform([&](const Point<dim> &x) { return Point<dim>(change * x); }, moved);
  const auto is_divided = [](const Tensor<1, dim> &x) { return x[0] < 2. && x[1] < 1.; };
  small_problem::refine<dim>(mesh, is_divided);
  small_problem::refine<dim>(moved, [&](const Point<dim> &x) { return is_divided(back * x); });
  Space<dim> space(mesh, SpaceParameters(), model, 1), of_moved(moved, SpaceParameters(), model, 1);
  space.distribute();
  of_moved.distribute();
  const auto speed = [](const Tensor<1, dim> &x)
  {
    Tensor<1, dim> value;
    for (unsigned int c = 0; c < dim; ++c)
      value[c] = std::sin(x[0] + 2. * c) * std::exp(x[1] - x[dim - 1] * c);
    return value;
  };
  const auto load = [](const Tensor<1, dim> &x) { return std::cos(2. * x[0]) + x[1] * x[1]; };
  const DistributedVector displacement =
      small_problem::interpolated<dim>(space, [&](const Point<dim> &x) { return change * x - x; });
  const hp::QCollection<dim - 1> points(QGauss<dim - 1>(space.degree() + 1));
  Vector<float> own, library(moved.n_active_cells());
  kelly_indicators_of_velocity(space, small_problem::interpolated<dim>(space, speed), &displacement,
                               own);
  KellyErrorEstimator<dim>::estimate(
      of_moved.mapping, of_moved.velocity_dofs, points, {},
      of_moved.ghosted_velocity(small_problem::interpolated<dim>(of_moved, [&](const Point<dim> &x)
                                                                 { return speed(back * x); })),
      library);
  check::absolute(name + "velocity", largest_difference(mesh, own, library), 0., 1e-5);
  kelly_indicators_of_pressure(
      space,
      small_problem::interpolated_pressure<dim>(space, [&](const Point<dim> &x, unsigned int)
                                                { return load(x); }),
      &displacement, own);
  KellyErrorEstimator<dim>::estimate(
      of_moved.mapping, of_moved.pressure_dofs, points, {},
      of_moved.ghosted_pressure(small_problem::interpolated_pressure<dim>(
          of_moved, [&](const Point<dim> &x, unsigned int) { return load(back * x); })),
      library);
  check::absolute(name + "pressure", largest_difference(mesh, own, library), 0., 1e-5);
}

/// A kink at x = 1, where one region is, and one at x = 2, where they meet.
void kinks()
{
  small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
  small_problem::make_box<2>(mesh, {4, 3}, Point<2>(), 2.);
  Space<2> space(mesh, SpaceParameters(), Model::plane_strain, 2);
  space.distribute();
  const auto roof = [](const double x) { return std::abs(x - 1.) + 5. * std::abs(x - 2.); };
  const DistributedVector velocity =
      small_problem::interpolated<2>(space,
                                     [&](const Point<2> &x) {
                                       return Tensor<1, 2>({roof(x[0]), 0.});
                                     });
  const DistributedVector pressure = small_problem::interpolated_pressure<2>(
      space, [&](const Point<2> &x, unsigned int) { return roof(x[0]); });
  // The derivative jumps by 2 across a face of length 1.
  const double expected = std::sqrt(std::sqrt(2.) / 24. * 4.);
  Vector<float> per_cell;
  for (const bool of_velocity : {true, false})
  {
    if (of_velocity)
      kelly_indicators_of_velocity(space, velocity, nullptr, per_cell);
    else
      kelly_indicators_of_pressure(space, pressure, nullptr, per_cell);
    double error = 0.;
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned())
        error = std::max(error, std::abs(per_cell[cell->active_cell_index()] -
                                         (cell->center()[0] < 2. ? expected : 0.)));
    check::absolute(std::string("a kink inside a region counts: ") +
                        (of_velocity ? "velocity" : "pressure"),
                    Utilities::MPI::max(error, MPI_COMM_WORLD), 0., 1e-5);
  }
}
} // namespace

UNIT_TEST(kelly_indicator)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  compare_with_library<2>();
  compare_with_library<3>();
  compare_moved_mesh<2>();
  compare_moved_mesh<3>();
  kinks();
}
} // namespace test_of_kelly_indicator
