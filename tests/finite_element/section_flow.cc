// Flow rates through sections by the balance of mass: exact for cubic polynomials wherever the
// section is, on faces, inside cells, at the ends and beside hanging nodes, on one and two ranks;
// and the flow from a point source in a cone, the same through every section.

#include <continua/finite_element/section_flow.h>
#include <continua/mesh/tube_geometry.h>

#include "../unit_test.h"
#include "small_problem.h"

using namespace Continua;
using namespace dealii;

namespace
{
template <int dim>
double flow(const Space<dim> &space,
            const DistributedVector &velocity,
            const double x,
            const std::set<unsigned int> &regions,
            const double direction = 1.)
{
  Point<dim> point;
  point[0] = x;
  Tensor<1, dim> normal;
  normal[0] = direction;
  DistributedVector weights = space.velocity_vector();
  if (!SectionFlow<dim>(space, regions, point, normal).add_weights(weights))
    return 0.;
  weights.compress(VectorOperation::add);
  return weights * velocity;
}

template <int dim>
void test_box(const std::vector<unsigned int> &cells, const std::vector<double> &places)
{
  small_problem::Mesh<dim> mesh(MPI_COMM_WORLD);
  small_problem::make_box<dim>(mesh, cells);
  small_problem::refine<dim>(mesh, [](const Point<dim> &x) { return x[0] > 3. && x[1] > 1.; });
  SpaceParameters parameters;
  parameters.velocity_degree = 3;
  Space<dim> space(mesh, parameters, dim == 2 ? Model::plane_strain : Model::three_dimensional, 2);
  space.distribute();
  const auto cubic = [](const double x) { return 1. + x - 0.2 * x * x + 0.03 * x * x * x; };
  const DistributedVector velocity = small_problem::interpolated<dim>(space,
                                                                      [&](const Point<dim> &x)
                                                                      {
                                                                        Tensor<1, dim> value;
                                                                        value[0] = cubic(x[0]);
                                                                        return value;
                                                                      });
  double area = 1.;
  for (unsigned int c = 1; c < dim; ++c)
    area *= cells[c];
  for (const double x : places)
    check::relative("box " + std::to_string(dim) + ", x = " + std::to_string(x),
                    flow<dim>(space, velocity, x, {}), area * cubic(x), 1e-9);
  check::relative("against the normal", flow<dim>(space, velocity, 2.4, {}, -2.),
                  -area * cubic(2.4), 1e-9);
  check::absolute("outside", flow<dim>(space, velocity, 100., {}), 0., 0.);
  check::absolute("no such region", flow<dim>(space, velocity, 2.4, {1}), 0., 0.);
}

/// A box of few cells: exact for polynomials of a degree below the number of cells.
void test_few_cells()
{
  for (const unsigned int n : {1u, 2u, 3u})
  {
    small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
    small_problem::make_box<2>(mesh, {n, 2});
    Space<2> space(mesh, SpaceParameters(), Model::plane_strain, 1);
    space.distribute();
    const DistributedVector velocity =
        small_problem::interpolated<2>(space,
                                       [n](const Point<2> &x) {
                                         return Tensor<1, 2>({std::pow(x[0], n - 1.), 0.});
                                       });
    check::relative(std::to_string(n) + " cells", flow<2>(space, velocity, 0.7, {}),
                    2. * std::pow(0.7, n - 1.), 1e-9);
  }
}

/// A point source of 1 m^3/s per unit of solid angle in the apex, x = -2 m, of a cone.
template <int dim>
void test_cone(const double copies, const unsigned int n_cells, const std::vector<double> &places)
{
  typename TubeGeometry<dim>::Parameters tube;
  tube.law = TubeLaw::taper(2., 1., 2., 0.1, 0.1);
  tube.axial_cells = n_cells;
  tube.radial_cells = dim == 2 ? 3 : 2;
  tube.circumferential_cells = 4;
  tube.radial_grading = 0.5;
  small_problem::Mesh<dim> mesh(MPI_COMM_WORLD);
  TubeGeometry<dim> geometry(tube);
  geometry.note_fixed_boundaries({"wall inlet end"});
  geometry.create(mesh);
  Space<dim> space(mesh, SpaceParameters(),
                   dim == 2 ? Model::axisymmetric : Model::three_dimensional, 2);
  space.distribute();
  const DistributedVector velocity =
      small_problem::interpolated<dim>(space,
                                       [](const Point<dim> &x)
                                       {
                                         Point<dim> apex;
                                         apex[0] = -2.;
                                         const Tensor<1, dim> from_apex = x - apex;
                                         return from_apex / std::pow(from_apex.norm(), 3);
                                       });
  const double cosine = 1. / std::hypot(1., 0.25);
  const double solid_angle = 2. * numbers::PI * (1. - cosine) / copies;
  // The interpolation in the section costs 2e-3 in the few cells of three dimensions, the same
  // everywhere.
  const double first = flow<dim>(space, velocity, places.front(), {0});
  for (const double x : places)
  {
    const std::string name = "cone " + std::to_string(dim) + ", x = " + std::to_string(x);
    const double present = flow<dim>(space, velocity, x, {0});
    check::relative(name, present, solid_angle, dim == 2 ? 2e-4 : 2e-3);
    check::relative(name + ", beside the first", present, first, 1e-4);
  }
}
} // namespace

UNIT_TEST(section_flow)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  test_box<2>({8, 3}, {0., 0.3, 1., 2.9, 3., 3.25, 5.9, 7., 8.});
  test_box<3>({5, 2, 1}, {1., 3.3});
  test_few_cells();
  test_cone<2>(1., 20, {0.01, 0.5, 0.537, 1., 1.93, 2.});
  test_cone<3>(4., 8, {0.5, 0.6});
}
