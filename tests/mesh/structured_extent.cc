// The extent of every geometry is that of the mesh it makes, and a coarsened geometry is the same
// body in fewer cells.

#include <continua/base/parameter_file.h>
#include <continua/mesh/geometry.h>
#include <continua/mesh/structured_extent.h>

#include <deal.II/grid/grid_tools.h>

#include "../unit_test.h"

#include <fstream>

namespace test_of_structured_extent
{
namespace
{
using namespace Continua;
using namespace dealii;

template <int dim>
void compare(const std::string &name,
             const std::string &geometry,
             const std::string &mesh,
             const double n_layers,
             const double volume_tolerance,
             const bool axisymmetric = false)
{
  std::ofstream("extent.prm") << "subsection Geometry\n"
                              << geometry << "end\nsubsection Mesh\n"
                              << mesh << "end\n";
  ParameterFile file("extent.prm");
  const auto body = make_geometry<dim>(file.root().subsection("Geometry"),
                                       file.root().subsection("Mesh"), axisymmetric);
  Triangulation<dim> triangulation;
  body->create(triangulation);
  check::relative(name + ": cells", body->extent().n_cells, triangulation.n_active_cells(), 1e-12);
  check::relative(name + ": layers", body->extent().n_layers, n_layers, 1e-12);
  const double most = triangulation.n_active_cells() / 2.;
  const auto coarse = body->coarsened(most);
  check::is_true(name + ": can be coarse", coarse != nullptr);
  Triangulation<dim> coarse_triangulation;
  coarse->create(coarse_triangulation);
  check::is_true(name + ": coarse", coarse_triangulation.n_active_cells() <= most);
  check::relative(name + ": volume", GridTools::volume(coarse_triangulation),
                  GridTools::volume(triangulation), volume_tolerance);
  check::is_true(name + ": names", coarse->regions() == body->regions() &&
                                       coarse->boundaries() == body->boundaries());
  check::relative(name + ": nothing to do", body->coarsened(1e9)->extent().n_cells,
                  body->extent().n_cells, 1e-12);
}
} // namespace

UNIT_TEST(structured_extent)
{
  compare<2>("box", "set Type = box\n", "set Cells = 4, 6\n", 6., 1e-12);
  compare<3>("cuboid", "set Type = box\n", "set Cells = 4, 6, 2\n", 6., 1e-12);
  compare<2>("beam", "set Type = beam\n", "set Cells = 10, 2\n", 10., 1e-12);
  compare<3>("beam in space", "set Type = beam\n", "set Cells = 10, 2, 3\n", 10., 1e-12);
  const std::string channel =
      "set Type = layered channel\nset Fluid depth = 0.1\nset Layer thicknesses = 0.01, 0.02\n";
  compare<2>("channel", channel,
             "set Axial cells = 8\nset Fluid cells = 3\nset Wall cells = 1, 2\n", 8., 1e-12);
  compare<3>(
      "channel in space", channel,
      "set Axial cells = 8\nset Fluid cells = 3\nset Wall cells = 1, 2\nset Width cells = 4\n", 8.,
      1e-12);
  // Along x: 3 before the square around the cylinder, 8 of it, 15 along the beam, 20 behind it. The
  // coarse chords are less like the circle.
  const std::string cylinder = "set Type = channel with cylinder\n";
  compare<2>("channel with beam", cylinder, "set Upstream cells = 3\n", 46., 2e-3);
  compare<2>("channel with cylinder", cylinder + "set Beam length = 0 m\n",
             "set Upstream cells = 3\n", 31., 2e-3);
  compare<3>("channel with beam in space", cylinder, "set Width cells = 3\n", 47., 2e-3);
  compare<3>("wide channel", cylinder, "set Width cells = 50\n", 50., 2e-3);
  const std::string tube = "set Type = tube\nset Inner diameter = 10 mm\nset Length = 0.8 m\n"
                           "set Wall thickness = 1.5 mm\n";
  compare<2>("tube", tube, "set Axial cells = 12\nset Radial cells = 3\nset Wall cells = 2\n", 12.,
             1e-12, true);
  const std::string rings =
      "set Axial cells = 12\nset Radial cells = 3\nset Wall cells = 2\nset Circumferential cells = "
      "4\n";
  compare<3>("quarter of a tube", tube, rings, 12., 1e-12);
  compare<3>("whole tube", tube + "set Sector = full\n", rings, 12., 1e-12);
  compare<2>("cylinder", "set Type = hollow cylinder\n",
             "set Radial cells = 3\nset Axial cells = 8\n", 8., 1e-12, true);
  // The arcs of the quarter become chords.
  compare<2>("ring", "set Type = hollow cylinder\n",
             "set Radial cells = 3\nset Circumferential cells = 20\n", 20., 0.02);
  compare<2>("membrane", "set Type = cook membrane\n", "set Cells = 6, 4\n", 6., 1e-12);

  check::equal("the largest is divided first",
               std::to_string(coarsened_cells({100, 3}, 80.)[0]) + " " +
                   std::to_string(coarsened_cells({100, 3}, 80.)[1]),
               "25 3");
  check::relative("never less than one", structured_extent(coarsened_cells({7, 5}, 0.5)).n_cells,
                  1., 1e-12);
}
} // namespace test_of_structured_extent
