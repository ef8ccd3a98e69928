#include <continua/continuum/cavity_coupling.h>

#include <continua/base/input_error.h>
#include <continua/continuum/branch_history.h>
#include <continua/signal/jump.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
namespace
{
double volume_ratio(const BoundaryCondition &condition, const double time)
{
  const double origin[3] = {0., 0., 0.};
  return condition.volume_ratio(origin, time);
}
} // namespace

CavityCoupling::CavityCoupling(const Problem &problem, Operators &operators)
    : problem(problem), operators(operators), conditions(problem.cavities())
{
}

void CavityCoupling::initialise()
{
  present.assign(conditions.size(), CavityState());
}

void CavityCoupling::build()
{
  if (is_empty())
    return;
  present.resize(conditions.size());
  zero_velocity = operators.velocity_vector();
  // An assignment keeps the distribution of a vector of the same size.
  momentum.reinit(zero_velocity);
  mass = operators.pressure_vector();
  const std::vector<double> volumes = operators.cavity_volumes(zero_velocity);
  cavities.assign(conditions.size(), Cavity());
  for (unsigned int i = 0; i < cavities.size(); ++i)
  {
    cavities[i].rest_volume = volumes[i];
    for (DistributedVector *const vector :
         {&cavities[i].derivative, &cavities[i].force, &cavities[i].velocity_response})
      vector->reinit(zero_velocity);
    cavities[i].pressure_response.reinit(mass);
  }
  matrix.reinit(cavities.size(), cavities.size());
  differences.reinit(cavities.size());
  changes.reinit(cavities.size());
}

void CavityCoupling::begin_step(const Step &step)
{
  for (unsigned int i = 0; i < cavities.size(); ++i)
  {
    const BoundaryCondition &condition = problem.conditions[conditions[i]];
    const double ratio = volume_ratio(condition, step.balance_time);
    // What is no number fails the comparison.
    if (!(ratio > 0.))
    {
      std::ostringstream text;
      text << "the volume ratio of the cavity '" << condition.name << "' is " << ratio
           << " and not positive (Boundaries/" << condition.name << "/Volume ratio)";
      throw RunError(text.str());
    }
    cavities[i].given_volume = cavities[i].rest_volume * (1. + step.load_factor * (ratio - 1.));
  }
}

void CavityCoupling::measure(const BalancedStep &balanced)
{
  if (is_empty())
    return;
  const DistributedVector &displacement =
      problem.mesh_moves ? balanced.mesh_displacement : balanced.displacement;
  const std::vector<double> volumes = operators.cavity_volumes(displacement);
  for (unsigned int i = 0; i < cavities.size(); ++i)
  {
    cavities[i].volume = volumes[i];
    operators.linearise_cavity(i, displacement, cavities[i].derivative, cavities[i].force);
  }
}

double CavityCoupling::residual() const
{
  double largest = 0.;
  for (const Cavity &cavity : cavities)
  {
    const double share = std::abs(cavity.given_volume - cavity.volume) / cavity.given_volume;
    // What is no number stays.
    if (!(share <= largest))
      largest = share;
  }
  return largest;
}

void CavityCoupling::respond(const Solve &solve)
{
  for (Cavity &cavity : cavities)
  {
    momentum.equ(1., cavity.force);
    mass = 0.;
    solve(momentum, mass, cavity.velocity_response, cavity.pressure_response);
  }
}

double CavityCoupling::largest_flow() const
{
  double largest = 0.;
  for (const Cavity &cavity : cavities)
    largest =
        std::max(largest, cavity.derivative.linfty_norm() * cavity.velocity_response.linfty_norm());
  return largest;
}

void CavityCoupling::couple(const Step &step,
                            DistributedVector &velocity_change,
                            DistributedVector &pressure_change,
                            std::vector<double> &cavity_pressures)
{
  if (is_empty())
    return;
  const double displacement_by_velocity = BranchHistory::step_displacement(step);
  for (unsigned int i = 0; i < cavities.size(); ++i)
  {
    const Cavity &row = cavities[i];
    differences[i] = row.given_volume - row.volume -
                     displacement_by_velocity * (row.derivative * velocity_change);
    for (unsigned int j = 0; j < cavities.size(); ++j)
      matrix(i, j) = displacement_by_velocity * (row.derivative * cavities[j].velocity_response);
    if (matrix(i, i) == 0.)
      throw RunError("the volume of the cavity '" + problem.conditions[conditions[i]].name +
                     "' does not change by its pressure: nothing of its surface can move");
  }
  matrix.gauss_jordan();
  matrix.vmult(changes, differences);
  for (unsigned int i = 0; i < cavities.size(); ++i)
  {
    velocity_change.add(changes[i], cavities[i].velocity_response);
    pressure_change.add(changes[i], cavities[i].pressure_response);
    cavity_pressures[i] += changes[i];
  }
}

std::vector<double> CavityCoupling::pressures() const
{
  std::vector<double> numbers;
  for (const CavityState &cavity : present)
    numbers.push_back(cavity.pressure);
  return numbers;
}

void CavityCoupling::finish_step(const BalancedStep &balanced)
{
  for (unsigned int i = 0; i < present.size(); ++i)
    present[i].pressure = balanced.cavity_pressures[i];
}

const std::vector<CavityState> &CavityCoupling::states(const DistributedVector &displacement)
{
  if (is_empty())
    return present;
  const std::vector<double> volumes = operators.cavity_volumes(displacement);
  for (unsigned int i = 0; i < present.size(); ++i)
    present[i].volume = volumes[i];
  return present;
}

bool CavityCoupling::jumps(const double begin, const double end) const
{
  return std::any_of(conditions.begin(), conditions.end(),
                     [&](const unsigned int condition)
                     {
                       return jumps_within(
                           [&](const double time)
                           { return volume_ratio(problem.conditions[condition], time); },
                           begin, end);
                     });
}

void CavityCoupling::visit(StateVisitor &visitor)
{
  for (unsigned int i = 0; i < present.size(); ++i)
    visitor.value(StateName("cavity pressure", i), present[i].pressure);
}
} // namespace Continua
