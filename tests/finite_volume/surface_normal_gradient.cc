// n . gradient on faces: of linear functions on every mesh, of quadratic ones on Cartesian meshes.

#include "cell_wise_meshes.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_surface_normal_gradient
{
using namespace cell_wise_meshes;

namespace
{
template <int dim>
void check_linear(const bool axisymmetric)
{
  on_each<dim>(flat_faced<dim>(), axisymmetric,
               [](const std::string &name, const Operators<dim> &operators)
               {
                 const auto values = operators.field(linear<dim>);
                 const auto &mesh = operators.mesh;
                 double error = 0.;
                 for (unsigned int f = 0; f < mesh.faces().size(); ++f)
                   for (unsigned int side = 0; side < mesh.faces()[f].n_sides(); ++side)
                     error = std::max(
                         error, std::abs(evaluate(operators.normal_gradient(f, side), values) -
                                         slope<dim>() * mesh.faces()[f].outward(side)));
                 check::absolute(name + ": linear functions", largest(error), 0., 1e-12);
               });
}
} // namespace

UNIT_TEST(surface_normal_gradient)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();

  check_linear<2>(false);
  check_linear<2>(true);
  check_linear<3>(false);

  Triangulation<3> triangulation(MPI_COMM_WORLD);
  make_box(triangulation, 4);
  CellWiseMesh<3> mesh(triangulation, false);
  mesh.build();
  const Operators<3> operators(mesh, InterfaceValue::broken);
  const auto values =
      operators.field([](const dealii::Point<3> &p)
                      { return 3. * p[0] * p[0] - p[1] * p[1] + p[1] * p[2] + 2. * p[2] * p[2]; });
  double error = 0., wide = 0., sides = 0.;
  for (unsigned int f = 0; f < mesh.faces().size(); ++f)
  {
    const auto &face = mesh.faces()[f];
    wide += operators.normal_gradient(f).size() != 2;
    if (face.has_value())
      continue;
    const dealii::Point<3> &p = face.centre;
    const dealii::Tensor<1, 3> exact({6. * p[0], -2. * p[1] + p[2], p[1] + 4. * p[2]});
    error = std::max(
        error, std::abs(evaluate(operators.normal_gradient(f), values) - exact * face.normal));
    sides = std::max(sides, std::abs(evaluate(operators.normal_gradient(f, 0), values) +
                                     evaluate(operators.normal_gradient(f, 1), values)));
  }
  check::absolute("Cartesian: quadratic functions", largest(error), 0., 1e-13);
  check::absolute("Cartesian: two values and no more", sum(wide), 0., 0.);
  check::absolute("one side's is the other's with its sign turned", largest(sides), 0., 1e-13);

  // A line of centres at 45 degrees to the normal: the compact part alone is (f_N - f_P) / (d . n)
  // of two cells side by side, which for f = x + y is 2 and not 1.
  Triangulation<2> leaning(MPI_COMM_WORLD);
  make_box(leaning, 2);
  move_vertices<2>(leaning, [](const dealii::Point<2> &point)
                   { return dealii::Point<2>(point[0], point[1] + point[0]); });
  CellWiseMesh<2> leaning_mesh(leaning, false);
  leaning_mesh.build();
  const Operators<2> leaning_operators(leaning_mesh, InterfaceValue::common);
  const auto sums =
      leaning_operators.field([](const dealii::Point<2> &point) { return point[0] + point[1]; });
  double compact = 0.;
  for (unsigned int f = 0; f < leaning_mesh.faces().size(); ++f)
    if (std::abs(leaning_mesh.faces()[f].normal[1]) < 1e-12)
      compact =
          std::max(compact, std::abs(evaluate(leaning_operators.normal_gradient.compact(f), sums) -
                                     2. * leaning_mesh.faces()[f].normal[0]));
  check::absolute("leaning: the compact part is over-relaxed", largest(compact), 0., 1e-13);
}
} // namespace test_of_surface_normal_gradient
