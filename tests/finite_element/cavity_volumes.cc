// The volumes that cavities enclose: of spheres and circles, whole and in part, at rest and in
// affine motions; their derivative against differences; the power of a pressure is that of the
// volume where the motion keeps the planes that close the surface; on hanging nodes, in all models.

#include <continua/finite_element/assembly/deformation_terms.h>
#include <continua/finite_element/conditions/cavity_volumes.h>
#include <continua/materials/strain_law_types.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>

#include "../unit_test.h"
#include "powers_of_terms.h"
#include "small_problem.h"

namespace test_of_cavity_volumes
{
using namespace Continua;
using namespace dealii;

namespace
{
constexpr double inner = 0.8, outer = 1.3;

Problem make_problem(const Model model)
{
  Problem problem;
  problem.model = model;
  problem.deformation = Deformation::finite;
  problem.regions = {"body"};
  problem.materials.resize(1);
  Material &material = problem.materials[0];
  material.shear.branches = {{2., std::numeric_limits<double>::infinity()}};
  material.strain_law = make_strain_law(StrainLawParameters(), 2., 7.);
  BoundaryCondition condition;
  condition.type = BoundaryType::cavity;
  condition.boundary_id = 0;
  condition.region_ids = {0};
  problem.conditions.push_back(condition);
  return problem;
}

template <int dim>
using Motion = std::function<Tensor<1, dim>(const Point<dim> &)>;

/// No symmetry.
template <int dim>
Motion<dim> wave(const double size, const double phase)
{
  return [=](const Point<dim> &x)
  {
    Tensor<1, dim> value;
    for (unsigned int c = 0; c < dim; ++c)
      value[c] = size * std::sin(phase + 2. * c + (0.9 + 0.3 * c) * x[0] + 1.1 * x[dim - 1]);
    return value;
  };
}

/// The same where it keeps the planes through the origin.
template <int dim>
Motion<dim> wave_between_planes(const double size, const double phase)
{
  return [=](const Point<dim> &x)
  {
    Tensor<1, dim> value = wave<dim>(size, phase)(x);
    for (unsigned int c = 0; c < dim; ++c)
      value[c] *= x[c];
    return value;
  };
}

/// Three numbers: a stretch along each axis.
template <int dim>
Motion<dim> stretch()
{
  return [](const Point<dim> &x)
  {
    Tensor<1, dim> value;
    for (unsigned int c = 0; c < dim; ++c)
      value[c] = (0.3 - 0.4 * c) * x[c];
    return value;
  };
}

/// Whole shells are closed, parts of them are not. `volume`: at rest. A curved surface with hanging
/// nodes has gaps, so that there only the derivative is exact.
template <int dim>
void check_volume(const std::string &name,
                  const Model model,
                  const bool is_whole,
                  const double volume,
                  const bool hangs = false)
{
  small_problem::Mesh<dim> mesh(MPI_COMM_WORLD);
  if (is_whole)
    GridGenerator::hyper_shell(mesh, Point<dim>(), inner, outer, dim == 2 ? 8 : 6, true);
  else
    GridGenerator::quarter_hyper_shell(mesh, Point<dim>(), inner, outer, 0, true);
  mesh.refine_global(dim == 2 ? 2 : 1);
  if (hangs)
    small_problem::refine<dim>(mesh, [](const Point<dim> &x) { return x[0] > 0.7; });
  const Problem problem = make_problem(model);
  Space<dim> space(mesh, SpaceParameters(), model, 1);
  space.distribute();
  CavityVolumes<dim> cavities(space, problem);
  cavities.reinit();

  const auto volume_at = [&](const Motion<dim> &motion)
  { return cavities.volumes(small_problem::interpolated<dim>(space, motion)).at(0); };
  const double undeformed = volume_at([](const Point<dim> &) { return Tensor<1, dim>(); });
  check::relative(name + ": at rest", undeformed, volume, dim == 2 ? 1e-4 : 5e-3);
  // In axisymmetry the radial stretch counts for the circumference, too.
  const double of_stretch = model == Model::axisymmetric ? 1.3 * 0.9 * 0.9
                            : dim == 2                   ? 1.3 * 0.9
                                                         : 1.3 * 0.9 * 0.5;
  if (!hangs)
    check::relative(name + ": stretched", volume_at(stretch<dim>()) / undeformed, of_stretch,
                    1e-12);
  if (is_whole && !hangs)
    check::relative(name + ": moved",
                    volume_at([](const Point<dim> &) { return 3. * Point<dim>::unit_vector(1); }),
                    undeformed, 1e-12);

  const DistributedVector displacement = small_problem::interpolated<dim>(
                              space,
                              is_whole ? wave<dim>(0.15, 1.) : wave_between_planes<dim>(0.15, 1.)),
                          change = small_problem::interpolated<dim>(space, wave<dim>(1., 4.));
  DistributedVector derivative = space.velocity_vector(), force = space.velocity_vector();
  cavities.linearise(0, displacement, derivative, force);
  const double h = 1e-4;
  DistributedVector above = displacement, below = displacement;
  above.add(h, change);
  below.add(-h, change);
  const double difference =
      (cavities.volumes(above).at(0) - cavities.volumes(below).at(0)) / (2. * h);
  check::is_true(name + ": there is a derivative", std::abs(difference) > 1e-2);
  check::relative(name + ": derivative", derivative * change, difference, 1e-7);
  const DistributedVector kept =
      is_whole ? change : small_problem::interpolated<dim>(space, wave_between_planes<dim>(1., 4.));
  check::is_true(name + ": there is a power", std::abs(derivative * kept) > 1e-2);
  if (!hangs)
    check::relative(name + ": power of the pressure", force * kept, derivative * kept, 1e-10);

  // As a load of the equations.
  DeformationTerms<dim> terms(space, problem);
  terms.reinit();
  StepSolution state;
  state.step = euler_step(0., 0.3, Update::implicit);
  for (DistributedVector *const vector : {&state.velocity, &state.acceleration})
    *vector = space.velocity_vector();
  for (DistributedVector *const vector : {&state.pressure, &state.pressure_rate})
    *vector = space.pressure_vector();
  state.displacement = displacement;
  state.boundary_pressures = {2.5};
  DistributedVector loads = forces_of(terms, state);
  state.boundary_pressures = {0.};
  loads.add(-1., forces_of(terms, state), 2.5, force);
  check::absolute(name + ": load", loads.linfty_norm() / force.linfty_norm(), 0., 1e-12);
}
} // namespace

UNIT_TEST(cavity_volumes)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  const double pi = numbers::PI, circle = pi * inner * inner, sphere = 4. / 3. * circle * inner;
  check_volume<2>("circle", Model::plane_strain, true, circle);
  check_volume<2>("quarter of a circle", Model::plane_strain, false, circle / 4.);
  check_volume<2>("half a sphere by its section", Model::axisymmetric, false, sphere / 2.);
  check_volume<3>("sphere", Model::three_dimensional, true, sphere);
  check_volume<3>("octant of a sphere", Model::three_dimensional, false, sphere / 8.);
  check_volume<3>("sphere with hanging nodes", Model::three_dimensional, true, sphere, true);
}
} // namespace test_of_cavity_volumes
