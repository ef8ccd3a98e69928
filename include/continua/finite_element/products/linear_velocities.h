#ifndef continua_finite_element_products_linear_velocities_h
#define continua_finite_element_products_linear_velocities_h

#include <continua/finite_element/products/matrix_free_product.h>
#include <continua/finite_element/space/space.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <vector>

namespace Continua
{
/**
 * The velocities of a space that are linear in each cell, as the coarse level of its quadratic
 * ones. They have the nodes at the vertices of the same mesh, and are constrained there as the
 * velocities of the space are: prescribed components, also on inclined boundaries, and hanging
 * nodes.
 */
template <int dim>
class LinearVelocities
{
public:
  /// Those that are `stiff`, a flag for each owned velocity of the space; the others are zero.
  /// `constraints`: homogeneous, with the hanging nodes. Both must outlive it. Collective.
  LinearVelocities(const Space<dim> &space,
                   const dealii::AffineConstraints<double> &constraints,
                   const std::vector<bool> &stiff);

  /// Assembles the integrals of MatrixFreeProduct for these velocities [kg/s]. `supports`: a matrix
  /// of the velocities of the space that is added; null is none. Collective.
  void assemble(const typename MatrixFreeProduct<dim, double>::Coefficients &coefficients,
                const dealii::TrilinosWrappers::SparseMatrix *supports,
                dealii::TrilinosWrappers::SparseMatrix &matrix) const;

  /// Values of the linear velocities at the nodes of the space: rows of velocities that are stiff
  /// and free, columns of linear ones; other rows and columns are empty.
  const dealii::TrilinosWrappers::SparseMatrix &interpolation() const
  {
    return interpolation_matrix;
  }
  /// Local indices of the stiff ones, node by node, with prescribed components, which have no
  /// coupling in the matrix, and without hanging nodes.
  const std::vector<unsigned int> &stiff_rows() const { return rows; }
  const dealii::DoFHandler<dim> &dofs() const { return dof_handler; }
  DistributedVector vector() const;

private:
  const Space<dim> &space;
  const dealii::AffineConstraints<double> &constraints;
  dealii::FESystem<dim> element;
  dealii::DoFHandler<dim> dof_handler;
  dealii::IndexSet owned, relevant;
  dealii::AffineConstraints<double> lines;
  // Of each relevant one, by its place in `relevant`:
  std::vector<bool> is_stiff, is_hanging;
  std::vector<unsigned int> rows;
  dealii::TrilinosWrappers::SparseMatrix interpolation_matrix;

  void find_stiff(const std::vector<bool> &stiff);
  void constrain();
  void interpolate(const std::vector<bool> &stiff);
  void add_supports(const dealii::TrilinosWrappers::SparseMatrix &supports,
                    dealii::TrilinosWrappers::SparseMatrix &matrix) const;
  /// Calls visit(index of the space, index of the linear velocity) for each component at each
  /// vertex of the cells that are not artificial, several times for some.
  template <typename Visit>
  void for_vertices(const Visit &visit) const;
};
} // namespace Continua

#endif
