#include <continua/theory/stream_waves.h>

#include <continua/theory/womersley.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace Continua
{
namespace
{
/// Chebyshev's intervals: so many, and so many times the root of Womersley's number, whose layer at
/// the wall they resolve.
constexpr double least_intervals = 24., intervals_of_layer = 6.;
constexpr unsigned int most_intervals = 600;
constexpr unsigned int most_secants = 50;
constexpr double accuracy_of_wave_number = 1e-11;
/// Of the speed without stream, how near to zero or to the stream's velocity a wave may be.
constexpr double nearest = 1e-9;
} // namespace

StreamWaves::StreamWaves(const Stream &stream,
                         const double radius,
                         const double density,
                         const double viscosity,
                         const double inverse_bulk_modulus)
    : stream(stream),
      radius(radius),
      density(density),
      viscosity(viscosity),
      inverse_bulk_modulus(inverse_bulk_modulus)
{
  if (!(radius > 0.) || !(density > 0.) || !(viscosity >= 0.) || !(inverse_bulk_modulus >= 0.) ||
      !(stream.mean_velocity >= 0.) || !(stream.exponent >= 2.))
    throw std::invalid_argument("a stream needs a radius and a density, no value below zero and an "
                                "exponent of 2 or more");
}

double StreamWaves::mean_inverse_square(const double speed) const
{
  if (stream.profile == StreamProfile::plug)
    return 1. / ((speed - stream.mean_velocity) * (speed - stream.mean_velocity));
  const auto integrand = [&](const double place)
  {
    const double relative = speed - stream.velocity(place * place);
    return 2. * place / (relative * relative);
  };
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, 0., 1., 15,
                                                                       1e-12);
}

Complex StreamWaves::plug_speed(const Complex distensibility,
                                const Direction direction,
                                const Wall wall) const
{
  // With the speed x relative to the stream: x^2 rho (D + 1/K) + x rho D U = 1 on a mesh that
  // stays, without the term of U on a moving wall.
  const Complex square = density * (distensibility + inverse_bulk_modulus);
  const Complex half_linear =
      wall == Wall::moving ? 0. : 0.5 * density * distensibility * stream.mean_velocity;
  const Complex root = std::sqrt(half_linear * half_linear + square);
  return stream.mean_velocity +
         (-half_linear + (direction == Direction::with_stream ? root : -root)) / square;
}

double StreamWaves::long_wave_speed(const double distensibility,
                                    const Direction direction,
                                    const Wall wall) const
{
  const double slowness_square = density * (distensibility + inverse_bulk_modulus);
  if (!(slowness_square > 0.))
    throw std::domain_error("an incompressible liquid in a rigid tube carries no wave");
  const double still = 1. / std::sqrt(slowness_square);
  const std::string too_fast = "the stream is so fast that no wave runs against it";
  if (stream.profile == StreamProfile::plug)
  {
    const double speed = plug_speed(distensibility, direction, wall).real();
    if (direction == Direction::against_stream && !(speed < 0.))
      throw std::domain_error(too_fast);
    return speed;
  }
  // No slip: the wall's velocity is zero, and both walls have one speed.
  const auto residual = [&](const double speed)
  { return mean_inverse_square(speed) - slowness_square; };
  const bool is_with = direction == Direction::with_stream;
  const double begin = is_with ? stream.largest_velocity() + nearest * still : -nearest * still;
  const double end = (is_with ? stream.largest_velocity() : 0.) + (is_with ? 2. : -2.) * still;
  if (!(residual(begin) > 0.))
    throw std::domain_error(too_fast);
  std::uintmax_t n_iterations = 200;
  const auto interval = boost::math::tools::toms748_solve(
      residual, std::min(begin, end), std::max(begin, end),
      boost::math::tools::eps_tolerance<double>(48), n_iterations);
  return 0.5 * (interval.first + interval.second);
}

