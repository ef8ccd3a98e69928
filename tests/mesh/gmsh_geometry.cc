#include <continua/mesh/gmsh_geometry.h>

#include "../unit_test.h"
#include "curved_measures.h"
#include "gmsh_meshes.h"
#include "mesh_measures.h"

#include <deal.II/base/mpi.h>

namespace test_of_gmsh_geometry
{
using namespace Continua;
using meshes::squares;
using meshes::with;

namespace
{
template <int dim>
GmshGeometry<dim>
make(const std::string &text, const double unit_length = 1., const bool axisymmetric = false)
{
  std::ofstream("x.msh") << text;
  return GmshGeometry<dim>({"x.msh", unit_length}, axisymmetric);
}

template <int dim = 2>
void refused(const std::string &name,
             const std::string &text,
             const std::string &pattern,
             const bool axisymmetric = false)
{
  check::throws<InputError>(
      name, [&] { make<dim>(text, 1., axisymmetric); }, "^x.msh:.*'Geometry/File'.*" + pattern);
}

/// With the entries that name what is in no group, or leave groups and curvature out.
GmshGeometry<2> make_with(const std::string &text,
                          const std::vector<std::string> &ignored_groups,
                          const std::string &ungrouped_cells = "",
                          const std::string &ungrouped_faces = "",
                          const bool straightens = false)
{
  std::ofstream("x.msh") << text;
  return GmshGeometry<2>(
      {"x.msh", 1., 600., ignored_groups, ungrouped_cells, ungrouped_faces, straightens}, false);
}

/// The cuboid of `meshes::block` with 27 or 20 nodes, of which the middle of the floor and that of
/// its side at y = 0 lie deeper. The nodes stand in the order of gmsh's reference manual.
std::string curved_block(const unsigned int n_nodes)
{
  const std::vector<std::string> middles = {
      "0.5 0 -0.2", "0 1 0",   "0 0 1.5",   "1 1 0",   "1 0 1.5",  "0.5 2 0",    "1 2 1.5",
      "0 2 1.5",    "0.5 0 3", "0 1 3",     "1 1 3",   "0.5 2 3",  "0.5 1 -0.3", "0.5 0 1.5",
      "0 1 1.5",    "1 1 1.5", "0.5 2 1.5", "0.5 1 3", "0.5 1 1.5"};
  std::string nodes, tags;
  for (unsigned int node = 0; node + 8 < n_nodes; ++node)
  {
    nodes += std::to_string(node + 9) + " " + middles[node] + "\n";
    tags += " " + std::to_string(node + 9);
  }
  const std::string corners =
      "1 0 0 0\n2 1 0 0\n3 1 2 0\n4 0 2 0\n5 0 0 3\n6 1 0 3\n7 1 2 3\n8 0 2 3\n";
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(n_nodes) + "\n" +
         corners + nodes + "$EndNodes\n$Elements\n2\n1 3 2 1 1 1 2 3 4\n2 " +
         (n_nodes == 27 ? "12" : "17") + " 2 1 1 1 2 3 4 5 6 7 8" + tags + "\n$EndElements\n";
}

/// Refined so that hanging nodes lie on curved sides.
template <int dim>
void refine_first_cell(dealii::Triangulation<dim> &mesh)
{
  mesh.begin_active()->set_refine_flag();
  mesh.execute_coarsening_and_refinement();
  mesh.begin_active(1)->set_refine_flag();
  mesh.execute_coarsening_and_refinement();
}

void check_second_order()
{
  const GmshGeometry<2> geometry = make<2>(meshes::curved_squares, 0.1);
  dealii::Triangulation<2> mesh;
  geometry.create(mesh);
  for (const std::string stage : {"", ", refined"})
  {
    // A parabola over a chord c with the height h holds 2/3 c h.
    const measures::CurvedMeasures<2> curved(geometry, mesh, 2);
    check::relative("9 nodes" + stage, curved.volumes.at("fluid"), 1e-2 * (1. + 2. / 3. * 0.4),
                    1e-13);
    check::relative("8 nodes" + stage, curved.volumes.at("wall"), 1e-2 * (1. + 2. / 3. * 0.2),
                    1e-13);
    check::relative("the whole by its surface" + stage, curved.flux, 2.4e-2, 1e-13);
    if (stage.empty())
      refine_first_cell(mesh);
  }
  mesh.refine_global(1);
  const auto has = [&mesh](const dealii::Point<2> &place)
  {
    return std::any_of(mesh.get_vertices().begin(), mesh.get_vertices().end(),
                       [&](const auto &vertex) { return vertex.distance(place) < 1e-14; });
  };
  check::is_true("the middle in the file", has({0.055, 0.05}));
  // -1/4 of the corners and 1/2 of the nodes between them.
  check::is_true("the middle of an incomplete element", has({0.155, 0.055}));

  for (const unsigned int n_nodes : {27u, 20u})
  {
    std::ofstream("x.msh") << curved_block(n_nodes);
    const GmshGeometry<3> block({"x.msh", 1., 600., {}, "", "rest"}, false);
    dealii::Triangulation<3> mesh_in_space;
    block.create(mesh_in_space);
    refine_first_cell(mesh_in_space);
    const measures::CurvedMeasures<3> curved(block, mesh_in_space, 2);
    // The floor is deeper by the polynomials of its middle and of the middle of its side, whose
    // means are 4/9 and 1/9; that of the 20 nodes has half the depth of the side in its middle.
    const double middle = n_nodes == 27 ? 0.3 : 0.1;
    const std::string name = std::to_string(n_nodes) + " nodes";
    check::relative(name, curved.volume(), 6. + 2. * (4. / 9. * middle + 1. / 9. * 0.2), 1e-13);
    check::relative(name + ", by the surface", curved.flux, curved.volume(), 1e-13);
  }

  // Straight cells stay as they are, with the warning of their corners.
  std::string straight = meshes::curved_squares;
  for (const auto &[curved, middle] :
       std::vector<std::pair<std::string, std::string>>{{"0.5 -0.1 0", "0.5 0 0"},
                                                        {"1.5 -0.1 0", "1.5 0 0"},
                                                        {"1.5 1.2 0", "1.5 1 0"},
                                                        {"0.5 1.2 0", "0.5 1 0"},
                                                        {"1.1 0.5 0", "1 0.5 0"},
                                                        {"0.55 0.5 0", "0.5 0.5 0"}})
    straight = with(straight, curved, middle);
  dealii::Triangulation<2> flat;
  make<2>(straight).create(flat);
  check::is_true("straight cells are no manifolds",
                 flat.get_manifold_ids() ==
                     std::vector<dealii::types::manifold_id>{dealii::numbers::flat_manifold_id});

  refused("a side below its other side", with(meshes::curved_squares, "0.5 1.2 0", "0.5 -0.2 0"),
          "x = 0.5, y = 0.5 .element 8..*curved sides meet.*HighOrderOptimize");
  refused(
      "first and second order",
      with(meshes::curved_squares, "9 16 2 8 2 12 15 16 13 27 24 23 22", "9 3 2 8 2 12 15 16 13"),
      "first and of second order .Surface 2");
  refused("another node between the same corners",
          with(with(with(meshes::curved_squares, "14\n11", "15\n11"), "28 0.55 0.5 0\n",
                    "28 0.55 0.5 0\n29 1.05 0.5 0\n"),
               "13 27 24", "13 29 24"),
          "element 9 has another node .*x = 1, y = 0.5.*neighbour");
  refused("third order",
          with(meshes::curved_squares, "8 10 4 7 1 1 2 11 12 15 14 21 27 25 26 28",
               "8 39 2 7 1 11 12 15 14 21 21 27 27 25 25 26 26"),
          "type 39 .Surface 1.*above the second.*ElementOrder = 2");
  refused("a node with a negative radius", meshes::curved_squares,
          "negative radius.*x = 0.5, y = -0.1", true);
}
} // namespace

UNIT_TEST(gmsh_geometry)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const measures::Measures<2> plane(make<2>(squares, 1e-3));
  check::absolute("regions", plane.region_names.size(), 2., 0.);
  check::absolute("boundaries", plane.boundary_names.size(), 2., 0.);
  check::relative("fluid", plane.region("fluid"), 1e-6, 1e-12);
  check::relative("wall", plane.region("wall"), 1e-6, 1e-12);
  check::relative("below", plane.boundary("below"), 2e-3, 1e-12);
  check::relative("around it", plane.boundary("around it"), 4e-3, 1e-12);
  check::absolute("vertices in use", plane.mesh.n_used_vertices(), 6., 0.);
  check::relative("axisymmetric", measures::Measures<2>(make<2>(squares, 1., true)).region("wall"),
                  1., 1e-12);

