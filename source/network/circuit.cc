#include <continua/network/circuit.h>

#include <continua/base/six_digits.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
constexpr unsigned int most_iterations = 50;
/// Of the largest pressure; the error after the last correction is about the square of it.
constexpr double tolerance_of_pressure = 1e-10;
/// Of A dp/dA of a vessel, or of what a chamber or a compliance has with its whole volume, as which
/// a smaller pressure counts: round-off of the area or of the volume is more.
constexpr double least_pressure = 1e-3;
/// What a closed valve lets through, of what it lets through where it is open: so that nodes
/// between closed valves have a pressure.
constexpr double leak = 1e-9;
} // namespace

Circuit::Circuit(const Description &description,
                 const std::vector<std::pair<unsigned int, EndWave>> &vessels)
{
  for (const ElementLaw &law : description.elements)
  {
    Element element;
    element.law = law;
    element.from = place(law.from);
    element.to = law.stores() ? element.from : place(law.to);
    element.state = law.initial_volume; // of an inertance: nothing flows
    elements.push_back(element);
  }
  for (const auto &[node, value] : description.pressures)
    given.emplace_back(place(node), value);
  for (const auto &[node, value] : description.inflows)
    inflows.emplace_back(place(node), value);
  for (const auto &[node, wave] : vessels)
    this->vessels.emplace_back(place(node), wave);
  const std::size_t n = nodes.size();
  pressures.assign(n, 0.);
  first_pressures = pressures;
  flow_into.assign(n, 0.);
  is_given.assign(n, 0);
  areas.assign(this->vessels.size(), 0.);
}

unsigned int Circuit::place(const unsigned int node)
{
  const unsigned int number = place_of(node);
  if (number == nodes.size())
    nodes.push_back(node);
  return number;
}

unsigned int Circuit::place_of(const unsigned int node) const
{
  return std::find(nodes.begin(), nodes.end(), node) - nodes.begin();
}

const EndWave *Circuit::vessel_at(const unsigned int node) const
{
  for (const auto &[place, wave] : vessels)
    if (nodes[place] == node)
      return &wave;
  return nullptr;
}

double Circuit::volume_at(const ElementLaw &law, const double pressure, const double time)
{
  return law.type == ElementLaw::Type::compliance
             ? law.compliance * (pressure - law.outside_pressure)
             : law.unloaded_volume + pressure / law.elastance(time);
}

double Circuit::volume_slope(const ElementLaw &law, const double time)
{
  return law.type == ElementLaw::Type::compliance ? law.compliance : 1. / law.elastance(time);
}

double Circuit::volume() const
{
  double sum = 0.;
  for (const Element &element : elements)
    if (element.law.stores())
      sum += element.state;
  return sum;
}

double Circuit::energy() const
{
  double sum = 0.;
  for (const Element &element : elements)
  {
    const ElementLaw &law = element.law;
    const double state = element.state;
    if (law.type == ElementLaw::Type::compliance)
      sum += state * (0.5 * state / law.compliance + law.outside_pressure);
    else if (!law.stores())
      sum += 0.5 * law.inertance * state * state;
  }
  return sum;
}

std::string Circuit::element_without_pressure() const
{
  std::vector<char> has_pressure(nodes.size(), 0);
  for (const auto &[node, value] : given)
    has_pressure[node] = 1;
  for (const auto &[node, wave] : vessels)
    has_pressure[node] = 1;
  for (const Element &element : elements)
    if (element.law.stores())
      has_pressure[element.from] = 1;
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const Element &element : elements)
      if (element.law.inertance == 0. && has_pressure[element.from] != has_pressure[element.to])
      {
        has_pressure[element.from] = has_pressure[element.to] = 1;
        changed = true;
      }
  }
  for (const Element &element : elements)
    if (has_pressure[element.from] == 0 || has_pressure[element.to] == 0)
      return element.law.name;
  return "";
}

std::pair<double, double>
Circuit::flow_of(const Element &element, const double difference, const double share)
{
  // known + share (difference - R Q)/L = Q; without an inertance R Q = difference.
  const ElementLaw &law = element.law;
  const bool is_inert = law.inertance > 0.;
  const double divisor = is_inert ? law.inertance + share * law.resistance : law.resistance,
               slope = (is_inert ? share : 1.) / divisor,
               flow =
                   (is_inert ? element.known * law.inertance : 0.) / divisor + slope * difference;
  if (law.type == ElementLaw::Type::valve && flow < 0.)
    return {leak * flow, leak * slope};
  return {flow, slope};
}

