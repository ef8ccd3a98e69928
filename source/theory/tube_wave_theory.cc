#include <continua/signal/fourier_transform.h>
#include <continua/theory/constants.h>
#include <continua/theory/dispersion_curves.h>
#include <continua/theory/matched_impedance.h>
#include <continua/theory/scaled_system.h>
#include <continua/theory/tube_wave_theory.h>

#include <deal.II/base/numbers.h>

#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
using Complex = std::complex<double>;
constexpr unsigned int largest_n_samples = 1 << 18;

using Matrix = ComplexMatrix;

/// The quantities that join segments of these families.
std::vector<WaveMode::Junction>
joined_quantities(const std::vector<ExactDispersion::Family> &families)
{
  switch (families.size())
  {
  case 1:
    return {WaveMode::traction, WaveMode::flow_rate};
  case 3: // held axially
    return {WaveMode::traction, WaveMode::flow_rate,      WaveMode::radial_displacement,
            WaveMode::rotation, WaveMode::bending_moment, WaveMode::shear_force};
  default:
    return {WaveMode::traction,           WaveMode::flow_rate,  WaveMode::radial_displacement,
            WaveMode::axial_displacement, WaveMode::rotation,   WaveMode::axial_force,
            WaveMode::bending_moment,     WaveMode::shear_force};
  }
}

/// A quantity of a wave at a joint. Where the radius steps, the ring between both is wall: its
/// motion displaces liquid, whose pressure acts on it. So the flow through the moving section and
/// the force of wall and liquid together are what is continuous.
Complex joint_value(const WaveMode &mode,
                    const WaveMode::Junction quantity,
                    const double area,
                    const Complex &omega)
{
  const Complex value = mode.junction[quantity];
  if (quantity == WaveMode::flow_rate)
    return value - imaginary * omega * area * mode.junction[WaveMode::axial_displacement];
  if (quantity == WaveMode::axial_force)
    return value - area * mode.junction[WaveMode::traction];
  return value;
}

Complex decay(const WaveMode &mode, const double length)
{
  return std::exp(-imaginary * mode.wave_number * length);
}

/// The equations of an end, one a row: what they make of each forward wave at the end.
Matrix end_conditions(const std::vector<WaveMode> &modes,
                      const WaveMode::Junction liquid,
                      const WallEnd wall,
                      const Complex &load_impedance,
                      const double direction)
{
  const unsigned int n = modes.size();
  std::vector<WaveMode::Junction> rows = {liquid};
  for (const WaveMode::Junction quantity : zero_quantities(wall, n))
    rows.push_back(quantity);
  Matrix matrix(n, n);
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n; ++i)
    {
      const double sign = direction > 0. ? 1. : WaveMode::parity[rows[i]];
      matrix(i, j) = sign * modes[j].junction[rows[i]];
    }
  // Of a loaded end: traction - Z flow.
  if (load_impedance != 0.)
    for (unsigned int j = 0; j < n; ++j)
      matrix(0, j) =
          modes[j].junction[WaveMode::traction] -
          (direction > 0. ? 1. : -1.) * load_impedance * modes[j].junction[WaveMode::flow_rate];
  return matrix;
}

/// Backward waves at the end of the last segment over forward ones at its start.
Matrix far_end_reflection(const TubeWaveProblem &problem,
                          const std::vector<WaveMode> &modes,
                          const Complex &omega)
{
  using Outlet = TubeWaveProblem::Outlet;
  const unsigned int n = modes.size();
  const TubeSegment &segment = problem.segments.back();
  const WallEnd wall = problem.wall_outlet_end;
  // A tube that goes on for ever.
  if (problem.outlet == Outlet::absorbing && wall == WallEnd::absorbing)
    return Matrix(n, n);
  if (wall == WallEnd::absorbing)
    throw std::invalid_argument("The wall's end absorbs, but the liquid's does not.");
  Complex load = 0.;
  if (problem.outlet == Outlet::absorbing)
    load = matched_impedance(modes, wall, omega, segment.section.wall_area())(0, 0);
  else if (problem.outlet == Outlet::matched)
    load = modes[0].junction[WaveMode::traction] / modes[0].junction[WaveMode::flow_rate];
  else if (problem.outlet == Outlet::loaded)
    load = problem.load.value(imaginary * omega)(0, 0);
  const WaveMode::Junction liquid =
      problem.outlet == Outlet::closed ? WaveMode::flow_rate : WaveMode::traction;
  Matrix forward = end_conditions(modes, liquid, wall, load, 1.);
  const Matrix backward = end_conditions(modes, liquid, wall, load, -1.);
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n; ++i)
      forward(i, j) *= -decay(modes[j], segment.length);
  return solve_scaled(backward, forward);
}
} // namespace

