#ifndef continua_finite_element_space_linear_solver_parameters_h
#define continua_finite_element_space_linear_solver_parameters_h

#include <continua/base/instruction_set.h>
#include <continua/linear_algebra/direct_solver.h>

namespace Continua
{
/// The solver of the step's system.
enum class LinearSolverType
{
  automatic, ///< choose_step_solver()
  direct,
  iterative
};

/// The precision of a direct solver's factor. The solution has double precision in any case.
enum class FactorPrecision
{
  automatic, ///< double if that fits into the memory
  double_precision,
  single_precision
};

/// How the iterative solver approximates the pressure's matrix.
enum class SchurApproximation
{
  automatic, ///< cahouet_chabard
  cahouet_chabard,
  simple
};

/// What the iterative solver does with the solid.
enum class StiffBlock
{
  automatic, ///< by StiffBlockLimits
  direct,
  polynomial_multigrid, ///< PolynomialMultigrid
  algebraic_multigrid
};

/// Up to where `automatic` takes a factor of the stiff block. It always does up to a number of its
/// velocities on all ranks. Beyond it does where the factor takes little memory: the block of a
/// thin wall is nearly a surface, whose factor is small, and for which multigrid is a poor inverse.
struct StiffBlockLimits
{
  unsigned int small_in_plane = 400000, small_in_space = 60000;
  // Beyond these an estimate of the factor alone takes too much memory.
  unsigned int largest = 1000000;
  double largest_share = 0.5; ///< of all velocities
  /// Of the factor, by an estimate and by its analysis, for each unknown of the whole system.
  double bytes_per_unknown = 1000.;
  /// The same of the linear velocities in polynomial multigrid, up to a number of stiff velocities.
  double linear_bytes_per_unknown = 250.;
  unsigned int largest_with_linear_factor = 2000000;
};

/// What the iterative solver does with the fluid.
enum class FluidBlock
{
  automatic, ///< relaxation unless viscosity evens velocities out over several cells within a step
  relaxation,
  algebraic_multigrid
};

/// How the iterative solver forms its products with the velocities' matrix.
enum class VelocityProduct
{
  automatic, ///< without a matrix if the velocity is quadratic
  assembled,
  matrix_free
};

/// The section Linear solver.
struct LinearSolverParameters
{
  LinearSolverType type = LinearSolverType::automatic;
  DirectSolver direct_solver = DirectSolver::automatic;
  FactorPrecision factor_precision = FactorPrecision::automatic;
  unsigned int refinement_steps = 0;
  unsigned int kept_factors = 2;
  // Of the iterative solver.
  double tolerance = 1e-8;
  unsigned int maximum_iterations = 500;
  unsigned int restart_length = 60;
  SchurApproximation schur_complement = SchurApproximation::automatic;
  StiffBlock stiff_block = StiffBlock::automatic;
  StiffBlockLimits stiff_block_limits; ///< no entries of the section
  FluidBlock fluid_block = FluidBlock::automatic;
  VelocityProduct velocity_product = VelocityProduct::automatic;
  InstructionSet instruction_set = widest_instruction_set(); ///< of products without a matrix

  /// Whether the products with the velocities' matrix have none.
  bool is_matrix_free(const unsigned int velocity_degree) const
  {
    return velocity_product == VelocityProduct::matrix_free ||
           (velocity_product == VelocityProduct::automatic && velocity_degree == 2);
  }
  void read(ParameterSection section);
};
} // namespace Continua

#endif
