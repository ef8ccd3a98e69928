#include <continua/theory/dispersion_curves.h>

#include <continua/base/input_error.h>
#include <continua/theory/constants.h>

#include <deal.II/base/numbers.h>

#include <gsl/gsl_spline.h>

#include <array>
#include <cmath>
#include <sstream>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
using Complex = std::complex<double>;
/// Points of a curve that are also taken at negative frequencies.
constexpr unsigned int n_mirrored = 6;
/// Points in what the decay of the transform lets pass. A wall that is supported along its axis has
/// an axial wave that does not travel below a frequency, and its curve turns sharply beside that of
/// the pressure wave.
constexpr double n_in_decay = 3., n_in_decay_supported = 24.;
/// By how much a root may differ from what is foreseen, relative.
constexpr double largest_surprise = 0.1, largest_surprise_supported = 0.01;

bool is_supported_along(const TubeSection &section)
{
  return section.axial_stiffness > 0. || section.axial_damping > 0.;
}

/// The same wave at -f.
WaveMode mirrored(const WaveMode &mode)
{
  std::array<Complex, WaveMode::n_numbers> numbers = mode.numbers();
  for (Complex &number : numbers)
    number = std::conj(number);
  numbers[0] = -numbers[0];
  return WaveMode::from_numbers(numbers);
}
} // namespace

struct DispersionCurves::Splines
{
  std::vector<gsl_spline *> parts; ///< real and imaginary parts in turn

  Splines(const std::vector<double> &frequencies, const std::vector<WaveMode> &modes)
  {
    const unsigned int n = frequencies.size();
    std::vector<double> values(n);
    for (unsigned int i = 0; i < WaveMode::n_numbers; ++i)
      for (const bool real : {true, false})
      {
        for (unsigned int j = 0; j < n; ++j)
        {
          const Complex number = modes[j].numbers()[i];
          values[j] = real ? number.real() : number.imag();
        }
        parts.push_back(gsl_spline_alloc(gsl_interp_cspline, n));
        gsl_spline_init(parts.back(), frequencies.data(), values.data(), n);
      }
  }
  Splines(const Splines &) = delete;
  ~Splines()
  {
    for (gsl_spline *part : parts)
      gsl_spline_free(part);
  }
};

DispersionCurves::DispersionCurves(const TubeSection &section,
                                   const double shift,
                                   const double highest_frequency)
    : DispersionCurves(section, shift, frequencies_of(section, shift, highest_frequency))
{
}

DispersionCurves::DispersionCurves(const TubeSection &section,
                                   const double shift,
                                   const std::vector<double> &frequencies)
    : dispersion(section), frequencies(frequencies), is_supported(is_supported_along(section))
{
  build(shift);
}

std::vector<double> DispersionCurves::frequencies_of(const TubeSection &section,
                                                     const double shift,
                                                     const double highest_frequency)
{
  // Fine where the decay of the transform sets the scale, then a fixed part of the frequency.
  const double finest =
      shift / (2. * PI) / (is_supported_along(section) ? n_in_decay_supported : n_in_decay);
  std::vector<double> frequencies;
  for (double frequency = 0.; frequency < highest_frequency;
       frequency += std::max(finest, 0.1 * frequency))
    frequencies.push_back(frequency);
  while (frequencies.size() <= n_mirrored)
    frequencies.push_back(frequencies.empty() ? 0. : frequencies.back() + finest);
  if (frequencies.back() < highest_frequency)
    frequencies.push_back(highest_frequency);
  return frequencies;
}

void DispersionCurves::build(const double shift)
{
  std::vector<std::vector<WaveMode>> curves;
  for (const ExactDispersion::Family family : families())
    curves.push_back(follow(family, shift, curves));
  // What is real in time is conjugate at -f, which continues the curves beyond their start; the two
  // bending waves change places.
  const bool from_zero = frequencies.front() == 0. && frequencies.size() > n_mirrored;
  std::vector<double> all_frequencies;
  for (unsigned int j = from_zero ? n_mirrored : 0; j > 0; --j)
    all_frequencies.push_back(-frequencies[j]);
  all_frequencies.insert(all_frequencies.end(), frequencies.begin(), frequencies.end());
  for (unsigned int i = 0; i < curves.size(); ++i)
  {
    const ExactDispersion::Family family = families()[i];
    const std::vector<WaveMode> &partner =
        curves[family == ExactDispersion::bending_wave         ? i + 1
               : family == ExactDispersion::other_bending_wave ? i - 1
                                                               : i];
    std::vector<WaveMode> modes;
    for (unsigned int j = from_zero ? n_mirrored : 0; j > 0; --j)
      modes.push_back(mirrored(partner[j]));
    modes.insert(modes.end(), curves[i].begin(), curves[i].end());
    splines.push_back(std::make_unique<Splines>(all_frequencies, modes));
  }
}

