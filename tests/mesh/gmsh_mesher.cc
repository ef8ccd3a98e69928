#include <continua/base/input_error.h>
#include <continua/mesh/gmsh_file.h>
#include <continua/mesh/gmsh_geometry.h>
#include <continua/mesh/gmsh_mesher.h>

#include "../unit_test.h"
#include "mesh_measures.h"

#include <deal.II/base/mpi.h>

#include <fstream>
#include <sstream>

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
    std::ofstream("wrong.geo") << "Point(1) = {0, 0, 0};\nLine(1 = {1, 2};\n";
    std::ofstream("coarse.geo") << "Point(1) = {0, 0, 0};\n";
  }
  MPI_Barrier(MPI_COMM_WORLD);

  const GmshFile file = GmshFile::read(mesh_with_gmsh("ring.geo", 2), "ring.geo");
  const measures::Measures<2> ring(GmshGeometry<2>({"ring.geo", 1.}, false));
  std::string why;
  try
  {
    mesh_with_gmsh("wrong.geo", 2);
  }
  catch (const InputError &error)
  {
    why = error.what();
  }
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
  check::is_true("error of gmsh", why.find("wrong.geo: 'Geometry/File'") == 0 &&
                                      why.find("line 2") != std::string::npos);
}
