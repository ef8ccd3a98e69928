// Energies of motions that are known: mass of a uniform motion = volume, stiffness 0 for rigid ones
// and for pure dilatation exact, divergence of linear fields; with hanging nodes; axisymmetry.

#include <continua/finite_element/products/region_operators.h>
#include <continua/linear_algebra/matrix_product.h>

#include "../unit_test.h"
#include "small_problem.h"

namespace test_of_region_operators
{
using namespace Continua;
using namespace dealii;

namespace
{
template <int dim>
struct Operators
{
  Operators(small_problem::Mesh<dim> &mesh, const Model model)
      : space(mesh, SpaceParameters(), model, 2), regions(2)
  {
    space.distribute();
    assemble_region_operators(space, regions);
  }
  using Field = std::function<Tensor<1, dim>(const Point<dim> &)>;

  double energy(const TrilinosWrappers::SparseMatrix &matrix, const Field &field) const
  {
    const DistributedVector u = small_problem::interpolated<dim>(space, field);
    DistributedVector product(u);
    multiply(matrix, product, u);
    return product * u;
  }
  /// int q div u with q = 1 in that region.
  double divergence(const unsigned int region, const Field &field) const
  {
    const DistributedVector u = small_problem::interpolated<dim>(space, field);
    const DistributedVector one = small_problem::interpolated_pressure<dim>(
        space, [](const Point<dim> &, unsigned int) { return 1.; });
    DistributedVector product = space.pressure_vector();
    multiply(regions[region].divergence, product, u);
    return product * one;
  }
  double pressure_mass(const unsigned int region) const
  {
    const DistributedVector p = small_problem::interpolated_pressure<dim>(
        space, [](const Point<dim> &, const unsigned int r) { return r == 0 ? 2. : 5.; });
    DistributedVector product(p);
    multiply(regions[region].pressure_mass, product, p);
    return product * p;
  }

  Space<dim> space;
  std::vector<RegionOperators> regions;
};
} // namespace

UNIT_TEST(region_operators)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  {
    // 3 x 2, of which x > 2 is region 1.
    small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
    small_problem::make_box<2>(mesh, {3, 2}, Point<2>(), 2.);
    small_problem::refine<2>(mesh, [](const Point<2> &x) { return x[0] > 1. && x[1] < 1.; });
    const Operators<2> plane(mesh, Model::plane_strain);
    using V = Tensor<1, 2>;
    const auto uniform = [](const Point<2> &) { return V({2., 1.}); };
    const auto rigid = [](const Point<2> &x) { return V({1. - x[1], 3. + x[0]}); };
    const auto shear = [](const Point<2> &x) { return V({x[1], 0.}); };
    const auto stretch = [](const Point<2> &x) { return V({x[0], 0.}); };
    check::relative("2-D: mass, region 0", plane.energy(plane.regions[0].mass, uniform), 20.,
                    1e-13);
    check::relative("2-D: mass, region 1", plane.energy(plane.regions[1].mass, uniform), 10.,
                    1e-13);
    check::absolute("2-D: rigid", plane.energy(plane.regions[0].stiffness, rigid), 0., 1e-12);
    // 2 (e_xy^2 + e_yx^2), e_xy = 1/2
    check::relative("2-D: shear", plane.energy(plane.regions[0].stiffness, shear), 4., 1e-13);
    // dev = (2, -1, -1) / 3: 2 * 6 / 9
    check::relative("2-D: stretch", plane.energy(plane.regions[1].stiffness, stretch), 8. / 3.,
                    1e-13);
    check::relative("2-D: divergence, region 0", plane.divergence(0, stretch), 4., 1e-13);
    check::relative("2-D: divergence, region 1",
                    plane.divergence(1,
                                     [](const Point<2> &x) {
                                       return V({x[0], 4. * x[1]});
                                     }),
                    10., 1e-13);
    check::absolute("2-D: divergence of a rotation", plane.divergence(0, rigid), 0., 1e-13);
    check::relative("2-D: pressure mass, region 0", plane.pressure_mass(0), 16., 1e-13);
    check::relative("2-D: pressure mass, region 1", plane.pressure_mass(1), 50., 1e-13);
  }
  {
    // Axis x, radius y: cylinder of radius 2 and length 2, then one of length 1.
    small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
    small_problem::make_box<2>(mesh, {3, 2}, Point<2>(), 2.);
    small_problem::refine<2>(mesh, [](const Point<2> &x) { return x[0] > 1. && x[1] < 1.; });
    const Operators<2> tube(mesh, Model::axisymmetric);
    using V = Tensor<1, 2>;
    const double pi = numbers::PI;
    check::relative("tube: mass is density times volume",
                    tube.energy(tube.regions[0].mass,
                                [](const Point<2> &) {
                                  return V({1., 0.});
                                }),
                    8. * pi, 1e-13);
    check::absolute("tube: rigid",
                    tube.energy(tube.regions[0].stiffness,
                                [](const Point<2> &) {
                                  return V({1., 0.});
                                }),
                    0., 1e-11);
    const auto radial = [](const Point<2> &x) { return V({0., x[1]}); };
    // e = (0, 1, 1) axial, radial, hoop: div = 2, dev = (-2, 1, 1) / 3, 2 dev : dev = 4 / 3.
    check::relative("tube: divergence with the hoop strain", tube.divergence(0, radial), 16. * pi,
                    1e-13);
    check::relative("tube: stiffness with the hoop strain",
                    tube.energy(tube.regions[0].stiffness, radial), 4. / 3. * 8. * pi, 1e-13);
    check::relative("tube: dilatation has no deviator",
                    1. + tube.energy(tube.regions[1].stiffness,
                                     [](const Point<2> &x) {
                                       return V({x[0], x[1]});
                                     }),
                    1., 1e-11);
    check::relative("tube: pressure mass", tube.pressure_mass(1), 25. * 4. * pi, 1e-13);
  }
  {
    small_problem::Mesh<3> mesh(MPI_COMM_WORLD);
    small_problem::make_box<3>(mesh, {2, 1, 1}, Point<3>(), 1.);
    small_problem::refine<3>(mesh, [](const Point<3> &x) { return x[0] > 1.; });
    const Operators<3> space(mesh, Model::three_dimensional);
    using V = Tensor<1, 3>;
    check::relative("3-D: mass",
                    space.energy(space.regions[0].mass,
                                 [](const Point<3> &) {
                                   return V({1., 2., 2.});
                                 }),
                    9., 1e-13);
    check::absolute("3-D: rigid",
                    space.energy(space.regions[1].stiffness,
                                 [](const Point<3> &x) {
                                   return V({x[1] - x[2], x[2] - x[0], x[0] - x[1]});
                                 }),
                    0., 1e-12);
    check::relative("3-D: stretch",
                    space.energy(space.regions[0].stiffness,
                                 [](const Point<3> &x) {
                                   return V({0., x[1], 0.});
                                 }),
                    4. / 3., 1e-13);
    check::relative("3-D: divergence",
                    space.divergence(0,
                                     [](const Point<3> &x) {
                                       return V({x[0], 2. * x[1], 4. * x[2]});
                                     }),
                    7., 1e-13);
  }
}
} // namespace test_of_region_operators
