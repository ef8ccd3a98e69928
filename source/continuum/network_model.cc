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

/// Of a step: by which the network goes on at least, and as which a smaller offset counts as none.
constexpr double least_interval = 0.5, even_offset = 1e-9;

/// For the scales of pressures and flow rates where no vessel is at the joint [m^2], [m/s].
constexpr double area_without_vessel = 1e-4, speed_without_vessel = 1.;

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
      nodes(outlet.network->numbers_at_body()),
      steady(outlet, vessels, nodes),
      z(outlet.conditions.size(), outlet.conditions.size()),
      predicted(outlet.conditions.size())
{
  const std::size_t n = outlet.conditions.size();
  for (const unsigned int node : nodes)
  {
    const EndWave *const end = vessels.vessel_at(node);
    has_elements_alone = has_elements_alone || end == nullptr;
    const double density = outlet.network->liquid.density,
                 area = end != nullptr ? end->of().end_state(end->at()).area : area_without_vessel;
    stiffness.push_back(end != nullptr ? area * end->of().stiffness(end->at(), area)
                                       : density * speed_without_vessel * speed_without_vessel);
    flow_scale.push_back(area * std::sqrt(stiffness.back() / density));
  }
  take_state();
  trial_pressures.assign(n, 0.);
  steady_flow_rates = present.flow_rates = trial_pressures;
  present.flow_slopes = present.pressure_slopes = trial_pressures;
  present.z.assign(n * n, 0.);
  present.level_pressures = present.pressures;
  older = present;
}

void NetworkModel::take_state()
{
  StateNumbers numbers(StateNumbers::Direction::take, present.network);
  vessels.visit(numbers);
  present.pressures.clear();
  for (const unsigned int node : nodes)
    present.pressures.push_back(vessels.end_pressure(node));
  present.energy = vessels.energy();
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
  if (step.finds_steady_state)
  {
    steady.solve(step, flow_rates, trial_pressures, z);
    trial_flow_rates.assign(flow_rates, flow_rates + n);
    return;
  }
  // What was before a start of the scheme says nothing of what follows.
  const double ahead = step.is_start ? 0. : offset;
  for (unsigned int i = 0; i < n; ++i)
    (*inflows)[i] =
        (flow_rates[i] + ahead * present.flow_slopes[i]) / outlet.fractions[i]; // of the whole tube
  for (;; n_steps *= 2)
  {
    if (n_steps > most_network_steps)
      throw StepFailure("the network at '" + outlet.name +
                        "' needs more than a million steps of its own: its waves are too fast for "
                        "its cells. Give longer cells, a softer wall or larger radii");
    restore();
    if (vessels.advance_in(end_time, n_steps))
      break;
  }
  trial_flow_rates.assign(flow_rates, flow_rates + n);
  for (unsigned int i = 0; i < n; ++i)
    trial_pressures[i] = vessels.mean_pressure(nodes[i]) - ahead * present.pressure_slopes[i];
}

void NetworkModel::place_interval()
{
  const double size = step.size(),
               even = step.balance_time + 0.5 * size; // where it ends in steps of one size
  begin_time = vessels.time();
  end_time = std::max(even, begin_time + least_interval * size);
  offset = 0.5 * (begin_time + end_time) - step.balance_time;
  if (std::abs(offset) <= even_offset * size)
    offset = 0.;
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

void NetworkModel::find_impedance(const std::vector<double> flow_rates)
{
  const unsigned int n = n_ports();
  // Away from zero, where a valve opens.
  std::vector<double> distances;
  for (unsigned int j = 0; j < n; ++j)
    distances.push_back(
        std::copysign(flow_difference * flow_scale[j] * outlet.fractions[j], flow_rates[j]));
  unsigned int n_steps_before;
  do
  {
    // All trials have the same steps: a difference tells the impedance, not that of two meshes of
    // time.
    n_steps_before = n_steps;
    for (unsigned int j = 0; j < n; ++j)
    {
      std::vector<double> shifted = flow_rates;
      shifted[j] += distances[j];
      make_trial(shifted.data());
      for (unsigned int i = 0; i < n; ++i)
        z(i, j) = trial_pressures[i] / distances[j];
    }
    make_trial(flow_rates.data());
  } while (n_steps != n_steps_before);
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n; ++i)
      z(i, j) -= trial_pressures[i] / distances[j];
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
    if (waits())
    {
      z = 0.;
      for (unsigned int i = 0; i < n; ++i)
        predicted[i] = step.load_factor * present.pressures[i];
    }
    else
    {
      make_trial(steady_flow_rates.data());
      set_predicted();
    }
    is_linearised = true;
    return true;
  }
  restore();
  place_interval();
  const double longest = courant_share * outlet.network->courant_number * vessels.largest_step();
  n_steps = static_cast<unsigned int>(std::clamp(
      std::ceil((end_time - begin_time) / longest * (1. - 1e-9)), 1., double(most_network_steps)));
  if (!is_same_size(present.interval, end_time - begin_time))
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

