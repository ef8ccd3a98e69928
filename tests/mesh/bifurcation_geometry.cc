#include <continua/mesh/bifurcation_geometry.h>

#include "../unit_test.h"
#include "bifurcation_shapes.h"
#include "curved_measures.h"
#include "geometry_text.h"

#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <map>

namespace test_of_bifurcation_geometry
{
using namespace Continua;
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;
using Sector = TubeCrossSection::Sector;
using geometry_text::joined;

namespace
{
using Measured = measures::CurvedMeasures<3>;

Measured measure(const BifurcationGeometry &geometry, const unsigned int degree)
{
  dealii::Triangulation<3> mesh;
  geometry.create(mesh);
  return Measured(geometry, mesh, degree);
}

/// The shape of bifurcation_shapes::make, all three branches 5 long.
BifurcationGeometry::Parameters coarse(const bifurcation_shapes::Daughter &first,
                                       const bifurcation_shapes::Daughter &second,
                                       const Sector sector)
{
  BifurcationGeometry::Parameters parameters;
  parameters.branches[0] = {5., 2., 0.2, 0., 3};
  parameters.branches[1] = {5., 2. * first.inner_radius, first.wall_thickness,
                            first.angle * PI / 180., 3};
  parameters.branches[2] = {5., 2. * second.inner_radius, second.wall_thickness,
                            second.angle * PI / 180., 3};
  parameters.sector = sector;
  parameters.axial_grading = 1.;
  parameters.section.radial_cells = 1;
  parameters.section.radial_grading = 1.;
  parameters.section.circumferential_cells = 2;
  return parameters;
}

constexpr bifurcation_shapes::Daughter first = {25., 0.73, 0.16}, second = {35., 0.56, 0.12};

void test_measures()
{
  const BifurcationGeometry half(coarse(first, second, Sector::half));
  check::equal("regions", joined(half.regions()), "fluid; wall; ");
  check::equal("boundaries", joined(half.boundaries()),
               "inlet; first outlet; second outlet; wall inlet end; wall first outlet end; wall "
               "second outlet end; outside; side z; ");
  dealii::Triangulation<3> mesh;
  half.create(mesh);
  check::absolute("cells", mesh.n_active_cells(), 9. * 2. * (1 + 2 * 2), 0.);
  check::absolute("cells known before", half.extent().n_cells, mesh.n_active_cells(), 0.);
  check::absolute("layers", half.extent().n_layers, 9., 0.);
  // A body without holes: no face inside has two sides, no vertex is there twice.
  check::absolute("Euler's number",
                  1. * mesh.n_vertices() - mesh.n_active_lines() + mesh.n_active_quads() -
                      mesh.n_active_cells(),
                  1., 0.);

  const BifurcationShape shape = bifurcation_shapes::make(first, second);
  const std::array<double, 3> radii = {{1., first.inner_radius, second.inner_radius}};
  const std::array<double, 3> thicknesses = {
      {0.1 * 2., first.wall_thickness, second.wall_thickness}};
  // The shape counts counter-clockwise.
  const std::array<double, 3> lengths = {
      {5. - shape.reach(0), 5. - shape.reach(2), 5. - shape.reach(1)}};
  double fluid = 0., wall = 0., outside = 0.;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double length = lengths[i], radius = radii[i], outer = radius + thicknesses[i];
    fluid += PI * radius * radius * length;
    wall += PI * (outer * outer - radius * radius) * length;
    outside += 2. * PI * outer * length;
  }
  const bifurcation_shapes::Measures junction = bifurcation_shapes::measure(shape);
  fluid += junction.fluid;
  wall += junction.wall;
  outside += junction.outside;

  // Each branch has an axis, which knows its own places alone.
  const auto branches = half.branches();
  check::is_true("three branches", branches.size() == 3);
  for (unsigned int i = 0; i < 3; ++i)
  {
    const VesselAxis<3> &axis = *branches[i].axis;
    const std::array<double, 2> range = axis.range();
    check::relative(branches[i].name + ": length of the tube", range[1] - range[0], lengths[i],
                    1e-12);
    check::relative(branches[i].name + ": length of the law", branches[i].law.length(), 5., 1e-12);
    const double middle = 0.5 * (range[0] + range[1]);
    const Point<3> beside = axis.point(middle) + 0.5 * radii[i] * Point<3>(0., 0., 1.);
    check::relative(branches[i].name + ": position", axis.position(beside), middle, 1e-12);
    for (unsigned int j = 0; j < 3; ++j)
      if (j != i)
        check::is_true(branches[i].name + ": is not " + branches[j].name,
                       std::isnan(branches[j].axis->position(beside)));
    check::is_true(branches[i].name + ": the junction is in no branch",
                   std::isnan(axis.position(Point<3>(5., 0., 0.))));
    const double angle = i == 1 ? first.angle : -second.angle;
    const Point<3> end = i == 0 ? Point<3>()
                                : Point<3>(5. + 5. * std::cos(angle * PI / 180.),
                                           5. * std::sin(angle * PI / 180.), 0.);
    check::absolute(branches[i].name + ": end",
                    axis.point(branches[i].ends.front().position).distance(end), 0., 1e-12);
  }