double TubeWaveProblem::length() const
{
  double sum = 0.;
  for (const TubeSegment &segment : segments)
    sum += segment.length;
  return sum;
}

TubeWaveTheory::TubeWaveTheory(const TubeWaveProblem &problem,
                               const std::function<double(double)> &inlet,
                               const double end_time,
                               const double spectral_tolerance)
    : problem(problem), period(2. * end_time), shift(std::log(1e6) / period), n_samples(0)
{
  // Sampled ever finer until the upper half of the spectrum is below the tolerance.
  std::vector<Complex> samples;
  unsigned int last = 0;
  for (n_samples = 1 << 14;; n_samples *= 2)
  {
    samples = transform_inlet(inlet, end_time);
    double largest = 0.;
    for (unsigned int n = 0; n < n_samples / 2; ++n)
      largest = std::max(largest, std::abs(samples[n]));
    last = 16;
    for (unsigned int n = last; n < n_samples / 2; ++n)
      if (std::abs(samples[n]) > spectral_tolerance * largest)
        last = n;
    // An inlet with a jump has a spectrum that ends nowhere: it is then cut where it is.
    if (last < n_samples / 4 || n_samples >= largest_n_samples)
      break;
  }
  last = std::min(last, n_samples / 4);
  // Well above the ring frequency of its wall a tube carries no pressure wave, and the closed
  // formulas of a membrane end at it.
  const bool is_membrane =
      problem.level == WaveLevel::membrane || problem.level == WaveLevel::closed_formula;
  for (const TubeSegment &segment : problem.segments)
    if (!segment.section.layers.empty())
    {
      const double young = segment.section.membrane_modulus(Complex(0., -shift)).real();
      const double ring_frequency = std::sqrt(young / segment.section.wall_density()) /
                                    (2. * PI * segment.section.inner_radius);
      last = std::min(
          last, static_cast<unsigned int>((is_membrane ? 0.5 : 2.) * ring_frequency * period));
    }
  last = std::max(last, 16u);
  last_frequency = last / period;
  const unsigned int first_faded = static_cast<unsigned int>(0.8 * last);
  for (unsigned int n = 0; n <= last; ++n)
  {
    const double share =
        n <= first_faded ? 0. : static_cast<double>(n - first_faded) / (last + 1 - first_faded);
    spectrum.push_back(samples[n] * 0.5 * (1. + std::cos(PI * share)));
  }

  compute_sections();
}

