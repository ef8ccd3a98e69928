#include <continua/finite_element/motion/present_cell_point.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <array>
#include <vector>

namespace Continua
{
using namespace dealii;

namespace
{
/// Whether the box around the displaced vertices is near; a curved cell may reach beyond it.
template <int dim>
bool is_near(const typename DoFHandler<dim>::active_cell_iterator &cell,
             const DistributedVector &displacement,
             const Point<dim> &point)
{
  for (unsigned int c = 0; c < dim; ++c)
  {
    const auto place = [&](const unsigned int v)
    { return cell->vertex(v)[c] + displacement(cell->vertex_dof_index(v, c)); };
    double lower = place(0), upper = lower;
    for (unsigned int v = 1; v < cell->n_vertices(); ++v)
    {
      lower = std::min(lower, place(v));
      upper = std::max(upper, place(v));
    }
    const double margin = 0.5 * std::max(upper - lower, cell->diameter());
    if (point[c] < lower - margin || point[c] > upper + margin)
      return false;
  }
  return true;
}
} // namespace

template <int dim>
bool cell_holds_present_point(const Space<dim> &space,
                              const typename DoFHandler<dim>::active_cell_iterator &cell,
                              const DistributedVector &displacement,
                              const Point<dim> &point,
                              Point<dim> &unit_point)
{
  constexpr double tolerance = 1e-8, least_step = 1e-13, largest_distance = 1.;
  constexpr unsigned int most_steps = 30;
  if (!is_near(cell, displacement, point))
    return false;
  // Newton's iteration for X(xi) + d(xi) = x.
  Point<dim> candidate;
  for (unsigned int c = 0; c < dim; ++c)
    candidate[c] = 0.5;
  for (unsigned int step = 0; step < most_steps; ++step)
  {
    FEValues<dim> values(space.mapping, space.velocity_element, Quadrature<dim>(candidate),
                         update_values | update_gradients | update_quadrature_points |
                             update_inverse_jacobians);
    values.reinit(cell);
    std::vector<Vector<double>> of_point(1, Vector<double>(dim));
    std::vector<std::vector<Tensor<1, dim>>> slopes(1, std::vector<Tensor<1, dim>>(dim));
    values.get_function_values(displacement, of_point);
    values.get_function_gradients(displacement, slopes);
    Tensor<1, dim> rest = point - values.quadrature_point(0);
    Tensor<2, dim> gradient;
    for (unsigned int c = 0; c < dim; ++c)
    {
      rest[c] -= of_point[0][c];
      gradient[c] = slopes[0][c];
      gradient[c][c] += 1.;
    }
    const Tensor<2, dim> inverse_jacobian = values.inverse_jacobian(0);
    const Tensor<1, dim> change = inverse_jacobian * (invert(gradient) * rest);
    candidate += change;
    // Nothing is known of a motion far outside of the cell.
    if (!(GeometryInfo<dim>::distance_to_unit_cell(candidate) < largest_distance))
      return false;
    if (change.norm() < least_step)
      break;
  }
  if (!GeometryInfo<dim>::is_inside_unit_cell(candidate, tolerance))
    return false;
  unit_point = GeometryInfo<dim>::project_to_unit_cell(candidate);
  return true;
}

template bool cell_holds_present_point(const Space<2> &,
                                       const DoFHandler<2>::active_cell_iterator &,
                                       const DistributedVector &,
                                       const Point<2> &,
                                       Point<2> &);
template bool cell_holds_present_point(const Space<3> &,
                                       const DoFHandler<3>::active_cell_iterator &,
                                       const DistributedVector &,
                                       const Point<3> &,
                                       Point<3> &);
} // namespace Continua
