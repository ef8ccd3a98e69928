#include <continua/case/before_the_run/load_spectrum.h>

#include <continua/signal/energy_frequency.h>
#include <continua/signal/fourier_transform.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace Continua
{
namespace
{
constexpr double origin[3] = {0., 0., 0.};
/// What of the spectrum does not matter, relative to its largest value.
constexpr double negligible = 1e-3;

using TimeFunction = std::function<double(double)>;

/// What drives the body, each as a function of time. In a body that starts at rest under its loads
/// only their changes make waves.
std::vector<TimeFunction> loads_of(const Problem &problem)
{
  std::vector<TimeFunction> loads;
  const bool starts_loaded =
      (problem.interior.starts_steady_under_loads && !problem.interior.starts_under_mean_loads) ||
      problem.finds_unloaded_shape();
  const auto add = [&loads, starts_loaded](const Waveform &waveform)
  {
    if (waveform.is_zero() || (starts_loaded && !waveform.depends_on_time()))
      return;
    const double start = starts_loaded ? waveform.initial_value(origin) : 0.;
    loads.emplace_back([waveform, start](const double time)
                       { return waveform(origin, time) - start; });
  };
  const auto add_all = [&add](const std::vector<Waveform> &waveforms)
  {
    for (const Waveform &waveform : waveforms)
      add(waveform);
  };
  for (const BoundaryCondition &condition : problem.conditions)
  {
    if (condition.free_flow)
      add(condition.free_flow->rate);
    for (const BoundaryPart *part : {&condition.normal, &condition.tangential})
    {
      add(part->along_normal);
      add_all(part->vector);
    }
  }
  for (const Outlet &outlet : problem.outlets)
    add(outlet.pressure_behind);
  add_all(problem.interior.acceleration);
  add_all(problem.interior.body_force);
  return loads;
}

} // namespace

LoadSpectrum::LoadSpectrum(const Problem &problem, const double end_time, const double time_step)
{
  // What a load still says at the end is faded out, since its cut would be a jump.
  const std::size_t n = std::max<std::size_t>(64, std::lround(end_time / time_step)),
                    // Enough for 90 % of the energy, which a long run has at low frequencies.
      n_of_reference = std::min<std::size_t>(n, 1 << 16), n_fade = n / 2,
                    n_padded = next_power_of_two(2 * n);
  spacing = n / (end_time * n_padded);
  for (const TimeFunction &load : loads_of(problem))
  {
    std::vector<double> samples;
    for (std::size_t i = 0; i < n; ++i)
      samples.push_back(load(i * end_time / n));
    reference =
        std::max(reference,
                 Continua::energy_frequency(samples_of_whole_pulse(load, end_time, n_of_reference),
                                            end_time / n_of_reference));
    const double at_end = samples.back();
    samples.resize(n_padded, 0.);
    for (std::size_t i = 0; i < n_fade; ++i)
      samples[n + i] = at_end * 0.5 * (1. + std::cos(dealii::numbers::PI * i / n_fade));
    const auto spectrum = fourier_transform(samples);
    envelope.resize(spectrum.size(), 0.);
    double largest = 0.;
    for (const auto &value : spectrum)
      largest = std::max(largest, std::abs(value));
    for (std::size_t k = 0; k < spectrum.size() && largest > 0.; ++k)
      envelope[k] = std::max(envelope[k], std::abs(spectrum[k]) / largest);
  }
  for (std::size_t k = envelope.size(); k-- > 1;)
    envelope[k - 1] = std::max(envelope[k - 1], envelope[k]);
}

double LoadSpectrum::memory(const double end_time, const double time_step)
{
  // The padded samples and their transform, up to four times as long, with what GSL needs, and the
  // envelope of the loads before.
  return 230. * end_time / time_step;
}

double LoadSpectrum::from(const double frequency) const
{
  const std::size_t k = frequency / spacing;
  return k < envelope.size() ? envelope[k] : 0.;
}

double LoadSpectrum::highest_frequency() const
{
  std::size_t k = 0;
  while (k < envelope.size() && envelope[k] > negligible)
    ++k;
  return k * spacing;
}
} // namespace Continua
