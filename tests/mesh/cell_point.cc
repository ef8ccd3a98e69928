// Which cell holds a point: inside, on faces up to round-off, outside, and on curved cells.

#include <continua/mesh/cell_point.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>

#include "../unit_test.h"

namespace test_of_cell_point
{
using namespace dealii;

UNIT_TEST(cell_point)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Point<2> unit;
  {
    Triangulation<2> mesh;
    GridGenerator::hyper_rectangle(mesh, Point<2>(1., 2.), Point<2>(3., 3.));
    const MappingQ<2> mapping(2);
    const auto cell = mesh.begin();
    check::is_true("inside",
                   Continua::cell_holds_point<2>(mapping, cell, Point<2>(1.5, 2.25), unit));
    check::absolute("unit point", unit.distance(Point<2>(0.25, 0.25)), 0., 1e-12);
    check::is_true("on a face, off by round-off",
                   Continua::cell_holds_point<2>(mapping, cell, Point<2>(3. + 1e-12, 2.5), unit));
    check::absolute("and put onto it", unit[0], 1., 0.);
    check::is_true("outside",
                   !Continua::cell_holds_point<2>(mapping, cell, Point<2>(3.001, 2.5), unit));
  }
  {
    // A quarter of a ring in two cells: a point beyond the chord of the outer arc and within the
    // arc.
    Triangulation<2> mesh;
    GridGenerator::quarter_hyper_shell(mesh, Point<2>(), 10., 20., 2);
    const double angle = numbers::PI / 8.;
    const Point<2> point(19.9 * std::cos(angle), 19.9 * std::sin(angle));
    unsigned int n_straight = 0, n_curved = 0;
    for (const auto &cell : mesh.active_cell_iterators())
    {
      n_straight += Continua::cell_holds_point<2>(MappingQ<2>(1), cell, point, unit) ? 1 : 0;
      n_curved += Continua::cell_holds_point<2>(MappingQ<2>(6), cell, point, unit) ? 1 : 0;
    }
    check::is_true("outside the straight cells", n_straight == 0);
    check::is_true("inside one curved cell", n_curved == 1);
  }
  {
    Triangulation<3> mesh;
    GridGenerator::hyper_cube(mesh);
    Point<3> unit_3d;
    check::is_true("3-D corner", Continua::cell_holds_point<3>(MappingQ<3>(1), mesh.begin(),
                                                               Point<3>(1., 1., 1.), unit_3d));
  }
}
} // namespace test_of_cell_point
