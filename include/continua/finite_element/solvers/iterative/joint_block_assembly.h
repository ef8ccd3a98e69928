#ifndef continua_finite_element_solvers_iterative_joint_block_assembly_h
#define continua_finite_element_solvers_iterative_joint_block_assembly_h

#include <continua/continuum/system_coefficients.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/saddle_point_block.h>

#include <deal.II/base/types.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace Continua
{
/// Gives the joint block of stiff velocities and pressures its entries of A, cell by cell. No
/// matrix is made.
template <int dim>
class JointBlockAssembly
{
public:
  /// All must outlive it. `supports`: their matrix, with a one on the diagonal of constrained
  /// velocities; null without.
  JointBlockAssembly(const Space<dim> &space,
                     const BoundaryConstraints<dim> &constraints,
                     const SystemCoefficients &coefficients,
                     const dealii::TrilinosWrappers::SparseMatrix *supports,
                     SaddlePointBlock &block);

  /// `stiff`: local indices of the velocities of the block. Collective.
  void add_velocities(const std::vector<unsigned int> &stiff);

private:
  const Space<dim> &space;
  const dealii::AffineConstraints<double> &lines;
  const SystemCoefficients &coefficients;
  const dealii::TrilinosWrappers::SparseMatrix *const supports;
  SaddlePointBlock &block;
  std::vector<dealii::types::global_dof_index> indices; ///< of the present cell
  /// The rows of the block that each velocity of a cell stands for, with their weights.
  std::vector<std::vector<std::pair<int, double>>> rows;
  std::vector<bool> is_of_block; ///< of each cell
  std::vector<int> of_cell;      ///< work space

  /// The block learns which velocities of other ranks the owned cells have. Collective.
  void learn_numbers();
  /// Finds the rows of the present cell, and returns how many there are.
  std::size_t find_rows();
  /// Entries that the owned cells add, and which cells add some.
  std::size_t count_entries();
  void add_cells();
};
} // namespace Continua

#endif
