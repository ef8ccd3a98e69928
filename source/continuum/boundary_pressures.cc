#include <continua/continuum/boundary_pressures.h>

#include <continua/base/input_error.h>
#include <continua/continuum/branch_history.h>
#include <continua/signal/jump.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
namespace
{
const double origin[3] = {0., 0., 0.};

/// Of each entry's product alone, all signs taken away; of all ranks.
double sum_of_sizes(const DistributedVector &section, const DistributedVector &velocity)
{
  double sum = 0.;
  for (unsigned int i = 0; i < section.locally_owned_size(); ++i)
    sum += std::abs(section.begin()[i] * velocity.begin()[i]);
  return dealii::Utilities::MPI::sum(sum, section.get_mpi_communicator());
}
} // namespace

BoundaryPressures::BoundaryPressures(const Problem &problem, Operators &operators)
    : problem(problem), operators(operators), conditions(problem.unknown_pressures())
{
}

const Waveform &BoundaryPressures::given(const unsigned int row) const
{
  const BoundaryCondition &condition = problem.conditions[conditions[row]];
  return condition.is_cavity() ? condition.volume_ratio : condition.free_flow->rate;
}

void BoundaryPressures::initialise()
{
  present.assign(conditions.size(), CavityState());
  largest_flow_rates.assign(conditions.size(), 0.);
}

void BoundaryPressures::build()
{
  if (is_empty())
    return;
  present.resize(conditions.size());
  largest_flow_rates.resize(conditions.size(), 0.);
  zero_velocity = operators.velocity_vector();
  // An assignment keeps the distribution of a vector of the same size.
  momentum.reinit(zero_velocity);
  mass = operators.pressure_vector();
  rows.assign(conditions.size(), Row());
  int n_cavities = 0;
  for (unsigned int i = 0; i < rows.size(); ++i)
  {
    rows[i].cavity = problem.conditions[conditions[i]].is_cavity() ? n_cavities++ : -1;
    for (DistributedVector *const vector :
         {&rows[i].derivative, &rows[i].force, &rows[i].velocity_response})
      vector->reinit(zero_velocity);
    rows[i].pressure_response.reinit(mass);
  }
  const std::vector<double> volumes = volumes_at(zero_velocity);
  for (Row &row : rows)
    if (row.cavity >= 0)
      row.undeformed_volume = volumes[row.cavity];
  matrix.reinit(rows.size(), rows.size());
  differences.reinit(rows.size());
  changes.reinit(rows.size());
}

std::vector<double> BoundaryPressures::volumes_at(const DistributedVector &displacement)
{
  return std::any_of(rows.begin(), rows.end(), [](const Row &row) { return row.cavity >= 0; })
             ? operators.cavities()->volumes(displacement)
             : std::vector<double>();
}

void BoundaryPressures::begin_step(const Step &step)
{
  for (unsigned int i = 0; i < rows.size(); ++i)
  {
    const BoundaryCondition &condition = problem.conditions[conditions[i]];
    // The mean of both ends of the step: else a kink between them would ring.
    const double value =
        rows[i].cavity < 0 && step.extrapolate
            ? 0.5 * (given(i)(origin, step.time - step.size()) + given(i)(origin, step.time))
            : given(i)(origin, step.balance_time);
    if (rows[i].cavity < 0)
    {
      if (!std::isfinite(value))
        throw RunError("the flow rate of the boundary '" + condition.name +
                       "' is no number (Boundaries/" + condition.name + "/Flow rate)");
      rows[i].given = step.load_factor * condition.free_flow->fraction * value;
      largest_flow_rates[i] = std::max(largest_flow_rates[i], std::abs(rows[i].given));
      continue;
    }
    // What is no number fails the comparison.
    if (!(value > 0.))
    {
      std::ostringstream text;
      text << "the volume ratio of the cavity '" << condition.name << "' is " << value
           << " and not positive (Boundaries/" << condition.name << "/Volume ratio)";
      throw RunError(text.str());
    }
    rows[i].given = rows[i].undeformed_volume * (1. + step.load_factor * (value - 1.));
  }
}

