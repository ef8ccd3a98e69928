#include <continua/finite_element/solvers/iterative/preconditioner_maker.h>

#include <continua/base/memory_limit.h>
#include <continua/finite_element/solvers/condensed_system.h>
#include <continua/finite_element/solvers/iterative/fluid_mobility.h>
#include <continua/finite_element/solvers/iterative/pressure_places.h>
#include <continua/finite_element/space/velocity_nodes.h>
#include <continua/linear_algebra/matrix_product.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>

namespace Continua
{
using namespace dealii;

template <int dim>
PreconditionerMaker<dim>::PreconditionerMaker(const Space<dim> &space,
                                              const std::vector<RegionOperators> &operators,
                                              const BoundaryConstraints<dim> &constraints,
                                              const LinearSolverParameters &parameters,
                                              const StepBlocks<dim> &blocks,
                                              MemoryUse *const memory_use)
    : space(space),
      operators(operators),
      constraints(constraints),
      parameters(parameters),
      blocks(blocks),
      memory_use(memory_use),
      limit(space, constraints, parameters),
      velocity_inverse_maker(space, operators, constraints, parameters, blocks, limit)
{
}

template <int dim>
std::unique_ptr<StepPreconditioner<dim>>
PreconditionerMaker<dim>::make(const SystemCoefficients &coefficients)
{
  try
  {
    return try_to_make(coefficients);
  }
  catch (const FactorTooLarge &factor)
  {
    limit.refuse(factor.bytes);
  }
  return try_to_make(coefficients);
}

template <int dim>
std::unique_ptr<StepPreconditioner<dim>>
PreconditionerMaker<dim>::try_to_make(const SystemCoefficients &coefficients)
{
  auto made = std::make_unique<StepPreconditioner<dim>>();
  made->coefficients = coefficients;
  {
    const StiffRegions<dim> stiff_regions(space, operators, coefficients);
    PreconditionerPlan plan = choose_blocks(stiff_regions, *made);
    std::vector<double> mass_factors;
    augment(stiff_regions, plan, mass_factors, *made);
    mark_memory("preconditioner of the velocities");
    velocity_inverse_maker.make(stiff_regions, plan, *made);
    mark_memory("preconditioner of the velocities"); // also frees what the factorisation leaves

    if (made->has_stiff && made->has_fluid && made->has_inertia && !is_simple())
      stiff_regions.add_wall_compliance(constraints, *made->velocity, plan.mobility);
    if (made->has_fluid && made->fluid_is_viscous && !is_simple())
    {
      add_friction(space, operators, constraints, blocks.velocity(), *made, plan.mobility);
      plan.has_mobility = true;
    }
    make_schur_complement(plan, mass_factors, *made);
    made->name = name_of(plan, *made);
    mark_memory("preconditioner of the pressure");
  }
  // What was needed for making it is free.
  mark_memory("preconditioner of the velocities");
  return made;
}

template <int dim>
PreconditionerPlan PreconditionerMaker<dim>::choose_blocks(const StiffRegions<dim> &stiff_regions,
                                                           StepPreconditioner<dim> &made)
{
  const SystemCoefficients &coefficients = made.coefficients;
  const bool has_inertia = std::all_of(coefficients.mass.begin(), coefficients.mass.end(),
                                       [](const double mass) { return mass > 0.; });

  PreconditionerPlan plan;
  plan.mobility = space.velocity_vector();
  plan.has_mobility = has_inertia;
  double fluid_ratio = 0.;
  plan.parts = stiff_regions.velocity_blocks(blocks.velocity(), plan.mobility, fluid_ratio);
  VelocityBlocks &parts = plan.parts;
  const auto n_stiff =
      Utilities::MPI::sum(static_cast<unsigned int>(parts.stiff.size()), space.communicator);
  const bool has_fluid =
      Utilities::MPI::sum(static_cast<unsigned int>(parts.fluid.size()), space.communicator) > 0;
  limit.set_size(n_stiff);
  parts.most_factor_bytes = limit.most_bytes();
  limit.refuse_large_factor(parts);
  parts.stiff_is_direct = parts.most_factor_bytes > 0.;
  parts.fluid_is_viscous = parameters.fluid_block == FluidBlock::algebraic_multigrid ||
                           (parameters.fluid_block == FluidBlock::automatic &&
                            (fluid_ratio > viscous_ratio || !has_inertia));
  plan.relaxes_without_matrix =
      can_relax_without_matrix(stiff_regions, coefficients) &&
      !(parts.fluid_is_viscous && parameters.fluid_block == FluidBlock::algebraic_multigrid);
  plan.fluid_has_multigrid = plan.relaxes_without_matrix && parts.fluid_is_viscous;
  plan.has_joint_block = n_stiff > 0 && parts.stiff_is_direct && !is_simple();

  made.has_polynomial_multigrid = n_stiff > 0 && !parts.stiff_is_direct &&
                                  blocks.matrix_free() != nullptr &&
                                  parameters.stiff_block != StiffBlock::algebraic_multigrid;
  const bool has_algebraic_multigrid =
      (n_stiff > 0 && !parts.stiff_is_direct && !made.has_polynomial_multigrid) ||
      (has_fluid && parts.fluid_is_viscous && !plan.fluid_has_multigrid);
  if (has_algebraic_multigrid)
    parts.modes = rigid_motions(space.mapping, space.velocity_dofs);
  if (plan.has_joint_block)
    plan.stiff_pressures = stiff_regions.pressures();
  made.has_fluid = has_fluid;
  made.has_stiff = n_stiff > 0;
  made.stiff_is_direct = parts.stiff_is_direct;
  made.fluid_is_viscous = parts.fluid_is_viscous;
  made.has_inertia = has_inertia;
  made.is_stiff.assign(space.velocity_owned.n_elements(), false);
  for (const unsigned int i : parts.stiff)
    made.is_stiff[i] = true;
  return plan;
}

template <int dim>
bool PreconditionerMaker<dim>::can_relax_without_matrix(
    const StiffRegions<dim> &stiff_regions, const SystemCoefficients &coefficients) const
{
  if (blocks.matrix_free() == nullptr)
    return false;
  // Its products have no supports, and those of stiff regions are in the stiff block.
  if (coefficients.support_stiffness == 0. && coefficients.support_damping == 0.)
    return true;
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (operators[region].is_supported && !stiff_regions[region])
      return false;
  return true;
}

template <int dim>
void PreconditionerMaker<dim>::augment(const StiffRegions<dim> &stiff_regions,
                                       const PreconditionerPlan &plan,
                                       std::vector<double> &mass_factors,
                                       StepPreconditioner<dim> &made) const
{
  const SystemCoefficients &coefficients = made.coefficients;
  // The mass form of the Schur complement follows an augmentation by a bulk modulus of alpha.
  made.augmentation = space.pressure_vector();
  DistributedVector one = space.pressure_vector(), volume = space.pressure_vector();
  one = 1.;
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    const double alpha = coefficients.stiffness[region];
    const bool is_augmented = stiff_regions[region] && !is_simple() && !plan.has_joint_block;
    mass_factors.push_back((1. / std::max(alpha, 1e-100) + coefficients.compressibility[region]) /
                           (is_augmented ? 2. : 1.));
    if (!is_augmented)
      continue;
    multiply(operators[region].pressure_mass, volume, one);
    for (unsigned int i = 0; i < volume.locally_owned_size(); ++i)
      if (volume.begin()[i] > 0. &&
          !space.pressure_hanging.is_constrained(space.pressure_owned.nth_index_in_set(i)))
        made.augmentation.begin()[i] = alpha / volume.begin()[i];
  }
}

