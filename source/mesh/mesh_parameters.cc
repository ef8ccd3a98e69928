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
  mesh.add("Memory limit", parameters.memory_limit, Dimensions::none,
           "Memory that all ranks on a machine may take together; a run that is estimated to need "
           "more is refused before anything is made. 0: the free memory of the machine, or what is "
           "left of the limit of its container [GB]",
           Range::not_negative());
  parameters.partition.read(mesh);
  return parameters;
}

std::string entry_of_cells(const ParameterSection &mesh)
{
  for (const char *const key : {"Cells", "Axial cells", "Parent cells", "First daughter cells",
                                "Second daughter cells", "Circumferential cells", "Radial cells"})
    if (mesh.given(key))
      return key;
  return "";
}
} // namespace Continua
