#include <continua/finite_element/solvers/iterative/velocity_inverse_maker.h>

#include <continua/finite_element/solvers/chebyshev_relaxation.h>
#include <continua/finite_element/solvers/iterative/joint_block_assembly.h>
#include <continua/finite_element/solvers/iterative/velocity_rows.h>
#include <continua/finite_element/solvers/polynomial_multigrid.h>
#include <continua/finite_element/solvers/polynomial_relaxation.h>
#include <continua/linear_algebra/matrix_relaxation.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <utility>

namespace Continua
{
using namespace dealii;

template <int dim>
VelocityInverseMaker<dim>::VelocityInverseMaker(const Space<dim> &space,
                                                const std::vector<RegionOperators> &operators,
                                                const BoundaryConstraints<dim> &constraints,
                                                const LinearSolverParameters &parameters,
                                                const StepBlocks<dim> &blocks,
                                                StiffFactorLimit<dim> &limit)
    : space(space),
      operators(operators),
      constraints(constraints),
      parameters(parameters),
      blocks(blocks),
      limit(limit)
{
}

template <int dim>
void VelocityInverseMaker<dim>::make(const StiffRegions<dim> &stiff_regions,
                                     const PreconditionerPlan &plan,
                                     StepPreconditioner<dim> &made)
{
  VolumetricStiffness volumetric = volumetric_stiffness(stiff_regions, plan, made.coefficients);
  // Without a relaxation by the matrix only the rows of the stiff block are needed.
  const bool needs_all_rows = made.has_fluid && !plan.relaxes_without_matrix;
  const bool needs_stiff_rows = made.has_stiff && !made.has_polynomial_multigrid;
  // Where the regions have no matrices the joint block has none either, but its entries alone.
  const bool has_matrix =
      needs_all_rows ||
      (needs_stiff_rows &&
       !(plan.has_joint_block && blocks.matrix_free() != nullptr && operators.front().products));
  if (has_matrix)
    assemble_velocity_rows(space, operators, constraints, made.coefficients,
                           needs_all_rows ? nullptr : &plan.parts.stiff, volumetric,
                           made.velocity_matrix);

  std::unique_ptr<VelocityRelaxation> relaxation =
      make_relaxation(plan, volumetric.coefficients, made);
  if (plan.has_joint_block)
    make_joint_block(stiff_regions, plan, has_matrix, needs_all_rows, std::move(relaxation), made);
  else if (made.has_polynomial_multigrid)
  {
    TrilinosWrappers::SparseMatrix divergence_matrix;
    assemble_divergence(space, operators, constraints, divergence_matrix);
    made.velocity = std::make_unique<VelocityPreconditioner>(
        space.velocity_vector(),
        make_polynomial_multigrid(made, volumetric.coefficients, divergence_matrix),
        std::move(relaxation));
  }
  else
    made.velocity = std::make_unique<VelocityPreconditioner>(made.velocity_matrix, plan.parts,
                                                             std::move(relaxation));
  if (!needs_all_rows)
    made.velocity_matrix.clear();
}

template <int dim>
VolumetricStiffness
VelocityInverseMaker<dim>::volumetric_stiffness(const StiffRegions<dim> &stiff_regions,
                                                const PreconditionerPlan &plan,
                                                const SystemCoefficients &coefficients) const
{
  VolumetricStiffness volumetric;
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    const bool is_augmented = stiff_regions[region] && !plan.has_joint_block &&
                              parameters.schur_complement != SchurApproximation::simple;
    volumetric.coefficients.push_back(is_augmented ? coefficients.stiffness[region] : 0.);
  }
  return volumetric;
}

