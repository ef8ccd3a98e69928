#include <continua/continuum/equation_term.h>

#include <continua/continuum/local_product.h>

#include <cmath>
#include <limits>

namespace Continua
{
namespace
{
/// rho dU/dt.
class InertiaTerm : public EquationTerm
{
public:
  double power(const unsigned int region,
               const FinishedStep &step,
               TermContext &context,
               DistributedVector *const forces) const override
  {
    const double density = context.problem.materials[region].density;
    if (context.operators.variant().reports_change_of_kinetic_energy())
      return 0.5 * density / step.solution.step.size() *
             (square(region, step.end, context) - square(region, step.start, context));
    const double of_terms =
        context.operators.is_nonlinear_in(region) ? context.nonlinear_powers.inertia : 0.;
    if (context.has_all_terms_in(region))
      return of_terms;
    if (context.has_products_of_step(region))
      context.products->set_inertia(region, step.solution.step, context.force);
    else
      context.operators.products().multiply_mass(region, context.force, step.solution.acceleration);
    context.force *= density;
    if (forces != nullptr)
      forces->add(1., context.force);
    return local_product(context.force, step.solution.velocity) + of_terms;
  }
  double energy(const unsigned int region, const State &state, TermContext &context) const override
  {
    if (context.operators.is_nonlinear_in(region))
      return context.nonlinear_energy.kinetic;
    const double density = context.problem.materials[region].density;
    if (context.has_products(region))
      return 0.5 * density * local_product(context.products->mass(region), state.velocity);
    return 0.5 * density * square(region, state.velocity, context);
  }

private:
  static double
  square(const unsigned int region, const DistributedVector &velocity, TermContext &context)
  {
    context.operators.products().multiply_mass(region, context.force, velocity);
    return local_product(context.force, velocity);
  }
};

/// The stress of the branches, 2 mu_k dev sym grad D_k, or in finite deformation that of the law.
class BranchTerm : public EquationTerm
{
public:
  double power(const unsigned int region,
               const FinishedStep &step,
               TermContext &context,
               DistributedVector *const forces) const override
  {
    if (is_finite(region, context))
      return context.nonlinear_powers.strain;
    if (context.has_products(region) && context.products->is_elastic(region))
    {
      context.products->set_stiffness(region, step.solution.step, context.force);
      context.force *= context.products->spring(region);
    }
    else if (context.history.mix_balanced(region, step.solution.step, context.mixture))
      context.operators.variant().set_reported_stress_force(region, step.solution, context.mixture,
                                                            context.force);
    else
      return 0.;
    if (forces != nullptr)
      forces->add(1., context.force);
    return local_product(context.force, step.solution.velocity);
  }
  double relaxation_power(const unsigned int region,
                          const StepSolution &step,
                          TermContext &context) const override
  {
    if (is_finite(region, context))
      return context.operators.nonlinear()->relaxation_power(region);
    double sum = 0.;
    for (const Branch &branch : context.problem.materials[region].shear.branches)
      if (!std::isinf(branch.relaxation_time))
      {
        context.history.balanced_displacement(branch.relaxation_time, step.step, context.mixture);
        context.history.forgotten_velocity(branch.relaxation_time, step.step, step.velocity,
                                           context.forgotten);
        context.operators.products().multiply_stiffness(region, context.force, context.mixture);
        sum += branch.shear_modulus * local_product(context.force, context.forgotten);
      }
    return sum;
  }
  double energy(const unsigned int region, const State &state, TermContext &context) const override
  {
    if (is_finite(region, context))
      return context.nonlinear_energy.strain;
    if (context.has_products(region) && context.products->is_elastic(region))
      return 0.5 * context.products->spring(region) *
             local_product(context.products->stiffness(region), state.history.displacement());
    double sum = 0.;
    for (const Branch &branch : context.problem.materials[region].shear.branches)
    {
      const DistributedVector &internal =
          state.history.internal_displacement(branch.relaxation_time);
      context.operators.products().multiply_stiffness(region, context.force, internal);
      sum += 0.5 * branch.shear_modulus * local_product(context.force, internal);
    }
    return sum;
  }

private:
  static bool is_finite(const unsigned int region, const TermContext &context)
  {
    return context.problem.region_model(region) == RegionModel::finite_solid;
  }
};

/// The stress of the viscosity, 2 eta dev sym grad U.
class ViscosityTerm : public EquationTerm
{
public:
  double power(const unsigned int region,
               const FinishedStep &step,
               TermContext &context,
               DistributedVector *const forces) const override
  {
    const Shear &shear = context.problem.materials[region].shear;
    if (shear.viscosity == 0.)
      return 0.;
    if (context.has_all_terms_in(region))
      return context.nonlinear_powers.viscosity;
    if (context.has_products_of_step(region))
      context.products->set_stiffness_of_velocity(region, step.solution.step, context.force);
    else
      context.operators.products().multiply_stiffness(region, context.force,
                                                      step.solution.velocity);
    context.force *= shear.viscosity;
    if (forces != nullptr)
      forces->add(1., context.force);
    return local_product(context.force, step.solution.velocity) +
           (shear.flow_curve ? context.nonlinear_powers.viscosity : 0.);
  }
};

/// The pressure, with the springs of a volume change that relaxes.
class CompressionTerm : public EquationTerm
{
public:
  double power(const unsigned int region,
               const FinishedStep &step,
               TermContext &context,
               DistributedVector *const forces) const override
  {
    if (context.has_all_terms_in(region))
      return context.nonlinear_powers.compression;
    if (forces == nullptr && context.products != nullptr &&
        context.products->has_divergence(region, step.solution.step))
      return -local_product(context.products->divergence(region), step.solution.pressure);
    if (forces == nullptr)
      return context.operators.products().pressure_power(region, step.solution.velocity,
                                                         step.solution.pressure);
    context.operators.products().multiply_gradient(region, context.force, step.solution.pressure);
    forces->add(1., context.force);
    return local_product(context.force, step.solution.velocity);
  }
  double relaxation_power(const unsigned int region,
                          const StepSolution &step,
                          TermContext &context) const override
  {
    double sum = 0.;
    const std::vector<BulkBranch> &branches =
        context.problem.materials[region].compression.bulk_branches();
    for (unsigned int k = 0; k < branches.size(); ++k)
      if (!std::isinf(branches[k].relaxation_time))
      {
        context.bulk_history.balanced_dilatation(region, k, step.step, context.dilatation);
        context.bulk_history.forgotten_rate(region, k, step.step, context.forgotten_rate);
        sum += branches[k].bulk_modulus * context.operators.products().pressure_product(
                                              region, context.dilatation, context.forgotten_rate);
      }
    return sum;
  }
  double energy(const unsigned int region, const State &state, TermContext &context) const override
  {
    if (context.operators.is_nonlinear_in(region))
      return context.nonlinear_energy.compressive;
    const Material &material = context.problem.materials[region];
    double sum = 0.;
    for (unsigned int k = 0; k < material.compression.bulk_branches().size(); ++k)
    {
      const DistributedVector &internal = context.bulk_history.internal_dilatation(region, k);
      sum += 0.5 * material.compression.bulk_branches()[k].bulk_modulus *
             context.operators.products().pressure_product(region, internal, internal);
    }
    if (material.compression.bulk_branches().empty())
      sum += 0.5 * material.inverse_bulk_modulus() *
             context.operators.products().pressure_product(region, state.pressure, state.pressure);
    return sum;
  }
};

/// A kind of power that regions of flow have alone.
template <PowerKind kind>
class FlowTerm : public EquationTerm
{
public:
  double power(const unsigned int region,
               const FinishedStep & /*step*/,
               TermContext &context,
               DistributedVector *const /*forces*/) const override
  {
    return context.problem.region_model(region) == RegionModel::flow
               ? context.nonlinear_powers.*kind
               : 0.;
  }
};

/// The springs of the supports.
class SupportTerm : public EquationTerm
{
public:
  double power(const unsigned int region,
               const FinishedStep &step,
               TermContext &context,
               DistributedVector *const forces) const override
  {
    context.history.balanced_displacement(std::numeric_limits<double>::infinity(),
                                          step.solution.step, context.mixture);
    context.operators.products().multiply_support_stiffness(region, context.force, context.mixture);
    if (forces != nullptr)
      forces->add(1., context.force);
    return local_product(context.force, step.solution.velocity);
  }
  double energy(const unsigned int region, const State &state, TermContext &context) const override
  {
    context.operators.products().multiply_support_stiffness(region, context.force,
                                                            state.history.displacement());
    return 0.5 * local_product(context.force, state.history.displacement());
  }
};

/// Their dampers.
class SupportDampingTerm : public EquationTerm
{
public:
  double power(const unsigned int region,
               const FinishedStep &step,
               TermContext &context,
               DistributedVector *const forces) const override
  {
    context.operators.products().multiply_support_damping(region, context.force,
                                                          step.solution.velocity);
    if (forces != nullptr)
      forces->add(1., context.force);
    return local_product(context.force, step.solution.velocity);
  }
};

template <typename Term>
std::unique_ptr<EquationTerm> make_term()
{
  return std::make_unique<Term>();
}
} // namespace

std::vector<EquationTermType> equation_terms(const Problem &problem)
{
  std::vector<EquationTermType> terms = {
      {"kinetic", "kinetic energy taken", true, false, make_term<InertiaTerm>},
      {"strain", "strain energy taken", true, true, make_term<BranchTerm>},
      {"viscous", "energy dissipated", false, false, make_term<ViscosityTerm>},
      {"compressive", "compressive energy taken", true, true, make_term<CompressionTerm>}};
  if (problem.has_supports())
  {
    terms.push_back({"support", "support energy taken", true, false, make_term<SupportTerm>});
    terms.push_back({"support damping", "energy damped by the support", false, false,
                     make_term<SupportDampingTerm>});
  }
  // On a mesh that moves the flow past it carries energy, also without convection.
  if (problem.has_regions_of(RegionModel::flow))
  {
    terms.push_back({"convective", "energy convected", false, false,
                     make_term<FlowTerm<&NonlinearPowers::convection>>});
    terms.push_back({"inflow", "energy taken from inflow", false, false,
                     make_term<FlowTerm<&NonlinearPowers::inflow>>});
    terms.push_back({"stabilisation", "energy taken by the stabilisation", false, false,
                     make_term<FlowTerm<&NonlinearPowers::stabilisation>>});
  }
  return terms;
}
} // namespace Continua
