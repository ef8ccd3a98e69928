#include <continua/finite_element/terms/follower_pressure.h>

#include <continua/finite_element/conditions/loads.h>
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
      quadrature(space.face_quadrature(space.n_quadrature_points() + 1))
{
}

template <int dim>
void FollowerPressure<dim>::reinit()
{
  faces_of_cells.clear();
  const FiniteElement<dim> &element = space.scalar_element();
  FEFaceValues<dim> values(space.mapping, element, quadrature,
                           update_values | update_gradients | update_quadrature_points |
                               update_normal_vectors | update_JxW_values);
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (cell->is_locally_owned() && cell->at_boundary())
      for (const unsigned int f : cell->face_indices())
      {
        unsigned int n_cavities = 0;
        for (const BoundaryCondition &condition : problem.conditions)
        {
          const int cavity = condition.is_cavity() ? static_cast<int>(n_cavities++) : -1;
          const bool is_on_liquid = !problem.materials[cell->material_id()].is_solid();
          if (!cell->face(f)->at_boundary() ||
              cell->face(f)->boundary_id() != condition.boundary_id ||
              condition.region_ids.count(cell->material_id()) == 0)
            continue;
          if (cavity < 0 && !acts(condition, is_on_liquid))
            continue;
          values.reinit(static_cast<typename Triangulation<dim>::active_cell_iterator>(cell), f);
          faces_of_cells[number_of(cell)].push_back(
              {&condition, cavity, is_on_liquid, deformed_face_points(space, values)});
        }
      }
}

template <int dim>
bool FollowerPressure<dim>::acts(const BoundaryCondition &condition, const bool is_on_liquid)
{
  const auto has_vector = [](const BoundaryPart &part)
  { return part.kind == BoundaryPart::Kind::traction && !part.vector.empty(); };
  const BoundaryPart &normal = condition.normal;
  if (normal.kind == BoundaryPart::Kind::traction && (normal.negative || is_on_liquid) &&
      !normal.along_normal.is_zero())
    return true;
  return is_on_liquid && (has_vector(normal) || has_vector(condition.tangential));
}

template <int dim>
Tensor<1, dim> FollowerPressure<dim>::force_on_liquid(const DeformedFacePoint<dim> &point,
                                                      const Face &face,
                                                      const Step &step,
                                                      const Vector<double> &displacement) const
{
  const auto force = [&](const Point<dim> &place, const Tensor<1, 3> &area)
  {
    Tensor<1, dim> normal;
    for (unsigned int c = 0; c < dim; ++c)
      normal[c] = area[c] / area.norm();
    return step.load_factor * area.norm() *
           Loads<dim>::prescribed_traction(*face.condition, place, normal, step.balance_time);
  };
  return force(point.place + point.way(displacement),
               point.kinematics(displacement).area(point.area)) -
         force(point.place, point.area);
}

template <int dim>
double FollowerPressure<dim>::pressure_at(const DeformedFacePoint<dim> &point,
                                          const Face &face,
                                          const Step &step) const
{
  if (face.cavity >= 0)
    return cavity_pressures[face.cavity];
  return step.load_factor *
         face.condition->normal.along_normal(coordinates(point.place).data(), step.balance_time);
}

template <int dim>
void FollowerPressure<dim>::add(const Cell &cell,
                                const Step &step,
                                const Vector<double> &displacement,
                                Vector<double> &forces) const
{
  for (const Face &face : faces_of_cells.at(number_of(cell)))
    for (const DeformedFacePoint<dim> &point : face.points)
    {
      Tensor<1, dim> force;
      if (face.is_of_liquid && face.cavity < 0)
        force = force_on_liquid(point, face, step, displacement);
      else
      {
        Tensor<1, 3> area = point.kinematics(displacement).area(point.area);
        if (face.cavity < 0)
          area -= point.area;
        const double pressure = pressure_at(point, face, step);
        for (unsigned int c = 0; c < dim; ++c)
          force[c] = -pressure * area[c];
      }
      const unsigned int n_functions = point.n_functions();
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
    for (const DeformedFacePoint<dim> &point : face.points)
    {
      const Kinematics motion = point.kinematics(displacement);
      const Tensor<1, 3> area = motion.area(point.area);
      const double pressure = factor * pressure_at(point, face, step);
      const unsigned int n_functions = point.n_functions();
      for (unsigned int b = 0; b < n_functions; ++b)
      {
        const std::array<Tensor<1, 3>, dim> changes = point.area_derivatives(motion, area, b);
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int a = 0; a < n_functions; ++a)
              matrix(c * n_functions + a, d * n_functions + b) +=
                  pressure * point.values[a] * changes[d][c];
      }
    }
}

template class FollowerPressure<2>;
template class FollowerPressure<3>;
} // namespace Continua
