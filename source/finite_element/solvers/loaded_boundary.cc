#include <continua/finite_element/solvers/loaded_boundary.h>

#include <continua/finite_element/conditions/following_loads.h>
#include <continua/finite_element/conditions/loads.h>
#include <continua/finite_element/space/cell_sums.h>
#include <continua/mesh/coordinates.h>

#include <deal.II/fe/fe_values.h>

#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
template <int dim>
Tensor<1, dim> in_space(const Tensor<1, 3> &vector)
{
  Tensor<1, dim> result;
  for (unsigned int c = 0; c < dim; ++c)
    result[c] = vector[c];
  return result;
}
} // namespace

template <int dim>
LoadedBoundary<dim>::LoadedBoundary(const Space<dim> &space,
                                    const Problem &problem,
                                    const LoadedCells<dim> &cells)
    : space(space), problem(problem), cells(cells)
{
  FEFaceValues<dim> values = face_values_under_load(space);
  for (const LoadedCell<dim> &cell : cells.all())
  {
    const auto &at = cell.at->velocity_cell;
    for (const unsigned int face : at->face_indices())
    {
      if (!at->at_boundary(face))
        continue;
      for (unsigned int number = 0; number < problem.conditions.size(); ++number)
      {
        const BoundaryCondition &condition = problem.conditions[number];
        if (at->face(face)->boundary_id() != condition.boundary_id ||
            condition.region_ids.count(cell.at->region) == 0)
          continue;
        values.reinit(static_cast<typename Triangulation<dim>::active_cell_iterator>(at), face);
        faces.push_back({number, &cell, deformed_face_points(space, values)});
      }
    }
  }
}

template <int dim>
template <typename ForceOf>
DistributedVector LoadedBoundary<dim>::sum_over_faces(const unsigned int condition,
                                                      const ForceOf &force_of) const
{
  CellSums sums;
  sums.reinit(cells.shape(), space.velocity_owned, space.velocity_hanging);
  Vector<double> displacements(space.velocity_element.n_dofs_per_cell()),
      forces(displacements.size());
  for (const Face &face : faces)
  {
    if (face.condition != condition)
      continue;
    const QuadratureCell<dim> &cell = *face.cell->at;
    set_entries(cell.velocity_places, cells.shape(), displacements);
    forces = 0.;
    for (const DeformedFacePoint<dim> &point : face.points)
    {
      const Tensor<1, dim> force =
          force_of(cell.region, point,
                   in_space<dim>(point.kinematics(displacements).area(point.area)), displacements);
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int a = 0; a < point.n_functions(); ++a)
          forces[c * point.n_functions() + a] += force[c] * point.values[a];
    }
    sums.add(cell.velocity_places, forces);
  }
  DistributedVector sum = space.velocity_vector();
  sums.add_to(sum);
  return sum;
}

template <int dim>
DistributedVector LoadedBoundary<dim>::flow_of_velocities(const unsigned int condition) const
{
  return sum_over_faces(condition,
                        [](const unsigned int, const DeformedFacePoint<dim> &,
                           const Tensor<1, dim> &area, const Vector<double> &) { return area; });
}

template <int dim>
DistributedVector LoadedBoundary<dim>::following_forces(const unsigned int number,
                                                        const double time) const
{
  const BoundaryCondition &condition = problem.conditions[number];
  const auto force_of = [&](const unsigned int region, const DeformedFacePoint<dim> &point,
                            const Tensor<1, dim> &area,
                            const Vector<double> &displacements) -> Tensor<1, dim>
  {
    if (!has_following_traction(problem, region, condition))
      return {};
    // A pressure on a solid is that of the undeformed place, a traction on a liquid that of the
    // present place.
    if (problem.materials[region].is_solid())
      return -condition.normal.along_normal(coordinates(point.place).data(), time) * area;
    const double size = area.norm();
    return size * Loads<dim>::prescribed_traction(
                      condition, point.place + point.value_of(displacements), area / size, time);
  };
  return sum_over_faces(number, force_of);
}

template class LoadedBoundary<2>;
template class LoadedBoundary<3>;
} // namespace Continua
