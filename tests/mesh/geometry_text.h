#ifndef continua_tests_mesh_geometry_text_h
#define continua_tests_mesh_geometry_text_h

// Geometries that are read from a text, and texts that are refused.

#include "../check.h"
#include "../parameter_text.h"

#include <continua/base/input_error.h>
#include <continua/mesh/geometry.h>

#include <memory>
#include <string>
#include <vector>

namespace geometry_text
{
/// From the lines of the sections Geometry and Mesh.
template <int dim>
std::unique_ptr<Continua::Geometry<dim>>
make(const std::string &geometry, const std::string &mesh = "", const bool axisymmetric = false)
{
  Continua::ParameterFile file =
      parameters_of("subsection Geometry\n" + geometry + "end\nsubsection Mesh\n" + mesh + "end\n");
  auto result = Continua::make_geometry<dim>(file.root().subsection("Geometry"),
                                             file.root().subsection("Mesh"), axisymmetric);
  file.refuse_unknown();
  return result;
}

/// Whether they are refused with a message that begins with the parameter file and then matches.
template <int dim>
void refused(const std::string &name,
             const std::string &geometry,
             const std::string &mesh,
             const std::string &pattern,
             const bool axisymmetric = false)
{
  check::throws<Continua::InputError>(
      name, [&] { make<dim>(geometry, mesh, axisymmetric); },
      std::string(parameter_file_of_the_test) + ":" + pattern);
}

/// "fluid; wall; ", of names.
inline std::string joined(const std::vector<std::string> &names)
{
  std::string text;
  for (const std::string &name : names)
    text += name + "; ";
  return text;
}
} // namespace geometry_text

#endif
