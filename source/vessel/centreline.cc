#include <continua/vessel/centreline.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/quadrature_lib.h>

#include <gsl/gsl_linalg.h>
#include <gsl/gsl_vector.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Continua
{
namespace
{
/// Below this part of the squared length the points lie on a straight line.
constexpr double straight_tolerance = 1e-6;

/// The slope at the first of the places of the polynomial through all of them.
Centreline::Tensor slope_of_polynomial(const std::vector<double> &places,
                                       const std::vector<Centreline::Point> &points)
{
  // By the derivatives of Lagrange's polynomials.
  Centreline::Tensor result;
  for (std::size_t i = 1; i < places.size(); ++i)
  {
    double weight = 1. / (places[i] - places[0]);
    for (std::size_t j = 1; j < places.size(); ++j)
      if (j != i)
        weight *= (places[0] - places[j]) / (places[i] - places[j]);
    result += weight * (points[i] - points[0]);
  }
  return result;
}

Centreline::Tensor unit(const Centreline::Tensor &vector)
{
  return vector / vector.norm();
}

/// What is left of a vector across a direction of length one.
Centreline::Tensor across(const Centreline::Tensor &vector, const Centreline::Tensor &direction)
{
  return vector - (vector * direction) * direction;
}

/// The normal of the plane in which the points lie, or of that in which the line turns most; of a
/// straight line one across it, z where that is possible.
Centreline::Tensor normal_of_plane(const std::vector<Centreline::Point> &points)
{
  Centreline::Tensor sum;
  double size = 0.;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const Centreline::Tensor next = points[i] - points.front();
    size = std::max(size, next.norm_square());
    if (i + 1 < points.size())
      sum += dealii::cross_product_3d(next, points[i + 1] - points.front());
  }
  if (sum.norm() > straight_tolerance * size)
    return unit(sum);
  const Centreline::Tensor direction = unit(points.back() - points.front());
  Centreline::Tensor result;
  result[std::abs(direction[2]) < 0.9 ? 2 : 1] = 1.;
  return unit(across(result, direction));
}
} // namespace

Centreline::Centreline(const std::vector<Point> &points) : points(points)
{
  Assert(points.size() >= 2, dealii::ExcInternalError());
  knots = {0.};
  for (std::size_t i = 1; i < points.size(); ++i)
    knots.push_back(knots.back() + points[i].distance(points[i - 1]));
  // The chords first, then the lengths of the spline, until they are its parameter.
  for (unsigned int iteration = 0; iteration < 50; ++iteration)
  {
    fit();
    std::vector<double> lengths = {0.};
    double change = 0.;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      lengths.push_back(lengths.back() + length_of_interval(i));
      change = std::max(change, std::abs(lengths.back() - knots[i + 1]));
    }
    if (change < 1e-14 * lengths.back())
      break;
    knots = lengths;
  }
  fit();
  make_frames();
}

