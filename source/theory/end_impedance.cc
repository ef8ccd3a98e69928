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

dealii::FullMatrix<std::complex<double>> EndImpedance::operator()(const Complex s) const
{
  if (s.real() < 0. || s.imag() == 0.)
    throw RunError("the impedance of a tube's end is known of motions that oscillate and do not "
                   "decay by themselves");
  const double frequency = std::abs(s.imag()) / (2. * dealii::numbers::PI);
  const auto [entry, is_new] = known.try_emplace({s.real(), frequency});
  if (is_new)
  {
    constexpr unsigned int n = 18;
    constexpr double ratio = 30.;
    std::vector<double> frequencies;
    for (unsigned int k = 0; k < n; ++k)
      frequencies.push_back(frequency * std::pow(ratio, k / (n - 1.) - 1.));
    frequencies.back() = frequency;
    try
    {
      entry->second = matched_impedances(section, wall, s.real(), frequencies).back();
    }
    catch (...)
    {
      known.erase(entry);
      throw;
    }
  }
  dealii::FullMatrix<Complex> result = entry->second;
  for (unsigned int i = 0; i < result.m(); ++i)
    for (unsigned int j = 0; j < result.n(); ++j)
      result(i, j) = factor * (s.imag() > 0. ? result(i, j) : std::conj(result(i, j)));
  return result;
}
} // namespace Continua
