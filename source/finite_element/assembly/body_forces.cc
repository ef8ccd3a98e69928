#include <continua/finite_element/assembly/body_forces.h>

#include <continua/finite_element/conditions/following_loads.h>

#include <cstddef>

namespace Continua
{
using namespace dealii;

namespace
{
/// Over the size of a cell: that of a difference of two forces.
constexpr double difference_share = 1e-5;
} // namespace

template <int dim>
BodyForces<dim>::BodyForces(const Space<dim> &space,
                            const Problem &problem,
                            const QuadratureCells<dim> &cells,
                            const Quadrature<dim> &quadrature)
    : problem(problem),
      cells(cells),
      depends_on_space(body_force_depends_on_space(problem.interior)),
      places(space.mapping,
             space.velocity_element.base_element(0),
             quadrature,
             update_quadrature_points)
{
}

template <int dim>
bool BodyForces<dim>::visit(const Cell &cell,
                            const Step &of_state,
                            const Vector<double> &displacement)
{
  if (!body_force_follows(problem, cell.region))
    return false;
  present = &cell;
  step = of_state;
  displacements = &displacement;
  if (depends_on_space)
    places.reinit(
        static_cast<typename Triangulation<dim>::active_cell_iterator>(cell.velocity_cell));
  return true;
}

template <int dim>
Point<dim> BodyForces<dim>::place(const unsigned int q) const
{
  if (!depends_on_space)
    return Point<dim>();
  const std::size_t n_functions = cells.n_functions();
  Point<dim> sum = places.quadrature_point(q);
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int a = 0; a < n_functions; ++a)
      sum[c] += (*displacements)[c * n_functions + a] * cells.values(q)[a];
  return sum;
}

template <int dim>
Tensor<1, dim> BodyForces<dim>::force(const Point<dim> &place) const
{
  return body_force_at(problem, present->region, place, step);
}

template <int dim>
BodyForcePoint<dim> BodyForces<dim>::point(const unsigned int q) const
{
  BodyForcePoint<dim> result;
  result.force = force(place(q));
  return result;
}

template <int dim>
BodyForcePoint<dim> BodyForces<dim>::point_with_slope(const unsigned int q,
                                                      const double displacement_by_velocity) const
{
  BodyForcePoint<dim> result = point(q);
  result.displacement_by_velocity = displacement_by_velocity;
  const Point<dim> here = place(q);
  const double size = difference_share * present->size;
  for (unsigned int d = 0; d < dim; ++d)
  {
    const Tensor<1, dim> side = size * Point<dim>::unit_vector(d),
                         change = force(here + side) - force(here - side);
    for (unsigned int c = 0; c < dim; ++c)
      result.slope[c][d] = change[c] / (2. * size);
  }
  return result;
}

template class BodyForces<2>;
template class BodyForces<3>;
} // namespace Continua