void Circuit::add_equations(const double time, const double share)
{
  const std::size_t n = nodes.size();
  rows.resize(n);
  for (std::vector<double> &row : rows)
    row.assign(n + 1, 0.);
  std::fill(flow_into.begin(), flow_into.end(), 0.);
  for (std::size_t i = 0; i < inflows.size(); ++i)
    flow_into[inflows[i].first] += inflows[i].second(time);
  for (std::size_t i = 0; i < vessels.size(); ++i)
  {
    const unsigned int node = vessels[i].first;
    const EndWave &wave = vessels[i].second;
    areas[i] = wave.of().area_at(wave.at(), pressures[node], areas[i]);
    if (!(areas[i] > 0.))
      throw std::domain_error("the wall of the vessel '" + wave.of().name() +
                              "' has no state under " + six_digits(pressures[node]) + " Pa");
    const EndWave::Values values = wave.at_area(areas[i]);
    flow_into[node] += values.inflow;
    rows[node][node] += values.inflow_slope / values.stiffness;
  }
  for (Element &element : elements)
    if (!element.law.stores())
    {
      const auto [flow, slope] =
          flow_of(element, pressures[element.from] - pressures[element.to], share);
      element.flow = flow;
      flow_into[element.from] -= flow;
      flow_into[element.to] += flow;
      rows[element.from][element.from] -= slope;
      rows[element.from][element.to] += slope;
      rows[element.to][element.from] += slope;
      rows[element.to][element.to] -= slope;
    }
  for (std::size_t i = 0; i < n; ++i)
    rows[i][n] = -flow_into[i];
  for (const Element &element : elements)
    if (element.law.stores() && share > 0.)
    {
      const unsigned int node = element.from;
      rows[node][node] -= volume_slope(element.law, time) / share;
      rows[node][n] += (volume_at(element.law, pressures[node], time) - element.known) / share;
    }
  for (std::size_t i = 0; i < n; ++i)
    if (is_given[i] != 0)
    {
      rows[i].assign(n + 1, 0.);
      rows[i][i] = 1.;
    }
}

void Circuit::solve(const double time, const double share)
{
  double pressure_scale = 0.; // [Pa]
  for (std::size_t i = 0; i < vessels.size(); ++i)
  {
    EndWave &wave = vessels[i].second;
    wave.begin();
    areas[i] = wave.inside().area;
    pressure_scale = std::fmax(pressure_scale, least_pressure * areas[i] *
                                                   wave.of().stiffness(wave.at(), areas[i]));
  }
  for (const Element &element : elements)
  {
    const ElementLaw &law = element.law;
    if (law.type == ElementLaw::Type::chamber)
      pressure_scale = std::fmax(
          pressure_scale, least_pressure * law.elastance(time) *
                              std::fmax(std::abs(law.unloaded_volume), std::abs(element.known)));
    else if (law.type == ElementLaw::Type::compliance)
      pressure_scale = std::fmax(pressure_scale, least_pressure * std::abs(law.outside_pressure));
  }
  std::fill(is_given.begin(), is_given.end(), 0);
  for (const Element &element : elements)
    if (element.law.stores() && share == 0.)
    {
      pressures[element.from] =
          element.law.type == ElementLaw::Type::compliance
              ? element.law.outside_pressure + element.known / element.law.compliance
              : element.law.elastance(time) * (element.known - element.law.unloaded_volume);
      is_given[element.from] = 1;
    }
  for (const auto &[node, value] : given)
  {
    pressures[node] = value(time);
    is_given[node] = 1;
  }
  for (unsigned int i = 0; i < most_iterations; ++i)
  {
    add_equations(time, share);
    if (!solve_rows(rows, change))
      break;
    double largest = pressure_scale, largest_change = 0.;
    for (std::size_t node = 0; node < nodes.size(); ++node)
    {
      pressures[node] += change[node];
      largest = std::fmax(largest, std::abs(pressures[node]));
      largest_change = std::fmax(largest_change, std::abs(change[node]));
    }
    if (largest_change <= tolerance_of_pressure * largest)
    {
      take_rates(time, share);
      return;
    }
  }
  throw std::domain_error("no pressures were found that the elements have in common");
}