std::vector<TubeWaveTheory::Complex>
TubeWaveTheory::transform_inlet(const std::function<double(double)> &inlet,
                                const double end_time) const
{
  // By the trapezoidal rule. What the inlet still says at the end is faded out, since its cut would
  // be a jump.
  const double sample_time = period / n_samples;
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

void TubeWaveTheory::compute_sections()
{
  const auto add = [this](const TubeSection &section)
  {
    if (problem.level == WaveLevel::exact)
      waves.push_back(std::make_unique<DispersionCurves>(section, shift, last_frequency));
    else
      waves.push_back(std::make_unique<ClosedFormWaves>(section, problem.level, shift));
  };
  const std::vector<TubeSegment> &segments = problem.segments;
  std::vector<std::size_t> firsts; // of runs of segments with the same section
  for (std::size_t s = 0; s < segments.size(); ++s)
    if (s == 0 || !(segments[s].section == segments[s - 1].section))
      firsts.push_back(s);
  sections_of.resize(segments.size());
  const unsigned int n_nodes = problem.n_computed_sections;
  if (problem.level != WaveLevel::exact || firsts.size() <= std::max(n_nodes, 4u))
  {
    for (std::size_t i = 0; i < firsts.size(); ++i)
    {
      add(segments[firsts[i]].section);
      for (std::size_t s = firsts[i]; s < (i + 1 < firsts.size() ? firsts[i + 1] : segments.size());
           ++s)
        sections_of[s] = {{i, 1.}};
    }
    return;
  }
  // Nodes along the chain, and a cubic through the four nearest ones.
  std::vector<std::size_t> nodes;
  for (unsigned int i = 0; i < std::max(n_nodes, 4u); ++i)
    nodes.push_back((segments.size() - 1) * i / (std::max(n_nodes, 4u) - 1));
  for (const std::size_t node : nodes)
    add(segments[node].section);
  for (std::size_t s = 0; s < segments.size(); ++s)
  {
    std::size_t upper = 1;
    while (upper + 1 < nodes.size() && nodes[upper] < s)
      ++upper;
    const std::size_t first = std::min(upper < 2 ? 0 : upper - 2, nodes.size() - 4);
    for (std::size_t i = first; i < first + 4; ++i)
    {
      double weight = 1.;
      for (std::size_t j = first; j < first + 4; ++j)
        if (j != i)
          weight *=
              (static_cast<double>(s) - nodes[j]) / (static_cast<double>(nodes[i]) - nodes[j]);
      sections_of[s].emplace_back(i, weight);
    }
  }
}

void TubeWaveTheory::evaluate(const double frequency,
                              std::vector<std::vector<WaveMode>> &modes) const
{
  std::vector<std::vector<WaveMode>> computed(waves.size());
  for (std::size_t i = 0; i < waves.size(); ++i)
    waves[i]->evaluate(frequency, computed[i]);
  modes.resize(problem.segments.size());
  for (std::size_t s = 0; s < modes.size(); ++s)
  {
    modes[s].resize(computed[0].size());
    for (std::size_t m = 0; m < modes[s].size(); ++m)
    {
      std::array<Complex, WaveMode::n_numbers> sum = {};
      for (const auto &[section, weight] : sections_of[s])
      {
        const auto numbers = computed[section][m].numbers();
        for (unsigned int i = 0; i < sum.size(); ++i)
          sum[i] += weight * numbers[i];
      }
      modes[s][m] = WaveMode::from_numbers(sum);
    }
  }
}

double TubeWaveTheory::wrap_round() const
{
  return std::exp(-shift * period);
}

TubeWaveTheory::Amplitudes TubeWaveTheory::amplitudes(
    const Complex inlet, const std::vector<std::vector<WaveMode>> &modes, const Complex omega) const
{
  const unsigned int n_segments = problem.segments.size(), n = modes[0].size();
  const std::vector<WaveMode::Junction> quantities = joined_quantities(waves[0]->families());
  const auto values = [&](const unsigned int segment, const unsigned int family,
                          const unsigned int row, const bool forward)
  {
    const double radius = problem.segments[segment].section.inner_radius;
    return (forward ? 1. : WaveMode::parity[quantities[row]]) *
           joint_value(modes[segment][family], quantities[row], PI * radius * radius, omega);
  };

  // From the far end: backward waves at a segment's end = reflection x forward waves at its start.
  std::vector<Matrix> reflections(n_segments, Matrix(n, n)),
      transmissions(n_segments, Matrix(n, n));
  for (unsigned int s = n_segments; s-- > 0;)
  {
    const double length = problem.segments[s].length;
    if (s + 1 == n_segments)
    {
      reflections[s] = far_end_reflection(problem, modes[s], omega);
      continue;
    }
    // Liquid and wall are continuous: unknown are the backward waves here and the forward ones
    // behind the joint.
    Matrix system(2 * n, 2 * n), right(2 * n, n);
    for (unsigned int i = 0; i < 2 * n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        system(i, j) = values(s, j, i, false);
        Complex behind = values(s + 1, j, i, true);
        for (unsigned int m = 0; m < n; ++m)
          behind += values(s + 1, m, i, false) *
                    decay(modes[s + 1][m], problem.segments[s + 1].length) *
                    reflections[s + 1](m, j);
        system(i, n + j) = -behind;
        right(i, j) = -values(s, j, i, true) * decay(modes[s][j], length);
      }
    const Matrix solution = solve_scaled(system, right);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        reflections[s](i, j) = solution(i, j);
        transmissions[s](i, j) = solution(n + i, j);
      }
  }

  // The inlet, then forwards.
  const WaveMode::Junction driven =
      problem.inlet == TubeWaveProblem::Inlet::pressure ? WaveMode::traction : WaveMode::flow_rate;
  Matrix system = end_conditions(modes[0], driven, problem.wall_inlet_end, 0., 1.);
  const Matrix backward = end_conditions(modes[0], driven, problem.wall_inlet_end, 0., -1.);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int m = 0; m < n; ++m)
        system(i, j) +=
            backward(i, m) * decay(modes[0][m], problem.segments[0].length) * reflections[0](m, j);
  Matrix right(n, 1);
  right(0, 0) = inlet;
  const Matrix start = solve_scaled(system, right);
  Amplitudes result;
  std::vector<Complex> forward(start.entries);
  for (unsigned int s = 0; s < n_segments; ++s)
  {
    std::vector<Complex> next(n, 0.), back(n, 0.);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        back[i] += reflections[s](i, j) * forward[j];
        next[i] += transmissions[s](i, j) * forward[j];
      }
    result.forward.push_back(forward);
    result.backward.push_back(back);
    forward = next;
  }
  return result;
}

