#include <continua/finite_element/conditions/cavity_volumes.h>

#include <continua/mesh/connected_cells.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

template <int dim>
CavityVolumes<dim>::CavityVolumes(const Space<dim> &space, const Problem &problem)
    : space(space),
      problem(problem),
      faces(space, problem, problem.cavities()),
      surfaces(
          space,
          problem.cavities().empty()
              ? typename DeformedFaces<dim>::SetOfFace()
              : [this](const typename DeformedFaces<dim>::Cell &cell, const unsigned int face)
              { return cavity_of_face(cell, face); })
{
  for (const unsigned int number : problem.cavities())
    is_filled.push_back(problem.is_filled(problem.conditions[number]));
}

template <int dim>
void CavityVolumes<dim>::reinit()
{
  find_bodies_of_liquid();
  faces.reinit();
  surfaces.reinit();
}

template <int dim>
void CavityVolumes<dim>::find_bodies_of_liquid()
{
  cavity_of_coarse_cell.clear();
  is_of_solid.clear();
  if (std::find(is_filled.begin(), is_filled.end(), true) == is_filled.end())
    return;
  std::vector<unsigned int> kinds;
  for (const Material &material : problem.materials)
    kinds.push_back(material.is_solid() ? 1 : 0);
  const std::vector<unsigned int> body_of_cell = connected_cells<dim>(space.triangulation, kinds);
  const std::vector<unsigned int> conditions = problem.cavities();
  std::map<unsigned int, unsigned int> cavity_of_body;
  for (const auto &cell : space.triangulation.cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
      for (unsigned int cavity = 0; cavity < conditions.size(); ++cavity)
      {
        const BoundaryCondition &condition = problem.conditions[conditions[cavity]];
        if (is_filled[cavity] && cell->at_boundary(f) &&
            cell->face(f)->boundary_id() == condition.boundary_id &&
            condition.region_ids.count(cell->material_id()) > 0)
          cavity_of_body[body_of_cell[cell->index()]] = cavity;
      }
  for (unsigned int i = 0; i < body_of_cell.size(); ++i)
    if (const auto found = cavity_of_body.find(body_of_cell[i]); found != cavity_of_body.end())
      cavity_of_coarse_cell[i] = found->second;

  DistributedVector marks = space.velocity_vector();
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  const std::vector<double> ones(indices.size(), 1.);
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned() && problem.materials[cell->material_id()].is_solid())
    {
      cell->get_dof_indices(indices);
      marks.add(indices, ones);
    }
  marks.compress(VectorOperation::add);
  for (const double mark : marks)
    is_of_solid.push_back(mark > 0.);
}

template <int dim>
int CavityVolumes<dim>::cavity_of_face(const typename DeformedFaces<dim>::Cell &cell,
                                       const unsigned int f) const
{
  const std::vector<unsigned int> conditions = problem.cavities();
  if (problem.materials[cell->material_id()].is_solid())
  {
    for (unsigned int cavity = 0; cavity < conditions.size(); ++cavity)
      if (const BoundaryCondition &condition = problem.conditions[conditions[cavity]];
          cell->at_boundary(f) && cell->face(f)->boundary_id() == condition.boundary_id &&
          condition.region_ids.count(cell->material_id()) > 0)
        return static_cast<int>(cavity);
    return -1;
  }
  const auto found = cavity_of_coarse_cell.find(
      index_of_coarse_cell(static_cast<typename Triangulation<dim>::cell_iterator>(cell)));
  if (found == cavity_of_coarse_cell.end())
    return -1;
  if (!cell->at_boundary(f))
    return problem.materials[cell->neighbor(f)->material_id()].is_solid()
               ? static_cast<int>(found->second)
               : -1;
  // The axis is no part of the surface.
  const bool is_axis = std::any_of(problem.conditions.begin(), problem.conditions.end(),
                                   [&](const BoundaryCondition &condition)
                                   {
                                     return condition.type == BoundaryType::axis &&
                                            condition.boundary_id == cell->face(f)->boundary_id() &&
                                            condition.region_ids.count(cell->material_id()) > 0;
                                   });
  return is_axis ? -1 : static_cast<int>(found->second);
}

template <int dim>
double CavityVolumes<dim>::flux_factor(const unsigned int direction) const
{
  const bool is_in_plane = dim == 2 && !space.is_axisymmetric();
  return is_in_plane || direction > 0 ? 0.5 : 0.;
}

template <int dim>
Tensor<1, 3> CavityVolumes<dim>::flux_vector(const DeformedFacePoint<dim> &point,
                                             const Vector<double> &displacement) const
{
  const Tensor<1, dim> shift = point.value_of(displacement);
  Tensor<1, 3> vector;
  for (unsigned int c = 0; c < dim; ++c)
    vector[c] = flux_factor(c) * (point.place[c] + shift[c]);
  return vector;
}

template <int dim>
std::vector<double> CavityVolumes<dim>::volumes(const DistributedVector &displacement)
{
  surfaces.take(displacement);
  std::vector<double> sums(problem.cavities().size(), 0.);
  for (const auto &face : surfaces.all())
  {
    const Vector<double> &of_cell = surfaces.displacement_of(face);
    double flux = 0.;
    for (const DeformedFacePoint<dim> &point : face.points)
      flux += flux_vector(point, of_cell) * point.kinematics(of_cell).area(point.area);
    sums[face.number] += sign(face.number) * flux;
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
  faces.take(displacement);
  faces.set_flow(cavity, force);
  force *= -1.;
  surfaces.take(displacement);
  derivative = 0.;
  Vector<double> cell_derivative;
  for (const auto &face : surfaces.all())
  {
    if (face.number != cavity)
      continue;
    const Vector<double> &of_cell = surfaces.displacement_of(face);
    cell_derivative.reinit(of_cell.size());
    for (const DeformedFacePoint<dim> &point : face.points)
    {
      const Kinematics motion = point.kinematics(of_cell);
      const Tensor<1, 3> area = motion.area(point.area), flux = flux_vector(point, of_cell);
      const unsigned int n_functions = point.n_functions();
      for (unsigned int a = 0; a < n_functions; ++a)
      {
        const std::array<Tensor<1, 3>, dim> changes = point.area_derivatives(motion, area, a);
        for (unsigned int c = 0; c < dim; ++c)
          cell_derivative[c * n_functions + a] +=
              sign(cavity) * (flux_factor(c) * area[c] * point.values[a] + flux * changes[c]);
      }
    }
    space.velocity_hanging.distribute_local_to_global(cell_derivative, face.indices, derivative);
  }
  derivative.compress(VectorOperation::add);
  if (is_filled[cavity])
    for (unsigned int i = 0; i < is_of_solid.size(); ++i)
      if (!is_of_solid[i])
        derivative.begin()[i] = 0.;
}

template class CavityVolumes<2>;
template class CavityVolumes<3>;
} // namespace Continua
