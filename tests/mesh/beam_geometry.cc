#include <continua/mesh/beam_geometry.h>

#include "../unit_test.h"
#include "mesh_measures.h"

namespace test_of_beam_geometry
{
using namespace Continua;

UNIT_TEST(beam_geometry)
{
  BeamGeometry<2>::Parameters plane;
  plane.length = 4.;
  plane.height = 0.5;
  plane.cells = {8, 3};
  const measures::Measures<2> beam(BeamGeometry<2>{plane});
  check::absolute("cells", beam.mesh.n_cells(), 24., 0.);
  check::relative("area", beam.region("beam"), 2., 1e-13);
  check::relative("clamped end", beam.boundary("clamped end"), 0.5, 1e-13);
  check::relative("free end", beam.boundary("free end"), 0.5, 1e-13);
  check::relative("bottom", beam.boundary("bottom"), 4., 1e-13);
  check::relative("top", beam.boundary("top"), 4., 1e-13);

  BeamGeometry<3>::Parameters space;
  space.length = 4.;
  space.height = 0.5;
  space.width = 0.25;
  const measures::Measures<3> bar(BeamGeometry<3>{space});
  check::absolute("bar: cells", bar.mesh.n_cells(), 80., 0.);
  check::relative("bar: volume", bar.region("beam"), 0.5, 1e-13);
  check::relative("bar: clamped end", bar.boundary("clamped end"), 0.125, 1e-13);
  check::relative("bar: top", bar.boundary("top"), 1., 1e-13);
  check::relative("bar: back", bar.boundary("back"), 2., 1e-13);
  check::relative("bar: front", bar.boundary("front"), 2., 1e-13);
}
} // namespace test_of_beam_geometry
