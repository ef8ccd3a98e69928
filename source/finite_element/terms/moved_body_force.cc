#include <continua/finite_element/terms/moved_body_force.h>

#include <continua/mesh/coordinates.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace Continua
{
using namespace dealii;

namespace
{
/// Over the size of a cell: that of a difference of two forces.
constexpr double difference_share = 1e-5;

bool some_depend_on_space(const InteriorData &interior)
{
  const auto depends = [](const Waveform &component) { return component.depends_on_space(); };
  return std::any_of(interior.acceleration.begin(), interior.acceleration.end(), depends) ||
         std::any_of(interior.body_force.begin(), interior.body_force.end(), depends);
}
} // namespace

template <int dim>
MovedBodyForce<dim>::MovedBodyForce(const Space<dim> &space,
                                    const Problem &problem,
                                    const Quadrature<dim> &quadrature)
    : problem(problem),
      depends_on_space(some_depend_on_space(problem.interior)),
      places(space.mapping,
             space.velocity_element.base_element(0),
             quadrature,
             update_quadrature_points)
{
}

template <int dim>
bool MovedBodyForce<dim>::has_changes(const unsigned int region) const
{
  if (!problem.is_deformed(region))
    return false;
  // The matter of a solid keeps its mass and its volume at rest.
  return depends_on_space ||
         (!problem.materials[region].is_solid() &&
          (!problem.interior.acceleration.empty() || !problem.interior.body_force.empty()));
}

template <int dim>
Tensor<1, dim> MovedBodyForce<dim>::density(const unsigned int region,
                                            const Point<dim> &place,
                                            const Step &step) const
{
  const std::array<double, 3> x = coordinates(place);
  Tensor<1, dim> sum;
  for (unsigned int c = 0; c < problem.interior.acceleration.size(); ++c)
    sum[c] += problem.materials[region].density *
              problem.interior.acceleration[c](x.data(), step.balance_time);
  for (unsigned int c = 0; c < problem.interior.body_force.size(); ++c)
    sum[c] += problem.interior.body_force[c](x.data(), step.balance_time);
  return step.load_factor * sum;
}

template <int dim>
Tensor<1, dim> MovedBodyForce<dim>::way(const QuadratureCells<dim> &cells,
                                        const unsigned int q,
                                        const Vector<double> &displacement)
{
  const std::size_t n_functions = cells.n_functions();
  Tensor<1, dim> sum;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int a = 0; a < n_functions; ++a)
      sum[c] += displacement[c * n_functions + a] * cells.values(q)[a];
  return sum;
}

template <int dim>
void MovedBodyForce<dim>::add(const QuadratureCells<dim> &cells,
                              const Cell &cell,
                              const std::vector<typename Cell::Point> &present,
                              const Step &step,
                              const Vector<double> &displacement,
                              Vector<double> &forces)
{
  if (depends_on_space)
    places.reinit(
        static_cast<typename Triangulation<dim>::active_cell_iterator>(cell.velocity_cell));
  const std::size_t n_functions = cells.n_functions();
  for (unsigned int q = 0; q < cells.n_points(); ++q)
  {
    const Point<dim> at_rest = depends_on_space ? places.quadrature_point(q) : Point<dim>();
    const Tensor<1, dim> rest = density(cell.region, at_rest, step),
                         here =
                             depends_on_space
                                 ? density(cell.region, at_rest + way(cells, q, displacement), step)
                                 : rest,
                         change = present[q].weight * here - cell.points[q].weight * rest;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int a = 0; a < n_functions; ++a)
        forces[c * n_functions + a] += change[c] * cells.values(q)[a];
  }
}

template <int dim>
void MovedBodyForce<dim>::subtract_derivative(const QuadratureCells<dim> &cells,
                                              const Cell &cell,
                                              const Step &step,
                                              const Vector<double> &displacement,
                                              const double factor,
                                              FullMatrix<double> &matrix)
{
  places.reinit(static_cast<typename Triangulation<dim>::active_cell_iterator>(cell.velocity_cell));
  const std::size_t n_functions = cells.n_functions();
  const double size = difference_share * cell.size;
  for (unsigned int q = 0; q < cells.n_points(); ++q)
  {
    const double *const values = cells.values(q);
    const Point<dim> here = places.quadrature_point(q) + way(cells, q, displacement);
    for (unsigned int d = 0; d < dim; ++d)
    {
      const Tensor<1, dim> side = size * Point<dim>::unit_vector(d),
                           slope = (density(cell.region, here + side, step) -
                                    density(cell.region, here - side, step)) /
                                   (2. * size);
      for (unsigned int c = 0; c < dim; ++c)
      {
        const double of_point = -factor * cell.points[q].weight * slope[c];
        for (unsigned int a = 0; a < n_functions; ++a)
          for (unsigned int b = 0; b < n_functions; ++b)
            matrix(c * n_functions + a, d * n_functions + b) += of_point * values[a] * values[b];
      }
    }
  }
}

template class MovedBodyForce<2>;
template class MovedBodyForce<3>;
} // namespace Continua
