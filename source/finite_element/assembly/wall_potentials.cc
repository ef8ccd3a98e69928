#include <continua/finite_element/assembly/wall_potentials.h>

#include <continua/base/input_error.h>

#include <deal.II/base/function.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/component_mask.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/numerics/vector_tools.h>

#include <map>
#include <vector>

namespace Continua
{
using namespace dealii;

namespace
{
/// Of the right-hand side: far below what the mesh resolves of a direction.
constexpr double potential_tolerance = 1e-12;
constexpr unsigned int most_potential_iterations = 1000;
} // namespace

template <int dim>
WallPotentials<dim>::WallPotentials(const Space<dim> &space,
                                    const WallDirectionsParameters &parameters)
    : space(space), parameters(parameters)
{
}

template <int dim>
void WallPotentials<dim>::set_constraints(AffineConstraints<double> &constraints) const
{
  DoFTools::make_hanging_node_constraints(space.velocity_dofs, constraints);
  const auto prescribe =
      [&](const std::set<unsigned int> &ids, const unsigned int component, const double value)
  {
    const Functions::ConstantFunction<dim> function(value, dim);
    std::map<types::boundary_id, const Function<dim> *> of_boundaries;
    for (const unsigned int id : ids)
      of_boundaries[id] = &function;
    ComponentMask mask(dim, false);
    mask.set(component, true);
    VectorTools::interpolate_boundary_values(space.mapping, space.velocity_dofs, of_boundaries,
                                             constraints, mask);
  };
  prescribe(parameters.begin, 0, 0.);
  prescribe(parameters.end, 0, 1.);
  prescribe(parameters.inside, 1, 0.);
  prescribe(parameters.outside, 1, 1.);
  // What is no potential.
  const std::vector<bool> is_used = {!parameters.begin.empty(), true, false};
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (!cell->is_artificial())
    {
      cell->get_dof_indices(indices);
      for (unsigned int i = 0; i < indices.size(); ++i)
        if (!is_used[space.velocity_element.system_to_component_index(i).first] &&
            !constraints.is_constrained(indices[i]))
          constraints.add_line(indices[i]);
    }
  constraints.close();
}

template <int dim>
void WallPotentials<dim>::reinit()
{
  if (!exist())
    return;
  AffineConstraints<double> constraints(space.velocity_relevant);
  set_constraints(constraints);
  Table<2, DoFTools::Coupling> coupling(dim, dim);
  coupling.fill(DoFTools::none);
  for (unsigned int c = 0; c < dim; ++c)
    coupling(c, c) = DoFTools::always;
  DynamicSparsityPattern pattern(space.velocity_relevant);
  DoFTools::make_sparsity_pattern(space.velocity_dofs, coupling, pattern, constraints, false);
  SparsityTools::distribute_sparsity_pattern(pattern, space.velocity_owned, space.communicator,
                                             space.velocity_relevant);
  TrilinosWrappers::SparseMatrix matrix;
  matrix.reinit(space.velocity_owned, space.velocity_owned, pattern, space.communicator);
  solution = space.velocity_vector();
  DistributedVector right_side = space.velocity_vector();

  FEValues<dim> values(space.mapping, space.velocity_element,
                       space.quadrature(space.n_quadrature_points()),
                       update_gradients | update_quadrature_points | update_JxW_values);
  const unsigned int n = space.velocity_element.n_dofs_per_cell();
  FullMatrix<double> of_cell(n, n);
  Vector<double> nothing(n);
  std::vector<types::global_dof_index> indices(n);
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      values.reinit(cell);
      of_cell = 0.;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          if (space.velocity_element.system_to_component_index(i).first ==
              space.velocity_element.system_to_component_index(j).first)
            for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
              of_cell(i, j) += values.shape_grad(i, q) * values.shape_grad(j, q) * values.JxW(q) *
                               space.circumference(values.quadrature_point(q));
      cell->get_dof_indices(indices);
      constraints.distribute_local_to_global(of_cell, nothing, indices, matrix, right_side);
    }
  matrix.compress(VectorOperation::add);
  right_side.compress(VectorOperation::add);

  TrilinosWrappers::PreconditionAMG preconditioner;
  preconditioner.initialize(matrix);
  SolverControl control(most_potential_iterations, potential_tolerance * right_side.l2_norm());
  try
  {
    SolverCG<DistributedVector>(control).solve(matrix, solution, right_side, preconditioner);
  }
  catch (const SolverControl::NoConvergence &)
  {
    throw RunError("the potentials of the section Wall directions were not found in " +
                   std::to_string(most_potential_iterations) +
                   " iterations: each part of the body needs a boundary of Inside, Outside, Begin "
                   "and End");
  }
  constraints.distribute(solution);
}

template class WallPotentials<2>;
template class WallPotentials<3>;
} // namespace Continua
