#include <continua/continuum/ledger.h>

#include <continua/continuum/local_product.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

Ledger::Ledger(const Problem &problem,
               Operators &operators,
               const OutletCoupling &outlets,
               const BranchHistory &history,
               const BulkHistory &bulk_history,
               LevelProducts *const products)
    : problem(problem),
      operators(operators),
      outlets(outlets),
      context{problem, operators, history, bulk_history, products}
{
  for (const EquationTermType &type : equation_terms(problem))
    terms.push_back(type.make());
}

void Ledger::want_forces(const std::set<unsigned int> &regions)
{
  forces_are_wanted = true;
  for (const unsigned int region : regions)
    if (forces_of_regions.count(region) == 0)
      forces_of_regions[region] = operators.velocity_vector();
}

void Ledger::reinit(NonlinearForces &of_region) const
{
  if (problem.is_nonlinear())
    for (DistributedVector *vector :
         {&of_region.inertia, &of_region.viscosity, &of_region.compression, &of_region.load})
      vector->reinit(forces);
  if (problem.has_regions_of(RegionModel::flow))
    for (DistributedVector *vector :
         {&of_region.convection, &of_region.stabilisation, &of_region.inflow})
      vector->reinit(forces);
  if (problem.has_regions_of(RegionModel::finite_solid))
    of_region.strain.reinit(forces);
}

void Ledger::reinit()
{
  forces = operators.velocity_vector();
  for (auto &of_region : forces_of_regions)
    of_region.second = operators.velocity_vector();
  for (DistributedVector *vector : {&context.force, &context.mixture, &context.forgotten})
    vector->reinit(forces);
  reinit(context.nonlinear_forces);
  if (problem.convection.is_explicit())
  {
    reinit(explicit_forces);
    for (DistributedVector *vector : {&extrapolated.velocity, &extrapolated.acceleration})
      vector->reinit(forces);
    for (DistributedVector *vector : {&extrapolated.pressure, &extrapolated.pressure_rate})
      *vector = operators.pressure_vector();
  }
  for (DistributedVector *vector : {&context.dilatation, &context.forgotten_rate})
    *vector = operators.pressure_vector();
  forces_are_current = true;
}

const DistributedVector &Ledger::forces_at_nodes(const FinishedStep &step,
                                                 const std::optional<unsigned int> region)
{
  Assert(forces_are_wanted, ExcInternalError());
  if (!forces_are_current)
    balance(step, false);
  return region ? forces_of_regions.at(*region) : forces;
}

void Ledger::set_nonlinear_forces(const unsigned int region, const BalancedStep &balanced)
{
  operators.set_nonlinear_forces(region, balanced, context.nonlinear_forces);
  if (!problem.convection.is_explicit() || balanced.step.is_towards_rest ||
      problem.region_model(region) != RegionModel::flow)
    return;
  // What the step has taken from the extrapolated velocity.
  extrapolated.step = balanced.step;
  extrapolated.velocity.equ(1., balanced.extrapolated_velocity);
  extrapolated.pressure.equ(1., balanced.pressure);
  extrapolated.acceleration.equ(1., balanced.acceleration);
  extrapolated.pressure_rate.equ(1., balanced.pressure_rate);
  operators.set_nonlinear_forces(region, extrapolated, explicit_forces);
  for (const auto kind : {&NonlinearForces::convection, &NonlinearForces::inflow})
    (context.nonlinear_forces.*kind).swap(explicit_forces.*kind);
}

PowerBalance Ledger::balance(const FinishedStep &step, const bool relaxation)
{
  const std::size_t n_regions = problem.materials.size(), n_terms = terms.size();
  const BalancedStep &balanced = step.balanced;
  PowerBalance balance;
  balance.time = balanced.step.balance_time;
  balance.materials.resize(n_regions);
  // Numbers of this rank; all are summed over the ranks at once.
  sums.clear();

  // What the equations leave at the nodes - inertia + inner forces - loads - is the force that
  // moves those of prescribed velocity. Where nothing moves it does no work.
  const bool reactions = forces_are_wanted || !operators.is_homogeneous();
  forces = 0.;
  operators.loads().add(balance.time, forces);
  sums.push_back(local_product(forces, balanced.velocity));
  if (reactions)
  {
    outlets.add_forces(1., forces);
    forces *= -1.;
  }
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    const bool is_nonlinear = operators.is_nonlinear_in(region);
    if (is_nonlinear)
      set_nonlinear_forces(region, balanced);
    // The forces of a region that are wanted by themselves are added to those of the body later.
    const auto found = forces_of_regions.find(region);
    const bool is_wanted = found != forces_of_regions.end();
    if (is_wanted)
      found->second = 0.;
    DistributedVector *const target = is_wanted ? &found->second : &forces;
    if (is_nonlinear)
    {
      // Loads that follow the present shape.
      const DistributedVector &load = context.nonlinear_forces.load;
      sums.front() -= local_product(load, balanced.velocity);
      if (reactions)
        target->add(1., load);
    }
    for (const auto &term : terms)
      sums.push_back(term->power(region, step, context, reactions ? target : nullptr));
    if (is_wanted)
    {
      forces.add(1., found->second);
      found->second *= -1.;
      operators.loads_of(region).add(balance.time, found->second);
      outlets.add_forces_of(region, 1., found->second);
      found->second *= -1.;
    }
    double relaxed = 0.;
    if (relaxation)
      for (const auto &term : terms)
        relaxed += term->relaxation_power(region, balanced, context);
    sums.push_back(relaxed);
  }
  forces_are_current = reactions;
  sums.push_back(reactions ? local_product(forces, balanced.prescribed) : 0.);
  Utilities::MPI::sum(sums, problem.communicator, sums);

  balance.external = sums.front() + sums.back();
  balance.residual = balance.external;
  balance.exchanged = std::abs(balance.external);
  for (std::size_t region = 0; region < n_regions; ++region)
  {
    const auto of_region = sums.begin() + 1 + region * (n_terms + 1);
    Power &power = balance.materials[region];
    power.terms.assign(of_region, of_region + n_terms);
    power.relaxation = of_region[n_terms];
    balance.residual -= power.sum();
    for (const double of_term : power.terms)
      balance.exchanged += std::abs(of_term);
  }
  outlets.power(balance.outlets);
  for (const OutletPower &power : balance.outlets)
  {
    balance.residual -= power.leaving;
    balance.exchanged += std::abs(power.leaving);
  }
  return balance;
}

Energy Ledger::energy(const State &state)
{
  const std::size_t n_regions = problem.materials.size();
  sums.clear();
  for (unsigned int region = 0; region < n_regions; ++region)
  {
    if (operators.is_nonlinear_in(region))
      context.nonlinear_energy = operators.nonlinear_energy(region, state);
    for (const auto &term : terms)
      sums.push_back(term->energy(region, state, context));
  }
  Utilities::MPI::sum(sums, problem.communicator, sums);
  Energy energy;
  energy.terms.assign(terms.size(), std::vector<double>(n_regions));
  for (std::size_t region = 0; region < n_regions; ++region)
    for (std::size_t term = 0; term < terms.size(); ++term)
      energy.terms[term][region] = sums[region * terms.size() + term];
  energy.outlets = outlets.energy();
  return energy;
}
} // namespace Continua
