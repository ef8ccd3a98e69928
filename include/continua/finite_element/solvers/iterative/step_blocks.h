#ifndef continua_finite_element_solvers_iterative_step_blocks_h
#define continua_finite_element_solvers_iterative_step_blocks_h

#include <continua/continuum/system_coefficients.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/solvers/matrix_free_divergence.h>
#include <continua/finite_element/solvers/matrix_free_velocity.h>
#include <continua/finite_element/solvers/region_divergence.h>
#include <continua/finite_element/space/linear_solver_parameters.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/matrix_operator.h>
#include <continua/linear_algebra/saddle_point_solver.h>

#include <memory>
#include <vector>

namespace Continua
{
/// The blocks A [kg/s], B [m^(dim-1)] and C [m^3/(Pa s)] of a step's system (see StepSystem) with
/// the present coefficients. A is a product without a matrix, and B with it, or a matrix.
template <int dim>
class StepBlocks
{
public:
  /// The first three must outlive it.
  StepBlocks(const Space<dim> &space,
             const std::vector<RegionOperators> &operators,
             const BoundaryConstraints<dim> &constraints,
             const LinearSolverParameters &parameters);

  /// Assembles the blocks of the coefficients. Collective.
  void set(const SystemCoefficients &coefficients);
  /// Whether set() was called.
  bool are_set() const { return matrix_free_velocity || assembled_velocity; }

  /// A.
  const VelocityOperator &velocity() const;
  /// A without a matrix; null where A is a matrix.
  const MatrixFreeVelocity<dim> *matrix_free() const { return matrix_free_velocity.get(); }
  /// C.
  const dealii::TrilinosWrappers::SparseMatrix &compression() const { return compression_matrix; }
  SaddlePointSolver::Blocks all() const;

private:
  const Space<dim> &space;
  const std::vector<RegionOperators> &operators;
  const BoundaryConstraints<dim> &constraints;
  const LinearSolverParameters parameters;
  std::unique_ptr<MatrixFreeVelocity<dim>> matrix_free_velocity;
  dealii::TrilinosWrappers::SparseMatrix velocity_matrix;
  std::unique_ptr<MatrixOperator> assembled_velocity;
  RegionDivergence<dim> divergence;
  std::unique_ptr<MatrixFreeDivergence<dim>> matrix_free_divergence;
  dealii::TrilinosWrappers::SparseMatrix compression_matrix;
};
} // namespace Continua

#endif
