// The wall shear stress at the nodes of a liquid's walls: boundaries and a solid, with hanging
// nodes.

#include <continua/finite_element/looking/wall_shear_stress.h>
#include <continua/finite_element/products/region_operators.h>

#include "../unit_test.h"
#include "small_problem.h"

#include <cmath>

namespace test_of_wall_shear_stress
{
using namespace Continua;
using namespace dealii;

namespace
{
/// Right of x = 2 is a liquid, left of it a solid; all around the velocity is prescribed, but on
/// the boundary `open` only its normal part.
Problem make_solid_and_liquid(const unsigned int open)
{
  Problem problem;
  problem.model = Model::plane_strain;
  problem.regions = {"solid", "liquid"};
  problem.boundaries = {"left", "right", "bottom", "top"};
  Material solid, liquid;
  solid.shear.branches = {Branch{3., std::numeric_limits<double>::infinity()}};
  liquid.shear.viscosity = 2.;
  problem.materials = {solid, liquid};
  for (unsigned int b = 0; b < 4; ++b)
  {
    BoundaryCondition fixed;
    fixed.name = problem.boundaries[b];
    fixed.boundary_id = b;
    fixed.region_ids = {0, 1};
    fixed.normal.kind = BoundaryPart::Kind::velocity;
    if (b != open)
      fixed.tangential.kind = BoundaryPart::Kind::velocity;
    problem.conditions.push_back(fixed);
  }
  problem.further_fields.wall_shear_stress = true;
  return problem;
}

double difference(const DistributedVector &a, const DistributedVector &b)
{
  DistributedVector result(a);
  result.add(-1., b);
  return result.linfty_norm();
}

/// grad U = (2, 3; 0, 5) and eta = 2: the tangential part of n.sigma is 6 everywhere. The finer
/// cells are the solid's or the liquid's.
void test_nodes(const std::string &name, const bool liquid_is_finer)
{
  small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
  small_problem::make_box<2>(mesh, {4, 2}, Point<2>(), 2.);
  small_problem::refine<2>(mesh, [liquid_is_finer](const Point<2> &x)
                           { return x[1] > 1. && (liquid_is_finer ? x[0] > 2. : x[0] < 2.); });
  const Problem problem = make_solid_and_liquid(3);
  Space<2> space(mesh, SpaceParameters(), problem.model, 2);
  space.distribute();
  std::vector<RegionOperators> operators(2);
  assemble_region_operators(space, operators);
  BranchHistory history(problem.materials);
  history.reinit(space.velocity_vector(), velocity_nodes(operators));
  const DistributedVector velocity =
      small_problem::interpolated<2>(space,
                                     [](const Point<2> &x) {
                                       return Tensor<1, 2>({1. + 2. * x[0] + 3. * x[1], 5. * x[1]});
                                     });
  const DistributedVector pressure = space.pressure_vector();

  WallShearStress<2> wall_shear(space, problem);
  wall_shear.reinit();
  DistributedVector shear = space.velocity_vector(), magnitudes = space.velocity_vector();
  wall_shear.set(State{velocity, pressure, history}, shear);
  // On the bottom, the right and the solid; the top is no wall, for it holds no motion along it.
  const DistributedVector exact = small_problem::interpolated<2>(
      space,
      [](const Point<2> &x)
      {
        const bool bottom = x[0] > 2. - 1e-9 && x[1]<1e-9, right = x[0]> 4. - 1e-9,
                   solid = std::abs(x[0] - 2.) < 1e-9;
        Tensor<1, 2> sum;
        if (bottom)
          sum += Tensor<1, 2>({6., 0.});
        if (right)
          sum += Tensor<1, 2>({0., -6.});
        if (solid)
          sum += Tensor<1, 2>({0., 6.});
        return bottom && (right || solid) ? 0.5 * sum : sum;
      });
  check::absolute(name + ": at the nodes", difference(shear, exact), 0., 1e-12);

  wall_shear.set_magnitudes(shear, magnitudes);
  const DistributedVector exact_magnitudes = small_problem::interpolated<2>(
      space,
      [](const Point<2> &x)
      {
        const bool bottom = x[0] > 2. - 1e-9 && x[1]<1e-9, right = x[0]> 4. - 1e-9,
                   solid = std::abs(x[0] - 2.) < 1e-9;
        const double size = bottom && (right || solid) ? std::sqrt(18.)
                            : bottom || right || solid ? 6.
                                                       : 0.;
        return Tensor<1, 2>({size, size});
      });
  check::absolute(name + ": magnitudes", difference(magnitudes, exact_magnitudes), 0., 1e-12);

  DistributedVector everywhere = small_problem::interpolated<2>(space,
                                                                [](const Point<2> &) {
                                                                  return Tensor<1, 2>({1., 1.});
                                                                });
  wall_shear.keep_walls_alone(everywhere);
  const DistributedVector exact_walls =
      small_problem::interpolated<2>(space,
                                     [](const Point<2> &x)
                                     {
                                       const bool is_wall = (x[0] > 2. - 1e-9 && x[1] < 1e-9) ||
                                                            x[0] > 4. - 1e-9 ||
                                                            std::abs(x[0] - 2.) < 1e-9;
                                       return is_wall ? Tensor<1, 2>({1., 1.}) : Tensor<1, 2>();
                                     });
  check::absolute(name + ": walls alone", difference(everywhere, exact_walls), 0., 0.);
}
} // namespace

UNIT_TEST(wall_shear_stress)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  test_nodes("finer liquid", true);
  test_nodes("finer solid", false);
}
} // namespace test_of_wall_shear_stress
