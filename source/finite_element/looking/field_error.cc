#include <continua/finite_element/looking/field_error.h>

#include <continua/continuum/stress_and_strain.h>
#include <continua/finite_element/motion/kinematics_at.h>
#include <continua/mesh/cells_in_tree_order.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <utility>

namespace Continua
{
using namespace dealii;

template <int dim>
FieldError<dim>::FieldError(const Space<dim> &space,
                            const Problem &problem,
                            const State &state,
                            const ComparedField field,
                            std::vector<DistributedVector> vectors)
    : space(space),
      problem(problem),
      is_pressure(field == ComparedField::pressure),
      is_stress(field == ComparedField::stress),
      moves(state.mesh_displacement != nullptr && field != ComparedField::displacement),
      pressure(space.ghosted_pressure(state.pressure)),
      displacement(moves ? space.ghosted_velocity(*state.mesh_displacement) : DistributedVector()),
      vectors(std::move(vectors)),
      // Well above the degree of the fields, so that the number is the error and not the
      // quadrature's.
      quadrature(space.quadrature(space.degree() + 3)),
      values(space.mapping,
             space.velocity_element,
             quadrature,
             update_values | update_gradients | update_quadrature_points | update_JxW_values),
      hp_pressure_values(
          space.mappings, space.pressure_elements, hp::QCollection<dim>(quadrature), update_values),
      indices(space.velocity_element.n_dofs_per_cell()),
      displacements(quadrature.size(), Vector<double>(dim)),
      vector_values(quadrature.size(), Vector<double>(dim)),
      pressures(quadrature.size(), Vector<double>(space.pressure_elements.n_components())),
      gradients(quadrature.size(), std::vector<Tensor<1, dim>>(dim))
{
}

template <int dim>
void FieldError<dim>::take(const Cell &cell)
{
  const unsigned int region = cell->material_id();
  values.reinit(cell);
  if (is_pressure || is_stress)
  {
    hp_pressure_values.reinit(typename DoFHandler<dim>::active_cell_iterator(
        &space.triangulation, cell->level(), cell->index(), &space.pressure_dofs));
    hp_pressure_values.get_present_fe_values().get_function_values(pressure, pressures);
  }
  if (!is_pressure)
    values.get_function_values(vectors[is_stress ? region : 0], vector_values);
  if (is_stress)
    values.get_function_gradients(vectors[region], gradients);
  if (moves)
  {
    values.get_function_values(displacement, displacements);
    cell->get_dof_indices(indices);
  }
}

template <int dim>
std::array<double, 6> FieldError<dim>::components(const unsigned int region,
                                                  const unsigned int q) const
{
  std::array<double, 6> present = {{0., 0., 0., 0., 0., 0.}};
  const double p = pressures[q][space.pressure_component(region)];
  if (is_pressure)
    present[0] = problem.plane_stress(region).pressure_factor * p;
  else if (is_stress)
  {
    Tensor<2, dim> gradient;
    for (unsigned int c = 0; c < dim; ++c)
      gradient[c] = gradients[q][c];
    const double hoop =
        space.is_axisymmetric() ? vector_values[q][1] / values.quadrature_point(q)[1] : 0.;
    present = stress<dim>(gradient, hoop, p, problem.model);
  }
  else
    for (unsigned int c = 0; c < dim; ++c)
      present[c] = vector_values[q][c];
  return present;
}

template <int dim>
double FieldError<dim>::norm(const std::vector<Expression> &exact, const double time)
{
  double sum = 0.;
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (cell->is_locally_owned())
    {
      take(cell);
      for (const unsigned int q : values.quadrature_point_indices())
      {
        const Point<dim> &point = values.quadrature_point(q);
        Point<dim> moved = point;
        for (unsigned int c = 0; c < dim; ++c)
          moved[c] += displacements[q][c];
        const double stretch =
            moves ? kinematics_at(space, values, q, indices, displacement).volume_ratio() : 1.;
        const double square =
            squared_difference(components(cell->material_id(), q), exact, moved, time);
        sum += square * stretch * values.JxW(q) * space.circumference(point);
      }
    }
  return std::sqrt(Utilities::MPI::sum(sum, space.communicator));
}

template class FieldError<2>;
template class FieldError<3>;
} // namespace Continua
