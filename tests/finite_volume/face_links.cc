// How faces hang on cells: springs, shares and directions of two squares and their walls by hand;
// what a face lacks goes to its cells; faces follow their cells but where they are held; prescribed
// velocities on oblique faces.

#include <continua/finite_volume/face_links.h>

#include "cell_wise_step.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_face_links
{
namespace
{
using namespace cell_wise_meshes;

/// Moduli 3 (4/3) = 4 Pa s and 2 Pa s, faces of length 1/2 at 1/4 from the centres: springs of 8
/// and
/// 4. x = 0 is held, x = 1 a roller, the rest free.
void check_two_squares()
{
  const CellWiseStep<2> step(make_two_squares, Model::plane_strain, make_coefficients(),
                             [](Problem &problem)
                             {
                               set_roller(problem.conditions[1]);
                               set_free(problem.conditions[2]);
                               set_free(problem.conditions[3]);
                             });
  SplitEquations<2> equations(step.system);
  equations.reinit();
  FaceLinks<2> links(step.system, equations);
  links.reinit(false);
  auto residual = equations.vector(), change = residual, unknowns = residual;
  // Cells move by (1, 2) and (4, 8); faces lack (3, 6).
  double springs = 0., directions = 0.;
  for (const auto &link : links.links())
  {
    const auto &surface = step.space.mesh.faces()[link.face];
    const bool between = link.n_sides == 2;
    for (unsigned int side = 0; side < link.n_sides; ++side)
    {
      const bool solid = step.space.mesh.cells()[surface.cell(side)].material_id == 0;
      const double spring = solid ? 8. : 4.;
      springs = std::max({springs, std::abs(link.stiffness[side] - spring),
                          std::abs(link.share[side] - (between ? spring / 12. : 1.)),
                          std::abs(link.compliance - (between ? 1. / 12. : 1. / spring))});
      for (unsigned int c = 0; c < 2; ++c)
        change.begin()[link.cells[side] + c] = (solid ? 1. : 4.) * (c + 1.);
    }
    const bool held = !between && surface.boundary_id == 0,
               roller = !between && surface.boundary_id == 1;
    const bool follows[2] = {!held && !roller, !held};
    for (unsigned int c = 0; c < 2; ++c)
    {
      directions += link.follows[c] != follows[c];
      directions += std::abs(link.free[c][c] - (follows[c] ? 1. : 0.));
      residual.begin()[link.velocity + c] = 3. * (c + 1.);
    }
  }
  check::absolute("springs", largest(springs), 0., 1e-14);
  check::absolute("directions", largest(directions), 0., 1e-14);

  auto of_cells = residual;
  links.add_to_cells(of_cells);
  links.follow(change, &residual, unknowns);
  double received = 0., moved = 0.;
  // Two free faces of each square, and 2/3 or 1/3 of the face between them; the roller lets go of
  // its tangential part.
  for (unsigned int cell = 0; cell < step.space.mesh.n_owned_cells(); ++cell)
  {
    const bool solid = step.space.mesh.cells()[cell].material_id == 0;
    const unsigned int row = equations.velocity_index(step.space.velocities.of_cell(cell));
    const double share = 2. + (solid ? 2. / 3. : 1. / 3.);
    received = std::max({received, std::abs(of_cells.begin()[row] - 3. * share),
                         std::abs(of_cells.begin()[row + 1] - 6. * (share + (solid ? 0. : 1.)))});
  }
  for (const auto &link : links.links())
  {
    const auto &surface = step.space.mesh.faces()[link.face];
    const bool solid = step.space.mesh.cells()[surface.owner].material_id == 0;
    double expected = solid ? 1. + 3. / 8. : 4. + 3. / 4.;
    if (link.n_sides == 2)
      expected = 2. / 3. * 1. + 1. / 3. * 4. + 3. / 12.;
    for (unsigned int c = 0; c < 2; ++c)
      moved = std::max(moved, std::abs(unknowns.begin()[link.velocity + c] -
                                       (link.follows[c] ? expected * (c + 1.) : 0.)));
  }
  check::absolute("what faces lack", received, 0., 1e-14);
  check::absolute("faces follow", moved, 0., 1e-14);

  links.reinit(true);
  double following = 0.;
  for (const auto &link : links.links())
    for (unsigned int c = 0; c < 2; ++c)
      following += link.follows[c] != (link.n_sides == 2);
  check::absolute("by value: only the face between", following, 0., 0.);
}

/// Oblique rollers: the normal velocity becomes the prescribed one, the tangential one stays; and
/// when cells move the normal one stays.
template <int dim>
void check_oblique()
{
  const std::string name = dim == 2 ? "2-D: " : "3-D: ";
  const CellWiseStep<dim> step(
      [](Triangulation<dim> &mesh)
      {
        make_uniform_box(mesh, 3);
        shear(mesh);
      },
      dim == 2 ? Model::plane_strain : Model::three_dimensional, make_coefficients(),
      [](Problem &problem)
      {
        for (BoundaryCondition &condition : problem.conditions)
          set_roller(condition);
      });
  SplitEquations<dim> equations(step.system);
  equations.reinit();
  FaceLinks<dim> links(step.system, equations);
  links.reinit(false);
  // The rows of the prescribed directions say scale (given - U) = residual.
  const dealii::Tensor<1, dim> given = slope<dim>();
  auto residual = equations.vector(), unknowns = residual, change = residual;
  for (const auto &link : links.links())
    for (unsigned int c = 0; c < dim; ++c)
    {
      unknowns.begin()[link.velocity + c] = 0.1 * c;
      residual.begin()[link.velocity + c] =
          step.system.scale(step.conditions.of_face(link.face)) * (given[c] - 0.1 * c);
    }
  links.set_prescribed(residual, unknowns);
  const auto at = [&](const unsigned int place)
  {
    dealii::Tensor<1, dim> value;
    for (unsigned int c = 0; c < dim; ++c)
      value[c] = unknowns.begin()[place + c];
    return value;
  };
  dealii::Tensor<1, dim> before;
  for (unsigned int c = 0; c < dim; ++c)
    before[c] = 0.1 * c;
  double set = 0., kept = 0.;
  for (const auto &link : links.links())
  {
    const dealii::Tensor<1, dim> &n = step.space.mesh.faces()[link.face].normal;
    set = std::max(set, (at(link.velocity) - before - ((given - before) * n) * n).norm());
  }
  change = 1.;
  links.follow(change, nullptr, unknowns);
  dealii::Tensor<1, dim> ones;
  for (unsigned int c = 0; c < dim; ++c)
    ones[c] = 1.;
  for (const auto &link : links.links())
  {
    const dealii::Tensor<1, dim> &n = step.space.mesh.faces()[link.face].normal;
    const dealii::Tensor<1, dim> expected =
        before + ((given - before) * n) * n + ones - (ones * n) * n;
    kept = std::max(kept, (at(link.velocity) - expected).norm());
  }
  check::absolute(name + "prescribed", set, 0., 1e-13);
  check::absolute(name + "stays so", kept, 0., 1e-13);
}
} // namespace

UNIT_TEST(face_links)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_two_squares();
  check_oblique<2>();
  check_oblique<3>();
}
} // namespace test_of_face_links
