#include <continua/mesh/layered_stack.h>

#include "../unit_test.h"

namespace test_of_layered_stack
{
using namespace Continua;

UNIT_TEST(layered_stack)
{
  LayeredStack stack;
  stack.fluid_depth = 3.;
  stack.fluid_cells = 2;
  stack.fluid_grading = 0.5;
  stack.wall_thicknesses = {1., 0.5};
  stack.wall_cells = {2, 1};
  const std::vector<double> wanted = {0., 2., 3., 3.5, 4., 4.5};
  const auto points = stack.points();
  double error = points.size() == wanted.size() ? 0. : 1.;
  for (std::size_t i = 0; i < points.size() && i < wanted.size(); ++i)
    error += std::abs(points[i] - wanted[i]);
  check::absolute("points", error, 0., 1e-13);
  check::is_true("interface is exact", points[2] == 3.);

  std::string regions;
  std::string at_lower_end;
  std::string at_upper_side;
  for (unsigned int cell = 0; cell < 5; ++cell)
  {
    regions += std::to_string(stack.region(cell));
    at_lower_end += std::to_string(stack.boundary(cell, 0));
    at_upper_side += std::to_string(stack.boundary(cell, 3));
  }
  check::equal("regions", regions, "00112");
  check::equal("boundaries at the inlet's end", at_lower_end, "00222");
  check::equal("boundaries on top", at_upper_side, "55555");

  const auto names = stack.region_names();
  check::is_true("names", names == std::vector<std::string>({"fluid", "wall 1", "wall 2"}));
  stack.wall_thicknesses = {1.};
  check::is_true("names with one layer",
                 stack.region_names() == std::vector<std::string>({"fluid", "wall"}));
}
} // namespace test_of_layered_stack
