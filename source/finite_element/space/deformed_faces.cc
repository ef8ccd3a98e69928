#include <continua/finite_element/space/deformed_faces.h>

#include <continua/mesh/cells_in_tree_order.h>

#include <deal.II/fe/fe_values.h>

#include <cstddef>

namespace Continua
{
using namespace dealii;

namespace
{
template <int dim>
typename DeformedFaces<dim>::SetOfFace set_of_condition(const Problem &problem,
                                                        const std::vector<unsigned int> &conditions)
{
  if (conditions.empty())
    return {};
  return [&problem, conditions](const typename DeformedFaces<dim>::Cell &cell, const unsigned int f)
  {
    for (unsigned int number = 0; number < conditions.size(); ++number)
    {
      const BoundaryCondition &condition = problem.conditions[conditions[number]];
      if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == condition.boundary_id &&
          condition.region_ids.count(cell->material_id()) > 0)
        return static_cast<int>(number);
    }
    return -1;
  };
}
} // namespace

template <int dim>
DeformedFaces<dim>::DeformedFaces(const Space<dim> &space,
                                  const Problem &problem,
                                  const std::vector<unsigned int> &conditions)
    : DeformedFaces(space, set_of_condition<dim>(problem, conditions))
{
}

template <int dim>
DeformedFaces<dim>::DeformedFaces(const Space<dim> &space, const SetOfFace &set_of_face)
    : space(space),
      set_of_face(set_of_face),
      quadrature(space.face_quadrature(space.n_quadrature_points() + 1))
{
}

template <int dim>
void DeformedFaces<dim>::reinit()
{
  faces.clear();
  if (!set_of_face)
    return;
  ghosted.reinit(space.velocity_owned, space.velocity_relevant, space.communicator);
  const FiniteElement<dim> &element = space.scalar_element();
  const std::size_t n_functions = element.n_dofs_per_cell();
  of_cell.reinit(dim * n_functions);
  FEFaceValues<dim> values(space.mapping, element, quadrature,
                           update_values | update_gradients | update_quadrature_points |
                               update_normal_vectors | update_JxW_values);
  std::vector<types::global_dof_index> indices(dim * n_functions);
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
  {
    if (!cell->is_locally_owned())
      continue;
    for (const unsigned int f : cell->face_indices())
    {
      const int number = set_of_face(cell, f);
      if (number < 0)
        continue;
      values.reinit(static_cast<typename Triangulation<dim>::active_cell_iterator>(cell), f);
      faces.push_back(
          {static_cast<unsigned int>(number), indices, deformed_face_points(space, values)});
      cell->get_dof_indices(indices);
      for (unsigned int i = 0; i < indices.size(); ++i)
      {
        const auto [component, function] = space.velocity_element.system_to_component_index(i);
        faces.back().indices[component * n_functions + function] = indices[i];
      }
    }
  }
}

template <int dim>
void DeformedFaces<dim>::take(const DistributedVector &displacement)
{
  space.copy_velocity(displacement, ghosted);
}

template <int dim>
const Vector<double> &DeformedFaces<dim>::displacement_of(const Face &face)
{
  for (unsigned int i = 0; i < face.indices.size(); ++i)
    of_cell[i] = ghosted(face.indices[i]);
  return of_cell;
}

template <int dim>
void DeformedFaces<dim>::set_flow(const unsigned int number, DistributedVector &flow)
{
  flow = 0.;
  Vector<double> of_face(of_cell.size());
  for (const Face &face : faces)
  {
    if (face.number != number)
      continue;
    displacement_of(face);
    of_face = 0.;
    for (const DeformedFacePoint<dim> &point : face.points)
    {
      const Tensor<1, 3> area = point.kinematics(of_cell).area(point.area);
      const unsigned int n_functions = point.n_functions();
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int a = 0; a < n_functions; ++a)
          of_face[c * n_functions + a] += area[c] * point.values[a];
    }
    space.velocity_hanging.distribute_local_to_global(of_face, face.indices, flow);
  }
  flow.compress(VectorOperation::add);
}

template class DeformedFaces<2>;
template class DeformedFaces<3>;
} // namespace Continua