void Circuit::take_rates(const double time, const double share)
{
  add_equations(time, share); // the flow rates of the last pressures
  entering = 0.;
  for (const auto &[node, value] : inflows)
    entering += value(time);
  for (const auto &[node, value] : given)
    entering -= flow_into[node];
  for (std::size_t i = 0; i < vessels.size(); ++i)
    vessels[i].second.take(areas[i]);
  for (Element &element : elements)
    if (element.law.stores())
      element.rate = element.flow = flow_into[element.from];
    else if (element.law.inertance > 0.)
    {
      const double difference = pressures[element.from] - pressures[element.to];
      const bool is_closed =
          element.law.type == ElementLaw::Type::valve && element.flow <= 0. && difference <= 0.;
      element.rate = share > 0.  ? (element.flow - element.known) / share
                     : is_closed ? 0.
                                 : (difference - element.law.resistance * element.flow) /
                                       element.law.inertance;
    }
}

void Circuit::start_at_rest(const double time)
{
  for (Element &element : elements)
    element.known = element.state;
  solve(time, 0.);
}

void Circuit::start_steady(const std::vector<double> &of_nodes, const double *const flows)
{
  for (std::size_t i = 0; i < nodes.size(); ++i)
    pressures[i] = of_nodes[nodes[i]];
  for (std::size_t k = 0; k < elements.size(); ++k)
  {
    Element &element = elements[k];
    element.rate = 0.;
    element.flow = flows[k];
    if (element.law.type == ElementLaw::Type::compliance)
      element.state = volume_at(element.law, pressures[element.from], 0.);
    else if (element.law.inertance > 0.)
      element.state = flows[k];
    element.known = element.state;
  }
}

std::vector<std::pair<unsigned int, Circuit::Value>>
Circuit::by_number(std::vector<std::pair<unsigned int, Value>> by_place) const
{
  for (auto &[node, load] : by_place)
    node = nodes[node];
  return by_place;
}

void Circuit::add_work(const double time, const double step, const std::vector<double> &before)
{
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (const ElementLaw &law = elements[i].law; law.type == ElementLaw::Type::chamber)
    {
      const double volume = elements[i].state;
      elements[i].work -= 0.5 *
                          (law.elastance(time) * (before[i] - law.unloaded_volume) +
                           law.elastance(time + step) * (volume - law.unloaded_volume)) *
                          (volume - before[i]);
    }
}

void Circuit::solve_stage(const bool at_end_of_step, const double time, const double step)
{
  const double half = 0.5 * step;
  for (Element &element : elements)
    element.known = element.state + (at_end_of_step ? half * element.rate : 0.);
  if (!at_end_of_step)
  {
    solve(time, 0.);
    first_pressures = pressures;
    entered = half * entering;
    return;
  }
  solve(time + step, half);
  entered += half * entering;
  std::vector<double> &before = change;
  before.clear();
  for (Element &element : elements)
  {
    before.push_back(element.state);
    element.state = element.known + half * element.rate;
  }
  add_work(time, step, before);
}

void Circuit::step_alone(const double time, const double step)
{
  const double share = (1. - std::sqrt(0.5)) * step, start_at_rest = step - share;
  for (Element &element : elements)
    element.known = element.state;
  solve(time + share, share);
  entered = start_at_rest * entering;
  for (Element &element : elements)
    element.known = element.state + start_at_rest * element.rate;
  solve(time + step, share);
  entered += share * entering;
  std::vector<double> &before = change;
  before.clear();
  for (Element &element : elements)
  {
    before.push_back(element.state);
    element.state = element.known + share * element.rate;
  }
  add_work(time, step, before);
}

Circuit::Values Circuit::values(const unsigned int number) const
{
  const Element &element = elements[number];
  return {pressures[element.from], pressures[element.to], element.flow, element.state,
          element.work};
}

void Circuit::visit(StateNumbers &numbers)
{
  for (Element &element : elements)
    for (double *const member : {&element.state, &element.rate, &element.flow})
      numbers.value(*member);
  numbers.values(pressures);
}

void Circuit::visit_sums(StateNumbers &numbers)
{
  for (Element &element : elements)
    numbers.value(element.work);
}
} // namespace Continua