  const Measured fine(half, mesh, 4);
  check::relative("fluid", fine.volumes.at("fluid"), 0.5 * fluid, 2e-4);
  check::relative("wall", fine.volumes.at("wall"), 0.5 * wall, 2e-3);
  check::relative("outside", fine.areas.at("outside"), 0.5 * outside, 1e-3);
  const std::array<std::string, 3> ends = {{"inlet", "first outlet", "second outlet"}};
  const std::array<Tensor<1, 3>, 3> outwards = {
      {Point<3>(-1., 0., 0.),
       Point<3>(std::cos(first.angle * PI / 180.), std::sin(first.angle * PI / 180.), 0.),
       Point<3>(std::cos(second.angle * PI / 180.), -std::sin(second.angle * PI / 180.), 0.)}};
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double radius = radii[i], outer = radius + thicknesses[i];
    const double disc = 0.5 * PI * radius * radius, ring = 0.5 * PI * outer * outer - disc;
    const std::string of_wall = "wall " + ends[i] + " end";
    check::relative(ends[i], fine.areas.at(ends[i]), disc, 1e-6);
    check::absolute(ends[i] + ": normal", (fine.normals.at(ends[i]) - disc * outwards[i]).norm(),
                    0., 1e-6);
    check::relative(of_wall, fine.areas.at(of_wall), ring, 1e-5);
    check::absolute(of_wall + ": normal", (fine.normals.at(of_wall) - ring * outwards[i]).norm(),
                    0., 1e-5);
  }
  check::absolute("side z: normal",
                  (fine.normals.at("side z") - Point<3>(0., 0., -fine.areas.at("side z"))).norm(),
                  0., 1e-12);
  // A longer parent.
  BifurcationGeometry::Parameters longer = coarse(first, second, Sector::half);
  longer.branches[0].length = 6.;
  check::relative("longer parent",
                  measure(BifurcationGeometry(longer), 4).volumes.at("fluid") -
                      fine.volumes.at("fluid"),
                  0.5 * PI, 1e-5);

  const Measured before(half, mesh, 2);
  mesh.refine_global(1);
  const Measured after(half, mesh, 2);
  for (const Measured &measured : {fine, before, after})
  {
    check::absolute("closed", measured.closure().norm(), 0., 1e-12);
    check::relative("divergence theorem", measured.flux, measured.volume(), 1e-12);
    check::is_true("cells are good", measured.least_determinant > 0.1);
  }
  // Fourth order, since the error of a quadratic surface changes its sign in each cell.
  const std::map<std::string, double> halves = {{"fluid", 0.5 * fluid}, {"wall", 0.5 * wall}};
  for (const auto &[name, exact] : halves)
  {
    const double order = std::log2(std::abs(before.volumes.at(name) - exact) /
                                   std::abs(after.volumes.at(name) - exact));
    check::absolute(name + ": order", order, 4., 1.);
  }
  check::absolute("Euler's number, refined",
                  1. * mesh.n_vertices() - mesh.n_active_lines() + mesh.n_active_quads() -
                      mesh.n_active_cells(),
                  1., 0.);
  bool in_plane = true;
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary() && half.boundaries()[face->boundary_id()] == "side z")
      for (const unsigned int v : face->vertex_indices())
        in_plane &= face->vertex(v)[2] == 0.;
  check::is_true("refined: vertices on the plane of symmetry", in_plane);
}

