#ifndef continua_finite_element_solvers_iterative_step_preconditioner_h
#define continua_finite_element_solvers_iterative_step_preconditioner_h

#include <continua/continuum/system_coefficients.h>
#include <continua/finite_element/solvers/matrix_free_relaxation.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/linear_algebra/schur_complement.h>
#include <continua/linear_algebra/velocity_preconditioner.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// The preconditioner of a step's system: approximate inverses of A, augmented or not, and of the
/// Schur complement, and what is known of them. PreconditionerMaker makes it.
template <int dim>
struct StepPreconditioner
{
  SystemCoefficients coefficients;
  /// A where something needs its entries later on, else empty.
  dealii::TrilinosWrappers::SparseMatrix velocity_matrix;
  std::unique_ptr<VelocityPreconditioner> velocity;
  std::unique_ptr<SchurComplement> schur_complement;
  /// A part of the above; null: the fluid is not relaxed by products without a matrix.
  MatrixFreeRelaxation<dim> *relaxation = nullptr;
  DistributedVector augmentation; ///< W
  std::vector<bool> is_stiff;     ///< of each owned velocity
  bool has_stiff = false, stiff_is_direct = true, fluid_is_viscous = false, has_inertia = true;
  bool has_polynomial_multigrid = false; ///< on the stiff block, else algebraic if not direct
  unsigned int first_iterations = 0;
  bool is_used = false, is_worn = false, has_fluid = true;
  std::string name, multigrid_name, fluid_multigrid_name;
};
} // namespace Continua

#endif
