#include <continua/base/input_error.h>
#include <continua/mesh/box_geometry.h>

#include "../parameter_text.h"
#include "../unit_test.h"
#include "mesh_measures.h"

namespace test_of_box_geometry
{
using namespace Continua;

UNIT_TEST(box_geometry)
{
  BoxGeometry<2>::Parameters plane;
  plane.size = {20., 5.};
  plane.origin = {-1., 2.};
  plane.cells = {7, 3};
  plane.grading = {1., 4.};
  const measures::Measures<2> box(BoxGeometry<2>(plane, false));
  check::absolute("cells", box.mesh.n_cells(), 21., 0.);
  check::relative("area", box.region("body"), 100., 1e-13);
  check::relative("left", box.boundary("left"), 5., 1e-13);
  check::relative("right", box.boundary("right"), 5., 1e-13);
  check::relative("bottom", box.boundary("bottom"), 20., 1e-13);
  check::relative("top", box.boundary("top"), 20., 1e-13);
  double first = 0.;
  double last = 0.;
  for (const auto &cell : box.mesh.active_cell_iterators())
  {
    if (cell->at_boundary(2))
      first = cell->extent_in_direction(1);
    if (cell->at_boundary(3))
      last = cell->extent_in_direction(1);
  }
  check::relative("grading", last / first, 4., 1e-13);
  ParameterFile file = parameters_of("subsection Geometry\nset Size = 2 m, 3 m\nend\n"
                                     "subsection Mesh\nset Cells = 2, 5\nset Grading x = 0.5\n"
                                     "set Grading y = 3\nend\n");
  const BoxGeometry<2>::Parameters given = BoxGeometry<2>::Parameters::read(
      file.root().subsection("Geometry"), file.root().subsection("Mesh"), false);
  file.refuse_unknown();
  check::is_true("grading by its entries", given.grading == std::vector<double>({0.5, 3.}));
  check::is_true("origin", (box.mesh.get_vertices()[0] - dealii::Point<2>(-1., 2.)).norm() < 1e-14);

  const auto refused =
      [](const std::string &name, const std::string &size, const std::string &pattern)
  {
    check::throws<InputError>(
        name,
        [&size]
        {
          ParameterFile wrong =
              parameters_of("subsection Geometry\nset Size = " + size + "\nend\n");
          BoxGeometry<2>::Parameters::read(wrong.root().subsection("Geometry"),
                                           wrong.root().subsection("Mesh"), false);
        },
        pattern);
  };
  refused("one length", "2 m", "prm:2: 'Geometry/Size': the list has 1 entry, not 2.*Give 2, one");
  refused("three lengths", "2 m, 3 m, 4 m", "the list has 3 entries, not 2");

  plane.rotation = M_PI / 6.;
  const measures::Measures<2> turned(BoxGeometry<2>(plane, false));
  check::relative("turned: area", turned.region("body"), 100., 1e-13);
  check::relative("turned: right", turned.boundary("right"), 5., 1e-13);
  // (-1, 2) turned by 30 degrees.
  const dealii::Point<2> corner(-0.5 * std::sqrt(3.) - 1., -0.5 + std::sqrt(3.));
  check::is_true("turned: corner", (turned.mesh.get_vertices()[0] - corner).norm() < 1e-14);

  BoxGeometry<2>::Parameters axial;
  axial.size = {2., 3.};
  const measures::Measures<2> cylinder(BoxGeometry<2>(axial, true));
  check::relative("axisymmetric: axis", cylinder.boundary("axis"), 2., 1e-13);
  check::relative("axisymmetric: outside", cylinder.boundary("outside"), 2., 1e-13);
  check::relative("axisymmetric: left", cylinder.boundary("left"), 3., 1e-13);
  axial.origin = {0., 1.};
  const measures::Measures<2> hollow(BoxGeometry<2>(axial, true));
  check::relative("hollow: inside", hollow.boundary("inside"), 2., 1e-13);
  check::absolute("hollow: no axis", hollow.boundary("axis"), -1., 0.);

  BoxGeometry<3>::Parameters space;
  space.size = {2., 3., 5.};
  space.cells = {2, 1, 4};
  space.rotation = 0.5 * M_PI;
  const measures::Measures<3> cuboid(BoxGeometry<3>(space, false));
  check::absolute("cuboid: cells", cuboid.mesh.n_cells(), 8., 0.);
  check::relative("cuboid: volume", cuboid.region("body"), 30., 1e-13);
  check::relative("cuboid: left", cuboid.boundary("left"), 15., 1e-13);
  check::relative("cuboid: bottom", cuboid.boundary("bottom"), 10., 1e-13);
  check::relative("cuboid: back", cuboid.boundary("back"), 6., 1e-13);
  check::relative("cuboid: front", cuboid.boundary("front"), 6., 1e-13);
  bool left_is_at_y_0 = true;
  for (const auto &cell : cuboid.mesh.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && face->boundary_id() == 0)
        left_is_at_y_0 &= std::abs(face->center()[1]) < 1e-14;
  check::is_true("cuboid: turned", left_is_at_y_0);
}
} // namespace test_of_box_geometry
