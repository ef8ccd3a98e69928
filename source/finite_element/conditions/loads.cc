#include <continua/finite_element/conditions/loads.h>

#include <continua/finite_element/conditions/following_loads.h>
#include <continua/mesh/cells_in_tree_order.h>
#include <continua/mesh/coordinates.h>

#include <deal.II/fe/fe_values.h>

namespace Continua
{
using namespace dealii;

namespace
{
/// The part of a Cartesian vector that one half of a condition uses.
template <int dim>
Tensor<1, dim>
own_part(const Tensor<1, dim> &vector, const Tensor<1, dim> &normal, const bool normal_part)
{
  const Tensor<1, dim> along = (vector * normal) * normal;
  return normal_part ? along : vector - along;
}

template <typename Cell>
bool has_condition(const Cell &cell, const unsigned int face, const BoundaryCondition &condition)
{
  return cell->face(face)->at_boundary() &&
         cell->face(face)->boundary_id() == condition.boundary_id &&
         condition.region_ids.count(cell->material_id()) > 0;
}
} // namespace

template <int dim>
bool Loads<dim>::is_term(const Item &item, const unsigned int region) const
{
  if (item.waveform == nullptr)
    return false;
  if (item.condition < 0)
    return body_force_follows(problem, region);
  const BoundaryCondition &condition = problem.conditions[item.condition];
  return traction_follows(problem, region,
                          item.normal_part ? condition.normal : condition.tangential,
                          item.component < 0);
}

template <int dim>
void Loads<dim>::integrate(const Item &item,
                           const Waveform *waveform,
                           const double time,
                           DistributedVector &forces) const
{
  const unsigned int n_velocity = space.velocity_element.n_dofs_per_cell();
  // Loads are given functions, so one point more than the operators have.
  const Quadrature<dim> cell_quadrature = space.quadrature(space.n_quadrature_points() + 1);
  const Quadrature<dim - 1> face_quadrature =
      space.face_quadrature(space.n_quadrature_points() + 1);
  const UpdateFlags flags = update_values | update_quadrature_points | update_JxW_values;
  FEValues<dim> cell_values(space.mapping, space.velocity_element, cell_quadrature, flags);
  FEFaceValues<dim> face_values(space.mapping, space.velocity_element, face_quadrature,
                                flags | update_normal_vectors);
  Vector<double> local(n_velocity);
  std::vector<types::global_dof_index> indices(n_velocity);

  // Adds the integral over what `values` is initialised to.
  const auto add_integral = [&](const FEValuesBase<dim> &values, const double density)
  {
    for (const unsigned int q : values.quadrature_point_indices())
    {
      Tensor<1, dim> direction;
      if (item.component >= 0)
        direction[item.component] = 1.;
      if (item.condition >= 0)
        direction = item.component < 0
                        ? values.normal_vector(q)
                        : own_part(direction, values.normal_vector(q), item.normal_part);
      const Point<dim> &point = values.quadrature_point(q);
      const double amplitude =
          waveform == nullptr ? 1. : (*waveform)(coordinates(point).data(), time);
      direction *= item.sign * density * amplitude * values.JxW(q) * space.circumference(point);
      for (unsigned int i = 0; i < n_velocity; ++i)
        local[i] += values.shape_value(i, q) *
                    direction[space.velocity_element.system_to_component_index(i).first];
    }
  };
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (cell->is_locally_owned() && acts_on(cell->material_id()) &&
        !is_term(item, cell->material_id()))
    {
      bool touched = false;
      if (item.condition < 0)
      {
        local = 0.;
        cell_values.reinit(cell);
        add_integral(cell_values,
                     item.times_density ? problem.materials[cell->material_id()].density : 1.);
        touched = true;
      }
      else if (cell->at_boundary())
      {
        const BoundaryCondition &condition = problem.conditions[item.condition];
        local = 0.;
        for (const unsigned int f : cell->face_indices())
          if (has_condition(cell, f, condition))
          {
            face_values.reinit(cell, f);
            add_integral(face_values, 1.);
            touched = true;
          }
      }
      if (touched)
      {
        cell->get_dof_indices(indices);
        space.velocity_hanging.distribute_local_to_global(local, indices, forces);
      }
    }
  forces.compress(VectorOperation::add);
}

template <int dim>
DistributedVector Loads<dim>::flow_of_velocities(const unsigned int condition) const
{
  DistributedVector flow = space.velocity_vector();
  integrate(LoadList::along_normal(condition), nullptr, 0., flow);
  return flow;
}

template <int dim>
std::vector<std::array<double, 3>> Loads<dim>::places(const Item &item) const
{
  std::vector<std::array<double, 3>> points;
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (cell->is_locally_owned() && acts_on(cell->material_id()))
    {
      if (item.condition < 0)
        points.push_back(coordinates(cell->center()));
      else
        for (const unsigned int f : cell->face_indices())
          if (has_condition(cell, f, problem.conditions[item.condition]))
            points.push_back(coordinates(cell->face(f)->center()));
    }
  return points;
}

template <int dim>
Tensor<1, dim> Loads<dim>::prescribed_traction(const BoundaryCondition &condition,
                                               const Point<dim> &point,
                                               const Tensor<1, dim> &normal,
                                               const double time)
{
  Tensor<1, dim> traction;
  const auto x = coordinates(point);
  for (const bool normal_part : {true, false})
  {
    const BoundaryPart &part = normal_part ? condition.normal : condition.tangential;
    if (part.kind != BoundaryPart::Kind::traction)
      continue;
    Tensor<1, dim> vector;
    for (unsigned int c = 0; c < part.vector.size(); ++c)
      vector[c] = part.vector[c](x.data(), time);
    traction += own_part(vector, normal, normal_part);
    if (normal_part)
      traction += (part.negative ? -1. : 1.) * part.along_normal(x.data(), time) * normal;
  }
  return traction;
}

template class Loads<2>;
template class Loads<3>;
} // namespace Continua
