#include <continua/network/terminal.h>

#include <continua/base/six_digits.h>
#include <continua/time_integration/linear_relaxation.h>

#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
constexpr unsigned int most_iterations = 50;
/// Of the area: the error after the last correction is about the square of it.
constexpr double tolerance_of_area = 1e-9;

/// Newton's method for an area [m^2]; `surplus(area)` has a value and its derivative.
template <typename Surplus>
double find_area(const double start, const Surplus &surplus)
{
  double area = start;
  for (unsigned int i = 0; i < most_iterations; ++i)
  {
    const auto [value, slope] = surplus(area);
    double change = -value / slope;
    if (!std::isfinite(change))
      break;
    if (std::abs(change) > 0.5 * area)
      change = std::copysign(0.5 * area, change);
    area += change;
    if (std::abs(change) < tolerance_of_area * area)
      return area;
  }
  throw std::domain_error("no state was found that the end and its vessel have in common");
}
} // namespace

Terminal::Terminal(Vessel &vessel, const Vessel::End end, const TerminalLaw &law)
    : wave(vessel, end),
      law(law),
      heart(law.heart),
      compliance_pressure(law.initial_pressure),
      pressure_of_stage(law.initial_pressure),
      last_pressure(law.initial_pressure)
{
}

double Terminal::area_with(const double time, const double source, const double resistance) const
{
  using Type = TerminalLaw::Type;
  const double start = wave.inside().area;
  switch (law.type)
  {
  case Type::pressure:
  {
    const double pressure = law.value(time), largest = wave.of().largest_pressure(wave.at());
    if (pressure >= largest)
      throw std::domain_error("the given pressure, " + six_digits(pressure) +
                              " Pa, is above the largest one of the wall, " + six_digits(largest) +
                              " Pa");
    const double area = wave.of().area_at(wave.at(), pressure, start);
    if (!(area > 0.))
      throw std::domain_error("the wall has no state under the given pressure, " +
                              six_digits(pressure) + " Pa");
    return area;
  }
  case Type::flow_rate:
  case Type::closed:
  {
    const double inflow = law.type == Type::closed ? 0. : law.value(time);
    return find_area(start,
                     [&](const double area)
                     {
                       const EndWave::Values values = wave.at_area(area);
                       return std::make_pair(values.inflow + inflow, values.inflow_slope);
                     });
  }
  case Type::absorbing:
  {
    // The wave that comes in is that of the state at rest.
    const Vessel &vessel = wave.of();
    const double memory = vessel.memory_pressure(wave.at()),
                 start_area = vessel.area_at(wave.at(), law.initial_pressure + memory, start);
    return find_area(
        start,
        [&](const double area)
        {
          const EndWave::Values values = wave.at_area(area);
          if (memory == 0.)
          {
            const auto [velocity, slope] = wave.leaving(start_area, area);
            return std::make_pair(values.velocity - velocity, values.velocity_slope - slope);
          }
          // The area of the wall law that has half the pressure of the memory, too.
          const double behind = vessel.area_at(wave.at(), values.pressure + 0.5 * memory, area);
          const auto [velocity, slope] = wave.leaving(start_area, behind);
          return std::make_pair(values.velocity - velocity,
                                values.velocity_slope -
                                    slope * values.stiffness / vessel.stiffness(wave.at(), behind));
        });
  }
  default:
    return find_area(start,
                     [&](const double area)
                     {
                       const EndWave::Values values = wave.at_area(area);
                       return std::make_pair(values.pressure - source - resistance * values.inflow,
                                             values.stiffness - resistance * values.inflow_slope);
                     });
  }
}

double Terminal::area_with_heart(const bool at_end_of_step, const double time, const double step)
{
  const double start = wave.inside().area,
               closed = find_area(start,
                                  [&](const double area)
                                  {
                                    const EndWave::Values values = wave.at_area(area);
                                    return std::make_pair(values.inflow, values.inflow_slope);
                                  });
  // By the pressures: the flow rate of a closed valve is zero only up to round-off, of either sign.
  valve_is_open = heart.is_open(at_end_of_step, time, step, wave.at_area(closed).pressure);
  if (!valve_is_open)
    return closed;
  return find_area(
      closed,
      [&](const double area)
      {
        const EndWave::Values values = wave.at_area(area);
        // The flow rate into the vessel is less than nothing into the node.
        const Heart::Pressure inside = heart.pressure(at_end_of_step, time, step, -values.inflow);
        return std::make_pair(
            values.pressure - inside.value - heart.valve_resistance() * values.inflow,
            values.stiffness + (inside.slope - heart.valve_resistance()) * values.inflow_slope);
      });
}