DispersionCurves::~DispersionCurves() = default;

std::vector<WaveMode>
DispersionCurves::follow(const ExactDispersion::Family family,
                         const double shift,
                         const std::vector<std::vector<WaveMode>> &others) const
{
  // The last points of the curve, from which the next one is foreseen.
  std::vector<double> known_frequencies;
  std::vector<Complex> known;
  const auto foreseen = [&](const double frequency)
  {
    if (known.empty())
      return dispersion.guess(family, Complex(2. * PI * frequency, -shift));
    const unsigned int n = std::min<unsigned int>(3, known.size()), first = known.size() - n;
    Complex sum = 0.;
    for (unsigned int i = first; i < known.size(); ++i)
    {
      double factor = 1.;
      for (unsigned int j = first; j < known.size(); ++j)
        if (j != i)
          factor *=
              (frequency - known_frequencies[j]) / (known_frequencies[i] - known_frequencies[j]);
      sum += factor * known[i];
    }
    return sum;
  };

  std::vector<WaveMode> curve;
  for (unsigned int target = 0; target < frequencies.size(); ++target)
  {
    unsigned int n_halvings = 0;
    double step = target == 0 ? 0. : frequencies[target] - frequencies[target - 1];
    for (;;)
    {
      const double last = known.empty() ? 0. : known_frequencies.back();
      const double frequency =
          target == 0 ? frequencies[0] : std::min(frequencies[target], last + step * (1. + 1e-12));
      const Complex omega(2. * PI * frequency, -shift), start = foreseen(frequency);
      Complex root;
      // The first guess is that of a thin wall.
      const double tolerance = known.empty()  ? 0.6
                               : is_supported ? largest_surprise_supported
                                              : largest_surprise;
      bool found = dispersion.find_root(omega, start, root) &&
                   std::abs(root - start) < tolerance * std::abs(root) && root.imag() < 0.;
      // Another family's root is not this one's.
      if (frequency == frequencies[target])
        for (const std::vector<WaveMode> &other : others)
          found = found && std::abs(root - other[target].wave_number) > 1e-7 * std::abs(root);
      if (!found)
      {
        if (target == 0 || ++n_halvings > 12)
        {
          std::ostringstream text;
          text << "wave theory: the "
               << (family == ExactDispersion::pressure_wave ? "pressure wave"
                   : family == ExactDispersion::axial_wave  ? "axial wave"
                                                            : "bending wave")
               << (known.empty() ? " could not be found at " : " could not be followed beyond ")
               << (known.empty() ? frequency : last) << " Hz";
          throw RunError(text.str());
        }
        step *= 0.5;
        continue;
      }
      known_frequencies.push_back(frequency);
      known.push_back(root);
      if (frequency == frequencies[target])
        break;
    }
    curve.push_back(
        dispersion.mode(family, Complex(2. * PI * frequencies[target], -shift), known.back()));
  }
  return curve;
}

void DispersionCurves::evaluate(const double frequency, std::vector<WaveMode> &modes) const
{
  modes.resize(splines.size());
  std::array<Complex, WaveMode::n_numbers> numbers;
  for (unsigned int i = 0; i < splines.size(); ++i)
  {
    for (unsigned int j = 0; j < WaveMode::n_numbers; ++j)
      numbers[j] = Complex(gsl_spline_eval(splines[i]->parts[2 * j], frequency, nullptr),
                           gsl_spline_eval(splines[i]->parts[2 * j + 1], frequency, nullptr));
    modes[i] = WaveMode::from_numbers(numbers);
  }
}
} // namespace Continua
