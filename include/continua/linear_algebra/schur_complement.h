#ifndef continua_linear_algebra_schur_complement_h
#define continua_linear_algebra_schur_complement_h

#include <continua/linear_algebra/distributed_vector.h>
#include <continua/linear_algebra/sub_matrix.h>

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Epetra_Vector.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * An approximate inverse of the Schur complement C + B A^-1 B^T of the pressure. With a mass form M
 * it is that of Cahouet and Chabard (Int. J. Numer. Methods Fluids 8 (1988)) with compressibility,
 *
 *   M^-1 + (C + B D B^T)^-1,
 *
 * M a pressure mass matrix weighted with 1/(K b) + 1/alpha, D the inverse of the lumped inertia,
 * or of inertia and friction at walls (add_friction()); each of the two stands for one limit of A,
 * stiffness and inertia. Without M and with D the inverse diagonal of A it is that of SIMPLE
 * (Patankar and Spalding, 1972), without D the mass form alone. Masses are inverted by a sweep of
 * symmetric relaxation, C + B D B^T by a V-cycle of algebraic multigrid, whose aggregates join
 * pressures that are close to one another: on cells that are longer than thick the entries of B D
 * B^T along a cell are large and positive, and mislead.
 */
class SchurComplement
{
public:
  /// Coordinates of this rank's pressures, one vector for each direction [m]. No two pressures have
  /// the same place.
  using Places = std::vector<std::vector<double>>;

  /// B and C, and one or both of M and the diagonal D; pointers may be null and are not kept. B is
  /// freed as soon as nothing needs it: while B D B^T is made a run may have most in memory.
  SchurComplement(dealii::TrilinosWrappers::SparseMatrix &&divergence,
                  const dealii::TrilinosWrappers::SparseMatrix &compression,
                  const dealii::TrilinosWrappers::SparseMatrix *mass_form,
                  const DistributedVector *mobility,
                  const Places &places);
  /// Of some pressures only, by the local indices of this rank's; the others stay out of it.
  SchurComplement(dealii::TrilinosWrappers::SparseMatrix &&divergence,
                  const dealii::TrilinosWrappers::SparseMatrix &compression,
                  const dealii::TrilinosWrappers::SparseMatrix *mass_form,
                  const DistributedVector *mobility,
                  const Places &places,
                  const std::vector<unsigned int> &pressures);

  /// target = the approximate inverse times source; zero for pressures that stay out.
  void vmult(DistributedVector &target, const DistributedVector &source);
  /// From now on the inverse of the mass form is R M^-1 R with this diagonal R [1], of all of this
  /// rank's pressures. There has to be a mass form. diagonal() stays as it is.
  void scale_mass_inverse(const DistributedVector &roots);
  /// The diagonal of the approximate Schur complement of all pressures, roughly: what scales rows.
  const DistributedVector &diagonal() const { return diagonal_entries; }

private:
  const bool has_mass, has_laplacian;
  dealii::TrilinosWrappers::SparseMatrix mass, laplacian;
  dealii::TrilinosWrappers::PreconditionSSOR mass_inverse;
  Places places_of_part; ///< of the multigrid, which keeps pointers
  dealii::TrilinosWrappers::PreconditionAMG laplacian_inverse;
  std::unique_ptr<SubMatrix> part; ///< of C
  std::unique_ptr<Epetra_Vector> right_hand_side, solution, correction;
  std::unique_ptr<Epetra_Vector> mass_roots; ///< R; null: one
  bool is_empty = false;
  DistributedVector diagonal_entries;

  void set_diagonal(const dealii::TrilinosWrappers::SparseMatrix &divergence,
                    const dealii::TrilinosWrappers::SparseMatrix &compression,
                    const dealii::TrilinosWrappers::SparseMatrix *mass_form,
                    const DistributedVector *mobility);
};
} // namespace Continua

#endif
