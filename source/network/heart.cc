#include <continua/network/heart.h>

#include <algorithm>

namespace Continua
{
Heart::Heart(const Law &law) : law(law), now(law.initial_volume), next(law.initial_volume) {}

void Heart::end_step(const double time, const double step)
{
  const double before = pressure(time), change = next - now;
  now = next;
  done -= 0.5 * (before + pressure(time + step)) * change;
}

double Heart::filling(const double pressure) const
{
  return std::max(0., (law.filling_pressure - pressure) / law.filling_resistance);
}

double Heart::volume_at_end(const double time,
                            const double step,
                            const double outflow,
                            double &slope) const
{
  const double half = 0.5 * step, elastance = law.elastance(time + step),
               without_filling = now + half * (filling_at_begin - outflow_at_begin - outflow);
  slope = -half;
  if (elastance * (without_filling - law.unloaded_volume) >= law.filling_pressure)
    return without_filling;
  // The filling depends on the volume that it gives.
  const double rate = half / law.filling_resistance, divisor = 1. + rate * elastance;
  slope /= divisor;
  return (without_filling + rate * (law.filling_pressure + elastance * law.unloaded_volume)) /
         divisor;
}

Heart::Pressure Heart::pressure(const bool at_end_of_step,
                                const double time,
                                const double step,
                                const double outflow) const
{
  if (!at_end_of_step)
    return {law.elastance(time) * (now - law.unloaded_volume), 0.};
  double slope = 0.;
  const double volume = volume_at_end(time, step, outflow, slope),
               elastance = law.elastance(time + step);
  return {elastance * (volume - law.unloaded_volume), elastance * slope};
}

void Heart::take(const bool at_end_of_step,
                 const double time,
                 const double step,
                 const double outflow)
{
  if (at_end_of_step)
  {
    double slope = 0.;
    next = volume_at_end(time, step, outflow, slope);
    return;
  }
  outflow_at_begin = outflow;
  filling_at_begin = filling(pressure(false, time, step, 0.).value);
}
} // namespace Continua