void Centreline::fit()
{
  const std::size_t n = points.size();
  slopes.assign(n, Tensor());
  if (n == 2)
  {
    slopes[0] = slopes[1] = (points[1] - points[0]) / knots[1];
    return;
  }
  const std::size_t n_outermost = std::min<std::size_t>(n, 4);
  slopes[0] = slope_of_polynomial({knots.begin(), knots.begin() + n_outermost},
                                  {points.begin(), points.begin() + n_outermost});
  slopes[n - 1] = slope_of_polynomial({knots.rbegin(), knots.rbegin() + n_outermost},
                                      {points.rbegin(), points.rbegin() + n_outermost});
  // The second derivatives from either side agree: a tridiagonal system for the inner slopes.
  const std::size_t m = n - 2;
  gsl_vector *const diagonal = gsl_vector_alloc(m), *const right_hand_side = gsl_vector_alloc(m),
                    *const solution = gsl_vector_alloc(m),
                    *const above = gsl_vector_calloc(std::max<std::size_t>(m - 1, 1)),
                    *const below = gsl_vector_calloc(std::max<std::size_t>(m - 1, 1));
  for (unsigned int c = 0; c < 3; ++c)
  {
    for (std::size_t k = 0; k < m; ++k)
    {
      const std::size_t i = k + 1;
      const double before = knots[i] - knots[i - 1], behind = knots[i + 1] - knots[i];
      gsl_vector_set(diagonal, k, 2. * (before + behind));
      double known = 3. * (behind * (points[i][c] - points[i - 1][c]) / before +
                           before * (points[i + 1][c] - points[i][c]) / behind);
      if (k == 0)
        known -= behind * slopes[0][c];
      else
        gsl_vector_set(below, k - 1, behind);
      if (k + 1 == m)
        known -= before * slopes[n - 1][c];
      else
        gsl_vector_set(above, k, before);
      gsl_vector_set(right_hand_side, k, known);
    }
    if (m == 1)
      gsl_vector_set(solution, 0, gsl_vector_get(right_hand_side, 0) / gsl_vector_get(diagonal, 0));
    else
      gsl_linalg_solve_tridiag(diagonal, above, below, right_hand_side, solution);
    for (std::size_t k = 0; k < m; ++k)
      slopes[k + 1][c] = gsl_vector_get(solution, k);
  }
  for (gsl_vector *const vector : {diagonal, right_hand_side, solution, above, below})
    gsl_vector_free(vector);
}

std::size_t Centreline::interval(const std::vector<double> &values, const double position)
{
  const auto above = std::upper_bound(values.begin() + 1, values.end() - 1, position);
  return above - values.begin() - 1;
}

Centreline::Derivatives Centreline::derivatives(const double position) const
{
  const std::size_t i = interval(knots, position);
  const double h = knots[i + 1] - knots[i], t = (position - knots[i]) / h;
  const Tensor rise = points[i + 1] - points[i], begin = h * slopes[i], end = h * slopes[i + 1];
  // point = p_i + t (b + t (c2 + t c3))
  const Tensor c2 = 3. * rise - 2. * begin - end, c3 = begin + end - 2. * rise;
  return {points[i] + t * (begin + t * (c2 + t * c3)), (begin + t * (2. * c2 + 3. * t * c3)) / h,
          (2. * c2 + 6. * t * c3) / (h * h)};
}

double Centreline::length_of_interval(const std::size_t i) const
{
  static const dealii::QGauss<1> quadrature(8);
  const double h = knots[i + 1] - knots[i];
  double sum = 0.;
  for (unsigned int q = 0; q < quadrature.size(); ++q)
    sum += quadrature.weight(q) * derivatives(knots[i] + quadrature.point(q)[0] * h).first.norm();
  return sum * h;
}

void Centreline::make_frames()
{
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    for (unsigned int k = 0; k < samples_per_interval; ++k)
      sample_positions.push_back(knots[i] + (knots[i + 1] - knots[i]) * k / samples_per_interval);
  sample_positions.push_back(knots.back());
  for (const double position : sample_positions)
  {
    sample_points.push_back(derivatives(position).point);
    const std::size_t i = arc_lengths.size();
    arc_lengths.push_back(
        i == 0 ? 0. : arc_lengths.back() + sample_points[i].distance(sample_points[i - 1]));
  }

  Tensor direction = tangent(0.);
  Tensor binormal = across(normal_of_plane(points), direction);
  // In a tight space curve the plane's normal may be the direction itself.
  if (binormal.norm() < 1e-3)
    binormal =
        across(std::abs(direction[2]) < 0.9 ? Point(0., 0., 1.) : Point(0., 1., 0.), direction);
  sample_normals = {dealii::cross_product_3d(unit(binormal), direction)};
  for (std::size_t i = 1; i < sample_positions.size(); ++i)
  {
    // Reflected in the plane between the points, then in that between the tangents.
    const Tensor step = sample_points[i] - sample_points[i - 1];
    const auto reflected = [](const Tensor &vector, const Tensor &mirror)
    { return vector - (2. * (vector * mirror) / mirror.norm_square()) * mirror; };
    const Tensor normal = reflected(sample_normals.back(), step);
    const Tensor turned = reflected(direction, step);
    direction = tangent(sample_positions[i]);
    const Tensor between = direction - turned;
    sample_normals.push_back(unit(across(reflected(normal, between), direction)));
  }
}

