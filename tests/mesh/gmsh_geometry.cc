#include <continua/mesh/gmsh_geometry.h>

#include "../unit_test.h"
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
  refused("second order",
          with(squares, "2 1 3 1\n9 11 12 15 14", "2 1 10 1\n9 11 12 15 14 11 12 15 14 11"),
          "type 10.*ElementOrder = 1");
  refused("volumes in the plane", meshes::block, "Model");
  refused<3>("no volumes", squares, "no hexahedra.*Physical Volume.*gmsh -3");
  refused("cell without group", with(squares, "1 0 0 0 1 1 0 1 7 0", "1 0 0 0 1 1 0 0 0"),
          "no physical group .Surface 1, at x = 0.5, y = 0.5.*Physical Surface");
  refused("face without group", with(squares, "3 0 0 0 2 1 0 1 4 0", "3 0 0 0 2 1 0 0 0"),
          "'around it' has no elements");
  refused("face without element", with(squares, "5 16 15\n6 15 14\n", "5 16 15\n6 16 15\n"),
          "'around it' is not on the outside");
  refused("a hole in the boundary", with(with(squares, "1 3 1 4", "1 3 1 3"), "6 15 14\n", ""),
          "face at x = 0.5, y = 1 on the outside.*Physical Curve");
  refused("a name inside", with(squares, "4 1 0 0 1 1 0 0 0", "4 1 0 0 1 1 0 1 4 0"),
          "'around it' is not on the outside .at x = 1, y = 0.5.*Curve 4");
  refused("unnamed region", with(squares, "2 7 \"fluid\"", "2 6 \"fluid\""),
          "Physical Surface 7 has no name");
  refused("unnamed boundary", with(squares, "1 3 \"below\"", "1 2 \"below\""),
          "Physical Curve 3 has no name");
  refused("empty name", with(squares, "\"fluid\"", "\"\""), "Physical Surface 7 has an empty name");
  refused("name twice", with(squares, "\"fluid\"", "\"wall\""), "two .* Surfaces .*'wall'");
  refused("two groups", with(squares, "1 0 0 0 1 1 0 1 7 0", "1 0 0 0 1 1 0 2 7 8 0"),
          "2 physical groups .Surface 1");
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
