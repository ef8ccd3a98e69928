// Discs around the x axis and elsewhere, whole and in part, and what is none.

#include <continua/mesh/round_section.h>

#include "../unit_test.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <stdexcept>

namespace test_of_round_section
{
using namespace Continua;
using namespace dealii;

namespace
{
/// Gives all faces in the plane x = `place` the boundary id 7.
template <int dim>
void mark(Triangulation<dim> &mesh, const double place)
{
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->at_boundary(f) && std::abs(cell->face(f)->center()[0] - place) < 1e-9)
        cell->face(f)->set_boundary_id(7);
}
} // namespace

UNIT_TEST(round_section)
{
  {
    Triangulation<2> mesh;
    GridGenerator::subdivided_hyper_rectangle(mesh, {3, 4}, Point<2>(1., 0.), Point<2>(2., 0.3));
    mark(mesh, 1.);
    const RoundSection<2> disc = find_round_section(mesh, 7, {0});
    check::relative("axisymmetric: radius", disc.radius, 0.3, 1e-14);
    check::is_true("axisymmetric: the whole disc", disc.fraction == 1.);
    check::throws<std::invalid_argument>(
        "no face in the region", [&] { find_round_section(mesh, 7, {5}); }, "no face");
    Triangulation<2> hollow;
    GridGenerator::subdivided_hyper_rectangle(hollow, {3, 4}, Point<2>(1., 0.1), Point<2>(2., 0.3));
    mark(hollow, 1.);
    check::throws<std::invalid_argument>(
        "axisymmetric: a ring", [&] { find_round_section(hollow, 7, {0}); }, "not a disc");
  }
  {
    Triangulation<3> mesh;
    GridGenerator::cylinder(mesh, 0.5, 2.);
    mark(mesh, 2.);
    const RoundSection<3> disc = find_round_section(mesh, 7, {0});
    check::relative("cylinder: radius", disc.radius, 0.5, 1e-12);
    check::is_true("cylinder: the whole disc", disc.fraction == 1.);
    Triangulation<3> moved;
    GridGenerator::cylinder(moved, 0.5, 2.);
    mark(moved, 2.);
    // Straight cells: the square inscribed in the circle has too little area.
    moved.reset_all_manifolds();
    check::throws<std::invalid_argument>(
        "a square", [&] { find_round_section(moved, 7, {0}); }, "neither a disc");
    Triangulation<3> turned;
    GridGenerator::cylinder(turned, 0.5, 2.);
    mark(turned, 2.);
    GridTools::rotate(Tensor<1, 3>({0., 0.6, 0.8}), 0.7, turned);
    GridTools::shift(Tensor<1, 3>({1., 0.3, -2.}), turned);
    const Tensor<1, 3> direction({std::cos(0.7), 0.8 * std::sin(0.7), -0.6 * std::sin(0.7)});
    turned.set_manifold(0, CylindricalManifold<3>(direction, Point<3>(1., 0.3, -2.)));
    const RoundSection<3> elsewhere = find_round_section(turned, 7, {0});
    check::relative("elsewhere: radius", elsewhere.radius, 0.5, 1e-9);
    check::is_true("elsewhere: the whole disc", elsewhere.fraction == 1.);
    // The axis e_x becomes cos e_x + sin (0, 0.6, 0.8) x e_x.
    const Point<3> centre(1. + 2. * std::cos(0.7), 0.3 + 2. * 0.8 * std::sin(0.7),
                          -2. - 2. * 0.6 * std::sin(0.7));
    check::absolute("elsewhere: centre", elsewhere.centre.distance(centre), 0., 1e-9);
    for (const auto &cell : mesh.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f))
          cell->face(f)->set_boundary_id(7);
    check::throws<std::invalid_argument>(
        "not plane", [&] { find_round_section(mesh, 7, {0}); }, "one plane");
  }
  {
    // A quarter of a ball's sections is a quarter of a disc: extrude the flat one along z, then
    // turn.
    Triangulation<2> flat;
    GridGenerator::quarter_hyper_ball(flat, Point<2>(), 0.4);
    Triangulation<3> quarter;
    GridGenerator::extrude_triangulation(flat, 2, 1., quarter);
    GridTools::rotate(Tensor<1, 3>({0., 1., 0.}), M_PI / 2., quarter);
    quarter.reset_all_manifolds();
    quarter.refine_global(0);
    quarter.set_all_manifold_ids(numbers::flat_manifold_id);
    for (const auto &cell : quarter.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f))
        {
          bool outside = true;
          for (const unsigned int v : cell->face(f)->vertex_indices())
            outside = outside && std::abs(std::hypot(cell->face(f)->vertex(v)[1],
                                                     cell->face(f)->vertex(v)[2]) -
                                          0.4) < 1e-9;
          if (outside)
            cell->face(f)->set_all_manifold_ids(1);
        }
    quarter.set_manifold(1, CylindricalManifold<3>(0));
    mark(quarter, 0.);
    const RoundSection<3> disc = find_round_section(quarter, 7, {0});
    check::relative("quarter: radius", disc.radius, 0.4, 1e-12);
    check::is_true("quarter: a quarter of the disc", disc.fraction == 0.25);
    // Beside the axis a quarter is not told from other shapes.
    GridTools::shift(Tensor<1, 3>({0., 0.3, 0.}), quarter);
    check::throws<std::invalid_argument>(
        "a quarter beside the axis", [&] { find_round_section(quarter, 7, {0}); },
        "neither a disc");
  }
}
} // namespace test_of_round_section