void NetworkModel::refuse_steady() const
{
  throw RunError("the network at '" + outlet.name +
                 "' has no place in a steady analysis: set "
                 "Analysis = transient, or give the boundary Type = windkessel");
}

bool NetworkModel::linearise_steady(double)
{
  refuse_steady();
}

void NetworkModel::take_update(const std::vector<double> &flow_rates_before,
                               const std::vector<double> &pressures_before)
{
  const unsigned int n = n_ports();
  // Of a steady flow Z is the derivative; without flow rates the trial before has thrown, or the
  // present state was asked for.
  if (step.finds_steady_state || flow_rates_before.empty())
    return;
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

void NetworkModel::update_impedance(const std::vector<double> &flow_rates_before,
                                    const std::vector<double> &pressures_before,
                                    const bool is_slow)
{
  if (!step.finds_steady_state && (is_slow || has_elements_alone))
    find_impedance(trial_flow_rates);
  else
    take_update(flow_rates_before, pressures_before);
}

bool NetworkModel::correct(const double *const flow_rates)
{
  const unsigned int n = n_ports();
  if (waits() || !is_linearised)
    return false;
  const dealii::FullMatrix<double> z_before = z; // a steady trial has another one
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
      of_relation += z_before(i, j) * flow_rates[j];
      scale += std::abs(z_before(i, j) * flow_rates[j]);
    }
    largest = std::max(largest, std::abs(of_relation - trial_pressures[i]) / scale);
  }
  if (largest <= tolerance_after(n_corrections))
  {
    z = z_before;
    return false;
  }
  if (++n_corrections > most_corrections)
    throw StepFailure("the body and the network at '" + outlet.name +
                      "' have not found a common pressure and flow rate in " +
                      std::to_string(most_corrections) + " corrections: the pressures differ by " +
                      six_digits(largest) + " of themselves");
  update_impedance(flow_rates_before, pressures_before, n_corrections % corrections_by_update == 0);
  set_predicted();
  return true;
}

void NetworkModel::linearise_about(const double *const flow_rates)
{
  if (!is_linearised || waits())
    return;
  const std::vector<double> flow_rates_before = trial_flow_rates,
                            pressures_before = trial_pressures;
  make_trial(flow_rates);
  update_impedance(flow_rates_before, pressures_before, false);
  set_predicted();
}

void NetworkModel::advance(const Step &of_step, const double *const flow_rates)
{
  const unsigned int n = n_ports();
  if (of_step.finds_steady_state)
  {
    steady_flow_rates.assign(flow_rates, flow_rates + n);
    return;
  }
  if (!std::equal(flow_rates, flow_rates + n, trial_flow_rates.begin(), trial_flow_rates.end()))
    make_trial(flow_rates);
  std::swap(older, present);
  take_state();
  take_levels(flow_rates, older, present);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      present.z[i * n + j] = z(i, j);
  present.interval = end_time - begin_time;
  is_linearised = false;
}

void NetworkModel::take_levels(const double *const flow_rates,
                               const NetworkEndState &before,
                               NetworkEndState &now) const
{
  const unsigned int n = n_ports();
  now.flow_rates.assign(flow_rates, flow_rates + n);
  now.level_pressures = trial_pressures;
  now.size = step.size();
  now.level = step.balance_time;
  now.flow_slopes = step.is_start ? std::vector<double>(n, 0.) : before.flow_slopes;
  now.pressure_slopes = step.is_start ? now.flow_slopes : before.pressure_slopes;
  const bool is_even = offset == 0. && before.size > 0. && !step.is_start;
  for (unsigned int i = 0; i < n && is_even; ++i)
  {
    const double duration = now.level - before.level;
    now.flow_slopes[i] = (now.flow_rates[i] - before.flow_rates[i]) / duration;
    now.pressure_slopes[i] = (now.level_pressures[i] - before.level_pressures[i]) / duration;
  }
}

void NetworkModel::start_from(const double *const flow_rates)
{
  if (!steady.applies(step))
    return;
  make_trial(flow_rates);
  steady.start();
  take_state();
  present.flow_rates = trial_flow_rates;
  present.level_pressures = trial_pressures;
  older = present;
}

void NetworkModel::set_steady(const double *)
{
  refuse_steady();
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

void NetworkModel::visit(StateVisitor &visitor, const unsigned int number)
{
  present.visit(visitor, number, older);
  is_linearised = false;
}
} // namespace Continua
