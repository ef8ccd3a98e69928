#include <continua/finite_element/follower_pressure.h>

#include <continua/mesh/cells_in_tree_order.h>
#include <continua/mesh/coordinates.h>

#include <deal.II/fe/fe_values.h>

namespace Continua
{
using namespace dealii;

template <int dim>
FollowerPressure<dim>::FollowerPressure(const Space<dim> &space, const Problem &problem)
    : space(space),
      problem(problem),
      // As the loads of the body at rest, which are taken off.
      quadrature(space.n_quadrature_points() + 1)
{
}

template <int dim>
void FollowerPressure<dim>::reinit()
{
  faces_of_cells.clear();
  const FE_Q<dim> element(space.degree());
  FEFaceValues<dim> values(space.mapping, element, quadrature,
                           update_values | update_gradients | update_quadrature_points |
                               update_normal_vectors | update_JxW_values);
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (cell->is_locally_owned() && cell->at_boundary())
      for (const unsigned int f : cell->face_indices())
        for (const BoundaryCondition &condition : problem.conditions)
        {
          const BoundaryPart &part = condition.normal;
          if (!cell->face(f)->at_boundary() ||
              cell->face(f)->boundary_id() != condition.boundary_id ||
              condition.region_ids.count(cell->material_id()) == 0 ||
              part.kind != BoundaryPart::Kind::traction || !part.negative ||
              part.along_normal.is_zero())
            continue;
          values.reinit(static_cast<typename Triangulation<dim>::active_cell_iterator>(cell), f);
          Face face;
          face.part = &part;
          face.points.resize(quadrature.size());
          for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            Point &point = face.points[q];
            point.place = values.quadrature_point(q);
            const double size = values.JxW(q) * space.measure(point.place);
            for (unsigned int c = 0; c < dim; ++c)
              point.area[c] = size * values.normal_vector(q)[c];
            point.hoop = space.is_axisymmetric() ? 1. / point.place[1] : 0.;
            for (unsigned int a = 0; a < element.n_dofs_per_cell(); ++a)
            {
              point.values.push_back(values.shape_value(a, q));
              point.gradients.push_back(values.shape_grad(a, q));
            }
          }
          faces_of_cells[number_of(cell)].push_back(face);
        }
}

template <int dim>
Kinematics FollowerPressure<dim>::kinematics(const Point &point, const Vector<double> &displacement)
{
  const unsigned int n_functions = point.values.size();
  Tensor<2, dim> gradient;
  double radial = 0.;
  for (unsigned int a = 0; a < n_functions; ++a)
  {
    for (unsigned int c = 0; c < dim; ++c)
      gradient[c] += displacement[c * n_functions + a] * point.gradients[a];
    radial += displacement[n_functions + a] * point.values[a];
  }
  return Kinematics(whole_gradient<dim>(gradient, radial * point.hoop));
}

template <int dim>
double FollowerPressure<dim>::pressure_at(const Point &point, const Face &face, const Step &step)
{
  return step.load_factor *
         face.part->along_normal(coordinates(point.place).data(), step.balance_time);
}

template <int dim>
void FollowerPressure<dim>::add(const Cell &cell,
                                const Step &step,
                                const Vector<double> &displacement,
                                Vector<double> &forces) const
{
  for (const Face &face : faces_of_cells.at(number_of(cell)))
    for (const Point &point : face.points)
    {
      const Kinematics motion = kinematics(point, displacement);
      const Tensor<1, 3> force =
          -pressure_at(point, face, step) * (motion.area(point.area) - point.area);
      const unsigned int n_functions = point.values.size();
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int a = 0; a < n_functions; ++a)
          forces[c * n_functions + a] += force[c] * point.values[a];
    }
}

template <int dim>
void FollowerPressure<dim>::subtract_derivative(const Cell &cell,
                                                const Step &step,
                                                const Vector<double> &displacement,
                                                const double factor,
                                                FullMatrix<double> &matrix) const
{
  for (const Face &face : faces_of_cells.at(number_of(cell)))
    for (const Point &point : face.points)
    {
      const Kinematics motion = kinematics(point, displacement);
      const Tensor<1, 3> area = motion.area(point.area);
      const double pressure = factor * pressure_at(point, face, step);
      const unsigned int n_functions = point.values.size();
      for (unsigned int b = 0; b < n_functions; ++b)
      {
        // The gradient of a shape function by the present place.
        const Tensor<2, 3> whole = [&]()
        {
          Tensor<2, 3> by_reference;
          for (unsigned int c = 0; c < dim; ++c)
            by_reference[0][c] = point.gradients[b][c];
          return motion.gradient(by_reference);
        }();
        const Tensor<1, 3> slope = whole[0];
        const double hoop = point.values[b] * point.hoop * motion.inverse()[2][2];
        for (unsigned int d = 0; d < dim; ++d)
        {
          // d(n da) = div(du) n da - (grad du)^T n da.
          const double divergence = slope[d] + (d == 1 ? hoop : 0.);
          Tensor<1, 3> change = divergence * area;
          change -= area[d] * slope;
          if (d == 1)
            change[2] -= hoop * area[2];
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int a = 0; a < n_functions; ++a)
              matrix(c * n_functions + a, d * n_functions + b) +=
                  pressure * point.values[a] * change[c];
        }
      }
    }
}

template class FollowerPressure<2>;
template class FollowerPressure<3>;
} // namespace Continua
