#include <continua/continuum/network_model.h>

#include <continua/base/input_error.h>
#include <continua/base/six_digits.h>
#include <continua/network/network_parameters.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace Continua
{
using namespace dealii;

namespace
{
/// Of a step of the network in which the joint finds its pressure; waves of finite height may make
/// the steps after it shorter.
constexpr double courant_share = 0.95;
constexpr unsigned int most_network_steps = 1u << 20; ///< of the network in a step of the body
/// Of the pressure, and of A dp/dA where there is none.
constexpr double joint_tolerance = 1e-10, least_joint_tolerance = 1e-12;
/// Of the flow rate that is as fast as the wave: for differences, and below which a change tells
/// nothing of Z.
constexpr double flow_difference = 1e-5, least_flow_change = 1e-7;
/// Until Z is found by differences again.
constexpr unsigned int corrections_by_update = 10;
/// Where the limiter of a vessel changes the slope in a cell, p(Q) has a small jump, and a state in
/// it has no exact common pressure. After some corrections each one takes ten times the tolerance.
constexpr unsigned int corrections_to_tolerance = 8, corrections_of_a_decade = 2,
                       most_corrections = 20;
double tolerance_after(const unsigned int n_corrections)
{
  const unsigned int more =
      n_corrections > corrections_to_tolerance ? n_corrections - corrections_to_tolerance : 0;
  return joint_tolerance * std::pow(10., more / corrections_of_a_decade);
}

bool is_same_size(const double a, const double b)
{
  return std::abs(a - b) <= 1e-9 * std::abs(b);
}
} // namespace

NetworkModel::NetworkModel(const Outlet &outlet)
    : outlet(outlet),
      inflows(std::make_shared<std::vector<double>>(outlet.conditions.size())),
      vessels(
          [&]()
          {
            std::vector<std::function<double(double)>> functions;
            for (std::size_t i = 0; i < inflows->size(); ++i)
              functions.emplace_back([rates = inflows, i](const double /*time*/)
                                     { return (*rates)[i]; });
            return outlet.network->make(functions);
          }()),
      z(outlet.conditions.size(), outlet.conditions.size()),
      predicted(outlet.conditions.size())
{
  const std::size_t n = outlet.conditions.size();
  for (const std::string &name : outlet.network->nodes_at_body)
  {
    const unsigned int node = outlet.network->node(name);
    nodes.push_back(node);
    const double area = vessels.end_area(node);
    stiffness.push_back(area * vessels.end_stiffness(node));
    flow_scale.push_back(area * std::sqrt(stiffness.back() / outlet.network->liquid.density));
    present.pressures.push_back(vessels.end_pressure(node));
  }
  StateNumbers numbers(StateNumbers::Direction::take, present.network);
  vessels.visit(numbers);
  present.energy = vessels.energy();
  present.z.assign(n * n, 0.);
  present.flow_rates.assign(n, 0.);
  trial_pressures.assign(n, 0.);
  older = present;
}

void NetworkModel::restore()
{
  StateNumbers numbers(StateNumbers::Direction::give, present.network);
  vessels.visit(numbers);
  trial_flow_rates.clear();
}

void NetworkModel::make_trial(const double *const flow_rates)
{
  const unsigned int n = n_ports();
  for (unsigned int i = 0; i < n; ++i)
    (*inflows)[i] = flow_rates[i] / outlet.fractions[i]; // of the whole tube
  for (;; n_steps *= 2)
  {
    if (n_steps > most_network_steps)
      throw StepFailure("the network at '" + outlet.name +
                        "' needs more than a million steps of its own: its waves are too fast for "
                        "its cells. Give longer cells, a softer wall or larger radii");
    restore();
    if (vessels.advance_in(step.time, n_steps))
      break;
  }
  trial_flow_rates.assign(flow_rates, flow_rates + n);
  for (unsigned int i = 0; i < n; ++i)
    trial_pressures[i] = vessels.mean_pressure(nodes[i]);
}

void NetworkModel::set_predicted()
{
  for (unsigned int i = 0; i < n_ports(); ++i)
  {
    predicted[i] = trial_pressures[i];
    for (unsigned int j = 0; j < n_ports(); ++j)
      predicted[i] -= z(i, j) * trial_flow_rates[j];
  }
}

void NetworkModel::find_impedance(const std::vector<double> &flow_rates)
{
  const unsigned int n = n_ports();
  unsigned int n_steps_before;
  do
  {
    // All trials have the same steps: a difference tells the impedance, not that of two meshes of
    // time.
    n_steps_before = n_steps;
    for (unsigned int j = 0; j < n; ++j)
    {
      std::vector<double> shifted = flow_rates;
      const double distance = flow_difference * flow_scale[j] * outlet.fractions[j];
      shifted[j] += distance;
      make_trial(shifted.data());
      for (unsigned int i = 0; i < n; ++i)
        z(i, j) = trial_pressures[i] / distance;
    }
    make_trial(flow_rates.data());
  } while (n_steps != n_steps_before);
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n; ++i)
      z(i, j) -= trial_pressures[i] / (flow_difference * flow_scale[j] * outlet.fractions[j]);
}