  measures::Measures<3> space(make<3>(meshes::block));
  check::relative("block", space.region("block"), 6., 1e-12);
  check::relative("floor", space.boundary("floor"), 2., 1e-12);
  check::relative("rest", space.boundary("rest"), 20., 1e-12);
  space.mesh.refine_global(1);
  check::relative("floor, refined", space.boundary("floor"), 2., 1e-12);
  const measures::Measures<3> inverted(
      make<3>(with(meshes::block, "8 1 2 3 4 5 6 7 8", "8 5 6 7 8 1 2 3 4")));
  check::relative("block of negative orientation", inverted.region("block"), 6., 1e-12);

  refused("not in the plane", with(squares, "2 1 0\n", "2 1 0.1\n"), "z = 0");
  refused("triangles", with(squares, "2 1 3 1\n9 11 12 15 14", "2 1 2 1\n9 11 12 15"),
          "triangles .Surface 1.*quadrilaterals.*RecombineAll.*SubdivisionAlgorithm = 1");
  refused<3>("tetrahedra", with(meshes::block, "3 1 5 1\n8 1 2 3 4 5 6 7 8", "3 1 4 1\n8 1 2 3 5"),
             "tetrahedra .Volume 1.*hexahedra.*SubdivisionAlgorithm = 2");
  check_second_order();
  refused("volumes in the plane", meshes::block, "Model");
  refused<3>("no volumes", squares, "no hexahedra.*Physical Volume.*gmsh -3");
  refused("cell without group", with(squares, "1 0 0 0 1 1 0 1 7 0", "1 0 0 0 1 1 0 0 0"),
          "no physical group .Surface 1, at x = 0.5, y = 0.5.*Physical Surface.*Ungrouped cells");
  refused("face without group", with(squares, "3 0 0 0 2 1 0 1 4 0", "3 0 0 0 2 1 0 0 0"),
          "'around it' has no elements");
  refused(
      "face without element", with(squares, "5 16 15\n6 15 14\n", "5 16 15\n6 16 14\n"),
      "'around it' is neither on the outside nor between two regions.*'Ignored groups = around");
  refused("name with a comma",
          with(with(squares, "\"around it\"", "\"around, it\""), "5 16 15\n6 15 14\n",
               "5 16 15\n6 16 14\n"),
          "'Ignored groups = \"around, it\"'");
  const std::string hole = with(with(squares, "1 3 1 4", "1 3 1 3"), "6 15 14\n", "");
  refused("a hole in the boundary", hole,
          "face at x = 0.5, y = 1 on the outside.*Physical Curve.*'Ungrouped faces = NAME'");
  refused("outside and inside", with(squares, "4 1 0 0 1 1 0 0 0", "4 1 0 0 1 1 0 1 4 0"),
          "'around it' is partly on the outside.*here between two regions, at x = 1, y = 0.5");
  refused("name twice", with(squares, "\"fluid\"", "\"wall\""), "two .* Surfaces .*'wall'");
  refused("name and number", with(squares, "2 7 \"fluid\"", "2 6 \"7\""),
          "two .* Surfaces .*'7', or one the name and one the number");

