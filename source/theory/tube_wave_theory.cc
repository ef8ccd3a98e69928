#include <continua/theory/tube_wave_theory.h>

#include <continua/signal/fourier_transform.h>
#include <continua/theory/dispersion_curves.h>

#include <deal.II/base/numbers.h>

#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
using Complex = std::complex<double>;
constexpr unsigned int fewest_samples = 1 << 14, largest_n_samples = 1 << 18, fewest_kept = 16;

double window_of(const double end_time)
{
  return 2. * end_time;
}

/// [1/s]
double shift_of(const double end_time)
{
  return std::log(1e6) / window_of(end_time);
}

/// At most this frequency [Hz], by the walls of a tube and its branches.
double highest_of_walls(const TubeWaveProblem &problem, const double shift)
{
  // Well above the ring frequency of its wall a tube carries no pressure wave, and the closed
  // formulas of a membrane end at it.
  const bool is_membrane =
      problem.level == WaveLevel::membrane || problem.level == WaveLevel::closed_formula;
  double highest = std::numeric_limits<double>::infinity();
  for (const TubeSegment &segment : problem.segments)
    if (!segment.section.layers.empty())
    {
      const double young = segment.section.hoop_modulus(Complex(0., -shift)).real();
      const double ring_frequency = std::sqrt(young / segment.section.wall_density()) /
                                    (2. * PI * segment.section.inner_radius);
      highest = std::min(highest, (is_membrane ? 0.5 : 2.) * ring_frequency);
    }
  for (const TubeWaveProblem &branch : problem.branches)
    highest = std::min(highest, highest_of_walls(branch, shift));
  return highest;
}

std::vector<Complex> transform_inlet(const std::function<double(double)> &inlet,
                                     const double end_time,
                                     const double shift,
                                     const unsigned int n_samples)
{
  // By the trapezoidal rule. What the inlet still says at the end is faded out, since its cut would
  // be a jump.
  const double sample_time = window_of(end_time) / n_samples;
  const double fade = 0.5 * end_time, value_at_end = inlet(end_time);
  std::vector<double> samples(n_samples, 0.);
  for (unsigned int j = 0; j < n_samples; ++j)
  {
    const double time = j * sample_time, beyond = time - end_time;
    const double weight = sample_time * std::exp(-shift * time);
    if (beyond <= 0.)
      samples[j] = inlet(time) * weight;
    else if (beyond < fade)
      samples[j] = value_at_end * 0.5 * (1. + std::cos(PI * beyond / fade)) * weight;
  }
  samples[0] *= 0.5;
  return fourier_transform(samples);
}

/// The last line of the lower half of a spectrum that is above the tolerance.
unsigned int last_above(const std::vector<Complex> &spectrum, const double tolerance)
{
  const std::size_t half = spectrum.size() / 2;
  double largest = 0.;
  for (std::size_t n = 0; n < half; ++n)
    largest = std::max(largest, std::abs(spectrum[n]));
  unsigned int last = fewest_kept;
  for (std::size_t n = last; n < half; ++n)
    if (std::abs(spectrum[n]) > tolerance * largest)
      last = n;
  return last;
}

/// Of the exact waves of a tube, without its branches, up to a frequency [Hz].
double n_roots_of(const TubeWaveProblem &problem, const double shift, const double last_frequency)
{
  if (problem.level != WaveLevel::exact)
    return 0.;
  double n_roots = 0.;
  for (const std::size_t segment : TubeChain::computed_segments(problem))
  {
    const TubeSection &section = problem.segments[segment].section;
    n_roots += static_cast<double>(ExactDispersion(section).families().size()) *
               DispersionCurves::frequencies_of(section, shift, last_frequency).size();
  }
  return n_roots;
}
} // namespace

TubeWaveTheory::TubeWaveTheory(const TubeWaveProblem &problem,
                               const std::function<double(double)> &inlet,
                               const double end_time,
                               const double spectral_tolerance,
                               KeptWaves *const kept)
    : period(window_of(end_time)), shift(shift_of(end_time)), n_samples(fewest_samples)
{
  // Sampled ever finer until the upper half of the spectrum is below the tolerance.
  std::vector<Complex> samples;
  unsigned int last = 0;
  for (;; n_samples *= 2)
  {
    samples = transform_inlet(inlet, end_time, shift, n_samples);
    last = last_above(samples, spectral_tolerance);
    // An inlet with a jump has a spectrum that ends nowhere: it is then cut where it is.
    if (last < n_samples / 4 || n_samples >= largest_n_samples)
      break;
  }
  last = std::min(last, n_samples / 4);
  last =
      static_cast<unsigned int>(std::min<double>(last, highest_of_walls(problem, shift) * period));
  last = std::max(last, fewest_kept);
  last_frequency = last / period;
  const unsigned int first_faded = static_cast<unsigned int>(0.8 * last);
  for (unsigned int n = 0; n <= last; ++n)
  {
    const double share =
        n <= first_faded ? 0. : static_cast<double>(n - first_faded) / (last + 1 - first_faded);
    spectrum.push_back(samples[n] * 0.5 * (1. + std::cos(PI * share)));
  }

  add_chains(problem, 0, kept);
}