bool NetworkModel::linearise(const Step &new_step, const double * /*flow_rates_old*/)
{
  const unsigned int n = n_ports();
  if (is_linearised && new_step.time_old == step.time_old && new_step.size() == step.size() &&
      new_step.finds_steady_state == step.finds_steady_state &&
      new_step.load_factor == step.load_factor)
  {
    // Another iterate of the body in the same step: its dense system has corrections of its own.
    n_corrections = 0;
    return false;
  }
  step = new_step;
  is_linearised = false; // until no trial has thrown
  n_corrections = 0;
  if (step.finds_steady_state)
  {
    // The network waits.
    is_linearised = true;
    z = 0.;
    for (unsigned int i = 0; i < n; ++i)
      predicted[i] = step.load_factor * present.pressures[i];
    return true;
  }
  vessels.set_clock_ahead(step.balance_time - 0.5 * (step.time_old + step.time));
  restore();
  const double longest = courant_share * outlet.network->courant_number * vessels.largest_step();
  n_steps = static_cast<unsigned int>(
      std::min<double>(std::ceil(step.size() / longest * (1. - 1e-9)), most_network_steps));
  n_steps = std::max(n_steps, 1u);
  const bool is_new = !is_same_size(present.size, step.size());
  if (is_new)
    find_impedance(present.flow_rates);
  else
  {
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        z(i, j) = present.z[i * n + j];
    make_trial(present.flow_rates.data());
  }
  set_predicted();
  is_linearised = true;
  return true;
}

bool NetworkModel::linearise_steady(double)
{
  throw RunError("the network at '" + outlet.name +
                 "' has no steady flow of its own: set Analysis = transient, or give the boundary "
                 "Type = windkessel");
}

void NetworkModel::take_update(const std::vector<double> &flow_rates_before,
                               const std::vector<double> &pressures_before)
{
  const unsigned int n = n_ports();
  if (flow_rates_before.empty())
    return; // the trial before has thrown, or the present state was asked for
  double square = 0., largest = 0.;
  std::vector<double> change(n);
  for (unsigned int j = 0; j < n; ++j)
  {
    change[j] = trial_flow_rates[j] - flow_rates_before[j];
    square += change[j] * change[j];
    largest = std::max(largest, std::abs(change[j]) / (flow_scale[j] * outlet.fractions[j]));
  }
  if (largest < least_flow_change)
    return;
  for (unsigned int i = 0; i < n; ++i)
  {
    double missing = trial_pressures[i] - pressures_before[i];
    for (unsigned int j = 0; j < n; ++j)
      missing -= z(i, j) * change[j];
    for (unsigned int j = 0; j < n; ++j)
      z(i, j) += missing * change[j] / square;
  }
}

