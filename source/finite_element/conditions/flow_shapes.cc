#include <continua/finite_element/conditions/flow_shapes.h>

#include <continua/mesh/cells_in_tree_order.h>
#include <continua/mesh/coordinates.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_values.h>

namespace Continua
{
using namespace dealii;

template <int dim>
std::map<types::global_dof_index, std::vector<double>>
nodal_flow_shapes(const Space<dim> &space, const BoundaryCondition &condition)
{
  const FlowProfile &profile = *condition.normal.flow;
  const FiniteElement<dim> &scalar_element = space.scalar_element();
  const Quadrature<dim - 1> nodes_of_face(scalar_element.get_unit_face_support_points());
  FEFaceValues<dim> node_values(space.mapping, scalar_element, nodes_of_face,
                                update_quadrature_points);
  FEFaceValues<dim> values(space.mapping, space.velocity_element,
                           space.face_quadrature(space.n_quadrature_points() + 1),
                           update_values | update_quadrature_points | update_JxW_values);
  std::vector<types::global_dof_index> face_dofs(space.velocity_element.n_dofs_per_face());
  std::vector<types::global_dof_index> cell_dofs(space.velocity_element.n_dofs_per_cell());
  Vector<double> local(cell_dofs.size());

  std::map<types::global_dof_index, std::vector<double>> shapes;
  // What a unit velocity along x at a node lets through.
  DistributedVector flow_of_node = space.velocity_vector();
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (!cell->is_artificial() && cell->at_boundary() &&
        condition.region_ids.count(cell->material_id()) > 0)
      for (const unsigned int f : cell->face_indices())
      {
        if (!cell->face(f)->at_boundary() || cell->face(f)->boundary_id() != condition.boundary_id)
          continue;
        node_values.reinit(static_cast<typename Triangulation<dim>::active_cell_iterator>(cell), f);
        cell->face(f)->get_dof_indices(face_dofs, cell->active_fe_index());
        for (unsigned int i = 0; i < face_dofs.size(); ++i)
        {
          const auto component = space.velocity_element.face_system_to_component_index(i, f);
          const types::global_dof_index dof = face_dofs[i];
          if (component.first != 0 || !space.velocity_owned.is_element(dof) ||
              space.velocity_hanging.is_constrained(dof) || shapes.count(dof) > 0)
            continue;
          const Point<dim> &point = node_values.quadrature_point(component.second);
          shapes[dof] = profile.shapes_at(coordinates(point));
        }
        if (!cell->is_locally_owned())
          continue;
        values.reinit(cell, f);
        local = 0.;
        for (const unsigned int q : values.quadrature_point_indices())
          for (unsigned int i = 0; i < local.size(); ++i)
            if (space.velocity_element.system_to_component_index(i).first == 0)
              local[i] += values.shape_value(i, q) * values.JxW(q) *
                          space.circumference(values.quadrature_point(q));
        cell->get_dof_indices(cell_dofs);
        space.velocity_hanging.distribute_local_to_global(local, cell_dofs, flow_of_node);
      }
  flow_of_node.compress(VectorOperation::add);

  const std::size_t n_shapes = profile.shapes(0.).size();
  std::vector<double> means(n_shapes, 0.);
  const double area = profile.area();
  for (const auto &[dof, shape] : shapes)
    for (std::size_t m = 0; m < n_shapes; ++m)
      means[m] += flow_of_node[dof] * shape[m] / area;
  Utilities::MPI::sum(means, space.communicator, means);
  for (auto entry = shapes.begin(); entry != shapes.end();)
  {
    std::vector<double> &shape = entry->second;
    if (shape[0] == 0.)
    {
      entry = shapes.erase(entry);
      continue;
    }
    for (std::size_t m = n_shapes; m-- > 0;)
      shape[m] += ((m == 0 ? 1. : 0.) - means[m]) / means[0] * shape[0];
    ++entry;
  }
  return shapes;
}

template std::map<types::global_dof_index, std::vector<double>>
nodal_flow_shapes(const Space<2> &, const BoundaryCondition &);
template std::map<types::global_dof_index, std::vector<double>>
nodal_flow_shapes(const Space<3> &, const BoundaryCondition &);
} // namespace Continua
