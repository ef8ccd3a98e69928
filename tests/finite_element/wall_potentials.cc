// The directions of a wall: along straight and curved walls by two potentials, on hanging nodes; as
// given functions; and where there is no direction.

#include <continua/finite_element/assembly/wall_potentials.h>

#include <continua/base/input_error.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>

#include "../unit_test.h"
#include "small_problem.h"

namespace test_of_wall_potentials
{
using namespace Continua;
using namespace dealii;

namespace
{
using Type = WallDirectionsParameters::Type;

Tensor<1, 3> unit_vector(const unsigned int component)
{
  return Point<3>::unit_vector(component);
}

/// Calls check(place, directions) at quadrature points of the cells of this rank.
template <int dim, typename Check>
void visit(const Space<dim> &space,
           const Model model,
           const WallDirectionsParameters &parameters,
           const Check &check)
{
  WallPotentials<dim> potentials(space, parameters);
  potentials.reinit();
  const DistributedVector ghosted = space.ghosted_velocity(potentials.potentials());
  FEValues<dim> values(space.mapping, space.velocity_element, QGauss<dim>(3),
                       update_gradients | update_quadrature_points);
  std::vector<std::vector<Tensor<1, dim>>> gradients(values.n_quadrature_points,
                                                     std::vector<Tensor<1, dim>>(dim));
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      values.reinit(cell);
      values.get_function_gradients(ghosted, gradients);
      for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
      {
        Tensor<2, 3> slopes;
        for (unsigned int c = 0; c < 2; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            slopes[c][d] = gradients[q][c][d];
        const Point<dim> &place = values.quadrature_point(q);
        check(place, parameters.at<dim>(model, place, slopes));
      }
    }
}

double over_ranks(const double value)
{
  return Utilities::MPI::max(value, MPI_COMM_WORLD);
}
} // namespace

UNIT_TEST(wall_potentials)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  WallDirectionsParameters parameters;
  parameters.type = Type::potentials;

  // A block: along y, and from its bottom to its top.
  {
    small_problem::Mesh<3> mesh(MPI_COMM_WORLD);
    small_problem::make_box<3>(mesh, {2, 3, 2});
    small_problem::refine<3>(mesh, [](const Point<3> &x) { return x[0] < 1.; });
    Space<3> space(mesh, SpaceParameters(), Model::three_dimensional, 1);
    space.distribute();
    parameters.begin = {2};
    parameters.end = {3};
    parameters.inside = {4};
    parameters.outside = {5};
    double along = 0., around = 0.;
    visit<3>(space, Model::three_dimensional, parameters,
             [&](const Point<3> &, const TubeDirections &directions)
             {
               along = std::max(along, (directions.axis - unit_vector(1)).norm());
               around = std::max(around, (directions.circumference + unit_vector(0)).norm());
             });
    check::absolute("block: along it", over_ranks(along), 0., 1e-9);
    check::absolute("block: around it", over_ranks(around), 0., 1e-9);
  }

  // A quarter of a ring, where the potential is that of the logarithm.
  parameters.begin = parameters.end = {};
  parameters.inside = {0};
  parameters.outside = {1};
  for (const Model model : {Model::plane_strain, Model::axisymmetric})
  {
    const std::string name = model == Model::axisymmetric ? "axisymmetric" : "plane";
    double errors[2];
    for (unsigned int level = 0; level < 2; ++level)
    {
      small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
      GridGenerator::quarter_hyper_shell(mesh, Point<2>(), 1., 1.4, 4, true);
      mesh.refine_global(level);
      small_problem::refine<2>(mesh, [](const Point<2> &x) { return x[0] > x[1]; });
      Space<2> space(mesh, SpaceParameters(), model, 1);
      space.distribute();
      double error = 0., skew = 0.;
      visit<2>(
          space, model, parameters,
          [&](const Point<2> &place, const TubeDirections &directions)
          {
            Tensor<1, 3> radial, tangent;
            radial[0] = place[0] / place.norm();
            radial[1] = place[1] / place.norm();
            tangent = cross_product_3d(unit_vector(2), radial);
            const bool is_round = model == Model::axisymmetric;
            const Tensor<1, 3> in_plane = is_round ? directions.axis : directions.circumference;
            // The field of axisymmetry has no closed form here: its slope is nearly radial.
            if (!is_round)
              error = std::max(error, (in_plane - tangent).norm());
            else
              error = std::max(error, std::abs(in_plane * radial));
            skew = std::max(
                skew,
                ((is_round ? directions.circumference : directions.axis) - unit_vector(2)).norm());
            skew = std::max(skew, std::abs(in_plane.norm() - 1.));
          });
      errors[level] = over_ranks(error);
      check::absolute(name + ": unit vectors", over_ranks(skew), 0., 1e-14);
    }
    if (model == Model::plane_strain)
    {
      check::absolute("ring: around it", errors[1], 0., 2.5e-3);
      check::is_true("ring: the error falls", errors[1] < 0.4 * errors[0]);
    }
    else
      check::is_true("shell: along it", errors[1] < 0.1);
  }

  // As given: of any length, and the part along the axis left out.
  WallDirectionsParameters given;
  given.type = Type::expressions;
  for (const char *const text : {"0", "2*x", "0"})
    given.axis.emplace_back(text, Dimensions::none);
  for (const char *const text : {"3", "7", "4"})
    given.circumference.emplace_back(text, Dimensions::none);
  const TubeDirections directions =
      given.at<3>(Model::three_dimensional, Point<3>(0.5, 0., 0.), Tensor<2, 3>());
  check::absolute("given axis", (directions.axis - unit_vector(1)).norm(), 0., 1e-15);
  check::absolute("given circumference",
                  (directions.circumference - 0.6 * unit_vector(0) - 0.8 * unit_vector(2)).norm(),
                  0., 1e-15);
  check::throws<RunError>(
      "no axis",
      [&]() { given.at<3>(Model::three_dimensional, Point<3>(0., 0., 0.), Tensor<2, 3>()); },
      "gives no direction at \\(0, 0, 0\\) m");
  check::throws<RunError>(
      "no slope",
      [&]() { parameters.at<2>(Model::plane_strain, Point<2>(1., 0.), Tensor<2, 3>()); },
      "a potential has no slope there");
}
} // namespace test_of_wall_potentials