void test_symmetries()
{
  const Measured half = measure(BifurcationGeometry(coarse(first, second, Sector::half)), 2);
  const BifurcationGeometry whole(coarse(first, second, Sector::full));
  check::equal("full: boundaries", joined(whole.boundaries()),
               "inlet; first outlet; second outlet; wall inlet end; wall first outlet end; wall "
               "second outlet end; outside; ");
  dealii::Triangulation<3> mesh;
  whole.create(mesh);
  const Measured full(whole, mesh, 2);
  check::relative("full: fluid", full.volumes.at("fluid"), 2. * half.volumes.at("fluid"), 1e-12);
  check::relative("full: wall", full.volumes.at("wall"), 2. * half.volumes.at("wall"), 1e-12);
  check::relative("full: outside", full.areas.at("outside"), 2. * half.areas.at("outside"), 1e-12);
  check::absolute("full: moment", full.moment[2], 0., 1e-12);
  check::absolute("full: closed", full.closure().norm(), 0., 1e-12);
  check::relative("full: divergence theorem", full.flux, full.volume(), 1e-12);
  check::absolute("full: cells", whole.extent().n_cells, mesh.n_active_cells(), 0.);
  check::absolute("full: Euler's number",
                  1. * mesh.n_vertices() - mesh.n_active_lines() + mesh.n_active_quads() -
                      mesh.n_active_cells(),
                  1., 0.);

  const Measured swapped = measure(BifurcationGeometry(coarse(second, first, Sector::half)), 2);
  check::absolute(
      "daughters exchanged: moment",
      (swapped.moment - Point<3>(half.moment[0], -half.moment[1], half.moment[2])).norm(), 0.,
      1e-12);
  check::relative("daughters exchanged: outlet", swapped.areas.at("second outlet"),
                  half.areas.at("first outlet"), 1e-12);
  const Measured fork = measure(BifurcationGeometry(coarse(first, first, Sector::half)), 2);
  check::absolute("equal daughters: moment", fork.moment[1], 0., 1e-12);
}

/// Over what the manual promises.
void test_range()
{
  double least = 1.;
  for (const auto &[one, other] : {std::make_pair(bifurcation_shapes::Daughter{15., 0.5, 0.1},
                                                  bifurcation_shapes::Daughter{15., 1., 0.2}),
                                   std::make_pair(bifurcation_shapes::Daughter{80., 0.5, 0.2},
                                                  bifurcation_shapes::Daughter{15., 1., 0.1}),
                                   std::make_pair(bifurcation_shapes::Daughter{80., 1., 0.2},
                                                  bifurcation_shapes::Daughter{80., 0.5, 0.1})})
  {
    BifurcationGeometry::Parameters parameters = coarse(one, other, Sector::half);
    for (auto &branch : parameters.branches)
    {
      branch.length = 8.;
      branch.axial_cells = 4;
    }
    least = std::min(least, measure(BifurcationGeometry(parameters), 2).least_determinant);
  }
  check::is_true("angles and radii", least > 0.05);
}

void test_layers_and_ends()
{
  BifurcationGeometry::Parameters parameters = coarse(first, second, Sector::half);
  parameters.layers = {{"inner", "outer"}, {0.25, 0.75}};
  parameters.section.wall_cells = {1, 2};
  parameters.axial_grading = 0.;
  for (auto &branch : parameters.branches)
    branch.axial_cells = 10;
  BifurcationGeometry geometry(parameters);
  geometry.note_held_boundaries({"wall first outlet end"});
  check::equal("layers", joined(geometry.regions()), "fluid; inner; outer; ");
  dealii::Triangulation<3> mesh;
  geometry.create(mesh);
  std::map<std::string, double> lengths, thicknesses;
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->face(1)->at_boundary())
    {
      lengths[geometry.boundaries()[cell->face(1)->boundary_id()]] =
          cell->vertex(1).distance(cell->vertex(0));
      if (cell->face(1)->boundary_id() == 4) // the wall's end of the first daughter
        // Across the wall is the shorter one of the face's directions.
        thicknesses[geometry.regions()[cell->material_id()]] = std::min(
            cell->vertex(3).distance(cell->vertex(1)), cell->vertex(5).distance(cell->vertex(1)));
    }
  check::relative("clamped end", lengths.at("wall first outlet end"), 0.5 * std::sqrt(0.73 * 0.16),
                  1e-12);
  check::relative("free end", lengths.at("wall inlet end"),
                  geometry.branches()[0].axis->range()[1] / 8., 1e-12);
  check::relative("inner layer", thicknesses.at("inner"), 0.25 * 0.16, 1e-12);
  check::relative("outer layer", thicknesses.at("outer"), 0.75 * 0.16 / 2., 1e-12);

  const auto coarsened = geometry.coarsened(0.5 * geometry.extent().n_cells);
  check::absolute("coarsened", coarsened->extent().n_layers, 15., 0.);
  check::absolute("as coarse as can be", geometry.coarsened(1.)->extent().n_layers, 6., 0.);
}

