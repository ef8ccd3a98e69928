#include <continua/finite_element/motion/solid_motion.h>

#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Continua
{
using namespace dealii;

template <int dim>
SolidMotion<dim>::SolidMotion(const Space<dim> &space, const Problem &problem)
    : space(space),
      problem(problem),
      cells(space,
            space.quadrature(space.degree()),
            [&problem](const unsigned int region) { return problem.materials[region].is_solid(); })
{
}

template <int dim>
void SolidMotion<dim>::set_up()
{
  cells.reinit();
  find_nodes();
  measure_liquid();
  displacement.reinit(space.velocity_owned, space.velocity_relevant, space.communicator);
  is_set_up = true;
}

template <int dim>
void SolidMotion<dim>::find_nodes()
{
  nodes.clear();
  const DistributedVector ghosted(space.velocity_owned, space.velocity_relevant,
                                  space.communicator);
  const FiniteElement<dim> &base = space.velocity_element.base_element(0);
  FEValues<dim> values(space.mapping, space.velocity_element,
                       Quadrature<dim>(base.get_unit_support_points()), update_inverse_jacobians);
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
  {
    if (!cell->is_locally_owned() || !problem.materials[cell->material_id()].is_solid())
      continue;
    for (const unsigned int f : cell->face_indices())
    {
      if (cell->at_boundary(f) || problem.materials[cell->neighbor(f)->material_id()].is_solid())
        continue;
      values.reinit(cell);
      cell->get_dof_indices(indices);
      std::map<unsigned int, WallNode> of_face;
      for (unsigned int i = 0; i < indices.size(); ++i)
      {
        const auto [component, node] = space.velocity_element.system_to_component_index(i);
        if (!base.has_support_on_face(node, f))
          continue;
        of_face[node].places[component] = ghosted.trilinos_partitioner().LID(
            static_cast<TrilinosWrappers::types::int_type>(indices[i]));
      }
      for (auto &[node, wall] : of_face)
      {
        // A face of the unit cell is that of a coordinate, whose gradient is along the normal.
        for (unsigned int d = 0; d < dim; ++d)
          wall.normal[d] = values.inverse_jacobian(node)[f / 2][d];
        wall.normal /= wall.normal.norm();
        nodes.push_back(wall);
      }
    }
  }
}

template <int dim>
bool SolidMotion<dim>::is_wall_of_liquid(const typename DoFHandler<dim>::active_cell_iterator &cell,
                                         const unsigned int face) const
{
  if (!cell->at_boundary(face))
    return problem.materials[cell->neighbor(face)->material_id()].is_solid();
  return is_wall(problem, cell->face(face)->boundary_id(), cell->material_id());
}

template <int dim>
void SolidMotion<dim>::measure_liquid()
{
  const unsigned int n_points = space.n_quadrature_points();
  FEValues<dim> values(space.mapping, space.velocity_element, space.quadrature(n_points),
                       update_JxW_values | update_quadrature_points);
  FEFaceValues<dim> face_values(space.mapping, space.velocity_element,
                                space.face_quadrature(n_points),
                                update_JxW_values | update_quadrature_points);
  const auto size_of = [this](const FEValuesBase<dim> &present)
  {
    double size = 0.;
    for (const unsigned int q : present.quadrature_point_indices())
      size += present.JxW(q) * space.circumference(present.quadrature_point(q));
    return size;
  };
  liquid = {};
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
  {
    if (!cell->is_locally_owned() || problem.materials[cell->material_id()].is_solid())
      continue;
    values.reinit(cell);
    liquid.volume += size_of(values);
    for (const unsigned int f : cell->face_indices())
      if (is_wall_of_liquid(cell, f))
      {
        face_values.reinit(cell, f);
        const double area = size_of(face_values);
        liquid.area += area;
        if (!cell->at_boundary(f))
          liquid.area_of_solids += area;
      }
  }
  liquid.sum(space.communicator);
}

template <int dim>
void SolidMotion<dim>::take(const State &state, MotionExtremes &extremes)
{
  if (!is_set_up)
    set_up();
  liquid.set(extremes);
  space.copy_velocity(state.history.displacement(), displacement);
  const double *const values = displacement.begin();
  for (const WallNode &node : nodes)
  {
    double across = 0.;
    for (unsigned int c = 0; c < dim; ++c)
      across += node.normal[c] * values[node.places[c]];
    extremes.wall_displacement = std::max(extremes.wall_displacement, std::abs(across));
  }
  const unsigned int n = cells.n_functions();
  for (const QuadratureCell<dim> &cell : cells.all())
    for (unsigned int q = 0; q < cells.n_points(); ++q)
    {
      const Tensor<1, dim> *const slopes = cells.gradients(q);
      const double *const shapes = cells.values(q);
      Tensor<2, dim> on_reference_cell;
      double radial = 0.;
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int a = 0; a < n; ++a)
          on_reference_cell[c] += values[cell.velocity_places[c * n + a]] * slopes[a];
      const typename QuadratureCell<dim>::Point &point = cell.points[q];
      if (point.hoop > 0.)
        for (unsigned int a = 0; a < n; ++a)
          radial += values[cell.velocity_places[n + a]] * shapes[a];
      take_point_of_solid<dim>(on_reference_cell * point.inverse_jacobian, radial * point.hoop,
                               problem, cell.region, extremes);
    }
}

template class SolidMotion<2>;
template class SolidMotion<3>;
} // namespace Continua
