// div grad by the normal gradients on faces and by the cells' gradients there: linear and quadratic
// functions, a checkerboard, and what is conserved.

#include "cell_wise_meshes.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_laplacian
{
using namespace cell_wise_meshes;

namespace
{
template <int dim>
void check_linear(const bool axisymmetric)
{
  on_each<dim>(flat_faced<dim>(), axisymmetric,
               [axisymmetric](const std::string &name, const Operators<dim> &operators)
               {
                 const auto &mesh = operators.mesh;
                 const auto values = operators.field(linear<dim>);
                 const auto rough = operators.field([](const dealii::Point<dim> &point)
                                                    { return std::sin(1e3 * point.norm()); });
                 double error = 0., total = 0., through = 0.;
                 for (unsigned int c = 0; c < mesh.n_owned_cells(); ++c)
                 {
                   // In axisymmetry the Laplacian of r is 1/r.
                   const double exact = axisymmetric ? slope<dim>()[1] * 2. * dealii::numbers::PI *
                                                           mesh.cells()[c].plane_volume
                                                     : 0.;
                   const auto compact = operators.compact_laplacian(c);
                   error =
                       std::max({error, std::abs(evaluate(compact, values) - exact),
                                 std::abs(evaluate(operators.wide_laplacian(c), values) - exact)});
                   total += evaluate(compact, rough);
                 }
                 // On interfaces the fluxes of the two sides are equal only for the right values;
                 // here the values are any.
                 for (unsigned int f = 0; f < mesh.faces().size(); ++f)
                   if (mesh.faces()[f].has_value())
                     for (unsigned int side = 0; side < mesh.faces()[f].n_sides(); ++side)
                       if (operators.mesh.cells()[mesh.faces()[f].cell(side)].is_owned)
                         through += mesh.faces()[f].area *
                                    evaluate(operators.normal_gradient(f, side), rough);
                 check::absolute(name + ": linear functions", largest(error), 0., 1e-12);
                 check::absolute(name + ": what leaves a cell enters the next",
                                 sum(total - through), 0., 1e-11);
               });
}
} // namespace

UNIT_TEST(laplacian)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();

  check_linear<2>(false);
  check_linear<2>(true);
  check_linear<3>(false);

  // One region, 8 x 8 cells of width 1/8.
  Triangulation<2> triangulation(MPI_COMM_WORLD);
  make_box(triangulation, 8);
  for (const auto &cell : triangulation.active_cell_iterators())
    cell->set_material_id(0);
  CellWiseMesh<2> mesh(triangulation, false);
  mesh.build();
  const Operators<2> operators(mesh, InterfaceValue::common);
  // 2 x^2 + 3 x y - 5 y^2: 4 - 10.
  const auto quadratic =
      operators.field([](const dealii::Point<2> &p)
                      { return 2. * p[0] * p[0] + 3. * p[0] * p[1] - 5. * p[1] * p[1]; });
  const auto checkerboard = operators.field(
      [](const dealii::Point<2> &p)
      { return (int(std::floor(8. * p[0])) + int(std::floor(8. * p[1]))) % 2 == 0 ? 1. : -1.; });
  double compact = 0., wide = 0., seen = 0., unseen = 0., entries = 0.;
  for (unsigned int c = 0; c < mesh.n_owned_cells(); ++c)
  {
    const auto &cell = mesh.cells()[c];
    if (!is_inside(mesh, c))
      continue;
    compact =
        std::max(compact, std::abs(evaluate(operators.compact_laplacian(c), quadratic) + 6. / 64.));
    entries += operators.compact_laplacian(c).size() != 5;
    // -8 / h^2 times the value, over a cell of h^2.
    seen = std::max(seen, std::abs(evaluate(operators.compact_laplacian(c), checkerboard) +
                                   8. * checkerboard[operators.space.of_cell(c)]));
    if (cell.centre[0] > 0.25 && cell.centre[0] < 0.75 && cell.centre[1] > 0.25 &&
        cell.centre[1] < 0.75)
    {
      wide = std::max(wide, std::abs(evaluate(operators.wide_laplacian(c), quadratic) + 6. / 64.));
      unseen = std::max(unseen, std::abs(evaluate(operators.wide_laplacian(c), checkerboard)));
    }
  }
  check::absolute("Cartesian, compact: quadratic functions", largest(compact), 0., 1e-13);
  check::absolute("Cartesian, compact: five values", sum(entries), 0., 0.);
  check::absolute("Cartesian, wide: quadratic functions", largest(wide), 0., 1e-13);
  check::absolute("a checkerboard seen by the compact stencil", largest(seen), 0., 1e-12);
  check::absolute("and not by the wide one", largest(unseen), 0., 1e-13);
}
} // namespace test_of_laplacian
