#include <continua/network/terminal.h>

#include <continua/base/six_digits.h>

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
    : wave(vessel, end), law(law), compliance_pressure(law.initial_pressure)
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
    const double rest = wave.of().area_at(wave.at(), law.initial_pressure, start);
    return find_area(start,
                     [&](const double area)
                     {
                       const EndWave::Values values = wave.at_area(area);
                       const auto [velocity, slope] = wave.leaving(rest, area);
                       return std::make_pair(values.velocity - velocity,
                                             values.velocity_slope - slope);
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

double Terminal::solve(const bool at_end_of_step, const double time, const double step)
{
  wave.begin();
  double source = law.pressure_behind, resistance = law.resistance, of_outflow = 0.;
  if (law.type == TerminalLaw::Type::windkessel)
  {
    source = compliance_pressure;
    if (at_end_of_step)
    {
      // The pressure of the compliance behind a flow rate that is linear over the step.
      const double x = step / (law.distal_resistance * law.compliance), mean = -std::expm1(-x) / x,
                   of_begin = law.distal_resistance *
                              (x < 1e-3 ? x * (0.5 - x * (1. / 3. - x / 8.)) : mean - std::exp(-x));
      of_outflow =
          law.distal_resistance * (x < 1e-3 ? x * (0.5 - x * (1. / 6. - x / 24.)) : 1. - mean);
      source = law.pressure_behind + std::exp(-x) * (compliance_pressure - law.pressure_behind) +
               of_begin * outflow_at_begin;
      resistance += of_outflow;
    }
  }
  double area = 0.;
  try
  {
    area = area_with(at_end_of_step ? time + step : time, source, resistance);
  }
  catch (const std::domain_error &error)
  {
    throw std::domain_error(std::string(wave.at() == Vessel::End::start ? "start" : "end") +
                            " of the vessel '" + wave.of().name() + "': " + error.what());
  }
  wave.take(area);
  const double outflow = wave.at_area(area).inflow;
  if (at_end_of_step)
    next_pressure = source + of_outflow * outflow;
  else
    outflow_at_begin = outflow;
  return -outflow;
}

void Terminal::end_step()
{
  if (law.type == TerminalLaw::Type::windkessel)
    compliance_pressure = next_pressure;
}
} // namespace Continua
