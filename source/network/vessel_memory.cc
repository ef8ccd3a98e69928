#include <continua/network/vessel_memory.h>

#include <continua/network/friction_memory.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
/// The diagonal of the implicit stages.
const double implicit_share = 1. - std::sqrt(0.5);

using Affine = VesselMemory::Affine;

/// Adds a multiple.
void add_to(Affine &sum, const double factor, const Affine &value)
{
  sum.constant += factor * value.constant;
  sum.of_start += factor * value.of_start;
  sum.of_end += factor * value.of_end;
}
} // namespace

VesselMemory::VesselMemory(const unsigned int n_cells,
                           const double cell_length,
                           const FlowLaw &law,
                           const WallRelaxation &relaxation)
    : n(n_cells),
      cell_length(cell_length),
      law(law),
      relaxation(relaxation),
      branches(relaxation.branches.size()),
      modes(law.remembers ? friction_modes.size() : 0),
      pressures(n + 1, 0.),
      explicit_flows(n),
      viscosities(n + 1, 0.),
      known(n + 1, 0.),
      stiffness(n + 1),
      cells(n)
{
  if (wall_relaxes() && n < 2)
    throw std::invalid_argument("A vessel whose wall relaxes has one cell.");
  for (std::vector<double> &rates : flow_rates_of)
    rates.assign(n, 0.);
  const auto resize = [](std::vector<States> &all, const unsigned int size)
  {
    for (States &states : all)
      for (std::vector<double> *const values :
           {&states.now, &states.old, &states.rates[0], &states.rates[1]})
        values->assign(size, 0.);
  };
  resize(branches, n + 1);
  resize(modes, n);
}

void VesselMemory::start_at_rest(const std::vector<double> &flows)
{
  std::fill(pressures.begin(), pressures.end(), 0.);
  for (States &branch : branches)
    std::fill(branch.now.begin(), branch.now.end(), 0.);
  for (States &mode : modes)
  {
    mode.now = flows;
    for (std::vector<double> &rates : mode.rates)
      std::fill(rates.begin(), rates.end(), 0.);
  }
}

void VesselMemory::visit(StateNumbers &numbers)
{
  for (std::vector<States> *const list : {&branches, &modes})
    for (States &states : *list)
      numbers.values(states.now);
  numbers.values(pressures);
}

void VesselMemory::begin_step()
{
  for (std::vector<States> *const all : {&branches, &modes})
    for (States &states : *all)
      states.old = states.now;
}

double VesselMemory::friction_rate(const unsigned int mode, const double area) const
{
  return friction_modes[mode].rate * FlowLaw::pi * law.viscosity / (law.density * area);
}

double VesselMemory::friction_weight(const unsigned int mode, const double area) const
{
  return 4. * friction_modes[mode].weight * FlowLaw::pi * law.viscosity / (law.density * area);
}

double VesselMemory::friction(const unsigned int cell, const double area) const
{
  // Of modes that are much faster than a step neither stage has the rate of change of the step, but
  // their mean has it.
  double sum = 0.;
  for (unsigned int j = 0; j < modes.size(); ++j)
    sum += friction_weight(j, area) / friction_rate(j, area) * 0.5 *
           (modes[j].rates[0][cell] + modes[j].rates[1][cell]);
  return sum;
}

double VesselMemory::fast_share(const double step) const
{
  double sum = 0.;
  for (const WallRelaxation::Branch &branch : relaxation.branches)
    sum += branch.share * branch.relaxation_time / (branch.relaxation_time + step);
  return sum;
}

template <typename Value>
Affine VesselMemory::flow_slope(const unsigned int face, const Value &flow) const
{
  Affine slope;
  if (face == 0)
  {
    // Of the parabola through the end and the centres of two cells.
    add_to(slope, 3. / cell_length, flow(0));
    add_to(slope, -1. / (3. * cell_length), flow(1));
    slope.of_start -= 8. / (3. * cell_length);
  }
  else if (face == n)
  {
    add_to(slope, -3. / cell_length, flow(n - 1));
    add_to(slope, 1. / (3. * cell_length), flow(n - 2));
    slope.of_end += 8. / (3. * cell_length);
  }
  else
  {
    add_to(slope, 1. / cell_length, flow(face));
    add_to(slope, -1. / cell_length, flow(face - 1));
  }
  return slope;
}

void VesselMemory::begin_stage(const bool second,
                               const double step,
                               const std::vector<double> &areas,
                               const std::vector<double> &flows,
                               const std::vector<double> &stiffnesses)
{
  stage = second ? 1 : 0;
  implicit_step = implicit_share * step;
  stage_areas = areas;
  explicit_flows = flows;
  stiffness = stiffnesses;
  // What the first stage has given already. Before it the rates are those of a step that may have
  // failed, and no numbers.
  const double of_first = (1. - 2. * implicit_share) * step;
  for (std::vector<States> *const all : {&branches, &modes})
    for (States &states : *all)
      for (std::size_t i = 0; i < states.now.size(); ++i)
        states.now[i] = states.old[i] + (second ? of_first * states.rates[0][i] : 0.);
  if (wall_relaxes())
    for (unsigned int f = 0; f <= n; ++f)
    {
      known[f] = 0.;
      double modulus = relaxation.damping_time;
      for (std::size_t k = 0; k < branches.size(); ++k)
      {
        const WallRelaxation::Branch &branch = relaxation.branches[k];
        const double left = 1. / (1. + implicit_step / branch.relaxation_time);
        known[f] += left * branches[k].now[f];
        modulus += left * implicit_step * branch.share;
      }
      viscosities[f] = modulus * stiffness[f];
    }
  eliminate();
}

