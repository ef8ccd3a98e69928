#ifndef continua_finite_volume_vertex_extension_h
#define continua_finite_volume_vertex_extension_h

#include <continua/linear_algebra/distributed_vector.h>
#include <continua/linear_algebra/symmetric_factor.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * Extends displacements of some vertices to those of the cells of liquids: the cells are a linear
 * elastic body on the undeformed mesh,
 *
 *   int k ( 2 eps(d) : eps(z) + 2 div d div z ) dV = 0,
 *
 * with k = 1/(volume of the cell), linear in each cell along its edges. Small cells keep their
 * shape, and equal ones share the way of a piston. Matrix and factor are made once on a mesh.
 */
template <int dim>
class VertexExtension
{
public:
  /// Finds the operator. `dofs`: of a vector of linear elements, with its hanging nodes in
  /// `hanging`; both must outlive it. `is_liquid` is by material id. `is_known`: 1 at the entries
  /// of vertices whose displacement is given, else 0. Collective. Throws RunError.
  void reinit(const dealii::DoFHandler<dim> &dofs,
              const dealii::AffineConstraints<double> &hanging,
              bool axisymmetric,
              const std::vector<bool> &is_liquid,
              const DistributedVector &is_known);
  /// In: the displacements that are given, 0 elsewhere [m]. Out: those of all vertices of liquids;
  /// entries of hanging nodes are interpolated. Collective.
  void extend(DistributedVector &displacement);

private:
  struct Cell
  {
    std::vector<dealii::types::global_dof_index> indices;
    dealii::FullMatrix<double> matrix;
  };
  const dealii::AffineConstraints<double> *hanging = nullptr;
  dealii::AffineConstraints<double> constraints; ///< of hanging nodes and of what is given
  std::vector<Cell> cells;
  std::unique_ptr<SymmetricFactor> factor;
  DistributedVector rows, ghosted;
  std::vector<int> owned;
  std::vector<double> packed;

  void assemble(const dealii::DoFHandler<dim> &dofs,
                bool axisymmetric,
                const std::vector<bool> &is_liquid);
  void factorise(const dealii::DoFHandler<dim> &dofs);
};
} // namespace Continua

#endif