void TubeWaveTheory::add_chains(const TubeWaveProblem &problem,
                                const std::size_t before,
                                KeptWaves *const kept)
{
  const std::size_t here = chains.size();
  const bool divides = problem.outlet == TubeWaveProblem::Outlet::divided;
  if (divides == problem.branches.empty())
    throw std::invalid_argument("A tube has branches if its outlet is divided, and only then.");
  chains.push_back(
      {TubeChain(problem, shift, last_frequency, kept), problem.length(), before, divides});
  for (const TubeWaveProblem &branch : problem.branches)
  {
    if (branch.inlet != TubeWaveProblem::Inlet::pressure)
      throw std::invalid_argument("What drives a branch is the pressure before it.");
    add_chains(branch, here, kept);
  }
}

std::vector<TubeChain::Values> TubeWaveTheory::values(const double frequency,
                                                      const Complex &inlet,
                                                      const unsigned int chain,
                                                      const std::vector<double> &stations) const
{
  // From the ends of the branches to the inlet, each for a unit at its own inlet.
  std::vector<Complex> admittances(chains.size(), 0.);
  std::vector<TubeChain::Solution> solutions(chains.size());
  for (std::size_t c = chains.size(); c-- > 0;)
  {
    solutions[c] = chains[c].waves.solve(frequency, chains[c].divides ? 1. / admittances[c] : 0.);
    if (c > 0)
      admittances[chains[c].before] += chains[c].waves.values(solutions[c], 0.).flow_rate;
  }
  // And on to the chain: what stands at its inlet.
  Complex factor = inlet;
  for (std::size_t c = chain; c > 0; c = chains[c].before)
  {
    const std::size_t before = chains[c].before;
    factor *= chains[before].waves.values(solutions[before], chains[before].length).traction;
  }
  std::vector<TubeChain::Values> result;
  for (const double station : stations)
  {
    result.push_back(chains[chain].waves.values(solutions[chain], station));
    result.back().scale(factor);
  }
  return result;
}

TubeWaveTheory::Work TubeWaveTheory::work(const TubeWaveProblem &problem,
                                          const std::function<double(double)> &inlet,
                                          const double end_time,
                                          const double spectral_tolerance)
{
  const double shift = shift_of(end_time), window = window_of(end_time);
  double last =
      last_above(transform_inlet(inlet, end_time, shift, fewest_samples), spectral_tolerance);
  // The spectrum goes on beyond what so few samples show.
  if (last >= fewest_samples / 4)
    last = largest_n_samples / 4;
  last = std::max<double>(std::min(last, highest_of_walls(problem, shift) * window), fewest_kept);
  Work work;
  const std::function<void(const TubeWaveProblem &)> add = [&](const TubeWaveProblem &tube)
  {
    work.n_roots += n_roots_of(tube, shift, last / window);
    work.n_segment_solves += last * tube.segments.size();
    for (const TubeWaveProblem &branch : tube.branches)
      add(branch);
  };
  add(problem);
  return work;
}

double TubeWaveTheory::wrap_round() const
{
  return std::exp(-shift * period);
}

std::vector<WaveHistory> TubeWaveTheory::histories(const std::vector<double> &stations,
                                                   const std::vector<double> &times,
                                                   const unsigned int branch) const
{
  constexpr unsigned int n_fields = 6;
  if (branch >= chains.size())
    throw std::invalid_argument("There is no such branch.");
  std::vector<std::vector<Complex>> spectra(stations.size() * n_fields,
                                            std::vector<Complex>(n_samples / 2 + 1, 0.));
  for (unsigned int n = 0; n < spectrum.size(); ++n)
  {
    const std::vector<TubeChain::Values> at_stations =
        values(n / period, spectrum[n], branch, stations);
    for (unsigned int i = 0; i < stations.size(); ++i)
    {
      const TubeChain::Values &at = at_stations[i];
      const Complex of_fields[n_fields] = {at.pressure,          at.axis_pressure,
                                           at.flow_rate,         at.wall_distension,
                                           at.wall_shear_stress, at.hoop_stress};
      // The inverse transform divides by the number of samples.
      for (unsigned int f = 0; f < n_fields; ++f)
        spectra[i * n_fields + f][n] = of_fields[f] * static_cast<double>(n_samples) / period;
    }
  }

  // Back in time, and between the samples by splines.
  std::vector<double> sample_times(n_samples), samples(n_samples);
  for (unsigned int j = 0; j < n_samples; ++j)
    sample_times[j] = j * period / n_samples;
  const std::unique_ptr<gsl_spline, decltype(&gsl_spline_free)> spline(
      gsl_spline_alloc(gsl_interp_cspline, n_samples), &gsl_spline_free);
  std::vector<WaveHistory> result(stations.size());
  for (unsigned int i = 0; i < stations.size(); ++i)
  {
    std::vector<double> *const fields[n_fields] = {
        &result[i].pressure,        &result[i].axis_pressure,     &result[i].flow_rate,
        &result[i].wall_distension, &result[i].wall_shear_stress, &result[i].hoop_stress};
    for (unsigned int f = 0; f < n_fields; ++f)
    {
      samples = inverse_fourier_transform(spectra[i * n_fields + f], n_samples);
      for (unsigned int j = 0; j < n_samples; ++j)
        samples[j] *= std::exp(shift * sample_times[j]);
      gsl_spline_init(spline.get(), sample_times.data(), samples.data(), n_samples);
      for (const double time : times)
        fields[f]->push_back(gsl_spline_eval(spline.get(), time, nullptr));
    }
  }
  return result;
}
} // namespace Continua
