#include <continua/mesh/hollow_cylinder_geometry.h>

#include "../unit_test.h"
#include "mesh_measures.h"

namespace test_of_hollow_cylinder_geometry
{
using namespace Continua;

UNIT_TEST(hollow_cylinder_geometry)
{
  HollowCylinderGeometry::Parameters parameters;
  parameters.inner_radius = 1.;
  parameters.outer_radius = 3.;
  parameters.length = 5.;
  parameters.circumferential_cells = 4;
  const measures::Measures<2> section(HollowCylinderGeometry(parameters, true));
  check::relative("section: area", section.region("body"), 10., 1e-13);
  check::relative("section: left", section.boundary("left"), 2., 1e-13);
  check::relative("section: right", section.boundary("right"), 2., 1e-13);
  check::relative("section: inside", section.boundary("inside"), 5., 1e-13);
  check::relative("section: outside", section.boundary("outside"), 5., 1e-13);

  measures::Measures<2> ring(HollowCylinderGeometry(parameters, false));
  ring.mesh.refine_global(4);
  // 64 chords along the quarter: their lengths are too short by (pi / 256)^2 / 6.
  check::relative("ring: area", ring.region("body"), 2. * dealii::numbers::PI, 2e-4);
  check::relative("ring: inside", ring.boundary("inside"), 0.5 * dealii::numbers::PI, 3e-5);
  check::relative("ring: outside", ring.boundary("outside"), 1.5 * dealii::numbers::PI, 3e-5);
  check::relative("ring: symmetry x", ring.boundary("symmetry x"), 2., 1e-13);
  check::relative("ring: symmetry y", ring.boundary("symmetry y"), 2., 1e-13);
  double error = 0.;
  bool in_its_plane = true;
  for (const auto &cell : ring.mesh.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        for (unsigned int v = 0; v < 2; ++v)
        {
          const std::string name = ring.boundary_names[face->boundary_id()];
          if (name == "inside")
            error = std::max(error, std::abs(face->vertex(v).norm() - 1.));
          if (name == "outside")
            error = std::max(error, std::abs(face->vertex(v).norm() - 3.));
          if (name == "symmetry x")
            in_its_plane &= std::abs(face->vertex(v)[0]) < 1e-14;
          if (name == "symmetry y")
            in_its_plane &= std::abs(face->vertex(v)[1]) < 1e-14;
        }
  check::absolute("ring: refined vertices on the arcs", error, 0., 1e-13);
  check::is_true("ring: symmetry planes", in_its_plane);
}
} // namespace test_of_hollow_cylinder_geometry
