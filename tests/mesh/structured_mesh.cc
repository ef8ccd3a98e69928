#include <continua/mesh/structured_mesh.h>

#include "../unit_test.h"

namespace test_of_structured_mesh
{
using namespace Continua;

UNIT_TEST(structured_mesh)
{
  dealii::Triangulation<3> mesh;
  using Index = StructuredMesh<3>::CellIndex;
  StructuredMesh<3>({{0., 1., 3.}, {0., 2.}, {0., 1., 2., 5.}})
      .create(
          mesh, [](const Index &cell) { return cell[2]; },
          [](const Index &cell, const unsigned int face) { return 10 * cell[0] + face; });
  check::absolute("cells", mesh.n_cells(), 6., 0.);
  check::absolute("vertices", mesh.n_vertices(), 24., 0.);
  double volume_of_region_2 = 0.;
  bool faces_right = true;
  bool edges_right = true;
  for (const auto &cell : mesh.active_cell_iterators())
  {
    if (cell->material_id() == 2)
      volume_of_region_2 += cell->measure();
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary())
      {
        const bool second = cell->center()[0] > 1.;
        faces_right &= cell->face(f)->boundary_id() == (second ? 10 : 0) + f;
        for (unsigned int l = 0; l < 4; ++l)
          edges_right &=
              cell->face(f)->line(l)->boundary_id() != dealii::numbers::internal_face_boundary_id;
      }
  }
  check::relative("volume of a region", volume_of_region_2, 18., 1e-14);
  check::is_true("boundary ids of faces", faces_right);
  check::is_true("boundary ids of edges", edges_right);

  dealii::Triangulation<2> slanted;
  StructuredMesh<2>({{0., 1.}, {0., 1.}})
      .create(
          slanted, [](const auto &) { return 0u; }, [](const auto &, unsigned int) { return 0u; },
          [](const dealii::Point<2> &p) { return dealii::Point<2>(3. * p[0] + p[1], 2. * p[1]); });
  check::relative("area after a shear", slanted.begin()->measure(), 6., 1e-14);
}
} // namespace test_of_structured_mesh
