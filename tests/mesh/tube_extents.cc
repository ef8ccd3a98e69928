// The measures of a tube found in its mesh: of meshes of known measures, and bodies that are none.

#include <continua/mesh/tube_extents.h>

#include "../unit_test.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

namespace test_of_tube_extents
{
using namespace Continua;
using namespace dealii;

namespace
{
/// A rectangle 0.5 m x 30 mm of 5 x 6 cells of 100 x 5 mm. Regions by the cells' rows: 0 is fluid.
void rectangle(Triangulation<2> &mesh, const std::vector<unsigned int> &region_of_row)
{
  GridGenerator::subdivided_hyper_rectangle(mesh, {5, 6}, Point<2>(0.1, 0.), Point<2>(0.6, 0.03),
                                            true);
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(region_of_row[static_cast<unsigned int>(cell->center()[1] / 0.005)]);
}

bool is_tube(const std::vector<unsigned int> &region_of_row, const std::set<unsigned int> &fluids)
{
  Triangulation<2> mesh;
  rectangle(mesh, region_of_row);
  TubeExtents extents;
  return find_tube(mesh, fluids, extents);
}
} // namespace

UNIT_TEST(tube_extents)
{
  {
    Triangulation<2> mesh;
    rectangle(mesh, {0, 0, 0, 2, 1, 1});
    // The cells towards the end are longer.
    GridTools::transform([](const Point<2> &p) { return Point<2>(p[0] < 0.55 ? p[0] : 0.7, p[1]); },
                         mesh);
    TubeExtents extents;
    check::is_true("tube", find_tube(mesh, {0}, extents));
    const TubeExtents::End &begin = extents.ends[0], &end = extents.ends[1];
    check::relative("length", extents.length(), 0.6, 1e-12);
    check::relative("begin", begin.x, 0.1, 1e-12);
    check::relative("radius", begin.inner_radius, 0.015, 1e-12);
    check::is_true("layers", end.layers.size() == 2 && end.layers[0].region == 2 &&
                                 end.layers[1].region == 1);
    check::relative("inner layer", begin.layers[0].thickness, 0.005, 1e-12);
    check::relative("outer layer", begin.layers[1].thickness, 0.01, 1e-12);
    check::relative("wall cell at the begin", begin.wall_cell, 0.1, 1e-12);
    check::relative("wall cell at the end", end.wall_cell, 0.2, 1e-12);
    check::relative("axial cell", extents.axial_cell, 0.2, 1e-12);
    check::relative("cell at the wall", extents.normal_cell, 0.005, 1e-12);
    check::is_true("boundaries", begin.fluid_boundary == 0 && end.fluid_boundary == 1 &&
                                     begin.wall_boundary == 0 && end.wall_boundary == 1);
    check::is_true("outer surface", extents.outer_boundary == 3 && extents.outer_region == 1);
  }
  {
    // Half as wide at the end.
    Triangulation<2> mesh;
    rectangle(mesh, {0, 0, 0, 0, 1, 1});
    GridTools::transform([](const Point<2> &p) { return Point<2>(p[0], p[1] * (1.1 - p[0])); },
                         mesh);
    TubeExtents extents;
    check::is_true("taper", find_tube(mesh, {0}, extents));
    check::relative("taper, begin", extents.ends[0].inner_radius, 0.02, 1e-12);
    check::relative("taper, end", extents.ends[1].inner_radius, 0.01, 1e-12);
    check::relative("taper, wall at the end", extents.ends[1].layers[0].thickness, 0.005, 1e-12);
  }
  check::is_true("solid at the axis is no tube", !is_tube({1, 1, 0, 0, 1, 1}, {0}));
  check::is_true("fluid outside is no tube", !is_tube({0, 0, 1, 1, 0, 0}, {0}));
  check::is_true("no wall is no tube", !is_tube({0, 0, 0, 0, 0, 0}, {0}));
  check::is_true("no fluid is no tube", !is_tube({1, 1, 1, 1, 1, 1}, {0}));

  {
    // A quarter of a tube along x: inner radius 0.4 m, wall 0.6 m.
    Triangulation<2> core, fine_core, shell, section;
    GridGenerator::quarter_hyper_ball(core, Point<2>(), 0.4);
    core.refine_global(1);
    GridGenerator::flatten_triangulation(core, fine_core);
    GridGenerator::quarter_hyper_shell(shell, Point<2>(), 0.4, 1., 4);
    GridGenerator::merge_triangulations(fine_core, shell, section, 1e-6);
    Triangulation<3> along_z, mesh;
    GridGenerator::extrude_triangulation(section, 4, 3., along_z);
    GridTools::transform([](const Point<3> &p) { return Point<3>(p[2], p[0], p[1]); }, along_z);
    mesh.copy_triangulation(along_z);
    for (const auto &cell : mesh.active_cell_iterators())
    {
      const Point<3> c = cell->center();
      cell->set_material_id(std::hypot(c[1], c[2]) > 0.4 ? 1 : 0);
    }
    TubeExtents extents;
    check::is_true("in space", find_tube(mesh, {0}, extents));
    check::relative("in space, length", extents.length(), 3., 1e-12);
    check::relative("in space, radius", extents.ends[1].inner_radius, 0.4, 1e-12);
    check::relative("in space, wall", extents.ends[1].layers.at(0).thickness, 0.6, 1e-12);
    check::relative("in space, axial cell", extents.axial_cell, 1., 1e-12);
  }
}
} // namespace test_of_tube_extents
