#include <continua/base/interpolant.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
/// The slope at the point between two intervals of lengths h0, h1 and slopes d0, d1: zero at an
/// extremum, else their weighted harmonic mean, which keeps the interpolant monotone (Fritsch and
/// Butland 1984).
double inner_slope(const double h0, const double d0, const double h1, const double d1)
{
  if (d0 * d1 <= 0.)
    return 0.;
  const double w0 = h0 + 2. * h1;
  const double w1 = 2. * h0 + h1;
  return (w0 + w1) / (w0 / d0 + w1 / d1);
}

/// The slope at an end, next to the interval (h0, d0): of the parabola through three points,
/// limited to keep the interpolant monotone.
double end_slope(const double h0, const double d0, const double h1, const double d1)
{
  const double slope = ((2. * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0.)
    return 0.;
  return std::abs(slope) > 3. * std::abs(d0) ? 3. * d0 : slope;
}

std::vector<double> monotone_slopes(const std::vector<double> &points,
                                    const std::vector<double> &values,
                                    const bool periodic)
{
  const std::size_t n_intervals = points.size() - 1;
  std::vector<double> lengths(n_intervals), secants(n_intervals);
  for (std::size_t i = 0; i < n_intervals; ++i)
  {
    lengths[i] = points[i + 1] - points[i];
    secants[i] = (values[i + 1] - values[i]) / lengths[i];
  }
  std::vector<double> slopes(points.size(), secants[0]);
  if (n_intervals == 1)
    return slopes;

  for (std::size_t i = 1; i < n_intervals; ++i)
    slopes[i] = inner_slope(lengths[i - 1], secants[i - 1], lengths[i], secants[i]);
  const std::size_t last = n_intervals - 1;
  if (periodic)
    slopes.front() = slopes.back() =
        inner_slope(lengths[last], secants[last], lengths[0], secants[0]);
  else
  {
    slopes.front() = end_slope(lengths[0], secants[0], lengths[1], secants[1]);
    slopes.back() = end_slope(lengths[last], secants[last], lengths[last - 1], secants[last - 1]);
  }
  return slopes;
}
} // namespace

Interpolant::Interpolant(const std::vector<double> &points,
                         const std::vector<double> &values,
                         const Kind kind,
                         const bool periodic)
    : points(points), values(values)
{
  Assert(points.size() > 1 && points.size() == values.size() &&
             std::is_sorted(points.begin(), points.end()),
         dealii::ExcInternalError());
  if (kind == Kind::cubic)
    slopes = monotone_slopes(points, values, periodic);
}

double Interpolant::operator()(const double x) const
{
  if (x <= points.front())
    return values.front();
  if (x >= points.back())
    return values.back();

  const std::size_t i = std::upper_bound(points.begin(), points.end(), x) - points.begin() - 1;
  const double length = points[i + 1] - points[i];
  const double s = (x - points[i]) / length;
  if (slopes.empty())
    return (1. - s) * values[i] + s * values[i + 1];
  // Hermite's cubic, as the chord and a bubble that brings in the slopes.
  const double chord = values[i + 1] - values[i];
  const double start = slopes[i] * length - chord;
  const double end = chord - slopes[i + 1] * length;
  return values[i] + s * chord + s * (1. - s) * (start * (1. - s) + end * s);
}
} // namespace Continua
