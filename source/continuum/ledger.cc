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

void Ledger::reinit()
{
  forces = operators.velocity_vector();
  for (auto &of_region : forces_of_regions)
    of_region.second = operators.velocity_vector();
  for (DistributedVector *vector : {&context.force, &context.mixture, &context.forgotten})
    vector->reinit(forces);
  if (problem.convection.is_explicit())
  {
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

void Ledger::set_nonlinear_powers(const unsigned int region,
                                  const StepSolution &solution,
                                  DistributedVector *const at_nodes)
{
  NonlinearPowers &powers = context.nonlinear_powers;
  powers = {};
  const auto add = [&](const StepSolution &state, const TermsTaken taken)
  { operators.nonlinear()->add_powers(region, state, solution.velocity, taken, powers, at_nodes); };
  if (!problem.convection.is_explicit() || solution.step.finds_steady_state ||
      problem.region_model(region) != RegionModel::flow)
  {
    add(solution, TermsTaken::all);
    return;
  }
  add(solution, TermsTaken::not_carrying);
  // What the step has taken from the extrapolated velocity.
  extrapolated.step = solution.step;
  extrapolated.velocity.equ(1., solution.extrapolated_velocity);
  extrapolated.pressure.equ(1., solution.pressure);
  extrapolated.acceleration.equ(1., solution.acceleration);
  extrapolated.pressure_rate.equ(1., solution.pressure_rate);
  add(extrapolated, TermsTaken::carrying);
}

PowerBalance Ledger::balance(const FinishedStep &step, const bool relaxation)
{
  const std::size_t n_regions = problem.materials.size(), n_terms = terms.size();
  const StepSolution &solution = step.solution;
  PowerBalance balance;
  balance.time = solution.step.balance_time;
  balance.materials.resize(n_regions);
  // Numbers of this rank; all are summed over the ranks at once.
  sums.clear();

  // What the equations leave at the nodes - inertia + inner forces - loads - is the force that
  // moves those of prescribed velocity. Where nothing moves it does no work.
  const bool reactions = forces_are_wanted || !operators.prescribed().is_homogeneous();
  forces = 0.;
  operators.loads().add(balance.time, forces);
  sums.push_back(local_product(forces, solution.velocity));
  if (reactions)
  {
    outlets.add_forces(1., forces);
    forces *= -1.;
  }
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    // The forces of a region that are wanted by themselves are added to those of the body later.
    const auto found = forces_of_regions.find(region);
    const bool is_wanted = found != forces_of_regions.end();
    if (is_wanted)
      found->second = 0.;
    DistributedVector *const target = !reactions ? nullptr : is_wanted ? &found->second : &forces;
    if (operators.is_nonlinear_in(region))
    {
      set_nonlinear_powers(region, solution, target);
      // Loads that follow the present shape.
      sums.front() -= context.nonlinear_powers.load;
    }
    for (const auto &term : terms)
      sums.push_back(term->power(region, step, context, target));
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
        relaxed += term->relaxation_power(region, solution, context);
    sums.push_back(relaxed);
  }
  forces_are_current = reactions;
  sums.push_back(reactions ? local_product(forces, solution.prescribed) : 0.);
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
      context.nonlinear_energy = operators.nonlinear()->energy(region, state);
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