void test_distributed()
{
  dealii::parallel::distributed::Triangulation<3> mesh(MPI_COMM_WORLD);
  const BifurcationGeometry geometry(coarse(first, second, Sector::full));
  geometry.create(mesh);
  dealii::Triangulation<3> serial;
  geometry.create(serial);
  mesh.refine_global(1);
  serial.refine_global(1);
  Tensor<1, 3> distributed_sum, serial_sum;
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned())
      distributed_sum += cell->center() * (1. + cell->material_id());
  for (const auto &cell : serial.active_cell_iterators())
    serial_sum += cell->center() * (1. + cell->material_id());
  check::absolute(
      "distributed",
      (dealii::Utilities::MPI::sum(distributed_sum, MPI_COMM_WORLD) - serial_sum).norm(), 0.,
      1e-11);
}

const std::string type = "set Type = bifurcation\n";

void refused(const std::string &name,
             const std::string &geometry,
             const std::string &mesh,
             const std::string &pattern)
{
  geometry_text::refused<3>(name, type + geometry, mesh, pattern);
}

void test_input()
{
  const auto geometry = geometry_text::make<3>(
      type +
          "set Parent length = 6 cm\nset Parent inner diameter = 6 mm\n"
          "set Parent wall thickness = 0.6 mm\nset First daughter length = 50 mm\n"
          "set First daughter inner diameter = 5 mm\nset First daughter wall thickness = 0.5 mm\n"
          "set First daughter angle = 30 deg\nset Second daughter length = 40 mm\n"
          "set Second daughter inner diameter = 4 mm\nset Second daughter wall thickness = 0.4 mm\n"
          "set Second daughter angle = 20 deg\nset Wall layers = media, adventitia\n"
          "set Layer fractions = 0.6, 0.4\nset Sector = full\n",
      "set Parent cells = 5\nset First daughter cells = 6\nset Second daughter cells = 7\n"
      "set Radial cells = 2\nset Radial grading = 0.5\nset Wall cells = 2, 1\n"
      "set Circumferential cells = 4\nset Axial grading = 1\n");
  check::absolute("cells as given", geometry->extent().n_cells, 18. * 4. * (4 + 4 * 5), 0.);
  const auto branches = geometry->branches();
  check::relative("angle in degrees", branches[1].axis->tangent(0.)[1], 0.5, 1e-12);
  check::absolute("length", branches[2].axis->point(0.).distance({0.06, 0., 0.}), 0., 1e-15);

  refused("right angle", "set First daughter angle = 90 deg\n", "",
          "3.*First daughter angle'.*right");
  refused("no unit", "set Second daughter angle = 25\n", "",
          "3.*Second daughter angle'.*has no unit");
  refused("negative angle", "set First daughter angle = -20 deg\n", "", "3.*First daughter angle'");
  refused("small angles", "set First daughter angle = 3 deg\nset Second daughter angle = 3 deg\n",
          "", "3.*First daughter angle'.*folded.*larger angle");
  refused("short daughter", "set First daughter length = 5 mm\n", "",
          "3.*First daughter length'.*reaches 0.00[0-9]* m.*longer");
  refused("short parent", "set Parent length = 2 mm\n", "", "3.*Parent length'.*longer");
  refused("no diameter", "set Parent inner diameter = 0 mm\n", "", "3.*Parent inner diameter'");
  refused("no wall", "set First daughter wall thickness = 0 mm\n", "",
          "3.*First daughter wall thickness'");
  refused("negative length", "set Second daughter length = -1 m\n", "",
          "3.*Second daughter length'");
  refused("unequal daughters",
          "set First daughter inner diameter = 0.1 mm\nset First daughter angle = 5 deg\n"
          "set Second daughter angle = 5 deg\n",
          "", "4.*First daughter angle'.*folded.*diameters");
  refused("no quarter", "set Sector = quarter\n", "", "3.*Sector'");
  refused("angle of the parent", "set Parent angle = 3 deg\n", "", "3.*Parent angle'");
  refused("odd circumference", "", "set Circumferential cells = 3\n",
          "5.*Circumferential cells'.*odd");
  refused("one cell", "", "set Parent cells = 1\n", "5.*Parent cells'");
  refused("axial grading", "", "set Axial grading = 1e-5\n", "5.*Axial grading'.*less than 0.001");
  refused("radial grading", "", "set Radial grading = 1e-5\n",
          "5.*Radial grading'.*less than 0.001");
  refused("wall cells", "set Wall layers = a, b, c\n", "set Wall cells = 1, 2\n",
          "6.*Wall cells'.*2 entries.*3");
  refused("fluid in the wall", "set Wall layers = fluid\n", "", "3.*Wall layers'.*fluid");
  refused("too many cells", "", "set Parent cells = 1000000\n", "5.*Parent cells'.*coarse mesh");
}
} // namespace

UNIT_TEST(bifurcation_geometry)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_measures();
  test_symmetries();
  test_range();
  test_layers_and_ends();
  test_distributed();
  test_input();
}
} // namespace test_of_bifurcation_geometry
