#include <continua/theory/uniaxial_spectrum.h>

#include <deal.II/base/exceptions.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace Continua
{
namespace
{
using Line = UniaxialSpectrum::Line;

/**
 * The zero of a + sum b_j/(r_j - x) that lies above the rate number `left`, as its distance from
 * that rate: between two rates, or with a > 0 above the last. The sum is multiplied by what makes
 * it finite at the ends of the bracket.
 */
double distance_of_zero(const double a, const std::vector<Line> &lines, const std::size_t left)
{
  const double from = lines[left].rate;
  const bool is_last = left + 1 == lines.size();
  double total = 0.;
  for (const Line &line : lines)
    total += line.weight;
  // Above the last rate all terms but a are negative; at this distance their sum is above -a.
  const double width = is_last ? 2. * total / a : lines[left + 1].rate - from;
  const auto function = [&](const double distance)
  {
    const double right_factor = is_last ? 1. : width - distance;
    double value = a * distance * right_factor;
    for (std::size_t j = 0; j < lines.size(); ++j)
      if (j == left)
        value -= lines[j].weight * right_factor;
      else if (j == left + 1)
        value += lines[j].weight * distance;
      else
        value += lines[j].weight * distance * right_factor / ((lines[j].rate - from) - distance);
    return value;
  };
  std::uintmax_t n_iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      function, 0., width, function(0.), function(width),
      boost::math::tools::eps_tolerance<double>(std::numeric_limits<double>::digits - 2),
      n_iterations);
  return 0.5 * (bracket.first + bracket.second);
}
} // namespace

UniaxialSpectrum::UniaxialSpectrum(const double constant) : a(constant) {}

void UniaxialSpectrum::add(const double weight, const double rate)
{
  if (weight == 0.)
    return;
  const auto place = std::lower_bound(
      sum.begin(), sum.end(), rate, [](const Line &line, const double r) { return line.rate < r; });
  if (place != sum.end() && place->rate == rate)
    place->weight += weight;
  else
    sum.insert(place, {weight, rate});
}

void UniaxialSpectrum::add(const double factor, const UniaxialSpectrum &other)
{
  a += factor * other.a;
  for (const Line &line : other.sum)
    add(factor * line.weight, line.rate);
}

UniaxialSpectrum UniaxialSpectrum::inverse() const
{
  AssertThrow(a > 0. || !sum.empty(), dealii::ExcMessage("The spectrum is 0."));
  double total = 0.;
  for (const Line &line : sum)
    total += line.weight;
  UniaxialSpectrum result(a > 0. ? 0. : 1. / total);
  if (sum.empty() || sum.front().rate > 0.)
    result.add(1. / (*this)(0.).real(), 0.);
  for (std::size_t left = 0; left < sum.size(); ++left)
  {
    if (left + 1 == sum.size() && a == 0.)
      break;
    const double distance = distance_of_zero(a, sum, left);
    // The residue of 1/(s f) at s = -x is 1/(-x f'(-x)).
    double slope = 0.;
    for (const Line &line : sum)
    {
      const double difference = (line.rate - sum[left].rate) - distance;
      slope += line.weight / (difference * difference);
    }
    const double rate = sum[left].rate + distance;
    result.add(1. / (rate * slope), rate);
  }
  return result;
}

std::complex<double> UniaxialSpectrum::operator()(const std::complex<double> &s) const
{
  std::complex<double> value = a;
  for (const Line &line : sum)
    value += line.weight / (s + line.rate);
  return value;
}

double UniaxialSpectrum::decay(const double time) const
{
  double value = 0.;
  for (const Line &line : sum)
    value += line.weight * std::exp(-line.rate * time);
  return value;
}

double UniaxialSpectrum::integral(const double time) const
{
  if (time < 0.)
    return 0.;
  double value = a;
  for (const Line &line : sum)
    value += line.rate == 0. ? line.weight * time
                             : -line.weight * std::expm1(-line.rate * time) / line.rate;
  return value;
}
} // namespace Continua
