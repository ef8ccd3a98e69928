#include <continua/finite_element/cavity_volumes.h>

#include <continua/mesh/cells_in_tree_order.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

namespace Continua
{
using namespace dealii;

template <int dim>
CavityVolumes<dim>::CavityVolumes(const Space<dim> &space, const Problem &problem)
    : space(space), problem(problem), quadrature(space.n_quadrature_points() + 1)
{
}

template <int dim>
void CavityVolumes<dim>::reinit()
{
  faces.clear();
  const std::vector<unsigned int> cavities = problem.cavities();
  if (cavities.empty())
    return;
  ghosted.reinit(space.velocity_owned, space.velocity_relevant, space.communicator);
  displacement_work = space.velocity_vector();
  const FE_Q<dim> element(space.degree());
  const unsigned int n_functions = element.n_dofs_per_cell();
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
      for (unsigned int cavity = 0; cavity < cavities.size(); ++cavity)
      {
        const BoundaryCondition &condition = problem.conditions[cavities[cavity]];
        if (!cell->face(f)->at_boundary() ||
            cell->face(f)->boundary_id() != condition.boundary_id ||
            condition.region_ids.count(cell->material_id()) == 0)
          continue;
        values.reinit(static_cast<typename Triangulation<dim>::active_cell_iterator>(cell), f);
        faces.push_back({cavity, indices, deformed_face_points(space, values)});
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
void CavityVolumes<dim>::take(const DistributedVector &displacement)
{
  space.copy_velocity(displacement, displacement_work, ghosted);
}

template <int dim>
void CavityVolumes<dim>::set_displacement_of(const Face &face)
{
  for (unsigned int i = 0; i < face.indices.size(); ++i)
    of_cell[i] = ghosted(face.indices[i]);
}

template <int dim>
double CavityVolumes<dim>::flux_factor(const unsigned int direction) const
{
  const bool is_in_plane = dim == 2 && !space.is_axisymmetric();
  return is_in_plane || direction > 0 ? 0.5 : 0.;
}

template <int dim>
Tensor<1, 3> CavityVolumes<dim>::flux_vector(const DeformedFacePoint<dim> &point) const
{
  const Tensor<1, dim> way = point.way(of_cell);
  Tensor<1, 3> vector;
  for (unsigned int c = 0; c < dim; ++c)
    vector[c] = flux_factor(c) * (point.place[c] + way[c]);
  return vector;
}

template <int dim>
std::vector<double> CavityVolumes<dim>::volumes(const DistributedVector &displacement)
{
  take(displacement);
  std::vector<double> sums(problem.cavities().size(), 0.);
  for (const Face &face : faces)
  {
    set_displacement_of(face);
    for (const DeformedFacePoint<dim> &point : face.points)
      sums[face.cavity] -= flux_vector(point) * point.kinematics(of_cell).area(point.area);
  }
  Utilities::MPI::sum(sums, space.communicator, sums);
  return sums;
}

template <int dim>
void CavityVolumes<dim>::linearise(const unsigned int cavity,
                                   const DistributedVector &displacement,
                                   DistributedVector &derivative,
                                   DistributedVector &force)
{
  take(displacement);
  derivative = 0.;
  force = 0.;
  Vector<double> cell_derivative(of_cell.size()), cell_force(of_cell.size());
  for (const Face &face : faces)
  {
    if (face.cavity != cavity)
      continue;
    set_displacement_of(face);
    cell_derivative = 0.;
    cell_force = 0.;
    for (const DeformedFacePoint<dim> &point : face.points)
    {
      const Kinematics motion = point.kinematics(of_cell);
      const Tensor<1, 3> area = motion.area(point.area), flux = flux_vector(point);
      const unsigned int n_functions = point.n_functions();
      for (unsigned int a = 0; a < n_functions; ++a)
      {
        const std::array<Tensor<1, 3>, dim> changes = point.area_derivatives(motion, area, a);
        for (unsigned int c = 0; c < dim; ++c)
        {
          const double of_point = area[c] * point.values[a];
          cell_derivative[c * n_functions + a] -= flux_factor(c) * of_point + flux * changes[c];
          cell_force[c * n_functions + a] -= of_point;
        }
      }
    }
    space.velocity_hanging.distribute_local_to_global(cell_derivative, face.indices, derivative);
    space.velocity_hanging.distribute_local_to_global(cell_force, face.indices, force);
  }
  derivative.compress(VectorOperation::add);
  force.compress(VectorOperation::add);
}

template class CavityVolumes<2>;
template class CavityVolumes<3>;
} // namespace Continua
