// Sections of plane channels: whole, from the middle on, inclined, and what is none.

#include <continua/mesh/channel_section.h>

#include "../unit_test.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <stdexcept>

namespace test_of_channel_section
{
using namespace Continua;
using namespace dealii;

namespace
{
/// A box from (1, 1) to (2, 1.4) of 2 x 4 cells; boundaries: left 0, right 1, bottom 2, top 3.
void make_channel(Triangulation<2> &mesh)
{
  GridGenerator::subdivided_hyper_rectangle(mesh, {2, 4}, Point<2>(1., 1.), Point<2>(2., 1.4),
                                            true);
  // Colours are those of materials, too.
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(0);
}
} // namespace

UNIT_TEST(channel_section)
{
  Triangulation<2> mesh;
  make_channel(mesh);
  const ChannelSection whole = find_channel_section(mesh, 0, {0}, {});
  check::absolute("whole: middle", whole.middle.distance(Point<2>(1., 1.2)), 0., 1e-14);
  check::relative("whole: half of the gap", whole.half_gap, 0.2, 1e-14);
  check::is_true("whole", whole.fraction == 1.);
  check::relative("whole: direction", whole.direction[1], 1., 1e-14);
  for (const types::boundary_id symmetry : {2, 3})
  {
    const ChannelSection half = find_channel_section(mesh, 1, {0}, {symmetry});
    const std::string name = symmetry == 2 ? "from the bottom" : "from the top";
    check::absolute(name + ": middle", half.middle.distance(Point<2>(2., symmetry == 2 ? 1. : 1.4)),
                    0., 1e-14);
    check::relative(name + ": half of the gap", half.half_gap, 0.4, 1e-14);
    check::is_true(name + ": half", half.fraction == 0.5);
  }
  check::throws<std::invalid_argument>(
      "no wall",
      [&] {
        find_channel_section(mesh, 0, {0}, {2, 3});
      },
      "no wall");
  check::throws<std::invalid_argument>(
      "no face", [&] { find_channel_section(mesh, 0, {4}, {}); }, "no face");
  mesh.begin_active()->face(0)->set_boundary_id(3);
  check::throws<std::invalid_argument>(
      "bent", [&] { find_channel_section(mesh, 3, {0}, {}); }, "not a straight line");
  Triangulation<2> gaps;
  make_channel(gaps);
  for (const auto &cell : gaps.active_cell_iterators())
    if (cell->at_boundary(0) && std::abs(cell->center()[1] - 1.15) < 1e-9)
      cell->face(0)->set_boundary_id(7);
  check::throws<std::invalid_argument>(
      "with a gap", [&] { find_channel_section(gaps, 0, {0}, {}); }, "without gaps");

  Triangulation<2> inclined;
  make_channel(inclined);
  GridTools::rotate(0.3, inclined);
  const ChannelSection turned = find_channel_section(inclined, 0, {0}, {});
  check::relative("inclined: half of the gap", turned.half_gap, 0.2, 1e-12);
  check::absolute("inclined: direction",
                  (turned.direction - Tensor<1, 2>(Point<2>(-std::sin(0.3), std::cos(0.3)))).norm(),
                  0., 1e-12);
}
} // namespace test_of_channel_section
