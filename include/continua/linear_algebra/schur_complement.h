#ifndef continua_linear_algebra_schur_complement_h
#define continua_linear_algebra_schur_complement_h

#include <continua/linear_algebra/distributed_vector.h>

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace Continua
{
/**
 * An approximate inverse of the Schur complement C + B A^-1 B^T of the pressure. With a mass form M
 * it is that of Cahouet and Chabard (Int. J. Numer. Methods Fluids 8 (1988)) with compressibility,
 *
 *   M^-1 + (C + B D B^T)^-1,
 *
 * M a pressure mass matrix weighted with 1/(K b) + 1/alpha, D the inverse of the lumped inertia;
 * each of the two stands for one limit of A, stiffness and inertia. Without M and with D the
 * inverse diagonal of A it is that of SIMPLE (Patankar and Spalding, 1972), without D the mass form
 * alone. Masses are inverted by a sweep of symmetric relaxation, C + B D B^T by a V-cycle of
 * algebraic multigrid.
 */
class SchurComplement
{
public:
  /// B and C, and one or both of M and the diagonal D; pointers may be null and are not kept.
  SchurComplement(const dealii::TrilinosWrappers::SparseMatrix &divergence,
                  const dealii::TrilinosWrappers::SparseMatrix &compression,
                  const dealii::TrilinosWrappers::SparseMatrix *mass_form,
                  const DistributedVector *mobility);

  /// target = the approximate inverse times source.
  void vmult(DistributedVector &target, const DistributedVector &source);
  /// The diagonal of the approximate Schur complement, roughly: what scales its rows.
  const DistributedVector &diagonal() const { return diagonal_entries; }

private:
  const bool has_mass, has_laplacian;
  dealii::TrilinosWrappers::SparseMatrix mass, laplacian;
  dealii::TrilinosWrappers::PreconditionSSOR mass_inverse;
  dealii::TrilinosWrappers::PreconditionAMG laplacian_inverse;
  DistributedVector work, diagonal_entries;
};
} // namespace Continua

#endif
