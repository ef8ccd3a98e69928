// Mesh files of gmsh: refused with an InputError, or read so that every element has points that are
// there.

#include <continua/base/input_error.h>
#include <continua/mesh/gmsh_file.h>

#include "input_file.h"

#include <cmath>
#include <string>

using namespace Continua;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  try
  {
    const GmshFile file =
        GmshFile::read(std::string(reinterpret_cast<const char *>(data), size), "input.msh");
    for (const dealii::Point<3> &point : file.points)
      Fuzz::require(std::isfinite(point.norm_square()) || point.norm_square() > 0.,
                    "a point has no place");
    for (const GmshFile::Block &block : file.blocks)
      for (const GmshFile::Element &element : block.elements)
        for (const unsigned int vertex : element.nodes)
          Fuzz::require(vertex < file.points.size(), "an element has a point that is not there");
  }
  catch (const InputError &)
  {
  }
  return 0;
}
