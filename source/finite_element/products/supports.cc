#include <continua/finite_element/products/supports.h>

#include <continua/mesh/cells_in_tree_order.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

namespace Continua
{
using namespace dealii;

namespace
{
/// Calls work(cell, face, condition) for this rank's faces that are supported.
template <int dim, typename Work>
void for_supported_faces(const Space<dim> &space,
                         const std::vector<BoundaryCondition> &conditions,
                         const Work &work)
{
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (cell->is_locally_owned() && cell->at_boundary())
      for (const unsigned int f : cell->face_indices())
        for (const BoundaryCondition &condition : conditions)
          if (condition.is_supported() && cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() == condition.boundary_id &&
              condition.region_ids.count(cell->material_id()) > 0)
            work(cell, f, condition);
}

/// The matrices of one face, of the velocities that are not zero on it.
template <int dim>
class FaceMatrices
{
public:
  using Cell = typename DoFHandler<dim>::active_cell_iterator;

  explicit FaceMatrices(const Space<dim> &space)
      : space(space),
        // The normal of a curved face is not polynomial: one point more than products need.
        quadrature(space.face_quadrature(space.n_quadrature_points() + 1)),
        values(space.mapping,
               space.velocity_element,
               quadrature,
               update_values | update_quadrature_points | update_normal_vectors | update_JxW_values)
  {
  }

  /// Sets `indices`, the dofs on the face.
  void find_dofs(const Cell &cell, const unsigned int face)
  {
    std::vector<types::global_dof_index> of_cell(space.velocity_element.n_dofs_per_cell());
    cell->get_dof_indices(of_cell);
    local.clear();
    indices.clear();
    for (unsigned int i = 0; i < of_cell.size(); ++i)
      if (space.velocity_element.has_support_on_face(i, face))
      {
        local.push_back(i);
        indices.push_back(of_cell[i]);
      }
  }

  void integrate(const Cell &cell, const unsigned int face, const BoundaryCondition &condition)
  {
    find_dofs(cell, face);
    const unsigned int n = local.size();
    stiffness.reinit(n, n);
    damping.reinit(n, n);
    values.reinit(cell, face);
    for (const unsigned int q : values.quadrature_point_indices())
    {
      const Tensor<1, dim> &normal = values.normal_vector(q);
      const double weight = values.JxW(q) * space.circumference(values.quadrature_point(q));
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
        {
          const unsigned int c = space.velocity_element.system_to_component_index(local[i]).first,
                             d = space.velocity_element.system_to_component_index(local[j]).first;
          const double product =
              weight * values.shape_value(local[i], q) * values.shape_value(local[j], q);
          const double along = product * normal[c] * normal[d];
          const double across = (c == d ? product : 0.) - along;
          stiffness(i, j) +=
              condition.normal.stiffness * along + condition.tangential.stiffness * across;
          damping(i, j) += condition.normal.damping * along + condition.tangential.damping * across;
        }
    }
  }

  std::vector<types::global_dof_index> indices;
  FullMatrix<double> stiffness, damping;

private:
  const Space<dim> &space;
  const Quadrature<dim - 1> quadrature;
  FEFaceValues<dim> values;
  std::vector<unsigned int> local; ///< the same in the cell's numbering
};
} // namespace

template <int dim>
void assemble_supports(const Space<dim> &space,
                       const std::vector<BoundaryCondition> &conditions,
                       std::vector<RegionOperators> &operators)
{
  using Cell = typename FaceMatrices<dim>::Cell;
  for (RegionOperators &target : operators)
    target.is_supported = false;
  for (const BoundaryCondition &condition : conditions)
    if (condition.is_supported())
      for (const unsigned int region : condition.region_ids)
        operators[region].is_supported = true;

  FaceMatrices<dim> matrices(space);
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    RegionOperators &target = operators[region];
    target.support_stiffness.clear();
    target.support_damping.clear();
    if (!target.is_supported)
      continue;
    TrilinosWrappers::SparsityPattern pattern(space.velocity_owned, space.velocity_owned,
                                              space.velocity_relevant, space.communicator);
    for_supported_faces(space, conditions,
                        [&](const Cell &cell, const unsigned int face, const BoundaryCondition &)
                        {
                          if (cell->material_id() != region)
                            return;
                          matrices.find_dofs(cell, face);
                          space.velocity_hanging.add_entries_local_to_global(matrices.indices,
                                                                             pattern, false);
                        });
    pattern.compress();
    target.support_stiffness.reinit(pattern);
    target.support_damping.reinit(pattern);
  }
  for_supported_faces(
      space, conditions,
      [&](const Cell &cell, const unsigned int face, const BoundaryCondition &condition)
      {
        matrices.integrate(cell, face, condition);
        RegionOperators &target = operators[cell->material_id()];
        space.velocity_hanging.distribute_local_to_global(matrices.stiffness, matrices.indices,
                                                          target.support_stiffness);
        space.velocity_hanging.distribute_local_to_global(matrices.damping, matrices.indices,
                                                          target.support_damping);
      });
  for (RegionOperators &target : operators)
    if (target.is_supported)
    {
      target.support_stiffness.compress(VectorOperation::add);
      target.support_damping.compress(VectorOperation::add);
    }
}

template void assemble_supports(const Space<2> &,
                                const std::vector<BoundaryCondition> &,
                                std::vector<RegionOperators> &);
template void assemble_supports(const Space<3> &,
                                const std::vector<BoundaryCondition> &,
                                std::vector<RegionOperators> &);
} // namespace Continua
