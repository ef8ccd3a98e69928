#include <continua/theory/end_impedance.h>

#include <continua/base/input_error.h>
#include <continua/theory/dispersion_curves.h>
#include <continua/theory/matched_impedance.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <utility>
#include <vector>

namespace Continua
{
namespace
{
/// From a thirtieth of it, at equal ratios.
std::vector<double> frequencies_up_to(const double frequency)
{
  constexpr unsigned int n = 18;
  constexpr double ratio = 30.;
  std::vector<double> frequencies;
  for (unsigned int k = 0; k < n; ++k)
    frequencies.push_back(frequency * std::pow(ratio, k / (n - 1.) - 1.));
  frequencies.back() = frequency;
  return frequencies;
}
} // namespace

EndImpedance::EndImpedance(TubeSection section, const WallEnd wall, const double factor)
    : section(std::move(section)), wall(wall), factor(factor)
{
}

dealii::FullMatrix<std::complex<double>> EndImpedance::of_long_wave(const Complex &omega) const
{
  // Of a wave that is long beside the radius the first guesses are good.
  constexpr double longest = 0.3, largest_surprise = 0.3, smallest_difference = 1e-7;
  const ExactDispersion dispersion(section);
  std::vector<Complex> roots;
  std::vector<WaveMode> modes;
  for (const ExactDispersion::Family family : dispersion.families())
  {
    const Complex guess = dispersion.guess(family, omega);
    Complex root;
    if ((family == ExactDispersion::pressure_wave &&
         std::abs(guess) * section.inner_radius > longest) ||
        !dispersion.find_root(omega, guess, root) || root.imag() >= 0. ||
        std::abs(root - guess) > largest_surprise * std::abs(root))
      return dealii::FullMatrix<Complex>();
    for (const Complex &other : roots)
      if (std::abs(root - other) < smallest_difference * std::abs(root))
        return dealii::FullMatrix<Complex>();
    roots.push_back(root);
    modes.push_back(dispersion.mode(family, omega, root));
  }
  return matched_impedance(modes, wall, omega, section.wall_area());
}

dealii::FullMatrix<std::complex<double>> EndImpedance::followed(const Complex &omega) const
{
  const double frequency = omega.real() / (2. * dealii::numbers::PI);
  return matched_impedances(section, wall, -omega.imag(), frequencies_up_to(frequency)).back();
}

dealii::FullMatrix<std::complex<double>> EndImpedance::continued(const Complex &omega) const
{
  // On an arc about zero, on which the waves of an ideal tube turn as omega does.
  constexpr double largest_turn = 0.04;
  const ExactDispersion dispersion(section);
  const double radius = std::abs(omega), angle = std::arg(omega);
  const DispersionCurves curves(section, 0.,
                                frequencies_up_to(radius / (2. * dealii::numbers::PI)));
  std::vector<WaveMode> modes;
  curves.evaluate(radius / (2. * dealii::numbers::PI), modes);
  std::vector<Complex> roots, turned;
  for (const WaveMode &mode : modes)
    roots.push_back(mode.wave_number);
  turned = roots;
  const auto n_turns = static_cast<unsigned int>(std::ceil(angle / largest_turn));
  for (unsigned int turn = 1; turn <= n_turns; ++turn)
  {
    const Complex at = std::polar(radius, angle * turn / n_turns);
    for (std::size_t family = 0; family < roots.size(); ++family)
    {
      // By the change of the turn before; of the first turn there is none.
      const Complex guess = roots[family] * (roots[family] / turned[family]);
      turned[family] = roots[family];
      if (!dispersion.find_root(at, guess, roots[family]))
        throw RunError("a wave of the tube behind the absorbing end was lost");
    }
  }
  for (std::size_t family = 0; family < roots.size(); ++family)
    modes[family] = dispersion.mode(dispersion.families()[family], omega, roots[family]);
  return matched_impedance(modes, wall, omega, section.wall_area());
}

dealii::FullMatrix<std::complex<double>> EndImpedance::operator()(const Complex s) const
{
  constexpr double largest_angle = 160. / 180. * dealii::numbers::PI, beside_real = 1e-4;
  if (std::abs(std::arg(s)) > largest_angle || s == 0.)
    throw RunError("the impedance of a tube's end is known of motions that oscillate or grow, and "
                   "of those that decay by a damping ratio below 0.94");
  const bool is_real = s.imag() == 0.;
  const Complex above =
      is_real ? s * Complex(1., beside_real) : Complex(s.real(), std::abs(s.imag()));
  const auto [entry, is_new] = known.try_emplace({above.real(), above.imag()});
  if (is_new)
    try
    {
      const Complex omega(above.imag(), -above.real());
      if (s.real() < 0.)
        entry->second = continued(omega);
      else
        entry->second = of_long_wave(omega);
      if (entry->second.m() == 0)
        entry->second = followed(omega);
    }
    catch (...)
    {
      known.erase(entry);
      throw;
    }
  dealii::FullMatrix<Complex> result = entry->second;
  for (unsigned int i = 0; i < result.m(); ++i)
    for (unsigned int j = 0; j < result.n(); ++j)
      result(i, j) = factor * (is_real ? result(i, j).real()
                                       : (s.imag() > 0. ? result(i, j) : std::conj(result(i, j))));
  return result;
}
} // namespace Continua
