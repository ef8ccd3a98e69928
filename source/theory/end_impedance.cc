#include <continua/theory/end_impedance.h>

#include <continua/base/input_error.h>
#include <continua/theory/matched_impedance.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <utility>
#include <vector>

namespace Continua
{
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
  constexpr unsigned int n = 18;
  constexpr double ratio = 30.;
  const double frequency = omega.real() / (2. * dealii::numbers::PI);
  std::vector<double> frequencies;
  for (unsigned int k = 0; k < n; ++k)
    frequencies.push_back(frequency * std::pow(ratio, k / (n - 1.) - 1.));
  frequencies.back() = frequency;
  return matched_impedances(section, wall, -omega.imag(), frequencies).back();
}

dealii::FullMatrix<std::complex<double>> EndImpedance::operator()(const Complex s) const
{
  if (s.real() < 0. || s.imag() == 0.)
    throw RunError("the impedance of a tube's end is known of motions that oscillate and do not "
                   "decay by themselves");
  const double frequency = std::abs(s.imag()) / (2. * dealii::numbers::PI);
  const auto [entry, is_new] = known.try_emplace({s.real(), frequency});
  if (is_new)
    try
    {
      const Complex omega(2. * dealii::numbers::PI * frequency, -s.real());
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
      result(i, j) = factor * (s.imag() > 0. ? result(i, j) : std::conj(result(i, j)));
  return result;
}
} // namespace Continua