Terminal::Behind Terminal::behind(const bool at_end_of_step, const double step) const
{
  if (law.type != TerminalLaw::Type::windkessel)
    return {law.pressure_behind, law.resistance, 0.};
  if (!at_end_of_step)
    return {compliance_pressure, law.resistance, 0.};
  // The charge of the compliance behind a flow rate that is linear over the step.
  const LinearRelaxation charge(step, law.distal_resistance * law.compliance);
  const double of_outflow = charge.of_new / law.compliance;
  return {law.pressure_behind + charge.decay * (compliance_pressure - law.pressure_behind) +
              charge.of_old / law.compliance * outflow_at_begin,
          law.resistance + of_outflow, of_outflow};
}

Terminal::LinearLaw
Terminal::linear_law(const bool at_end_of_step, const double time, const double step) const
{
  using Type = TerminalLaw::Type;
  const double when = at_end_of_step ? time + step : time;
  switch (law.type)
  {
  case Type::pressure:
    return {0., 1., law.value(when), 1.};
  case Type::flow_rate:
    return {1., 0., -law.value(when), 1.};
  case Type::closed:
    return {1., 0., 0., 1.};
  case Type::heart:
  {
    if (!valve_is_open)
      return {1., 0., 0., 1.};
    const Heart::Pressure inside = heart.pressure(at_end_of_step, time, step, 0.);
    return {-(heart.valve_resistance() - inside.slope), 1., inside.value, 1.};
  }
  case Type::absorbing:
  {
    // About the last state, which satisfies the law.
    const double impedance = wave.of().linear_end(wave.at()).impedance;
    return {-impedance, 1., last_pressure - impedance * last_outflow, 0.5};
  }
  default:
  {
    const Behind what = behind(at_end_of_step, step);
    return {-what.resistance, 1., what.source, 1.};
  }
  }
}

double Terminal::solve(const bool at_end_of_step, const double time, const double step)
{
  wave.begin();
  const auto [source, resistance, of_outflow] = behind(at_end_of_step, step);
  double area = 0.;
  try
  {
    area = law.type == TerminalLaw::Type::heart
               ? area_with_heart(at_end_of_step, time, step)
               : area_with(at_end_of_step ? time + step : time, source, resistance);
  }
  catch (const std::domain_error &error)
  {
    throw std::domain_error(std::string(wave.at() == Vessel::End::start ? "start" : "end") +
                            " of the vessel '" + wave.of().name() + "': " + error.what());
  }
  wave.take(area);
  const EndWave::Values values = wave.at_area(area);
  const double outflow = values.inflow;
  if (law.type == TerminalLaw::Type::heart)
    heart.take(at_end_of_step, time, step, valve_is_open ? -outflow : 0.);
  last_outflow = outflow;
  pressure_of_stage = values.pressure;
  last_pressure = values.pressure - 0.5 * wave.of().memory_pressure(wave.at());
  if (at_end_of_step)
    next_pressure = source + of_outflow * outflow;
  else
    outflow_at_begin = outflow;
  return -outflow;
}

void Terminal::end_step(const double time, const double step)
{
  if (law.type == TerminalLaw::Type::windkessel)
    compliance_pressure = next_pressure;
  if (law.type == TerminalLaw::Type::heart)
    heart.end_step(time, step);
}

void Terminal::start_steady(const double pressure, const double outflow)
{
  if (law.type == TerminalLaw::Type::windkessel)
    compliance_pressure = next_pressure = law.pressure_behind + law.distal_resistance * outflow;
  pressure_of_stage = last_pressure = pressure;
  last_outflow = outflow_at_begin = outflow;
}

double Terminal::energy() const
{
  return law.type == TerminalLaw::Type::windkessel
             ? 0.5 * law.compliance * compliance_pressure * compliance_pressure
             : 0.;
}

void Terminal::visit(StateNumbers &numbers)
{
  numbers.value(valve_is_open);
  for (double *const member : {&compliance_pressure, &next_pressure, &outflow_at_begin,
                               &pressure_of_stage, &last_pressure, &last_outflow})
    numbers.value(*member);
  heart.visit(numbers);
}
} // namespace Continua
