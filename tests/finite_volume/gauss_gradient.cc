// The gradient of linear functions on every mesh, of quadratic ones on Cartesian meshes, the plain
// stencil where nothing is skewed, and observed orders.

#include "cell_wise_meshes.h"

#include "../unit_test.h"

#include <algorithm>
#include <array>

namespace test_of_gauss_gradient
{
using namespace cell_wise_meshes;

namespace
{
template <int dim>
void check_linear(const bool axisymmetric)
{
  on_each<dim>(
      flat_faced<dim>(), axisymmetric,
      [](const std::string &name, const Operators<dim> &operators)
      {
        const auto values = operators.field(linear<dim>);
        const auto &mesh = operators.mesh;
        double error = 0.;
        for (unsigned int c = 0; c < mesh.cells().size(); ++c) // ghosts too
          error = std::max(error, (evaluate(operators.gradient(c), values) - slope<dim>()).norm());
        for (unsigned int f = 0; f < mesh.faces().size(); ++f)
          for (unsigned int side = 0; side < mesh.faces()[f].n_sides(); ++side)
            error = std::max(
                {error,
                 (evaluate(operators.gradient.on_face(f, side), values) - slope<dim>()).norm(),
                 std::abs(evaluate(operators.gradient.face_value(f, side), values) -
                          linear<dim>(mesh.faces()[f].centre))});
        check::absolute(name + ": linear functions", largest(error), 0., 1e-12);
      });
}

/// Errors of the gradient of a smooth function: root mean square, largest, root mean square of the
/// cells whose neighbours are all cells.
std::array<double, 3> errors(const Sequence &sequence, const unsigned int n)
{
  Triangulation<2> triangulation(MPI_COMM_WORLD);
  sequence.make(triangulation, n);
  CellWiseMesh<2> mesh(triangulation, false);
  mesh.build();
  const Operators<2> operators(mesh, InterfaceValue::common);
  const auto values = operators.field(Waves<2>::value);
  double squares = 0., volume = 0., maximum = 0., squares_inside = 0., volume_inside = 0.;
  for (unsigned int c = 0; c < mesh.n_owned_cells(); ++c)
  {
    const auto &cell = mesh.cells()[c];
    const double error =
        (evaluate(operators.gradient(c), values) - Waves<2>::gradient(cell.centre)).norm();
    squares += error * error * cell.volume;
    volume += cell.volume;
    maximum = std::max(maximum, error);
    if (is_inside(mesh, c))
    {
      squares_inside += error * error * cell.volume;
      volume_inside += cell.volume;
    }
  }
  return {{std::sqrt(sum(squares) / sum(volume)), largest(maximum),
           std::sqrt(sum(squares_inside) / sum(volume_inside))}};
}
} // namespace

UNIT_TEST(gauss_gradient)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();

  check_linear<2>(false);
  check_linear<2>(true);
  check_linear<3>(false);

  {
    // Cells of width 1/4: the differences of the two neighbours over 1/2; nothing else.
    Triangulation<3> triangulation(MPI_COMM_WORLD);
    make_box(triangulation, 4);
    CellWiseMesh<3> mesh(triangulation, false);
    mesh.build();
    const Operators<3> operators(mesh, InterfaceValue::common);
    const auto quadratic = operators.field(
        [](const dealii::Point<3> &p)
        { return p[0] * p[0] - 3. * p[1] * p[1] + p[2] * (2. * p[2] + p[0]) + p[0] * p[1]; });
    double entries = 0., error = 0.;
    for (unsigned int c = 0; c < mesh.n_owned_cells(); ++c)
      if (is_inside(mesh, c))
      {
        const auto &stencil = operators.gradient(c);
        entries += stencil.size() != 7;
        for (const auto &entry : stencil)
        {
          dealii::Tensor<1, 3> expected;
          for (const unsigned int f : mesh.cells()[c].faces)
          {
            const unsigned int side = mesh.side(f, c);
            if (entry.first == operators.space.beyond(f, side))
              expected = 2. * mesh.faces()[f].outward(side);
          }
          entries += (entry.second - expected).norm();
        }
        const dealii::Point<3> &p = mesh.cells()[c].centre;
        const dealii::Tensor<1, 3> exact(
            {2. * p[0] + p[2] + p[1], -6. * p[1] + p[0], 4. * p[2] + p[0]});
        error = std::max(error, (evaluate(stencil, quadratic) - exact).norm());
      }
    check::absolute("Cartesian: differences of the neighbours", sum(entries), 0., 1e-12);
    check::absolute("Cartesian: quadratic functions", largest(error), 0., 1e-13);
  }

  // Beside a boundary the errors of the interpolation do not cancel: order 1 in a layer of one
  // cell, so 3/2 in the mean; inside, 2 where the cells become alike.
  for (const auto &sequence : sequences())
  {
    const auto coarse = errors(sequence, 16), fine = errors(sequence, 32);
    if (sequence.name == "random")
      check::is_true("random: at least of order 1", coarse[0] / fine[0] > 2.);
    else
      check_order(sequence.name + ": mean", coarse[0], fine[0], 1.5);
    check_order(sequence.name + ": largest", coarse[1], fine[1], 1.);
    if (sequence.is_smooth)
      check_order(sequence.name + ": inside", coarse[2], fine[2], 2.);
  }

  // Random vertices warp the faces of hexahedra. In cells that are divided faces depart from planes
  // by h^2, which gives linear functions an error of order 1 from each face; opposite faces are
  // warped alike but for h^3, so that of order 1 cancels.
  std::array<double, 2> warped;
  for (const unsigned int n_divisions : {0, 1})
  {
    Triangulation<3> triangulation(MPI_COMM_WORLD);
    make_box(triangulation, 4);
    distort_coarse_mesh(triangulation, 0.25);
    for (unsigned int i = 0; i < n_divisions; ++i)
      refine(triangulation);
    CellWiseMesh<3> mesh(triangulation, false);
    mesh.build();
    const Operators<3> operators(mesh, InterfaceValue::common);
    const auto values = operators.field(linear<3>);
    double squares = 0.;
    for (unsigned int c = 0; c < mesh.n_owned_cells(); ++c)
      squares += (evaluate(operators.gradient(c), values) - slope<3>()).norm_square() *
                 mesh.cells()[c].volume;
    warped[n_divisions] = std::sqrt(sum(squares));
  }
  check_order("3-D, warped faces: linear functions", warped[0], warped[1], 2.);
}
} // namespace test_of_gauss_gradient