Centreline::Point Centreline::point(const double position) const
{
  if (position < 0.)
    return points.front() + position * tangent(0.);
  if (position > length())
    return points.back() + (position - length()) * tangent(length());
  return derivatives(position).point;
}

Centreline::Tensor Centreline::tangent(const double position) const
{
  return unit(derivatives(std::clamp(position, 0., length())).first);
}

double Centreline::curvature(const double position) const
{
  if (position < 0. || position > length())
    return 0.;
  const Derivatives at = derivatives(position);
  return dealii::cross_product_3d(at.first, at.second).norm() / std::pow(at.first.norm(), 3);
}

Centreline::Frame Centreline::frame(const double position) const
{
  const double inside = std::clamp(position, 0., length());
  const std::size_t i = interval(sample_positions, inside);
  const double h = sample_positions[i + 1] - sample_positions[i];
  const double t = (inside - sample_positions[i]) / h;
  // A frame that does not turn about the tangent T has dN/ds = -(N.dT/ds) T.
  const auto slope = [&](const std::size_t sample)
  {
    const Derivatives at = derivatives(sample_positions[sample]);
    const Tensor direction = unit(at.first);
    const Tensor turn = across(at.second, direction) / at.first.norm();
    return Tensor(-(sample_normals[sample] * turn) * direction);
  };
  const Tensor rise = sample_normals[i + 1] - sample_normals[i];
  const Tensor begin = h * slope(i), end = h * slope(i + 1);
  const Tensor c2 = 3. * rise - 2. * begin - end, c3 = begin + end - 2. * rise;
  Frame result;
  result.point = point(position);
  result.tangent = tangent(inside);
  result.normal = unit(across(sample_normals[i] + t * (begin + t * (c2 + t * c3)), result.tangent));
  result.binormal = dealii::cross_product_3d(result.tangent, result.normal);
  return result;
}

double Centreline::nearest(const Point &place) const
{
  // A sample is nearer than another by at most the way between them. So a sample to which the way
  // is too short to be the nearest is left out.
  std::size_t sample = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < sample_points.size();)
  {
    const double distance = place.distance(sample_points[i]);
    if (distance < least)
    {
      least = distance;
      sample = i;
    }
    i = std::lower_bound(arc_lengths.begin() + i + 1, arc_lengths.end(),
                         arc_lengths[i] + distance - least) -
        arc_lengths.begin();
  }
  const auto ahead = [&](const double position)
  { return (place - point(position)) * tangent(position); };
  if (sample == 0)
    if (const double distance = ahead(0.); distance <= 0.)
      return distance;
  if (sample + 1 == sample_points.size())
    if (const double distance = ahead(length()); distance >= 0.)
      return length() + distance;

  // Newton's iteration, kept between the neighbours by halving.
  double lower = sample_positions[sample == 0 ? 0 : sample - 1];
  double upper = sample_positions[std::min(sample + 1, sample_positions.size() - 1)];
  double position = sample_positions[sample];
  for (unsigned int iteration = 0; iteration < 60; ++iteration)
  {
    const Derivatives at = derivatives(position);
    const Tensor distance = place - at.point;
    const double residual = distance * at.first;
    (residual > 0. ? lower : upper) = position;
    const double derivative = distance * at.second - at.first.norm_square();
    const double newton = derivative < 0. ? -residual / derivative : upper - lower;
    // Round-off may let a step this small leave the bounds.
    if (std::abs(newton) <= 1e-15 * length())
      break;
    double next = position + newton;
    if (next <= lower || next >= upper)
      next = 0.5 * (lower + upper);
    if (next == position)
      break;
    position = next;
  }
  return position;
}
} // namespace Continua
