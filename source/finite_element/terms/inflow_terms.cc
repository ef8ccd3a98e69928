#include <continua/continuum/kinematics.h>
#include <continua/finite_element/terms/inflow_terms.h>

#include <algorithm>
#include <utility>

namespace Continua
{
using namespace dealii;

template <int dim>
InflowTerms<dim>::InflowTerms(const Space<dim> &space, const Problem &problem)
    : space(space),
      problem(problem),
      scalar_element(space.scalar_element()),
      // Products of four functions.
      quadrature(space.face_quadrature(space.n_quadrature_points() + 2)),
      values(space.mapping,
             scalar_element,
             quadrature,
             update_values | update_gradients | update_quadrature_points | update_normal_vectors |
                 update_JxW_values),
      hp_pressure_values(space.mappings,
                         space.pressure_elements,
                         hp::QCollection<dim - 1>(quadrature),
                         update_values)
{
  for (const BoundaryCondition &condition : problem.conditions)
    if (problem.convection.is_on && condition.inflow_pressure == InflowPressure::total &&
        condition.normal.kind == BoundaryPart::Kind::traction)
      for (const unsigned int region : condition.region_ids)
        if (problem.region_model(region) == RegionModel::flow)
          ends.emplace_back(condition.boundary_id, region);
}

template <int dim>
bool InflowTerms<dim>::is_end(const Cell &cell, const unsigned int face) const
{
  return cell->face(face)->at_boundary() &&
         std::find(ends.begin(), ends.end(),
                   std::make_pair(cell->face(face)->boundary_id(), cell->material_id())) !=
             ends.end();
}

template <int dim>
bool InflowTerms<dim>::has_face(const Cell &cell) const
{
  if (ends.empty() || !cell->at_boundary())
    return false;
  for (const unsigned int face : cell->face_indices())
    if (is_end(cell, face))
      return true;
  return false;
}

template <int dim>
void InflowTerms<dim>::visit(const Cell &pressure_cell, const unsigned int face)
{
  values.reinit(static_cast<typename Triangulation<dim>::active_cell_iterator>(pressure_cell),
                face);
  hp_pressure_values.reinit(pressure_cell, face);
  pressure_values = &hp_pressure_values.get_present_fe_values();
}

template <int dim>
typename InflowTerms<dim>::Point
InflowTerms<dim>::point(const Cell &cell, const CellState<dim> &state, const unsigned int q) const
{
  const Material &material = problem.materials[cell->material_id()];
  const VolumeLaw law = material.volume_law();
  Point point;
  point.weight = values.JxW(q) * space.measure(values.quadrature_point(q));
  point.normal = values.normal_vector(q);
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int a = 0; a < state.n_functions(); ++a)
      point.velocity[c] += state.velocity[state.place(c, a)] * values.shape_value(a, q);
  double pressure = 0.;
  for (unsigned int k = 0; k < state.pressure.size(); ++k)
    pressure += state.pressure[k] * pressure_values->shape_value(k, q);
  point.density = material.density * law.density_ratio(pressure);
  point.density_slope = point.density * law.compressibility(pressure);
  double through = point.velocity * point.normal;
  if (state.mesh_displacement != nullptr)
    through = move(point, state, q);
  point.inflow = std::min(through, 0.);
  return point;
}

template <int dim>
double InflowTerms<dim>::move(Point &point, const CellState<dim> &state, const unsigned int q) const
{
  Tensor<2, dim> gradient;
  Tensor<1, dim> displacement, velocity;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int a = 0; a < state.n_functions(); ++a)
    {
      const double entry = (*state.mesh_displacement)[state.place(c, a)];
      gradient[c] += entry * values.shape_grad(a, q);
      displacement[c] += entry * values.shape_value(a, q);
      velocity[c] += (*state.mesh_velocity)[state.place(c, a)] * values.shape_value(a, q);
    }
  const double hoop =
      space.is_axisymmetric() ? displacement[1] / values.quadrature_point(q)[1] : 0.;
  Tensor<1, 3> area;
  for (unsigned int c = 0; c < dim; ++c)
    area[c] = point.weight * point.normal[c];
  area = Kinematics(whole_gradient<dim>(gradient, hoop)).area(area);
  point.weight = area.norm();
  for (unsigned int c = 0; c < dim; ++c)
    point.normal[c] = area[c] / point.weight;
  return (point.velocity - velocity) * point.normal;
}

template <int dim>
void InflowTerms<dim>::add(const Cell &pressure_cell,
                           const CellState<dim> &state,
                           Vector<double> &momentum)
{
  for (const unsigned int face : pressure_cell->face_indices())
    if (is_end(pressure_cell, face))
    {
      visit(pressure_cell, face);
      for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const Point here = point(pressure_cell, state, q);
        const Tensor<1, dim> force =
            -0.5 * here.weight * here.density * here.inflow * here.velocity;
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int a = 0; a < state.n_functions(); ++a)
            momentum[state.place(c, a)] += force[c] * values.shape_value(a, q);
      }
    }
}

template <int dim>
void InflowTerms<dim>::add_derivative(const Cell &pressure_cell,
                                      const CellState<dim> &state,
                                      FullMatrix<double> &matrix)
{
  const unsigned int n_scalar = state.n_functions(), n_velocity = state.velocity.size();
  for (const unsigned int face : pressure_cell->face_indices())
    if (is_end(pressure_cell, face))
    {
      visit(pressure_cell, face);
      for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const Point here = point(pressure_cell, state, q);
        if (here.inflow == 0.)
          continue;
        for (unsigned int a = 0; a < n_scalar; ++a)
        {
          const double test = -0.5 * here.weight * values.shape_value(a, q);
          for (unsigned int c = 0; c < dim; ++c)
          {
            const unsigned int i = state.place(c, a);
            for (unsigned int b = 0; b < n_scalar; ++b)
            {
              const double change = test * here.density * values.shape_value(b, q);
              for (unsigned int d = 0; d < dim; ++d)
                matrix(i, state.place(d, b)) +=
                    change * (here.normal[d] * here.velocity[c] + (c == d ? here.inflow : 0.));
            }
            for (unsigned int l = 0; l < state.pressure.size(); ++l)
              matrix(i, n_velocity + l) += test * here.density_slope * here.inflow *
                                           here.velocity[c] * pressure_values->shape_value(l, q);
          }
        }
      }
    }
}

template class InflowTerms<2>;
template class InflowTerms<3>;
} // namespace Continua