std::vector<WaveHistory> TubeWaveTheory::histories(const std::vector<double> &stations,
                                                   const std::vector<double> &times) const
{
  constexpr unsigned int n_fields = 6;
  // Where the stations are.
  std::vector<unsigned int> segment_of;
  std::vector<double> place;
  for (const double station : stations)
  {
    unsigned int s = 0;
    double start = 0.;
    while (s + 1 < problem.segments.size() && station > start + problem.segments[s].length)
      start += problem.segments[s++].length;
    segment_of.push_back(s);
    place.push_back(station - start);
  }

  std::vector<std::vector<Complex>> spectra(stations.size() * n_fields,
                                            std::vector<Complex>(n_samples / 2 + 1, 0.));
  std::vector<std::vector<WaveMode>> modes;
  for (unsigned int n = 0; n < spectrum.size(); ++n)
  {
    const double frequency = n / period;
    const Complex omega(2. * PI * frequency, -shift);
    evaluate(frequency, modes);
    const Amplitudes solution = amplitudes(spectrum[n], modes, omega);
    for (unsigned int i = 0; i < stations.size(); ++i)
    {
      const unsigned int s = segment_of[i];
      Complex values[n_fields] = {};
      for (unsigned int m = 0; m < modes[s].size(); ++m)
      {
        const WaveMode &mode = modes[s][m];
        const Complex forward = solution.forward[s][m] * decay(mode, place[i]);
        const Complex backward =
            solution.backward[s][m] * decay(mode, problem.segments[s].length - place[i]);
        values[0] += mode.section_pressure * (forward + backward);
        values[1] += mode.axis_pressure * (forward + backward);
        values[2] += mode.junction[WaveMode::flow_rate] * (forward - backward);
        values[3] += 2. * mode.wall_displacement * (forward + backward);
        values[4] -= mode.wall_shear_stress * (forward - backward);
        values[5] += mode.hoop_stress * (forward + backward);
      }
      for (unsigned int f = 0; f < n_fields; ++f)
      {
        // The inverse transform divides by the number of samples.
        spectra[i * n_fields + f][n] = values[f] * static_cast<double>(n_samples) / period;
      }
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
