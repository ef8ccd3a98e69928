#include <continua/mesh/mesh_parameters.h>

namespace Continua
{
MeshParameters MeshParameters::read(ParameterSection mesh)
{
  MeshParameters parameters;
  mesh.add("Distortion", parameters.distortion, Dimensions::none,
           "Largest random displacement of the inner coarse vertices, over the shortest edge at "
           "the vertex; boundaries and interfaces stay. For tests of irregular cells",
           Range{0., 0.25, false, false});
  mesh.add("Refinements", parameters.refinements,
           "How often every coarse cell is divided into 4 (2-D) or 8 (3-D)", 0, 12);
  parameters.partition.read(mesh);
  return parameters;
}
} // namespace Continua