bool NetworkModel::correct(const double *const flow_rates)
{
  const unsigned int n = n_ports();
  if (step.finds_steady_state || !is_linearised)
    return false;
  const std::vector<double> flow_rates_before = trial_flow_rates,
                            pressures_before = trial_pressures;
  make_trial(flow_rates);
  double largest = 0.; // over what is accepted
  for (unsigned int i = 0; i < n; ++i)
  {
    double of_relation = predicted[i],
           scale = std::abs(trial_pressures[i]) +
                   least_joint_tolerance / joint_tolerance * stiffness[i];
    for (unsigned int j = 0; j < n; ++j)
    {
      of_relation += z(i, j) * flow_rates[j];
      scale += std::abs(z(i, j) * flow_rates[j]);
    }
    largest = std::max(largest, std::abs(of_relation - trial_pressures[i]) / scale);
  }
  if (largest <= tolerance_after(n_corrections))
    return false;
  if (++n_corrections > most_corrections)
    throw StepFailure("the body and the network at '" + outlet.name +
                      "' have not found a common pressure and flow rate in " +
                      std::to_string(most_corrections) + " corrections: the pressures differ by " +
                      six_digits(largest) + " of themselves");
  if (n_corrections % corrections_by_update == 0)
    find_impedance(trial_flow_rates);
  else
    take_update(flow_rates_before, pressures_before);
  set_predicted();
  return true;
}

void NetworkModel::linearise_about(const double *const flow_rates)
{
  if (step.finds_steady_state || !is_linearised)
    return;
  const std::vector<double> flow_rates_before = trial_flow_rates,
                            pressures_before = trial_pressures;
  make_trial(flow_rates);
  take_update(flow_rates_before, pressures_before);
  set_predicted();
}

void NetworkModel::advance(const Step &of_step, const double *const flow_rates)
{
  const unsigned int n = n_ports();
  if (of_step.finds_steady_state)
    return;
  if (!std::equal(flow_rates, flow_rates + n, trial_flow_rates.begin(), trial_flow_rates.end()))
    make_trial(flow_rates);
  std::swap(older, present);
  StateNumbers numbers(StateNumbers::Direction::take, present.network);
  vessels.visit(numbers);
  present.flow_rates.assign(flow_rates, flow_rates + n);
  for (unsigned int i = 0; i < n; ++i)
  {
    present.pressures[i] = vessels.end_pressure(nodes[i]);
    for (unsigned int j = 0; j < n; ++j)
      present.z[i * n + j] = z(i, j);
  }
  present.size = step.size();
  present.energy = vessels.energy();
  is_linearised = false;
}

void NetworkModel::set_steady(const double *)
{
  throw RunError("the network at '" + outlet.name +
                 "' has no steady flow of its own: set Analysis = transient, or give the boundary "
                 "Type = windkessel");
}

double NetworkModel::stored_power() const
{
  // In the part of the sections that the mesh has.
  return present.size > 0.
             ? outlet.fractions.front() * (present.energy - older.energy) / present.size
             : 0.;
}

std::vector<double> NetworkModel::present_pressures(double, const double *) const
{
  return present.pressures;
}

const Network *NetworkModel::network()
{
  restore();
  return &vessels;
}

void NetworkModel::visit_state(StateVisitor &visitor,
                               const unsigned int number,
                               State &now,
                               State &before)
{
  visitor.levels({"network", number}, now.network.data(), before.network.data(),
                 now.network.size());
  visitor.levels({"pressures of network", number}, now.pressures.data(), before.pressures.data(),
                 now.pressures.size());
  visitor.levels({"impedance of network", number}, now.z.data(), before.z.data(), now.z.size());
  visitor.levels({"flow rates of network", number}, now.flow_rates.data(), before.flow_rates.data(),
                 now.flow_rates.size());
  visitor.levels({"step of network", number}, &now.size, &before.size, 1);
  visitor.levels({"energy of network", number}, &now.energy, &before.energy, 1);
}

void NetworkModel::visit(StateVisitor &visitor, const unsigned int number)
{
  visit_state(visitor, number, present, older);
  is_linearised = false;
}
} // namespace Continua
