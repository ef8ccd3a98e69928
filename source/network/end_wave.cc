#include <continua/network/end_wave.h>

#include <cmath>

namespace Continua
{
EndWave::EndWave(Vessel &vessel, const Vessel::End end)
    : vessel(vessel), end(end), sign(end == Vessel::End::end ? 1. : -1.)
{
}

void EndWave::begin()
{
  trace = vessel.trace(end);
  trace_rate = rate(-sign, trace.area, vessel.stiffness(end, trace.area), trace.flow / trace.area);
}

double EndWave::rate(const double direction,
                     const double area,
                     const double stiffness,
                     const double velocity) const
{
  const FlowLaw &law = vessel.flow_law();
  return ((law.momentum_correction - 1.) * velocity +
          direction * law.relative_speed(area * stiffness, velocity)) /
         area;
}

EndWave::Values EndWave::at_area(const double area) const
{
  const FlowLaw &law = vessel.flow_law();
  const double start = trace.flow / trace.area, change = area - trace.area,
               middle = 0.5 * (trace.area + area);
  Values values{};
  values.pressure = vessel.pressure(end, area);
  values.stiffness = vessel.stiffness(end, area);
  const double of_middle = rate(-sign, middle, vessel.stiffness(end, middle),
                                start + 0.5 * change * trace_rate),
               last = rate(-sign, area, values.stiffness,
                           start + change * (2. * of_middle - trace_rate));
  values.velocity = start + change * (trace_rate + 4. * of_middle + last) / 6.;
  values.velocity_slope = last;
  values.inflow = sign * area * values.velocity;
  values.inflow_slope = sign * (values.velocity + area * values.velocity_slope);
  const double factor = law.density * law.momentum_correction * values.velocity;
  values.head = values.pressure + 0.5 * factor * values.velocity;
  values.head_slope = values.stiffness + factor * values.velocity_slope;
  return values;
}

void EndWave::take(const double area)
{
  vessel.set_end(end, {area, area * at_area(area).velocity});
}

std::pair<double, double> EndWave::leaving(const double start_area, const double area) const
{
  // The classic method of Runge and Kutta over the logarithm of the area, in which the speed of the
  // wave varies slowly.
  constexpr unsigned int n_steps = 8;
  const double length = std::log(area / start_area) / n_steps;
  const auto slope = [&](const double place, const double velocity)
  {
    const double there = start_area * std::exp(place * length);
    return length * there * rate(sign, there, vessel.stiffness(end, there), velocity);
  };
  double velocity = 0.;
  for (unsigned int i = 0; i < n_steps; ++i)
  {
    const double first = slope(i, velocity), second = slope(i + 0.5, velocity + 0.5 * first),
                 third = slope(i + 0.5, velocity + 0.5 * second),
                 fourth = slope(i + 1., velocity + third);
    velocity += (first + 2. * (second + third) + fourth) / 6.;
  }
  return {velocity, rate(sign, area, vessel.stiffness(end, area), velocity)};
}
} // namespace Continua