void VesselMemory::eliminate()
{
  // Thomas's elimination for the flow rates of the cells, with three right-hand sides.
  std::vector<double> upper(n, 0.);
  for (unsigned int i = 0; i < n; ++i)
  {
    double diagonal = 1., lower = 0., of_next = 0.;
    Affine right;
    right.constant = explicit_flows[i];
    for (unsigned int j = 0; j < modes.size(); ++j)
    {
      const double share = implicit_step * friction_weight(j, stage_areas[i]) /
                           (1. + implicit_step * friction_rate(j, stage_areas[i]));
      diagonal += share;
      right.constant += share * modes[j].now[i];
    }
    if (wall_relaxes())
    {
      const double factor = implicit_step * stage_areas[i] / (law.density * cell_length);
      right.constant -= factor * (known[i + 1] - known[i]);
      const auto add_face = [&](const unsigned int face)
      {
        // The coefficients of the slope on the face.
        const double of_face = factor * viscosities[face];
        const bool is_start = face == 0, is_end = face == n;
        const double there = (is_start || is_end ? 3. : 1.) * of_face / cell_length,
                     third = of_face / (3. * cell_length);
        diagonal += there;
        if (is_start)
        {
          of_next -= third;
          right.of_start += 8. * third;
        }
        else if (is_end)
        {
          lower -= third;
          right.of_end += 8. * third;
        }
        else
          (face == i ? lower : of_next) -= of_face / cell_length;
      };
      add_face(i);
      add_face(i + 1);
    }
    if (i > 0)
    {
      diagonal -= lower * upper[i - 1];
      add_to(right, -lower, cells[i - 1]);
    }
    upper[i] = of_next / diagonal;
    cells[i] = {};
    add_to(cells[i], 1. / diagonal, right);
  }
  for (unsigned int i = n - 1; i-- > 0;)
    add_to(cells[i], -upper[i], cells[i + 1]);
}

Affine VesselMemory::flow_inside(const bool at_end) const
{
  Affine flow;
  if (n < 2)
    return cells[0];
  add_to(flow, 1.5, cells[at_end ? n - 1 : 0]);
  add_to(flow, -0.5, cells[at_end ? n - 2 : 1]);
  return flow;
}

Affine VesselMemory::end_pressure(const bool at_end) const
{
  Affine pressure;
  if (!wall_relaxes())
    return pressure;
  const unsigned int face = at_end ? n : 0;
  pressure.constant = known[face];
  add_to(
      pressure, -viscosities[face],
      flow_slope(face, [this](const unsigned int cell) -> const Affine & { return cells[cell]; }));
  return pressure;
}

void VesselMemory::end_stage(const double start_flow,
                             const double end_flow,
                             std::vector<double> &flows)
{
  for (unsigned int i = 0; i < n; ++i)
  {
    flows[i] = cells[i].at(start_flow, end_flow);
    flow_rates_of[stage][i] = (flows[i] - explicit_flows[i]) / implicit_step;
  }
  for (unsigned int j = 0; j < modes.size(); ++j)
    for (unsigned int i = 0; i < n; ++i)
    {
      const double rate = friction_rate(j, stage_areas[i]);
      modes[j].rates[stage][i] = rate * (flows[i] - modes[j].now[i]) / (1. + implicit_step * rate);
    }
  if (!wall_relaxes())
    return;
  const auto flow = [&flows](const unsigned int cell) { return Affine{flows[cell], 0., 0.}; };
  for (unsigned int f = 0; f <= n; ++f)
  {
    const double slope = flow_slope(f, flow).at(start_flow, end_flow);
    pressures[f] = known[f] - viscosities[f] * slope;
    for (std::size_t k = 0; k < branches.size(); ++k)
    {
      const WallRelaxation::Branch &branch = relaxation.branches[k];
      const double before = branches[k].now[f],
                   now = (before - implicit_step * branch.share * stiffness[f] * slope) /
                         (1. + implicit_step / branch.relaxation_time);
      branches[k].rates[stage][f] = (now - before) / implicit_step;
    }
  }
}

void VesselMemory::add(const bool second,
                       const double step,
                       const double start_flow,
                       const double end_flow,
                       std::vector<double> &flows)
{
  if (!second)
  {
    // The rates of the second stage are those of a step that may have failed, and no numbers.
    for (unsigned int i = 0; i < n; ++i)
      flows[i] += step * ((1. - 3. * implicit_share) * flow_rates_of[0][i]);
    return;
  }
  for (unsigned int i = 0; i < n; ++i)
    flows[i] += step * (implicit_share * flow_rates_of[0][i] +
                        0.5 * (1. - implicit_share) * flow_rates_of[1][i]);
  for (std::vector<States> *const all : {&branches, &modes})
    for (States &states : *all)
      for (std::size_t i = 0; i < states.now.size(); ++i)
        states.now[i] = states.old[i] + 0.5 * step * (states.rates[0][i] + states.rates[1][i]);
  if (!wall_relaxes())
    return;
  const auto flow = [&flows](const unsigned int cell) { return Affine{flows[cell], 0., 0.}; };
  for (unsigned int f = 0; f <= n; ++f)
  {
    pressures[f] =
        -relaxation.damping_time * stiffness[f] * flow_slope(f, flow).at(start_flow, end_flow);
    for (const States &branch : branches)
      pressures[f] += branch.now[f];
  }
}
} // namespace Continua
