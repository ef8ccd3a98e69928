// Supports of straight, inclined, curved and axisymmetric boundaries against integrals in closed
// form, with hanging nodes, of one region alone.

#include <continua/finite_element/products/supports.h>

#include "../parameter_text.h"
#include "../unit_test.h"
#include "small_problem.h"

#include <limits>

namespace test_of_supports
{
using namespace Continua;
using namespace dealii;

namespace
{
constexpr double pi = numbers::PI;

/// The support of one boundary of a mesh; the stiffness is 3 along the normal and 5 across, the
/// damping 7 and 11.
template <int dim>
struct Supported
{
  Supported(const Space<dim> &space, const unsigned int boundary, const unsigned int region = 0)
      : space(space), operators(2)
  {
    BoundaryCondition condition;
    condition.type = BoundaryType::support;
    condition.boundary_id = boundary;
    condition.region_ids = {region};
    condition.normal.stiffness = 3.;
    condition.tangential.stiffness = 5.;
    condition.normal.damping = 7.;
    condition.tangential.damping = 11.;
    assemble_supports(space, {condition}, operators);
  }
  /// u . K u of a motion, and u . C u.
  double energy(const std::function<Tensor<1, dim>(const Point<dim> &)> &motion,
                const bool damping) const
  {
    const DistributedVector u = small_problem::interpolated<dim>(space, motion);
    DistributedVector force = space.velocity_vector();
    double sum = 0.;
    for (const RegionOperators &region : operators)
      if (region.is_supported)
      {
        multiply(damping ? region.support_damping : region.support_stiffness, force, u);
        sum += force * u;
      }
    return sum;
  }
  /// Checks both: the integrals over the boundary of the squares of the normal and the other part.
  void check(const std::string &name,
             const std::function<Tensor<1, dim>(const Point<dim> &)> &motion,
             const double normal_square,
             const double tangential_square,
             const double tolerance = 1e-12) const
  {
    check::relative(name, energy(motion, false), 3. * normal_square + 5. * tangential_square,
                    tolerance);
    check::relative(name + ", damping", energy(motion, true),
                    7. * normal_square + 11. * tangential_square, tolerance);
  }

  const Space<dim> &space;
  std::vector<RegionOperators> operators;
};

void inclined()
{
  const double angle = 0.4, c = std::cos(angle), s = std::sin(angle);
  small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
  small_problem::make_box<2>(mesh, {4, 2}, Point<2>(), 2.);
  small_problem::refine<2>(mesh, [](const Point<2> &x) { return x[0] > 1. && x[1] > 1.; });
  GridTools::rotate(angle, mesh);
  Space<2> space(mesh, SpaceParameters(), Model::plane_strain, 2);
  space.distribute();
  // The right side has the length 2, the top 2 in each region.
  const Supported<2> right(space, 1, 1), top(space, 3, 0);
  check::is_true("of its region alone",
                 !right.operators[0].is_supported && right.operators[1].is_supported);
  const auto along_x = [](const Point<2> &) { return Tensor<1, 2>({1., 0.}); };
  right.check("inclined side", along_x, 2. * c * c, 2. * s * s);
  top.check("part of a top", along_x, 2. * s * s, 2. * c * c);
  // A turn by 1: along the normal of the side it is the distance from its foot.
  right.check(
      "a turn",
      [](const Point<2> &x) {
        return Tensor<1, 2>({-x[1], x[0]});
      },
      8. / 3., 32.);
}

void in_three_dimensions()
{
  small_problem::Mesh<3> mesh(MPI_COMM_WORLD);
  small_problem::make_box<3>(mesh, {2, 2, 1});
  small_problem::refine<3>(mesh, [](const Point<3> &x) { return x[0] > 1. && x[1] > 1.; });
  Space<3> space(mesh, SpaceParameters(), Model::three_dimensional, 2);
  space.distribute();
  // x = 2 is 2 x 1.
  const Supported<3> side(space, 1);
  side.check(
      "side of a box",
      [](const Point<3> &x) {
        return Tensor<1, 3>({x[1], x[2], 2.});
      },
      8. / 3., 2. / 3. + 8.);
}

void axisymmetric()
{
  small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
  small_problem::make_box<2>(mesh, {2, 2});
  Space<2> space(mesh, SpaceParameters(), Model::axisymmetric, 2);
  space.distribute();
  const Supported<2> disc(space, 1), mantle(space, 3);
  disc.check(
      "disc",
      [](const Point<2> &x) {
        return Tensor<1, 2>({1., x[1]});
      },
      4. * pi, 8. * pi);
  mantle.check(
      "mantle",
      [](const Point<2> &x) {
        return Tensor<1, 2>({1., x[0]});
      },
      4. * pi * 8. / 3., 8. * pi);
}

void curved()
{
  small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
  GridGenerator::hyper_shell(mesh, Point<2>(), 1., 2., 64, true);
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(0);
  Space<2> space(mesh, SpaceParameters(), Model::plane_strain, 2);
  space.distribute();
  const Supported<2> outside(space, 1);
  // The error of the circle by parabolas falls with the fourth power of their size.
  outside.check(
      "circle, widened", [](const Point<2> &x) { return x / 2.; }, 4. * pi, 0., 1e-6);
  outside.check(
      "circle, turned",
      [](const Point<2> &x) {
        return Tensor<1, 2>({-x[1] / 2., x[0] / 2.});
      },
      0., 4. * pi, 1e-6);
}
} // namespace

UNIT_TEST(supports)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  inclined();
  in_three_dimensions();
  axisymmetric();
  curved();
}
} // namespace test_of_supports
