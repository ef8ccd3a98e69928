// Rational functions are found with their poles; of a power law the poles beside the resonance lie
// on the branch cut.

#include "../unit_test.h"

#include <continua/frequency/rational_approximation.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace test_of_rational_approximation
{
using namespace Continua;
using Complex = std::complex<double>;

namespace
{
/// s = i omega at n frequencies from 0.1 to 5 rad/s.
std::vector<Complex> axis(const unsigned int n)
{
  std::vector<Complex> points;
  for (unsigned int i = 0; i < n; ++i)
    points.emplace_back(0., 0.1 + 4.9 * i / (n - 1.));
  return points;
}

std::vector<Complex> of(const std::vector<Complex> &points, Complex (*const function)(Complex))
{
  std::vector<Complex> values;
  for (const Complex &point : points)
    values.push_back(function(point));
  return values;
}

const std::vector<Complex> poles = {{-0.05, 1.}, {-0.01, 2.5}, {-0.3, 4.}};

/// Three resonances: the sum of residue/(s - pole) and of its conjugate.
Complex first_response(const Complex s)
{
  Complex sum = 0.;
  const std::vector<Complex> residues = {{1., 0.5}, {0.2, 0.}, {0., -2.}};
  for (unsigned int k = 0; k < poles.size(); ++k)
    sum += residues[k] / (s - poles[k]) + std::conj(residues[k]) / (s - std::conj(poles[k]));
  return sum;
}

/// The same poles in another unit; the first one is hardly there.
Complex second_response(const Complex s)
{
  return 1e9 * (1e-3 / (s - poles[0]) + 1e-3 / (s - std::conj(poles[0])) + 1. / (s - poles[2]) +
                1. / (s - std::conj(poles[2])));
}

/// An oscillator on a spring of the power law (1 + s^0.3).
Complex power_law(const Complex s)
{
  return 1. / (s * s + 1. + std::pow(s, 0.3));
}

/// A filter of a complex system: its pole has no conjugate one.
Complex one_sided(const Complex s)
{
  return Complex(0., 2.) / (s - Complex(-0.1, 3.));
}

/// The pole of the power law by Newton's method.
Complex pole_of_power_law()
{
  Complex s(0., 1.4);
  for (unsigned int i = 0; i < 30; ++i)
    s -= (s * s + 1. + std::pow(s, 0.3)) / (2. * s + 0.3 * std::pow(s, -0.7));
  return s;
}

double distance(const std::vector<Complex> &found, const Complex pole)
{
  double least = 1e300;
  for (const Complex &one : found)
    least = std::min(least, std::abs(one - pole));
  return least;
}
} // namespace

UNIT_TEST(rational_approximation)
{
  const std::vector<Complex> points = axis(40);
  const RationalApproximation three(points,
                                    {of(points, first_response), of(points, second_response)});
  check::is_true("has converged", three.has_converged() && three.error() < 1e-10);
  check::is_true("six poles", three.poles().size() == 6);
  for (const Complex &pole : poles)
  {
    check::absolute("pole", distance(three.poles(), pole), 0., 1e-9);
    check::absolute("conjugate pole", distance(three.poles(), std::conj(pole)), 0., 1e-9);
  }
  for (std::size_t k = 0; k < three.poles().size(); ++k)
  {
    if (std::abs(three.poles()[k] - poles[2]) < 1e-6)
    {
      check::absolute("residue", std::abs(three.residues(0)[k] - Complex(0., -2.)), 0., 1e-8);
      check::relative("residue in another unit", three.residues(1)[k].real(), 1e9, 1e-8);
    }
    if (std::abs(three.poles()[k] - poles[1]) < 1e-6)
      check::absolute("no residue", std::abs(three.residues(1)[k]) / 1e9, 0., 1e-9);
  }
  const Complex between(0.02, 2.3);
  check::absolute("value", std::abs(three.value(0, between) - first_response(between)), 0., 1e-8);
  check::absolute("value in another unit",
                  std::abs(three.value(1, between) - second_response(between)) / 1e9, 0., 1e-9);
  check::absolute("value at a sample",
                  std::abs(three.value(0, points[3]) - first_response(points[3])), 0., 1e-9);

  // A tolerance below round-off: the poles of the noise are doublets.
  RationalOptions noise;
  noise.tolerance = 1e-18;
  noise.most_poles = 24;
  noise.doublet = 0.;
  const RationalApproximation with_doublets(points, {of(points, first_response)}, noise);
  check::is_true("poles of noise", with_doublets.poles().size() > 20);
  noise.doublet = 1e-12;
  const RationalApproximation cleaned(points, {of(points, first_response)}, noise);
  check::is_true("doublets are removed", cleaned.poles().size() == 6);
  check::is_true("and the tolerance is not met",
                 !cleaned.has_converged() && cleaned.error() < 1e-11);

  RationalOptions complex_system;
  complex_system.is_real = false;
  const RationalApproximation one(points, {of(points, one_sided)}, complex_system);
  check::is_true("one pole of a complex system", one.poles().size() == 1);
  check::absolute("its place", distance(one.poles(), {-0.1, 3.}), 0., 1e-11);

  // A power law has one resonance. All other poles are on the cut, the negative axis.
  const RationalApproximation law(points, {of(points, power_law)});
  unsigned int n_resonances = 0;
  double widest = 0.;
  for (const Complex &pole : law.poles())
    if (damping_ratio(pole) < 0.9)
      n_resonances += pole.imag() > 0.;
    else
      widest = std::max(widest, std::abs(pole.imag()) / std::abs(pole));
  check::is_true("poles of a power law", law.has_converged() && law.poles().size() > 8);
  check::is_true("one of them is a resonance", n_resonances == 1);
  check::absolute("resonance of a power law", distance(law.poles(), pole_of_power_law()), 0., 1e-7);
  check::absolute("others are on the cut", widest, 0., 1e-2);

  check::relative("damping ratio", damping_ratio({-3., 4.}), 0.6, 1e-15);
  check::throws<std::invalid_argument>(
      "equal points",
      [] {
        RationalApproximation({{0., 1.}, {0., 1.}}, {{1., 2.}});
      },
      "equal");
  check::throws<std::invalid_argument>(
      "a point without a value",
      [] {
        RationalApproximation({{0., 1.}, {0., 2.}}, {{1.}});
      },
      "each point");
  check::throws<std::invalid_argument>(
      "no number",
      [] {
        RationalApproximation({{0., 1.}, {0., 2.}}, {{1., std::nan("")}});
      },
      "each point");
}
} // namespace test_of_rational_approximation
