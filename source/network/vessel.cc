#include <continua/network/vessel.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
Vessel::Vessel(const VesselDescription &description)
    : description(description),
      area(description.n_cells),
      flow(description.n_cells),
      old_area(description.n_cells),
      old_flow(description.n_cells)
{
  if (!(description.length > 0.) || description.n_cells == 0)
    throw std::invalid_argument("A vessel has no length or no cell.");
}

double Vessel::height(const double z) const
{
  return description.height_at_start +
         z / description.length * (description.height_at_end - description.height_at_start);
}

double Vessel::volume() const
{
  double sum = 0.;
  for (const double of_cell : area)
    sum += of_cell;
  return sum * cell_length();
}

double Vessel::energy() const
{
  const FlowLaw &law = flow_law();
  double sum = 0.;
  for (unsigned int i = 0; i < n_cells(); ++i)
    sum += 0.5 * law.density * flow[i] * flow[i] / area[i] + wall_energy(i, area[i]) +
           law.density * law.gravity * height((i + 0.5) * cell_length()) * area[i];
  return sum * cell_length();
}

Vessel::Values Vessel::values(const double z) const
{
  const double cell = cell_length(), place = z / cell - 0.5;
  const auto shear_stress = [&](const State &state, const unsigned int i)
  {
    const FlowLaw &law = flow_law();
    // The force on a length of the liquid over its density, over the circumference.
    const double friction =
        law.friction() * state.flow / state.area + (past ? past->friction(i, state.area) : 0.);
    return law.density * friction / (2. * std::sqrt(FlowLaw::pi * state.area));
  };
  const auto at_centre = [&](const unsigned int i)
  {
    return Values{pressure_at_centre(i, area[i]) + (past ? past->pressure_in_cell(i) : 0.), flow[i],
                  area[i], shear_stress({area[i], flow[i]}, i)};
  };
  const auto at_end = [&](const End end)
  {
    const State &state = of_end(end).state;
    return Values{pressure(end, state.area), state.flow, state.area,
                  shear_stress(state, end == End::start ? 0 : n_cells() - 1)};
  };
  Values first{}, second{};
  double share = 0.; // of the second
  if (place < 0.)
  {
    first = at_end(End::start);
    second = at_centre(0);
    share = z / (0.5 * cell);
  }
  else if (place >= n_cells() - 1.)
  {
    first = at_centre(n_cells() - 1);
    second = at_end(End::end);
    share = std::min((z - (length() - 0.5 * cell)) / (0.5 * cell), 1.);
  }
  else
  {
    const unsigned int i = static_cast<unsigned int>(place);
    first = at_centre(i);
    second = at_centre(i + 1);
    share = place - i;
  }
  const auto between = [&](const double a, const double b) { return a + share * (b - a); };
  return {between(first.pressure, second.pressure), between(first.flow, second.flow),
          between(first.area, second.area),
          between(first.wall_shear_stress, second.wall_shear_stress)};
}

void Vessel::start_at_rest(const double pressure)
{
  start_steady(0.,
               pressure - flow_law().density * flow_law().gravity * description.height_at_start);
}

void Vessel::set(const std::vector<double> &areas, const std::vector<double> &flows)
{
  area = areas;
  flow = flows;
  of_end(End::start).state = {areas.front(), flows.front()};
  of_end(End::end).state = {areas.back(), flows.back()};
  // Of the faces, where there is such a state.
  if (reconstruct())
    for (const End end : {End::start, End::end})
      of_end(end).state = of_end(end).trace;
  if (past)
    past->start_at_rest(flow);
}

void Vessel::set_relaxation(const WallRelaxation &relaxation)
{
  past = std::make_unique<VesselMemory>(n_cells(), cell_length(), flow_law(), relaxation);
}

void Vessel::visit(StateNumbers &numbers)
{
  numbers.values(area);
  numbers.values(flow);
  for (EndStates &end : ends)
    for (State *const state : {&end.trace, &end.state})
    {
      numbers.value(state->area);
      numbers.value(state->flow);
    }
  if (past)
    past->visit(numbers);
}

void Vessel::begin_step()
{
  old_area = area;
  old_flow = flow;
  if (past)
    past->begin_step();
}

void Vessel::begin_memory_stage(const bool second, const double step)
{
  const unsigned int n = n_cells();
  std::vector<double> stiffnesses(n + 1, 0.);
  if (past->wall_relaxes())
    for (unsigned int f = 0; f <= n; ++f)
      stiffnesses[f] = stiffness_at_face(f, f == 0   ? of_end(End::start).state.area
                                            : f == n ? of_end(End::end).state.area
                                                     : 0.5 * (area[f - 1] + area[f]));
  past->begin_stage(second, step, area, flow, stiffnesses);
}

void Vessel::end_memory_stage(const double start_flow, const double end_flow)
{
  past->end_stage(start_flow, end_flow, flow);
}

void Vessel::add_memory(const bool second, const double step)
{
  past->add(second, step, of_end(End::start).state.flow, of_end(End::end).state.flow, flow);
}
} // namespace Continua
