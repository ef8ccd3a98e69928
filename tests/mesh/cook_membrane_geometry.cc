#include <continua/mesh/cook_membrane_geometry.h>

#include "../unit_test.h"
#include "mesh_measures.h"

namespace test_of_cook_membrane_geometry
{
using namespace Continua;

UNIT_TEST(cook_membrane_geometry)
{
  CookMembraneGeometry::Parameters parameters;
  parameters.unit_length = 1e-3;
  parameters.cells = {6, 4};
  const measures::Measures<2> panel(CookMembraneGeometry{parameters});
  check::absolute("cells", panel.mesh.n_cells(), 24., 0.);
  // Trapezium: 48 (44 + 16) / 2 square millimetres.
  check::relative("area", panel.region("membrane"), 1440e-6, 1e-13);
  check::relative("clamped end", panel.boundary("clamped end"), 44e-3, 1e-13);
  check::relative("loaded end", panel.boundary("loaded end"), 16e-3, 1e-13);
  check::relative("bottom", panel.boundary("bottom"), std::sqrt(48. * 48. + 44. * 44.) * 1e-3,
                  1e-13);
  check::relative("top", panel.boundary("top"), std::sqrt(48. * 48. + 16. * 16.) * 1e-3, 1e-13);
}
} // namespace test_of_cook_membrane_geometry
