#include <continua/finite_element/solvers/iterative/step_blocks.h>

#include <continua/finite_element/products/matrix_free_regions.h>
#include <continua/finite_element/solvers/condensed_system.h>

namespace Continua
{
using namespace dealii;

template <int dim>
StepBlocks<dim>::StepBlocks(const Space<dim> &space,
                            const std::vector<RegionOperators> &operators,
                            const BoundaryConstraints<dim> &constraints,
                            const LinearSolverParameters &parameters)
    : space(space),
      operators(operators),
      constraints(constraints),
      parameters(parameters),
      divergence(space, operators, constraints)
{
}

template <int dim>
void StepBlocks<dim>::set(const SystemCoefficients &coefficients)
{
  if (!are_set() && parameters.is_matrix_free(space.degree()))
  {
    // The products of regions, if there are any, are of the same object.
    auto regions =
        std::dynamic_pointer_cast<const MatrixFreeRegions<dim>>(operators.front().products);
    if (!regions)
      regions = std::make_shared<MatrixFreeRegions<dim>>(space, constraints, operators.size(),
                                                         parameters.instruction_set);
    matrix_free_velocity = std::make_unique<MatrixFreeVelocity<dim>>(space, operators, constraints,
                                                                     regions->product());
    matrix_free_divergence = std::make_unique<MatrixFreeDivergence<dim>>(space, regions->product());
  }
  if (matrix_free_velocity)
    matrix_free_velocity->set(coefficients);
  else
  {
    assemble_velocity_block(space, operators, constraints, coefficients, nullptr, nullptr,
                            velocity_matrix);
    assembled_velocity = std::make_unique<MatrixOperator>(velocity_matrix);
  }
  assemble_pressure_mass(space, operators, coefficients.compressibility, compression_matrix);
}

template <int dim>
const VelocityOperator &StepBlocks<dim>::velocity() const
{
  if (matrix_free_velocity)
    return *matrix_free_velocity;
  return *assembled_velocity;
}

template <int dim>
SaddlePointSolver::Blocks StepBlocks<dim>::all() const
{
  if (!matrix_free_divergence)
    return {velocity(), divergence, compression_matrix};
  return {velocity(), *matrix_free_divergence, compression_matrix,
          [this](const DistributedVector &of_velocity, const DistributedVector &of_pressure,
                 DistributedVector &momentum, DistributedVector &mass)
          {
            matrix_free_divergence->multiply_with(*matrix_free_velocity, momentum, mass,
                                                  of_velocity, of_pressure);
          }};
}

template class StepBlocks<2>;
template class StepBlocks<3>;
} // namespace Continua
