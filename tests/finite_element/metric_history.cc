// The memory of solids that relax in finite deformation: a step by hand, values at any point, and
// refining and coarsening, which keep polynomials and positive tensors.

#include <continua/finite_element/assembly/metric_history.h>

#include <continua/continuum/state_vectors.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>
#include <functional>
#include <limits>

#include "../unit_test.h"
#include "small_problem.h"

namespace test_of_metric_history
{
using namespace Continua;
using namespace dealii;

namespace
{
using Metric = SymmetricTensor<2, 3>;

/// The second region relaxes, by two branches.
Problem make_problem()
{
  Problem problem;
  problem.deformation = Deformation::finite;
  problem.regions = {"stays", "relaxes"};
  problem.materials.resize(2);
  problem.materials[0].shear.branches = {{1., std::numeric_limits<double>::infinity()}};
  problem.materials[1].shear.branches = {
      {1., std::numeric_limits<double>::infinity()}, {2., 0.5}, {3., 0.25}};
  return problem;
}

/// Positive definite, and of the second degree in each coordinate.
template <int dim>
Metric metric_at(const Point<dim> &x)
{
  Metric result = 2. * unit_symmetric_tensor<3>();
  result[0][0] += 0.1 * x[0] * x[0] * x[1];
  result[1][1] += 0.1 * x[1] * x[1];
  result[2][2] += 0.05 * x[dim - 1] * x[dim - 1] * x[0];
  result[0][1] += 0.1 * x[0] - 0.02 * x[0] * x[0] * x[1] * x[1];
  if (dim == 3)
  {
    result[0][2] += 0.1 * x[2] * x[1];
    result[1][2] -= 0.05 * x[2] * x[2];
  }
  return result;
}

template <int dim>
void for_each_point(const Space<dim> &space,
                    const std::function<void(const typename Triangulation<dim>::cell_iterator &,
                                             unsigned int,
                                             const Point<dim> &)> &visit)
{
  FEValues<dim> values(space.mapping, space.velocity_element,
                       QGauss<dim>(space.n_quadrature_points()), update_quadrature_points);
  for (const auto &cell : space.triangulation.active_cell_iterators())
    if (cell->is_locally_owned() && cell->material_id() == 1)
    {
      values.reinit(cell);
      for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
        visit(cell, q, values.quadrature_point(q));
    }
}

template <int dim>
void give_sizes(const Space<dim> &space, MetricHistory<dim> &history)
{
  const DistributedVector velocity = space.velocity_vector(), pressure = space.pressure_vector(),
                          metric = history.vector();
  StateSizes sizes(velocity, pressure, metric, metric);
  history.visit(sizes);
}

/// The largest difference of sum mu_k A_k from a function, at the middle of the points and corners.
template <int dim>
double error_of(const Space<dim> &space,
                const MetricHistory<dim> &history,
                const std::function<Metric(const Point<dim> &)> &exact)
{
  const DistributedVector mixture = history.ghosted_mixture();
  double largest = 0.;
  for (const auto &cell : space.triangulation.active_cell_iterators())
    if (!cell->is_artificial())
    {
      Point<dim> unit_point;
      for (unsigned int c = 0; c < dim; ++c)
        unit_point[c] = 0.3 + 0.2 * c;
      const Metric value =
          MetricHistory<dim>::mixture_at(history.weights_at(cell, unit_point), mixture);
      const Metric expected =
          cell->material_id() == 1
              ? exact(space.mapping.transform_unit_to_real_cell(cell, unit_point))
              : Metric();
      largest = std::max(largest, (value - expected).norm());
    }
  return Utilities::MPI::max(largest, MPI_COMM_WORLD);
}

template <int dim>
void change_mesh(small_problem::Mesh<dim> &mesh,
                 Space<dim> &space,
                 MetricHistory<dim> &history,
                 const std::function<bool(const Point<dim> &)> &refines,
                 const bool coarsens)
{
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      if (refines(cell->center()))
        cell->set_refine_flag();
      else if (coarsens && cell->level() > 0)
        cell->set_coarsen_flag();
    }
  mesh.prepare_coarsening_and_refinement();
  StateVectors vectors;
  history.visit(vectors);
  history.prepare_transfer(vectors.internal_metrics);
  mesh.execute_coarsening_and_refinement();
  space.distribute();
  history.reinit();
  give_sizes(space, history);
  history.finish_transfer(vectors.internal_metrics);
}

template <int dim>
void test()
{
  const std::string name = std::to_string(dim) + "-D: ";
  small_problem::Mesh<dim> mesh(MPI_COMM_WORLD);
  std::vector<unsigned int> cells(dim, 2);
  small_problem::make_box<dim>(mesh, cells, Point<dim>(), 1.);
  Space<dim> space(mesh, SpaceParameters(),
                   dim == 2 ? Model::plane_strain : Model::three_dimensional, 2);
  space.distribute();
  const Problem problem = make_problem();
  const std::unique_ptr<MetricHistory<dim>> history = MetricHistory<dim>::make(space, problem);
  history->reinit();
  give_sizes(space, *history);
  check::is_true(name + "which regions relax", !history->relaxes(0) && history->relaxes(1));
  for_each_point<dim>(space, [&](const auto &cell, const unsigned int q, const Point<dim> &x)
                      { history->start(cell->active_cell_index(), q, metric_at<dim>(x)); });
  const auto relaxed = [](const Point<dim> &x) { return 5. * metric_at<dim>(x); };
  check::absolute(name + "at the start", error_of<dim>(space, *history, relaxed), 0., 1e-13);
  change_mesh<dim>(
      mesh, space, *history, [](const Point<dim> &x) { return x[0] > 1. && x[1] < 1.; }, false);
  check::is_true(name + "more cells", mesh.n_global_active_cells() > std::pow(2, dim));
  check::absolute(name + "refined", error_of<dim>(space, *history, relaxed), 0., 1e-13);
  change_mesh<dim>(
      mesh, space, *history, [](const Point<dim> &x) { return x[1] > 1.; }, true);
  check::absolute(name + "coarsened here, refined there", error_of<dim>(space, *history, relaxed),
                  0., 1e-12);

  // A step in which Cb^-1 becomes three times as large, at once: A_plus = A (e + g - e) and A_new =
  // A (g + 3 (1 - g)) with g = (1 - e)/x.
  const Step step = euler_step(0., 0.5, Update::implicit);
  history->predict(step);
  double of_step = 0., of_prediction = 0., largest = 0.;
  for (const Branch &branch : problem.materials[1].shear.branches)
    if (!std::isinf(branch.relaxation_time))
    {
      const double x = 0.5 / branch.relaxation_time, g = (1. - std::exp(-x)) / x;
      of_prediction += branch.shear_modulus * g;
      of_step += branch.shear_modulus * (3. - 2. * g);
    }
  for_each_point<dim>(
      space,
      [&](const auto &cell, const unsigned int q, const Point<dim> &x)
      {
        const unsigned int number = cell->active_cell_index();
        largest = std::max(
            largest, (history->predicted(number, q) - of_prediction * metric_at<dim>(x)).norm());
        history->advance(1, number, q, 3. * metric_at<dim>(x));
      });
  check::absolute(name + "prediction", Utilities::MPI::max(largest, MPI_COMM_WORLD), 0., 1e-12);
  check::absolute(name + "a step",
                  error_of<dim>(space, *history,
                                [&](const Point<dim> &x) { return of_step * metric_at<dim>(x); }),
                  0., 1e-12);

  // A tensor that is large in one child: the polynomial of the parent would not be positive.
  change_mesh<dim>(
      mesh, space, *history, [](const Point<dim> &x) { return x[0] > 1. && x[1] < 1.; }, false);
  const auto sharp = [](const Point<dim> &x)
  { return (x[0] < 1.5 && x[1] < 0.5 ? 100. : 0.01) * unit_symmetric_tensor<3>(); };
  const auto integral_and_least = [&]()
  {
    const DistributedVector mixture = history->ghosted_mixture();
    const QGauss<dim> quadrature(space.n_quadrature_points());
    double sum = 0., least = std::numeric_limits<double>::max();
    for_each_point<dim>(space,
                        [&](const auto &cell, const unsigned int q, const Point<dim> &)
                        {
                          const Metric value = MetricHistory<dim>::mixture_at(
                              history->weights_at(cell, quadrature.point(q)), mixture);
                          sum += cell->measure() * quadrature.weight(q) * trace(value);
                          least = std::min(least, eigenvalues(value)[2]);
                        });
    return std::make_pair(Utilities::MPI::sum(sum, MPI_COMM_WORLD),
                          Utilities::MPI::min(least, MPI_COMM_WORLD));
  };
  for_each_point<dim>(space, [&](const auto &cell, const unsigned int q, const Point<dim> &x)
                      { history->start(cell->active_cell_index(), q, sharp(x)); });
  const double before = integral_and_least().first;
  change_mesh<dim>(
      mesh, space, *history, [](const Point<dim> &) { return false; }, true);
  const auto [after, least] = integral_and_least();
  check::relative(name + "coarsened: the integral stays", after, before, 1e-12);
  check::is_true(name + "coarsened: positive definite", least > 0.);
}
} // namespace

UNIT_TEST(metric_history)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  test<2>();
  test<3>();
  Problem problem = make_problem();
  problem.deformation = Deformation::small;
  small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
  small_problem::make_box<2>(mesh, {1, 1});
  const Space<2> space(mesh, SpaceParameters(), Model::plane_strain, 2);
  check::is_true("none in small deformation", MetricHistory<2>::make(space, problem) == nullptr);
}
} // namespace test_of_metric_history
