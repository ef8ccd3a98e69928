// Central, upwind and blended values on faces against the formulas, with the flux of either sign.

#include "cell_wise_meshes.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_face_interpolation
{
using namespace cell_wise_meshes;

UNIT_TEST(face_interpolation)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();

  Triangulation<2> triangulation(MPI_COMM_WORLD);
  make_box(triangulation, 4);
  grade(triangulation);
  CellWiseMesh<2> mesh(triangulation, false);
  mesh.build();
  const Operators<2> operators(mesh, InterfaceValue::broken);
  const ValueSpace<2> &space = operators.space;
  const FaceInterpolation<2> central(mesh, space), upwind(mesh, space, 0.),
      blended(mesh, space, 0.75);

  const auto values = operators.field(linear<2>);
  double error = 0., upwind_error = 0., blended_error = 0., own_error = 0.;
  const dealii::Tensor<1, 2> velocity({3., -2.});
  for (unsigned int f = 0; f < mesh.faces().size(); ++f)
  {
    const auto &face = mesh.faces()[f];
    const double exact = linear<2>(face.centre);
    error = std::max(error, std::abs(evaluate(central(f), values) - exact));
    if (face.has_value())
    {
      for (unsigned int side = 0; side < face.n_sides(); ++side)
        for (const auto *scheme : {&central, &upwind, &blended})
        {
          const auto stencil = (*scheme)(f, side, -1.);
          own_error = std::max(own_error, stencil.size() == 1 &&
                                                  stencil.begin()->first == space.of_face(f, side)
                                              ? std::abs(stencil.begin()->second - 1.)
                                              : 1.);
        }
      continue;
    }
    // The cell upstream is the one to the left, or above.
    const unsigned int direction = std::abs(face.normal[0]) > 0.5 ? 0 : 1;
    const double here = face.centre[direction];
    const double there = graded(not_graded(here) + (direction == 0 ? -0.25 : 0.25));
    dealii::Point<2> upstream = face.centre;
    upstream[direction] = 0.5 * (here + there);
    const double flux = velocity * face.normal * face.area;
    upwind_error = std::max(upwind_error,
                            std::abs(evaluate(upwind(f, 0, flux), values) - linear<2>(upstream)));
    blended_error = std::max(blended_error, std::abs(evaluate(blended(f, 0, flux), values) -
                                                     0.75 * exact - 0.25 * linear<2>(upstream)));
  }
  check::absolute("central: linear functions", largest(error), 0., 1e-14);
  check::absolute("upwind: the cell where the flux comes from", largest(upwind_error), 0., 1e-14);
  check::absolute("blended", largest(blended_error), 0., 1e-14);
  check::absolute("a face's own value, on its side", largest(own_error), 0., 0.);
}
} // namespace test_of_face_interpolation