  // A number is a name, in the order of the numbers behind the names.
  const measures::Measures<2> numbered(
      make<2>(with(with(squares, "6\n0 9 \"a point\"\n1 3 \"below\"", "5\n0 9 \"a point\""),
                   "\"fluid\"", "\"\"")));
  check::relative("number of a region", numbered.region("7"), 1., 1e-12);
  check::relative("number of a boundary", numbered.boundary("3"), 2., 1e-12);
  check::is_true("names before numbers",
                 numbered.region_names == std::vector<std::string>({"wall", "7"}));
  const measures::Measures<2> of_version_2(make<2>(meshes::squares_2));
  check::relative("MSH 2: number of a boundary", of_version_2.boundary("4"), 4., 1e-12);
  check::relative("MSH 2: wall", of_version_2.region("wall"), 1., 1e-12);

  // The curve between the squares in a group of its own.
  const std::string with_interface = with(with(squares, "6\n0 9 ", "7\n1 5 \"between\"\n0 9 "),
                                          "4 1 0 0 1 1 0 0 0", "4 1 0 0 1 1 0 1 5 0");
  const std::vector<NamedInterface> interfaces = make<2>(with_interface).interfaces();
  check::is_true("an interface with a name",
                 interfaces.size() == 1 && interfaces[0].name == "between" &&
                     interfaces[0].sides ==
                         std::map<std::pair<unsigned int, unsigned int>, bool>{{{0, 1}, true}});
  check::is_true("it is no boundary", make<2>(with_interface).boundaries() ==
                                          std::vector<std::string>({"below", "around it"}));
  check::is_true("ignored", make_with(with_interface, {"between"}).interfaces().empty());
  check::throws<InputError>(
      "ignored, and unknown", [&] { make_with(with_interface, {"betwen"}); },
      "no physical group 'betwen'");
  const measures::Measures<2> rest(make_with(hole, {}, "", "the rest"));
  check::relative("faces in no group", rest.boundary("the rest"), 1., 1e-12);
  const measures::Measures<2> cells(
      make_with(with(with(squares, "6\n0 9 ", "5\n0 9 "), "2 7 \"fluid\"\n", "").replace(0, 0, ""),
                {"7"}, "the liquid"));
  check::relative("cells in no group", cells.region("the liquid"), 1., 1e-12);
  check::throws<InputError>(
      "name of the rest taken", [&] { make_with(hole, {}, "", "below"); },
      "'below'.*physical group");
  const measures::Measures<2> straight(
      make_with(with(squares, "2 1 3 1\n9 11 12 15 14", "2 1 10 1\n9 11 12 15 14 11 12 15 14 11"),
                {}, "", "", true));
  check::relative("corners of a curved cell", straight.region("fluid"), 1., 1e-12);
  refused("two groups", with(squares, "1 0 0 0 1 1 0 1 7 0", "1 0 0 0 1 1 0 2 7 8 0"),
          "2 physical groups, 'fluid', 'wall' .Surface 1.*'Ignored groups = wall'");
  check::relative(
      "two groups, of which one is ignored",
      measures::Measures<2>(
          make_with(with(squares, "2 1 0 0 2 1 0 1 8 0", "2 1 0 0 2 1 0 2 7 8 0"), {"wall"}))
          .region("fluid"),
      2., 1e-12);
  // Elements that the file has twice, on two entities.
  const auto with_copies = [](const std::string &groups_of_cell, const std::string &line)
  {
    const std::string elements = "9\n1 1 2 3 1 11 12\n";
    return with(meshes::squares_2, elements,
                "11\n1 1 2 3 1 11 12\n10 1 2 " + line + " 5 12 11\n11 3 2 " + groups_of_cell +
                    " 3 12 15 14 11\n");
  };
  const measures::Measures<2> once(make<2>(with_copies("7", "3")));
  check::relative("a cell twice", once.region("fluid"), 1., 1e-12);
  check::relative("a face twice", once.boundary("below"), 2., 1e-12);
  refused("a cell in two groups", with_copies("8", "3"),
          "at x = 0.5, y = 0.5 stands there twice, in .*'wall' and in 'fluid'.*'Ignored groups = "
          "fluid'");
  refused("a face in two groups", with_copies("7", "4"),
          "at x = 0.5, y = 0 stands there twice, in .*'below' and in '4'.*'Ignored groups = 4'");
  const measures::Measures<2> without(make_with(with_copies("7", "4"), {"below"}, "", "rest"));
  check::relative("a face in two groups, of which one is ignored", without.boundary("4"), 5.,
                  1e-12);
  const measures::Measures<2> in_one(make_with(with_copies("0", "3"), {}, "unused"));
  check::is_true("a cell in a group and in none",
                 in_one.region_names == std::vector<std::string>({"fluid", "wall"}));
  refused("twisted cell", with(squares, "9 11 12 15 14", "9 11 12 14 15"), "x = 0.5.*twisted");
  refused("negative radius", with(squares, "1 1 0\n", "1 -1 0\n"), "negative radius.*x = 1, y = -1",
          true);
  check::throws<InputError>(
      "missing file",
      [] {
        GmshGeometry<2>({"none.msh", 1.}, false);
      },
      "none.msh.*does not exist");
  check::absolute("without a file, for the manual",
                  measures::Measures<2>(GmshGeometry<2>({"", 1.}, false)).mesh.n_cells(), 1., 0.);
}
} // namespace test_of_gmsh_geometry
