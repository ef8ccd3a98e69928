#include <continua/base/input_error.h>
#include <continua/mesh/gmsh_file.h>
#include <continua/mesh/gmsh_geometry.h>
#include <continua/mesh/gmsh_mesher.h>

#include "../unit_test.h"
#include "mesh_measures.h"

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>

namespace test_of_gmsh_mesher
{
using namespace Continua;

UNIT_TEST(gmsh_mesher)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  if (rank == 0)
  {
    // A ring sector of the radii 1 and 2 over a quarter circle, and a file that is wrong.
    std::ofstream("ring.geo")
        << "Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {2, 0, 0};\n"
           "Point(4) = {0, 1, 0}; Point(5) = {0, 2, 0};\n"
           "Line(1) = {2, 3}; Circle(2) = {3, 1, 5}; Line(3) = {5, 4}; Circle(4) = {4, 1, 2};\n"
           "Curve Loop(1) = {-4, -3, -2, -1}; Plane Surface(1) = {1};\n"
           "Transfinite Curve{1, 3} = 3; Transfinite Curve{2, 4} = 41;\n"
           "Transfinite Surface{1}; Recombine Surface{1};\n"
           "Physical Surface(\"ring\") = {1}; Physical Curve(\"inside\") = {4};\n"
           "Physical Curve(\"rest\") = {1, 2, 3};\n";
    // Three squares in a row, the last in no group; in the second file their border is in one.
    const std::string row =
        "SetFactory(\"OpenCASCADE\");\n"
        "For i In {1 : 3}\n  Rectangle(i) = {i, 0, 0, 1, 1};\nEndFor\nCoherence;\n"
        "Transfinite Curve{:} = 2; Transfinite Surface{:}; Mesh.RecombineAll = 1;\n"
        "Physical Surface(\"a\") = {1}; Physical Surface(\"b\") = {2};\n";
    std::ofstream("row.geo") << row;
    std::ofstream("two.geo") << row << "Physical Curve(\"end\") = Curve In BoundingBox"
                             << "{2.9, -1, -1, 3.1, 2, 1};\n";
    std::ofstream("wrong.geo") << "Point(1) = {0, 0, 0};\nLine(1 = {1, 2};\n";
    std::ofstream("coarse.geo") << "Point(1) = {0, 0, 0};\n";
    std::ofstream("command.geo") << "Point(1) = {0, 0, 0};\nSystemCall \"touch made\";\n";
    // What gmsh leaves out by a condition it reads without regard to strings: the command stands in
    // one for whoever reads the file, and outside for gmsh.
    std::ofstream("hidden.geo") << "If(0) \" EndIf SystemCall \"touch made\"; //\"\n"
                                << "Point(1) = {0, 0, 0};\n";
    std::ofstream("endless.geo") << "For i In {1 : 1e12}\nEndFor\n";
    std::ofstream("exit.geo") << "Point(1) = {0, 0, 0};\nExit;\n";
    std::filesystem::remove("made");
  }
  MPI_Barrier(MPI_COMM_WORLD);

  const GmshFile file = GmshFile::read(mesh_with_gmsh("ring.geo", 2), "ring.geo");
  const measures::Measures<2> ring(GmshGeometry<2>({"ring.geo", 1.}, false));
  using Ignored = std::vector<std::string>;
  const measures::Measures<2> rest(
      GmshGeometry<2>({"row.geo", 1., 600., Ignored(), "rest", "outside"}, false));
  const measures::Measures<2> two(
      GmshGeometry<2>({"two.geo", 1., 600., Ignored(), "", "outside"}, false));
  std::string left_out;
  try
  {
    GmshGeometry<2>({"row.geo", 1., 600., Ignored(), "", "outside"}, false);
  }
  catch (const InputError &error)
  {
    left_out = error.what();
  }
  std::string why;
  try
  {
    mesh_with_gmsh("wrong.geo", 2);
  }
  catch (const InputError &error)
  {
    why = error.what();
  }
  const auto reason = [](const std::string &geo_file, const double time_limit = 600.)
  {
    try
    {
      mesh_with_gmsh(geo_file, 2, time_limit);
      return std::string();
    }
    catch (const InputError &error)
    {
      return std::string(error.what());
    }
  };
  const std::string command = reason("command.geo");
  reason("hidden.geo");
  MPI_Barrier(MPI_COMM_WORLD);
  const bool was_made = std::filesystem::exists("made");
  const std::string endless = reason("endless.geo", 1.);
  allow_mesh_commands();
  const std::string allowed = reason("command.geo"), ended = reason("exit.geo");
  MPI_Barrier(MPI_COMM_WORLD);
  const bool is_made = std::filesystem::exists("made");
  // Every rank must have the same; the checks are printed by one.
  const bool alike = dealii::Utilities::MPI::min(double(file.points.size()), MPI_COMM_WORLD) ==
                         dealii::Utilities::MPI::max(double(file.points.size()), MPI_COMM_WORLD) &&
                     dealii::Utilities::MPI::min(why.size() > 0 ? 1. : 0., MPI_COMM_WORLD) == 1.;
  if (rank > 0)
    return;
  check::is_true("alike on all ranks", alike);
  check::absolute("cells", ring.mesh.n_cells(), 80., 0.);
  // The chords of an arc of angle a = pi/80 are shorter by a^2/24.
  check::relative("inside", ring.boundary("inside"), dealii::numbers::PI / 2, 1e-4);
  check::relative("area", ring.region("ring"), 0.75 * dealii::numbers::PI, 3e-4);
  check::relative("cells in no group", rest.region("rest"), 1., 1e-12);
  check::relative("faces in no group", rest.boundary("outside"), 8., 1e-12);
  check::relative("what is left out", two.boundary("end"), 1., 1e-12);
  check::relative("faces of the rest", two.boundary("outside"), 5., 1e-12);
  check::is_true("what is left out by mistake",
                 left_out.find("the face at x = 3, y = 0.5 lies between the region 'b' and a cell "
                               "in no physical group") != std::string::npos &&
                     left_out.find("'Ungrouped cells = NAME'") != std::string::npos);
  check::is_true("a command", command.find("command.geo:2: 'Geometry/File'") == 0);
  check::is_true("nothing was executed", !was_made);
  check::is_true("time limit", endless.find("did not end within 1 s") != std::string::npos);
  check::is_true("a command that is allowed", allowed.empty() && is_made);
  check::is_true("the end of gmsh",
                 ended.find("ended before the mesh was made") != std::string::npos);
  check::is_true("error of gmsh", why.find("wrong.geo: 'Geometry/File'") == 0 &&
                                      why.find("line 2") != std::string::npos);
}
} // namespace test_of_gmsh_mesher
