#include <continua/base/parameter_file.h>
#include <continua/mesh/box_geometry.h>
#include <continua/mesh/painted_geometry.h>

#include "../unit_test.h"
#include "mesh_measures.h"

#include <fstream>

namespace test_of_painted_geometry
{
using namespace Continua;

namespace
{
/// A square of 4 x 4 with 4 x 4 cells, painted by these lines.
PaintedGeometry<2> painted(const std::string &lines)
{
  std::ofstream("painted.prm") << "subsection Regions\n" << lines << "end\n";
  ParameterFile file("painted.prm");
  BoxGeometry<2>::Parameters box;
  box.size = {4., 4.};
  box.cells = {4, 4};
  return PaintedGeometry<2>(std::make_unique<BoxGeometry<2>>(box, false),
                            file.root().subsection("Regions"));
}
} // namespace

UNIT_TEST(painted_geometry)
{
  const measures::Measures<2> square(painted("set core = 1.1 - sqrt((x-2)^2 + (y-2)^2) + 0*z\n"
                                             "set half = 2 - x\n"
                                             "set body = y - 3\n"));
  check::is_true("names",
                 square.region_names == std::vector<std::string>({"body", "core", "half"}));
  check::relative("core", square.region("core"), 4., 1e-13);
  check::relative("half, after the core", square.region("half"), 6., 1e-13);
  check::relative("the rest", square.region("body"), 6., 1e-13);
  check::relative("boundaries stay", square.boundary("left"), 4., 1e-13);

  const measures::Measures<2> angle(painted("set sector = pi/4 - atan2(y, x) - 0.1\n"));
  check::relative("pi and functions", angle.region("sector"), 6., 1e-13);

  check::throws<InputError>(
      "syntax", [] { painted("set a = x - 1\nset b = x +* 2\n"); },
      "painted.prm:3.*/b'.*x \\+\\* 2");
  check::throws<InputError>(
      "unknown name", [] { painted("set a = radius - 1\n"); }, "painted.prm:2.*radius");
  check::throws<InputError>(
      "no cell", [] { painted("set a = x - 2\nset b = x - 5\n"); },
      "painted.prm:3.*/b'.*no coarse cell");
  check::throws<InputError>(
      "hidden by an earlier one", [] { painted("set a = x - 2\nset b = x - 3\n"); },
      "painted.prm:3.*/b'.*earlier");
  check::throws<InputError>(
      "nothing left", [] { painted("set a = 1\n"); }, "painted.prm.*'body'");
}
} // namespace test_of_painted_geometry
