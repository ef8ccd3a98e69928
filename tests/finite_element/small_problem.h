#ifndef continua_tests_finite_element_small_problem_h
#define continua_tests_finite_element_small_problem_h

// Small meshes and spaces for the unit tests of the finite elements.

#include <continua/finite_element/space/space.h>

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <functional>
#include <iostream>
#include <vector>

namespace small_problem
{
using namespace Continua;
template <int dim>
using Mesh = dealii::parallel::distributed::Triangulation<dim>;

/// Only rank 0 prints.
inline void quiet_other_ranks()
{
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.setstate(std::ios::failbit);
}

/// A box of unit cubes with corner `origin`; cells beyond x = `interface` are region 1, the
/// boundary ids are those of the faces (0, 1: x, 2, 3: y, 4, 5: z).
template <int dim>
void make_box(Mesh<dim> &mesh,
              const std::vector<unsigned int> &cells,
              const dealii::Point<dim> &origin = dealii::Point<dim>(),
              const double interface = 1e9)
{
  dealii::Point<dim> end = origin;
  for (unsigned int c = 0; c < dim; ++c)
    end[c] += cells[c];
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh, cells, origin, end, true);
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(cell->center()[0] > interface ? 1 : 0);
}

/// Divides the owned cells where the condition holds.
template <int dim>
void refine(Mesh<dim> &mesh, const std::function<bool(const dealii::Point<dim> &)> &where)
{
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned() && where(cell->center()))
      cell->set_refine_flag();
  mesh.execute_coarsening_and_refinement();
}

/// The velocity-space vector of a function at the nodes; nothing at hanging nodes.
template <int dim>
DistributedVector
interpolated(const Space<dim> &space,
             const std::function<dealii::Tensor<1, dim>(const dealii::Point<dim> &)> &function)
{
  DistributedVector result = space.velocity_vector();
  std::vector<dealii::types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  dealii::FEValues<dim> values(
      space.mapping, space.velocity_element,
      dealii::Quadrature<dim>(space.velocity_element.get_unit_support_points()),
      dealii::update_quadrature_points);
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      values.reinit(cell);
      cell->get_dof_indices(indices);
      for (unsigned int i = 0; i < indices.size(); ++i)
        if (space.velocity_owned.is_element(indices[i]))
          result[indices[i]] = function(values.quadrature_point(
              i))[space.velocity_element.system_to_component_index(i).first];
    }
  result.compress(dealii::VectorOperation::insert);
  space.set_hanging_velocities_to_zero(result);
  return result;
}

/// The same of a pressure, as a function of place and region.
template <int dim>
DistributedVector interpolated_pressure(
    const Space<dim> &space,
    const std::function<double(const dealii::Point<dim> &, unsigned int)> &function)
{
  DistributedVector result = space.pressure_vector();
  std::vector<dealii::types::global_dof_index> indices;
  for (const auto &cell : space.pressure_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const auto &element = cell->get_fe();
      const dealii::FE_Q<dim> scalar(space.degree() - 1);
      dealii::FEValues<dim> values(space.mapping, scalar,
                                   dealii::Quadrature<dim>(scalar.get_unit_support_points()),
                                   dealii::update_quadrature_points);
      values.reinit(static_cast<typename dealii::Triangulation<dim>::active_cell_iterator>(cell));
      indices.resize(element.n_dofs_per_cell());
      cell->get_dof_indices(indices);
      for (unsigned int i = 0; i < indices.size(); ++i)
        if (space.pressure_owned.is_element(indices[i]))
          result[indices[i]] =
              function(values.quadrature_point(element.system_to_component_index(i).second),
                       cell->material_id());
    }
  result.compress(dealii::VectorOperation::insert);
  space.set_hanging_pressures_to_zero(result);
  return result;
}
} // namespace small_problem

#endif