template <int dim>
void PreconditionerMaker<dim>::make_schur_complement(PreconditionerPlan &plan,
                                                     const std::vector<double> &mass_factors,
                                                     StepPreconditioner<dim> &made) const
{
  DistributedVector &mobility = plan.mobility;
  const SchurComplement::Places places = places_of_pressures(space, operators.size());
  TrilinosWrappers::SparseMatrix divergence_matrix;
  assemble_divergence(space, operators, constraints, divergence_matrix);
  if (is_simple())
  {
    for (unsigned int i = 0; i < mobility.locally_owned_size(); ++i)
      mobility.begin()[i] = 1. / blocks.velocity().diagonal().begin()[i];
    made.schur_complement = std::make_unique<SchurComplement>(
        std::move(divergence_matrix), blocks.compression(), nullptr, &mobility, places);
  }
  else
  {
    TrilinosWrappers::SparseMatrix mass_form;
    assemble_pressure_mass(space, operators, mass_factors, mass_form);
    std::vector<unsigned int> pressures;
    std::vector<bool> is_left_out(space.pressure_owned.n_elements(), false);
    for (const unsigned int i : plan.stiff_pressures)
      is_left_out[i] = true;
    for (unsigned int i = 0; i < is_left_out.size(); ++i)
      if (!is_left_out[i])
        pressures.push_back(i);
    made.schur_complement = std::make_unique<SchurComplement>(
        std::move(divergence_matrix), blocks.compression(), &mass_form,
        plan.has_mobility ? &mobility : nullptr, places, pressures);
  }
}

template <int dim>
std::string PreconditionerMaker<dim>::name_of(const PreconditionerPlan &plan,
                                              const StepPreconditioner<dim> &made) const
{
  const VelocityBlocks &parts = plan.parts;
  std::ostringstream text;
  text << "FGMRES";
  if (made.has_stiff)
    text << "; stiff block: "
         << (parts.stiff_is_direct           ? made.velocity->factor()->name()
             : made.has_polynomial_multigrid ? made.multigrid_name
                                             : "algebraic multigrid");
  const std::optional<double> refused_bytes = limit.refused_bytes();
  if (!parts.stiff_is_direct && refused_bytes)
    text << ", since a factor would need " << memory_text(*refused_bytes);
  if (made.has_fluid)
    text << "; fluid block: "
         << (plan.fluid_has_multigrid      ? made.fluid_multigrid_name
             : parts.fluid_is_viscous      ? "algebraic multigrid"
             : plan.relaxes_without_matrix ? "Chebyshev relaxation"
                                           : "relaxation");
  text << "; Schur complement: " << (is_simple() ? "simple" : "cahouet-chabard");
  if (blocks.matrix_free() != nullptr)
    text << "; products without a matrix ("
         << word_of(instruction_set_words(),
                    instruction_set_of_products<dim>(parameters.instruction_set))
         << ")";
  return text.str();
}

template <int dim>
void PreconditionerMaker<dim>::mark_memory(const std::string &part) const
{
  if (memory_use != nullptr)
    memory_use->mark(part);
}

template class PreconditionerMaker<2>;
template class PreconditionerMaker<3>;
} // namespace Continua
