#include <continua/continuum/steady_network_end.h>

#include <continua/base/input_error.h>
#include <continua/network/network_parameters.h>
#include <continua/signal/waveform.h>

namespace Continua
{
SteadyNetworkEnd::SteadyNetworkEnd(const Outlet &outlet,
                                   Network &network,
                                   const std::vector<unsigned int> &nodes)
    : outlet(outlet), flow(network, nodes), exists(flow.exists())
{
}

bool SteadyNetworkEnd::applies(const Step &step) const
{
  return step.finds_steady_state && exists && !step.finds_unloaded_shape &&
         (step.balance_time == mean_over_period || !outlet.network->gives_state_at_rest());
}

void SteadyNetworkEnd::find(const std::vector<double> &flow_rates, const Step &step)
{
  const bool is_mean = step.balance_time == mean_over_period;
  try
  {
    flow.solve(flow_rates,
               {is_mean ? 0. : step.balance_time, is_mean ? outlet.network->period_of_loads : 0.});
  }
  catch (const StepFailure &failure)
  {
    throw StepFailure("at '" + outlet.name + "' " + failure.what());
  }
}

void SteadyNetworkEnd::solve(const Step &step,
                             const double *const flow_rates,
                             std::vector<double> &pressures,
                             dealii::FullMatrix<double> &impedance)
{
  const std::size_t n = outlet.conditions.size();
  pressures.assign(n, 0.);
  if (step.load_factor < 1.)
  {
    find(std::vector<double>(n, 0.), step);
    for (unsigned int i = 0; i < n; ++i)
      pressures[i] = (step.load_factor - 1.) * flow.pressure(i);
  }
  std::vector<double> rates(n); // of the whole tube
  for (unsigned int i = 0; i < n; ++i)
    rates[i] = flow_rates[i] / outlet.fractions[i];
  find(rates, step);
  for (unsigned int i = 0; i < n; ++i)
  {
    pressures[i] += flow.pressure(i);
    for (unsigned int j = 0; j < n; ++j)
      impedance(i, j) = flow.slope(i, j) / outlet.fractions[j];
  }
}
} // namespace Continua
