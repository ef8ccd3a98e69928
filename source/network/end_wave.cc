#include <continua/network/end_wave.h>

#include <gsl/gsl_integration.h>

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
  trace_rate = rate(trace.area, vessel.stiffness(end, trace.area));
}

double EndWave::rate(const double area, const double stiffness) const
{
  const FlowLaw &law = vessel.flow_law();
  const double velocity = trace.flow / trace.area;
  return ((law.momentum_correction - 1.) * velocity -
          sign * law.relative_speed(area * stiffness, velocity)) /
         area;
}

EndWave::Values EndWave::at_area(const double area) const
{
  const FlowLaw &law = vessel.flow_law();
  const double middle = 0.5 * (trace.area + area);
  Values values{};
  values.pressure = vessel.pressure(end, area);
  values.stiffness = vessel.stiffness(end, area);
  const double last = rate(area, values.stiffness),
               of_middle = rate(middle, vessel.stiffness(end, middle));
  values.velocity =
      trace.flow / trace.area + (area - trace.area) * (trace_rate + 4. * of_middle + last) / 6.;
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

double EndWave::speed_integral(const double from, const double to) const
{
  static const std::unique_ptr<gsl_integration_glfixed_table,
                               decltype(&gsl_integration_glfixed_table_free)>
      table(gsl_integration_glfixed_table_alloc(12), &gsl_integration_glfixed_table_free);
  const auto integrand = [this](const double area)
  { return std::sqrt(vessel.stiffness(end, area) / (vessel.flow_law().density * area)); };
  const gsl_function function = {[](const double area, void *const data) {
                                   return (*static_cast<const decltype(integrand) *>(data))(area);
                                 },
                                 const_cast<void *>(static_cast<const void *>(&integrand))};
  return gsl_integration_glfixed(&function, from, to, table.get());
}
} // namespace Continua