void BoundaryPressures::measure(const StepSolution &solution)
{
  if (is_empty())
    return;
  const DistributedVector &displacement =
      problem.mesh_moves ? solution.mesh_displacement : solution.displacement;
  const std::vector<double> volumes = volumes_at(displacement);
  for (unsigned int i = 0; i < rows.size(); ++i)
  {
    Row &row = rows[i];
    if (row.cavity >= 0)
    {
      row.value = volumes[row.cavity];
      operators.cavities()->linearise(row.cavity, displacement, row.derivative, row.force);
      continue;
    }
    // The flow rate out of the body by a velocity, and minus the force of a pressure of 1 Pa.
    operators.ports().set_flow_of_velocities(conditions[i], displacement, row.force);
    row.force *= -1.;
    row.derivative.equ(1., row.force);
    row.value = row.derivative * solution.velocity - row.derivative * solution.mesh_velocity;
    row.size =
        std::max(largest_flow_rates[i], sum_of_sizes(row.derivative, solution.velocity) +
                                            sum_of_sizes(row.derivative, solution.mesh_velocity));
  }
}

double BoundaryPressures::residual() const
{
  double largest = 0.;
  for (const Row &row : rows)
  {
    const double difference = std::abs(row.given - row.value),
                 share = difference / (row.cavity >= 0 ? row.given : row.size);
    if (std::isnan(difference))
      return difference;
    // Where nothing has flowed nothing is missing.
    if (difference != 0.)
      largest = std::max(largest, share);
  }
  return largest;
}

void BoundaryPressures::respond(const Solve &solve)
{
  for (Row &row : rows)
  {
    momentum.equ(1., row.force);
    mass = 0.;
    solve(momentum, mass, row.velocity_response, row.pressure_response);
  }
}

double BoundaryPressures::largest_flow() const
{
  double largest = 0.;
  for (const Row &row : rows)
    largest = std::max(largest, row.derivative.linfty_norm() * row.velocity_response.linfty_norm());
  return largest;
}

void BoundaryPressures::couple(const Step &step,
                               DistributedVector &velocity_change,
                               DistributedVector &pressure_change,
                               std::vector<double> &boundary_pressures)
{
  if (is_empty())
    return;
  for (unsigned int i = 0; i < rows.size(); ++i)
  {
    const Row &row = rows[i];
    const double by_velocity = row.cavity >= 0 ? BranchHistory::step_displacement(step) : 1.;
    differences[i] = row.given - row.value - by_velocity * (row.derivative * velocity_change);
    for (unsigned int j = 0; j < rows.size(); ++j)
      matrix(i, j) = by_velocity * (row.derivative * rows[j].velocity_response);
    if (matrix(i, i) == 0.)
    {
      const std::string name = "'" + problem.conditions[conditions[i]].name + "'";
      throw RunError(row.cavity >= 0
                         ? "the volume of the cavity " + name +
                               " does not change by its pressure: nothing of its surface can move"
                         : "the flow rate of the boundary " + name +
                               " does not change by its pressure: nothing can flow there");
    }
  }
  matrix.gauss_jordan();
  matrix.vmult(changes, differences);
  for (unsigned int i = 0; i < rows.size(); ++i)
  {
    velocity_change.add(changes[i], rows[i].velocity_response);
    pressure_change.add(changes[i], rows[i].pressure_response);
    boundary_pressures[i] += changes[i];
  }
}

std::vector<double> BoundaryPressures::pressures() const
{
  std::vector<double> numbers;
  for (const CavityState &of_boundary : present)
    numbers.push_back(of_boundary.pressure);
  return numbers;
}

void BoundaryPressures::finish_step(const StepSolution &solution)
{
  for (unsigned int i = 0; i < present.size(); ++i)
    present[i].pressure = solution.boundary_pressures[i];
}

const std::vector<CavityState> &BoundaryPressures::states(const DistributedVector &displacement)
{
  if (is_empty())
    return present;
  const std::vector<double> volumes = volumes_at(displacement);
  for (unsigned int i = 0; i < present.size(); ++i)
    present[i].volume = rows[i].cavity >= 0 ? volumes[rows[i].cavity] : 0.;
  return present;
}

bool BoundaryPressures::jumps(const double begin, const double end) const
{
  for (unsigned int i = 0; i < conditions.size(); ++i)
    if (jumps_within([&](const double time) { return given(i)(origin, time); }, begin, end))
      return true;
  return false;
}

void BoundaryPressures::visit(StateVisitor &visitor)
{
  for (unsigned int i = 0; i < present.size(); ++i)
  {
    visitor.value(StateName("cavity pressure", i), present[i].pressure);
    if (problem.conditions[conditions[i]].free_flow)
      visitor.value(StateName("largest flow rate", i), largest_flow_rates[i]);
  }
}
} // namespace Continua