StreamWaves::Collocation::Collocation(const unsigned int n_intervals)
    : diffusion(n_intervals + 1, n_intervals + 1), integral(n_intervals + 1, n_intervals + 1)
{
  const unsigned int n = n_intervals + 1;
  ComplexMatrix derivative(n, n);
  const double pi = std::acos(-1.);
  for (unsigned int i = 0; i < n; ++i)
    points.push_back(std::pow(std::cos(0.5 * pi * i / n_intervals), 2));
  points.back() = 0.;
  // L. N. Trefethen, Spectral Methods in MATLAB (2000), chapter 6, on an interval of length one.
  // The difference of two points is a product of sines, without cancellation.
  const auto weight = [n_intervals](const unsigned int i)
  { return (i == 0 || i == n_intervals ? 2. : 1.) * (i % 2 == 0 ? 1. : -1.); };
  for (unsigned int i = 0; i < n; ++i)
  {
    double sum = 0.;
    for (unsigned int j = 0; j < n; ++j)
      if (i != j)
      {
        const double difference = std::sin(0.5 * pi * (i + j) / n_intervals) *
                                  std::sin(0.5 * pi * (double(j) - double(i)) / n_intervals);
        const double entry = weight(i) / weight(j) / difference;
        derivative(i, j) = entry;
        sum += entry;
      }
    derivative(i, i) = -sum;
  }
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int l = 0; l < n; ++l)
      for (unsigned int j = 0; j < n; ++j)
        diffusion(i, j) += derivative(i, l) * points[l] * derivative(l, j);
  // The inverse of the derivative, of functions that are zero at s = 0.
  ComplexMatrix inner(n_intervals, n_intervals), right(n_intervals, n);
  for (unsigned int i = 0; i < n_intervals; ++i)
  {
    for (unsigned int j = 0; j < n_intervals; ++j)
      inner(i, j) = derivative(i, j);
    right(i, i) = 1.;
  }
  const ComplexMatrix inverse = solve_scaled(inner, right);
  for (unsigned int i = 0; i < n_intervals; ++i)
    for (unsigned int j = 0; j < n; ++j)
      integral(i, j) = inverse(i, j);
}

Complex StreamWaves::excess(const Collocation &collocation,
                            const double omega,
                            const Complex wave_number,
                            const Complex distensibility,
                            const Wall wall) const
{
  const Complex i(0., 1.);
  const unsigned int n = collocation.points.size();
  const double diffusion = 4. * viscosity / (radius * radius);
  // Of unit pressure. The radial flow 2 r v/R^2 is the integral over s of i k u - i (omega - k
  // V)/K.
  ComplexMatrix matrix(n, n), right(n, 1);
  std::vector<Complex> compression(n), compression_integral(n, 0.);
  for (unsigned int j = 0; j < n; ++j)
    compression[j] =
        i * (omega - wave_number * stream.velocity(collocation.points[j])) * inverse_bulk_modulus;
  for (unsigned int row = 0; row < n; ++row)
    for (unsigned int j = 0; j < n; ++j)
      compression_integral[row] += collocation.integral(row, j) * compression[j];
  for (unsigned int row = 1; row < n; ++row)
  {
    const double s = collocation.points[row], slope = density * stream.slope(s);
    for (unsigned int j = 0; j < n; ++j)
      matrix(row, j) = -diffusion * collocation.diffusion(row, j) +
                       slope * i * wave_number * collocation.integral(row, j);
    matrix(row, row) += i * density * (omega - wave_number * stream.velocity(s));
    right(row, 0) = i * wave_number + slope * compression_integral[row];
  }
  matrix(0, 0) = 1.;
  right(0, 0) = wall == Wall::moving ? -stream.slope(1.) * distensibility : 0.;
  const ComplexMatrix velocity = solve_scaled(matrix, right);
  Complex flow = -compression_integral[0];
  for (unsigned int j = 0; j < n; ++j)
    flow += collocation.integral(0, j) * i * wave_number * velocity(j, 0);
  return flow - i * omega * distensibility;
}

Complex StreamWaves::wave_number(const double omega,
                                 const Complex distensibility,
                                 const Direction direction,
                                 const Wall wall) const
{
  if (!(omega > 0.))
    throw std::invalid_argument("a wave needs a frequency");
  const double long_wave = long_wave_speed(distensibility.real(), direction, wall);
  if (stream.profile == StreamProfile::plug)
    return omega / plug_speed(distensibility, direction, wall);
  if (!(viscosity > 0.))
    throw std::invalid_argument("a liquid without viscosity slips along the wall");
  const Womersley still(radius, density, viscosity);
  const double intervals = least_intervals + intervals_of_layer * std::sqrt(still.number(omega));
  if (intervals > most_intervals)
    throw std::domain_error("the layer at the wall is too thin to be resolved");
  const Collocation collocation(static_cast<unsigned int>(intervals));
  const auto residual = [&](const Complex k)
  { return excess(collocation, omega, k, distensibility, wall); };
  // By secants, from the long wave that is slowed down as if the liquid were at rest.
  Complex previous = omega / long_wave * std::sqrt(1. / still.one_minus_f10(omega));
  Complex present = previous * 1.001;
  Complex residual_before = residual(previous);
  for (unsigned int iteration = 0; iteration < most_secants; ++iteration)
  {
    const Complex of_present = residual(present);
    const Complex change = of_present * (present - previous) / (of_present - residual_before);
    previous = present;
    residual_before = of_present;
    present -= change;
    if (std::abs(change) <= accuracy_of_wave_number * std::abs(present))
      return present;
  }
  throw std::domain_error("the iteration for the wave number does not converge");
}
} // namespace Continua