template <int dim>
std::unique_ptr<VelocityRelaxation>
VelocityInverseMaker<dim>::make_relaxation(const PreconditionerPlan &plan,
                                           const std::vector<double> &volumetric,
                                           StepPreconditioner<dim> &made)
{
  if (!made.has_fluid)
    return nullptr;
  if (!plan.relaxes_without_matrix)
    return std::make_unique<MatrixRelaxation>(made.velocity_matrix, plan.parts);
  const typename MatrixFreeRelaxation<dim>::Product::Coefficients coefficients{
      made.coefficients.mass, made.coefficients.stiffness, volumetric};
  std::unique_ptr<MatrixFreeRelaxation<dim>> relaxation;
  if (plan.fluid_has_multigrid)
  {
    auto multigrid = std::make_unique<PolynomialRelaxation<dim>>(
        single_precision_cells(), space, constraints, coefficients, plan.parts.fluid,
        limit.most_linear_bytes());
    made.fluid_multigrid_name = multigrid->name();
    relaxation = std::move(multigrid);
  }
  else
    relaxation = std::make_unique<ChebyshevRelaxation<dim>>(single_precision_cells(), coefficients,
                                                            plan.parts.fluid);
  made.relaxation = relaxation.get();
  return relaxation;
}

template <int dim>
void VelocityInverseMaker<dim>::make_joint_block(const StiffRegions<dim> &stiff_regions,
                                                 const PreconditionerPlan &plan,
                                                 const bool has_matrix,
                                                 const bool needs_all_rows,
                                                 std::unique_ptr<VelocityRelaxation> relaxation,
                                                 StepPreconditioner<dim> &made)
{
  // Compressible enough for a factor.
  std::vector<double> compressibility = made.coefficients.compressibility;
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (stiff_regions[region])
      compressibility[region] = std::max(
          compressibility[region], least_compressibility / made.coefficients.stiffness[region]);
  // Products in the iteration do without this matrix, and a factorisation has no memory to spare.
  TrilinosWrappers::SparseMatrix divergence_matrix;
  assemble_divergence(space, operators, constraints, divergence_matrix);
  TrilinosWrappers::SparseMatrix block_compression;
  assemble_pressure_mass(space, operators, compressibility, block_compression);
  auto block = std::make_unique<SaddlePointBlock>(divergence_matrix.trilinos_matrix(),
                                                  block_compression.trilinos_matrix(),
                                                  plan.parts.stiff, plan.stiff_pressures);
  if (has_matrix)
    block->add_velocity_entries(made.velocity_matrix.trilinos_matrix());
  else
    JointBlockAssembly<dim>(space, constraints, made.coefficients,
                            blocks.matrix_free()->support_matrix(), *block)
        .add_velocities(plan.parts.stiff);
  if (!needs_all_rows)
    made.velocity_matrix.clear();
  SaddlePointBlock &stiff_block = *block;
  made.velocity = std::make_unique<VelocityPreconditioner>(
      divergence_matrix, std::move(block), plan.stiff_pressures, std::move(relaxation));
  divergence_matrix.clear();
  stiff_block.factorize(plan.parts.most_factor_bytes);
}

template <int dim>
std::unique_ptr<VelocityCycle> VelocityInverseMaker<dim>::make_polynomial_multigrid(
    StepPreconditioner<dim> &made,
    const std::vector<double> &volumetric,
    const TrilinosWrappers::SparseMatrix &divergence_matrix)
{
  const SystemCoefficients &coefficients = made.coefficients;
  std::unique_ptr<TrilinosWrappers::SparseMatrix> supports;
  if (blocks.matrix_free()->support_matrix() != nullptr)
  {
    supports = std::make_unique<TrilinosWrappers::SparseMatrix>();
    supports->copy_from(*blocks.matrix_free()->support_matrix());
  }
  auto result = std::make_unique<PolynomialMultigrid<dim>>(
      single_precision_cells(), space, constraints,
      typename PolynomialMultigrid<dim>::Product::Coefficients{coefficients.mass,
                                                               coefficients.stiffness, volumetric},
      made.is_stiff, divergence_matrix, made.augmentation, std::move(supports),
      limit.most_linear_bytes());
  made.multigrid_name = result->name();
  if (!result->has_linear_factor())
    limit.refuse_linear_factor();
  return result;
}

template <int dim>
const MatrixFreeProduct<dim, float> &VelocityInverseMaker<dim>::single_precision_cells()
{
  if (!single_precision_product)
    single_precision_product = make_matrix_free_product<dim, float>(
        parameters.instruction_set,
        {space.mapping, space.velocity_dofs, constraints.all(), space.is_axisymmetric()});
  return *single_precision_product;
}

template class VelocityInverseMaker<2>;
template class VelocityInverseMaker<3>;
} // namespace Continua
