#include <continua/base/parameter_file.h>
#include <continua/mesh/mesh_parameters.h>

#include "../unit_test.h"

#include <fstream>

namespace test_of_mesh_parameters
{
using namespace Continua;

namespace
{
MeshParameters read(const std::string &lines)
{
  std::ofstream("mesh_parameters.prm") << "subsection Mesh\n" << lines << "end\n";
  ParameterFile file("mesh_parameters.prm");
  return MeshParameters::read(file.root().subsection("Mesh"));
}
} // namespace

UNIT_TEST(mesh_parameters)
{
  const MeshParameters none = read("");
  check::is_true("defaults", none.refinements == 0 && none.distortion == 0.);
  const MeshParameters some = read("set Refinements = 3\nset Distortion = 0.2\n");
  check::is_true("refinements", some.refinements == 3);
  check::is_true("distortion", some.distortion == 0.2);
  check::throws<InputError>(
      "too distorted", [] { read("set Distortion = 0.4\n"); }, "mesh_parameters.prm:2.*Distortion");
  check::throws<InputError>(
      "negative", [] { read("set Refinements = -1\n"); }, "mesh_parameters.prm:2.*Refinements");
}
} // namespace test_of_mesh_parameters
