#include <continua/mesh/geometry.h>
#include <continua/vessel/tube_law.h>

#include "../unit_test.h"
#include "geometry_text.h"
#include "mesh_measures.h"

namespace test_of_geometry
{
using namespace Continua;

namespace
{
using geometry_text::make;

void refused(const std::string &name,
             const std::string &geometry,
             const std::string &mesh,
             const bool axisymmetric,
             const std::string &pattern)
{
  geometry_text::refused<2>(name, geometry, mesh, pattern, axisymmetric);
}
} // namespace

UNIT_TEST(geometry)
{
  std::string types;
  for (const auto &type : geometry_types<2>())
    types += type.first + (type.second.empty() ? " without description; " : "; ");
  check::equal("types", types,
               "box; beam; layered channel; channel with cylinder; tube; curved vessel; "
               "bifurcation; hollow cylinder; cook membrane; gmsh; ");

  const measures::Measures<2> box(*make<2>(
      "set Type = box\nset Size = 20 m, 500 cm\nset Rotation = 30 deg\nset Origin = 1, 1\n",
      "set Cells = 4, 2\nset Grading x = 2\n"));
  check::relative("box", box.region("body"), 100., 1e-12);
  check::absolute("box: cells", box.mesh.n_cells(), 8., 0.);

  const measures::Measures<3> cuboid(
      *make<3>("set Type = box\nset Size = 1, 2, 3\n", "set Cells = 1, 2, 3\nset Grading z = 2\n"));
  check::relative("cuboid", cuboid.region("body"), 6., 1e-12);

  const measures::Measures<3> beam(
      *make<3>("set Type = beam\nset Length = 1\nset Height = 10 mm\nset Width = 20 mm\n",
               "set Cells = 4, 1, 1\n"));
  check::relative("beam", beam.boundary("free end"), 2e-4, 1e-12);

  const measures::Measures<3> channel(*make<3>(
      "set Type = layered channel\nset Length = 1\nset Fluid depth = 0.1\n"
      "set Layer thicknesses = 0.01, 0.02\nset Width = 0.5\n",
      "set Axial cells = 3\nset Fluid cells = 4\nset Fluid grading = 0.5\nset Wall cells = 2\n"
      "set Width cells = 2\n"));
  check::absolute("channel: cells", channel.mesh.n_cells(), 48., 0.);
  check::relative("channel: wall 2", channel.region("wall 2"), 0.01, 1e-12);

  const measures::Measures<2> tube(
      *make<2>("set Type = tube\nset Inner diameter = 10 mm\nset Length = 0.8 m\n"
               "set Wall thickness = 1.5 mm\nset Wall layers = inner, outer\n"
               "set Layer fractions = 66.666667 %, 33.333333 %\n",
               "set Axial cells = 10\nset Radial cells = 3\nset Radial grading = 0.5\n"
               "set Axial grading = 0.5\nset Wall cells = 1, 2\n",
               true));
  check::absolute("tube: cells", tube.mesh.n_cells(), 60., 0.);
  check::relative("tube: inlet", tube.boundary("inlet"), 5e-3, 1e-12);
  check::relative("tube: outer layer", tube.region("outer"), 4e-4, 1e-7);
  const auto tube_of_space = make<3>("set Type = tube\nset Law = E\nset Sector = full\n"
                                     "subsection Regions\nset end = x - 0.4\nend\n",
                                     "set Axial cells = 8\nset Radial cells = 2\n"
                                     "set Circumferential cells = 2\nset Axial grading = 1\n");
  const measures::Measures<3> space(*tube_of_space);
  check::absolute("tube in space: cells", space.mesh.n_cells(), 8. * 4. * (1 + 4 + 2), 0.);
  // A tube without a wall: its boundaries have no gaps in their numbers, in each model.
  const std::string rigid =
      "set Type = tube\nset Wall layers = none\nset Inner diameter = 20 mm\nset Length = 0.3 m\n";
  const measures::Measures<2> plane(
      *make<2>(rigid, "set Axial cells = 10\nset Radial cells = 3\n", true));
  check::equal("rigid: regions", geometry_text::joined(plane.region_names), "fluid; ");
  check::equal("rigid: boundaries", geometry_text::joined(plane.boundary_names),
               "inlet; outlet; axis; outside; ");
  check::relative("rigid: inlet", plane.boundary("inlet"), 0.01, 1e-13);
  check::relative("rigid: axis", plane.boundary("axis"), 0.3, 1e-13);
  check::relative("rigid: outside", plane.boundary("outside"), 0.3, 1e-13);
  for (const std::string sector : {"quarter", "half", "full"})
  {
    const measures::Measures<3> part(
        *make<3>(rigid + "set Sector = " + sector + "\n",
                 "set Axial cells = 4\nset Radial cells = 2\nset Circumferential cells = 8\n"));
    const double share = sector == "quarter" ? 0.25 : sector == "half" ? 0.5 : 1.;
    check::equal("rigid " + sector + ": boundaries", geometry_text::joined(part.boundary_names),
                 std::string("inlet; outlet; outside; ") + (sector == "quarter" ? "side y; " : "") +
                     (sector == "full" ? "" : "side z; "));
    // Of flat faces, which lie inside the cylinder.
    check::relative("rigid " + sector + ": outside", part.boundary("outside"),
                    share * 2. * dealii::numbers::PI * 0.01 * 0.3, 0.01);
    if (sector != "full")
      check::relative("rigid " + sector + ": side z", part.boundary("side z"),
                      (sector == "half" ? 0.02 : 0.01) * 0.3, 1e-12);
  }
  refused("wall cells without a wall", "set Type = tube\nset Wall layers = none\n",
          "set Wall cells = 1\n", true, "6.*/Wall cells'.*no wall");

  check::equal("law of a painted tube", tube_of_space->branches().front().law.name(), "E");
  check::is_true("law of no tube", make<2>("set Type = box\n")->branches().empty());

  const measures::Measures<2> section(
      *make<2>("set Type = hollow cylinder\nset Inner radius = 1\nset Outer radius = 2\n"
               "set Length = 3\n",
               "set Axial cells = 2\nset Radial cells = 2\n", true));
  check::relative("hollow cylinder", section.region("body"), 3., 1e-12);
  const measures::Measures<2> ring(
      *make<2>("set Type = hollow cylinder\nset Inner radius = 1\nset Outer radius = 2\n",
               "set Circumferential cells = 3\nset Radial cells = 2\n"));
  check::absolute("ring: cells", ring.mesh.n_cells(), 6., 0.);

  const measures::Measures<2> panel(
      *make<2>("set Type = cook membrane\nset Unit length = 1 mm\n", "set Cells = 2, 2\n"));
  check::relative("cook membrane", panel.region("membrane"), 1440e-6, 1e-12);

  const measures::Measures<2> painted(*make<2>("set Type = box\nset Size = 4, 4\n"
                                               "subsection Regions\nset fluid = x - 2\nend\n",
                                               "set Cells = 4, 4\n"));
  check::relative("painted", painted.region("fluid"), 8., 1e-12);

  refused("no such type", "set Type = bax\n", "", false, "2.*/Type'.*box");
  refused("tube in the plane", "set Type = tube\n", "", false, "2.*Model = plane strain.*box");
  refused("cylinder in axisymmetry", "set Type = channel with cylinder\n", "", true,
          "2.*Model = axisymmetric.*tube");
  refused("beam in axisymmetry", "set Type = beam\n", "", true, "2.*Model = axisymmetric.*tube");
  check::throws<InputError>(
      "panel in space", [] { make<3>("set Type = cook membrane\n"); },
      std::string(parameter_file_of_the_test) +
          ":2.*Model = three-dimensional.*box, beam, layered channel, channel with "
          "cylinder, tube");
  refused("two sizes wanted", "set Size = 1, 2, 3\n", "", false, "2.*/Size'.*3 entries.*2");
  refused("negative size", "set Size = 1, -2\n", "", false, "2.*/Size'");
  refused("size in seconds", "set Size = 1 s, 2 s\n", "", false, "2.*/Size'");
  refused("one count", "", "set Cells = 3\n", false, "4.*/Cells'.*1 entry.*2");
  refused("zero cells", "", "set Cells = 3, 0\n", false, "4.*/Cells'");
  refused("grading", "", "set Grading x = 0\n", false, "4.*/Grading x'");
  refused("no z in the plane", "", "set Grading z = 2\n", false, "4.*/Grading z'");
  refused("negative radius", "set Origin = 0, -1\n", "", true, "2.*/Origin'.*radius");
  refused("turned about the axis", "set Rotation = 10 deg\n", "", true, "2.*/Rotation'");
  refused("angle without unit", "set Rotation = 30\n", "", false, "2.*/Rotation'.*has no unit");
  refused("angle in metres", "set Rotation = 30 m\n", "", false, "2.*/Rotation'");
  refused("wall cells", "set Type = tube\nset Wall layers = a, b, c\n", "set Wall cells = 1, 2\n",
          true, "6.*/Wall cells'.*2 entries.*3");
  refused("thin radius", "set Type = hollow cylinder\nset Inner radius = 2\nset Outer radius = 1\n",
          "", false, "4.*/Outer radius'");
  refused("old entry of the tube", "set Type = tube\nset Wall thicknesses = 1 mm\n", "", true,
          "3.*/Wall thicknesses'.*new name.*'Wall thickness', with 'Wall layers'");
  refused("axial grading", "set Type = tube\n", "set Axial grading = 1e-5\n", true,
          "5.*/Axial grading'.*less than 0.001");
  check::throws<InputError>(
      "odd circumference", [] { make<3>("set Type = tube\n", "set Circumferential cells = 3\n"); },
      std::string(parameter_file_of_the_test) + ":5.*/Circumferential cells'.*odd");
}
} // namespace test_of_geometry
