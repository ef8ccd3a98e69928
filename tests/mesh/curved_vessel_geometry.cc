#include <continua/mesh/curved_vessel_geometry.h>
#include <continua/mesh/tube_manifold.h>

#include "../unit_test.h"
#include "curved_measures.h"
#include "geometry_text.h"
#include "mesh_measures.h"

#include <cmath>
#include <fstream>
#include <functional>

namespace test_of_curved_vessel_geometry
{
using namespace Continua;
using dealii::Point;
using dealii::numbers::PI;

namespace
{
const char *const header = "x [mm], y [mm], z [mm], inner radius [mm], wall thickness [mm]\n";

/// The table of a line whose parameter runs from 0 to 1, all in mm.
std::string table(const std::function<Point<3>(double)> &line,
                  const unsigned int n,
                  const double radius = 10.,
                  const double thickness = 2.)
{
  std::ostringstream text;
  text.precision(15);
  text << header;
  for (unsigned int i = 0; i <= n; ++i)
  {
    const Point<3> point = line(static_cast<double>(i) / n);
    text << point[0] << ", " << point[1] << ", " << point[2] << ", " << radius << ", " << thickness
         << "\n";
  }
  return text.str();
}

/// An arc of 120 degrees with that radius, in the plane z = 0.
std::function<Point<3>(double)> arc(const double radius)
{
  return [radius](const double t)
  {
    const double angle = 2. * PI / 3. * t;
    return Point<3>(radius * std::sin(angle), radius * (1. - std::cos(angle)), 0.);
  };
}

const std::string cells =
    "set Radial cells = 2\nset Radial grading = 0.5\nset Circumferential cells = 4\n";

/// The lines of the section Geometry.
std::string vessel(const std::string &content, const std::string &entries = "")
{
  std::ofstream("vessel.csv") << content;
  return "set Type = curved vessel\nset Table = vessel.csv\n" + entries;
}

std::unique_ptr<Geometry<3>> make(const std::string &content,
                                  const std::string &entries = "",
                                  const unsigned int axial_cells = 12)
{
  return geometry_text::make<3>(vessel(content, entries),
                                cells + "set Axial cells = " + std::to_string(axial_cells) + "\n");
}

measures::CurvedMeasures<3> curved(const measures::Measures<3> &mesh)
{
  return {mesh.region_names, mesh.boundary_names, mesh.mesh, 2};
}

void test_torus()
{
  // By Pappus: the section's area times the way of its middle.
  const auto geometry = make(table(arc(30.), 24), "set Wall layers = inner, outer\n");
  measures::Measures<3> mesh(*geometry);
  const double length = 2. * PI / 3. * 30e-3;
  const double fluid = PI * 1e-4 * length, layer = 0.5 * PI * (1.44e-4 - 1e-4) * length;
  const measures::CurvedMeasures<3> coarse = curved(mesh);
  const double error = std::abs(coarse.volumes.at("fluid") / fluid - 1.);
  check::absolute("torus: volume", error, 0., 1e-3);
  check::relative("torus: both layers", coarse.volumes.at("inner") + coarse.volumes.at("outer"),
                  2. * layer, 1e-3);
  check::is_true("torus: no cell is folded", coarse.least_determinant > 0.2);
  mesh.mesh.refine_global(1);
  const double finer = std::abs(curved(mesh).volumes.at("fluid") / fluid - 1.);
  check::is_true("torus: order of the volume at least 3.5", std::log2(error / finer) > 3.5);

  const auto branches = geometry->branches();
  check::is_true("torus: one branch with two ends",
                 branches.size() == 1 && branches[0].ends.size() == 2);
  const VesselAxis<3> &axis = *branches[0].axis;
  check::relative("torus: length", axis.range()[1], length, 1e-6);
  check::relative("torus: length of the law", branches[0].law.length(), length, 1e-6);
  const Point<3> middle(30e-3 * std::sin(PI / 3.), 30e-3 * (1. - std::cos(PI / 3.)), 0.);
  check::absolute("torus: point on the axis", axis.point(0.5 * length).distance(middle), 0., 1e-7);
  check::relative("torus: position of a point above",
                  axis.position(middle + Point<3>(0., 0., 8e-3)), 0.5 * length, 1e-5);

  const auto half = make(table(arc(30.), 24), "set Sector = half\n");
  measures::Measures<3> part(*half);
  check::relative("half: volume", curved(part).volumes.at("fluid"), 0.5 * fluid, 1e-3);
  check::is_true("half: its plane", part.boundary("side z") > 0.9 * 24e-3 * length);
  check::equal("half: no other plane", part.boundary_names.back(), "side z");
}

void test_helix()
{
  const auto coil = [](const double t)
  { return Point<3>(40. * std::cos(4. * PI * t), 40. * std::sin(4. * PI * t), 80. * t); };
  const auto geometry = make(table(coil, 80), "", 40);
  measures::Measures<3> mesh(*geometry);
  const double length = std::hypot(4. * PI * 40e-3, 80e-3);
  check::relative("coil: volume", curved(mesh).volumes.at("fluid"), PI * 1e-4 * length, 1e-3);
  check::is_true("coil: no cell is folded", curved(mesh).least_determinant > 0.2);
}

void test_straight()
{
  // On the x axis the mesh is that of the tube.
  const auto straight = [](const double t) { return Point<3>(50. * t, 0., 0.); };
  const auto straight_vessel = make(table(straight, 4));
  const auto tube = geometry_text::make<3>(
      "set Type = tube\nset Length = 50 mm\nset Inner diameter = 20 mm\nset Wall thickness = 2 mm\n"
      "set Sector = full\n",
      cells + "set Axial cells = 12\n");
  dealii::Triangulation<3> a, b;
  straight_vessel->create(a);
  tube->create(b);
  double distance = 0.;
  for (unsigned int v = 0; v < b.n_vertices(); ++v)
    distance = std::max(distance, a.get_vertices()[v].distance(b.get_vertices()[v]));
  check::absolute("straight: the tube's vertices", distance, 0., 1e-15);
}

void test_manifold()
{
  const auto centreline = std::make_shared<const Centreline>(
      []
      {
        std::vector<Point<3>> points;
        for (unsigned int i = 0; i <= 20; ++i)
          points.push_back(1e-3 * arc(30.)(i / 20.));
        return points;
      }());
  const TubeLaw law = TubeLaw::taper(centreline->length(), 0.02, 0.012, 2e-3, 1e-3);
  double error = 0.;
  for (const auto part : {TubeManifold<3>::Part::core, TubeManifold<3>::Part::rings})
  {
    const TubeManifold<3> manifold(law, part, centreline);
    for (const double along : {0., 0.011, 0.05})
      for (const double across : {0.05, 0.4, 1.6})
      {
        const Point<3> place(along, part == TubeManifold<3>::Part::core ? 0.3 * across : across,
                             1.3);
        error = std::max(error, manifold.pull_back(manifold.push_forward(place)).distance(place));
      }
  }
  check::absolute("manifold: there and back", error, 0., 1e-11);
}

void refused(const std::string &name,
             const std::string &content,
             const std::string &pattern,
             const std::string &entries = "")
{
  check::throws<InputError>(
      name, [&] { make(content, entries); }, pattern);
}

void test_bad_input()
{
  refused("tight bend", table(arc(13.), 24), "the bend folds the cells: its radius is 12.9");
  refused("row of the tight bend", table(arc(13.), 24), "vessel.csv:");
  const std::string straight = std::string(header) + "0, 0, 0, 10, 1\n50, 0, 0, 10, 1\n";
  refused("back", straight + "40, 5, 0, 10, 1\n", "vessel.csv:4: .*the line goes back");
  refused("twice", straight + "50, 0, 0, 10, 1\n", "vessel.csv:4: .*the point is that of the row");
  refused("no radius", straight + "90, 0, 0, 0, 1\n",
          "vessel.csv:4: .*inner radius is not positive");
  refused("no wall", straight + "90, 0, 0, 1, -1\n",
          "vessel.csv:4: .*wall thickness is not positive");
  refused("one row", std::string(header) + "0, 0, 0, 10, 1\n", "");
  // Two turns that touch: pitch 20 mm, outer diameter 24 mm.
  refused(
      "turns that touch",
      table([](const double t)
            { return Point<3>(40. * std::cos(4. * PI * t), 40. * std::sin(4. * PI * t), 40. * t); },
            80),
      "the vessel lies in itself");
  refused(
      "half of a coil",
      table([](const double t)
            { return Point<3>(40. * std::cos(4. * PI * t), 40. * std::sin(4. * PI * t), 80. * t); },
            80),
      "does not lie in a plane", "set Sector = half\n");
  refused("no quarter", straight, "Sector", "set Sector = quarter\n");
}
} // namespace

UNIT_TEST(curved_vessel_geometry)
{
  test_torus();
  test_helix();
  test_straight();
  test_manifold();
  test_bad_input();
}
} // namespace test_of_curved_vessel_geometry
