#include <continua/mesh/bifurcation_shape.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace Continua
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/// The length over which a corner between two tubes is rounded, along each of their walls, over the
/// mean of the radii.
constexpr double rounding = 1.;
/// How long the derivative at a half-surface is at most, over the inner radius.
constexpr double longest_arrival = 8.;

/// A number with its derivatives by y and z.
struct Number
{
  double value, by_y, by_z;
};

Number operator+(const Number &a, const Number &b)
{
  return {a.value + b.value, a.by_y + b.by_y, a.by_z + b.by_z};
}

Number operator*(const double factor, const Number &a)
{
  return {factor * a.value, factor * a.by_y, factor * a.by_z};
}

Number operator-(const Number &a, const Number &b)
{
  return a + -1. * b;
}

Number operator*(const Number &a, const Number &b)
{
  return {a.value * b.value, a.by_y * b.value + a.value * b.by_y,
          a.by_z * b.value + a.value * b.by_z};
}

/// The function with that value and that derivative at `a`.
Number function(const Number &a, const double value, const double derivative)
{
  return {value, derivative * a.by_y, derivative * a.by_z};
}

Number square_root(const Number &a)
{
  const double root = std::sqrt(a.value);
  return function(a, root, 0.5 / root);
}

Number inverse(const Number &a)
{
  return function(a, 1. / a.value, -1. / (a.value * a.value));
}

Number constant(const double value)
{
  return {value, 0., 0.};
}

Tensor<1, 3> direction(const double angle)
{
  return Point<3>(std::cos(angle), std::sin(angle), 0.);
}

Tensor<1, 3> turned(const Tensor<1, 3> &vector)
{
  return Point<3>(-vector[1], vector[0], 0.);
}
} // namespace

BifurcationShape::BifurcationShape(const Point<3> &centre, const std::array<Tube, 3> &tubes)
    : centre(centre)
{
  for (unsigned int i = 0; i < 3; ++i)
  {
    Branch &branch = branches[i];
    branch.axis = direction(tubes[i].direction);
    branch.normal = turned(branch.axis);
    branch.inner_radius = tubes[i].inner_radius;
    branch.wall_thickness = tubes[i].wall_thickness;
    branch.reach = 0.;
  }
  for (unsigned int i = 0; i < 3; ++i)
    set_half_surface(i, (i + 1) % 3);
  for (Branch &branch : branches)
  {
    // The axis arrives in the middle between the two half-surfaces, so that cells on its two sides
    // have the same angle.
    const auto angle = [](const Half &half) { return std::atan2(half.sine, half.cosine); };
    const double middle = 0.5 * (angle(branch.halves[0]) + angle(branch.halves[1]));
    for (Half &half : branch.halves)
    {
      half.normal_part = std::sin(middle);
      half.tangent_part = -std::cos(middle);
    }
  }
  // As high as makes the sum of the squares of the tubes' slopes up to there least.
  height = height_growth = 0.;
  double sum = 0.;
  for (const Branch &branch : branches)
  {
    const double weight = 1. / (branch.reach * branch.reach);
    height += weight * branch.inner_radius;
    height_growth += weight * branch.wall_thickness;
    sum += weight;
  }
  height /= sum;
  height_growth /= sum;

  constexpr unsigned int n_along = 4, n_around = 8;
  for (Branch &branch : branches)
    for (unsigned int half = 0; half < 2; ++half)
      for (unsigned int i = 0; i <= n_along; ++i)
        for (const double radius : {0.3, 0.8, 1.5})
          for (unsigned int j = 0; j < n_around; ++j)
          {
            const double turn = dealii::numbers::PI * ((j + 0.5) / n_around - 0.5);
            Sample sample;
            sample.half = half;
            sample.t = static_cast<double>(i) / n_along;
            sample.y = radius * std::cos(turn);
            sample.z = radius * std::sin(turn);
            const Half &side = branch.halves[half];
            sample.point =
                local_point(branch, side, sample.t, sample.y, sample.z, radius > 1.).value;
            sample.point[1] *= side.sign;
            branch.samples.push_back(sample);
          }
}

void BifurcationShape::set_half_surface(const unsigned int right, const unsigned int left)
{
  Branch &a = branches[right], &b = branches[left];
  const double angle = std::acos(std::clamp(a.axis * b.axis, -1., 1.));
  Assert(dealii::cross_product_3d(a.axis, b.axis)[2] > 0., dealii::ExcInternalError());
  const double tangent = std::tan(0.5 * angle);
  const double mean_radius = 0.5 * (a.inner_radius + b.inner_radius);
  const double mean_thickness = 0.5 * (a.wall_thickness + b.wall_thickness);
  // The outer surfaces are rounded by an arc of that radius, the inner ones by an arc about the
  // same point.
  const double outer_rounding = rounding * mean_radius * tangent;
  const double inner_rounding = outer_rounding + mean_thickness;
  // That far is the arc's centre from the two axes.
  const double from_a = a.inner_radius + inner_rounding;
  const double from_b = b.inner_radius + inner_rounding;
  // Along the axis of `a`, from the centre.
  const double along_a = (from_b + from_a * std::cos(angle)) / std::sin(angle);
  const double along_b = (from_a + from_b * std::cos(angle)) / std::sin(angle);
  const double distance = std::hypot(along_a, from_a);
  const double length = distance - inner_rounding;
  a.halves[0] = {1., along_a / distance, from_a / distance, length, mean_thickness, 0., 0.};
  b.halves[1] = {-1., along_b / distance, from_b / distance, length, mean_thickness, 0., 0.};
  a.reach = std::max({a.reach, along_a, a.inner_radius});
  b.reach = std::max({b.reach, along_b, b.inner_radius});
}

BifurcationShape::LocalPoint BifurcationShape::local_point(const Branch &branch,
                                                           const Half &half,
                                                           const double t,
                                                           const double y,
                                                           const double z,
                                                           const bool in_wall) const
{
  const Number place_y{y, 1., 0.}, place_z{z, 0., 1.};
  const Number one_over_radius =
      in_wall ? inverse(square_root(place_y * place_y + place_z * place_z)) : constant(1.);
  // What is `inner` on the wall's inner surface and grows to the outer one, over the place.
  const auto scale = [&](const double inner, const double growth)
  { return in_wall ? constant(growth) + (inner - growth) * one_over_radius : constant(inner); };
  const Number radius = scale(branch.inner_radius, branch.wall_thickness);
  const Number length = scale(half.length, half.growth);
  const Number vertical = scale(height, height_growth);
  const Number cosine = place_y * one_over_radius, sine = place_z * one_over_radius;

  const std::array<Number, 3> circle = {
      {constant(branch.reach), radius * place_y, radius * place_z}};
  const Number in_plane = length * place_y;
  const std::array<Number, 3> end = {
      {half.cosine * in_plane, half.sine * in_plane, vertical * place_z}};
  Number square = constant(0.);
  for (unsigned int k = 0; k < 3; ++k)
    square = square + (end[k] - circle[k]) * (end[k] - circle[k]);
  const Number chord = square_root(square);
  // How far the direction of arrival acts: as the chord of an arc where it is short, but not all
  // along a long one.
  const double range = longest_arrival * branch.inner_radius;
  const Number ratio = 1. / (range * range) * square;
  const Number arrival_length =
      chord * inverse(square_root(square_root(constant(1.) + ratio * ratio)));

  // In the half-surface's plane along its ellipse, or, on the axis, as the axis arrives.
  const Number flank = cosine * cosine, rest = constant(1.) - flank;
  const Number across = constant(half.normal_part) + (1. - half.normal_part) * flank;
  const Number along = half.tangent_part * (rest * rest + flank * (sine * sine));
  const Number upwards = -half.tangent_part * (vertical * inverse(length)) * (cosine * sine);
  const std::array<Number, 3> arrival = {{half.cosine * along - half.sine * across,
                                          half.sine * along + half.cosine * across, upwards}};

  const double from_circle = (1. + 2. * t) * (1. - t) * (1. - t);
  const double from_end = t * t * (3. - 2. * t);
  const double slope_at_circle = t * (1. - t) * (1. - t);
  const double slope_at_end = t * t * (t - 1.);
  const double by_t_from_end = 6. * t * (1. - t);
  const double by_t_at_circle = (1. - t) * (1. - 3. * t);
  const double by_t_at_end = t * (3. * t - 2.);
  LocalPoint result;
  for (unsigned int k = 0; k < 3; ++k)
  {
    const Number at_circle = k == 0 ? -1. * chord : constant(0.);
    const Number at_end = arrival_length * arrival[k];
    const Number x = from_circle * circle[k] + from_end * end[k] + slope_at_circle * at_circle +
                     slope_at_end * at_end;
    result.value[k] = x.value;
    result.derivatives[0][k] = by_t_from_end * (end[k].value - circle[k].value) +
                               by_t_at_circle * at_circle.value + by_t_at_end * at_end.value;
    result.derivatives[1][k] = x.by_y;
    result.derivatives[2][k] = x.by_z;
  }
  return result;
}

Point<3> BifurcationShape::point(const unsigned int tube, const Point<3> &place) const
{
  const Branch &branch = branches[tube];
  const double distance = std::hypot(place[1], place[2]);
  Tensor<1, 3> local;
  if (place[0] >= branch.reach)
  {
    const double factor =
        distance <= 1. ? branch.inner_radius
                       : (branch.inner_radius + branch.wall_thickness * (distance - 1.)) / distance;
    local = Point<3>(place[0], factor * place[1], factor * place[2]);
  }
  else
  {
    const Half &half = branch.halves[place[1] >= 0. ? 0 : 1];
    local = local_point(branch, half, 1. - place[0] / branch.reach, std::abs(place[1]), place[2],
                        distance > 1.)
                .value;
    local[1] *= half.sign;
  }
  Point<3> result = centre + local[0] * branch.axis + local[1] * branch.normal;
  result[2] += local[2];
  return result;
}

Tensor<2, 3> BifurcationShape::derivative(const unsigned int tube, const Point<3> &place) const
{
  const Branch &branch = branches[tube];
  const Half &half = branch.halves[place[1] >= 0. ? 0 : 1];
  const double distance = std::hypot(place[1], place[2]);
  std::array<Tensor<1, 3>, 3> columns;
  if (place[0] >= branch.reach)
  {
    columns[0][0] = 1.;
    if (distance <= 1.)
      columns[1][1] = columns[2][2] = branch.inner_radius;
    else
    {
      const double more = branch.inner_radius - branch.wall_thickness;
      const double y = place[1] / distance, z = place[2] / distance;
      columns[1] =
          Point<3>(0., branch.wall_thickness + more / distance * z * z, -more / distance * y * z);
      columns[2] =
          Point<3>(0., -more / distance * y * z, branch.wall_thickness + more / distance * y * y);
    }
  }
  else
  {
    columns = local_point(branch, half, 1. - place[0] / branch.reach, std::abs(place[1]), place[2],
                          distance > 1.)
                  .derivatives;
    columns[0] *= -1. / branch.reach;
    columns[1] *= half.sign;
    for (Tensor<1, 3> &column : columns)
      column[1] *= half.sign;
  }
  Tensor<2, 3> result;
  for (unsigned int i = 0; i < 3; ++i)
  {
    Tensor<1, 3> column = columns[i][0] * branch.axis + columns[i][1] * branch.normal;
    column[2] += columns[i][2];
    for (unsigned int k = 0; k < 3; ++k)
      result[k][i] = column[k];
  }
  return result;
}

bool BifurcationShape::find_place(const Branch &branch,
                                  const Tensor<1, 3> &target,
                                  Sample &sample) const
{
  // Steps of the scaled coordinates: longer ones leave the range where the derivative is good, no
  // place differs by less than the last ones.
  constexpr double longest_step = 0.3, shortest_step = 1e-15, small_step = 1e-9;
  double last = std::numeric_limits<double>::infinity();
  for (unsigned int iteration = 0; iteration < 60; ++iteration)
  {
    const Half &half = branch.halves[sample.half];
    const LocalPoint local = local_point(branch, half, sample.t, sample.y, sample.z,
                                         std::hypot(sample.y, sample.z) > 1.);
    Tensor<1, 3> residual = target;
    residual[1] *= half.sign;
    residual -= local.value;
    Tensor<2, 3> matrix;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int k = 0; k < 3; ++k)
        matrix[k][i] = local.derivatives[i][k];
    if (std::abs(dealii::determinant(matrix)) < std::numeric_limits<double>::min())
      return false;
    Tensor<1, 3> step = dealii::invert(matrix) * residual;
    const double size = std::max({std::abs(step[0]), std::abs(step[1]), std::abs(step[2])});
    if (!(size < std::numeric_limits<double>::infinity()))
      return false;
    if (size > longest_step)
      step *= longest_step / size;
    sample.t += step[0];
    sample.y += step[1];
    sample.z += step[2];
    if (sample.y < 0.)
    {
      sample.half = 1 - sample.half;
      sample.y = -sample.y;
    }
    if (size <= shortest_step || (size <= small_step && size >= last))
      // The curves go on beyond their ends, and there they may come back; some way beyond are the
      // vertices of a mesh that is distorted.
      return -0.1 < sample.t && sample.t < 1.5 && std::hypot(sample.y, sample.z) < 3.;
    last = size;
  }
  return false;
}

Point<3> BifurcationShape::place(const unsigned int tube, const Point<3> &point) const
{
  const Branch &branch = branches[tube];
  const Tensor<1, 3> distance = point - centre;
  const Point<3> local(distance * branch.axis, distance * branch.normal, distance[2]);
  if (local[0] >= branch.reach)
  {
    const double radius = std::hypot(local[1], local[2]);
    const double factor =
        radius <= branch.inner_radius
            ? 1. / branch.inner_radius
            : (1. + (radius - branch.inner_radius) / branch.wall_thickness) / radius;
    return {local[0], factor * local[1], factor * local[2]};
  }
  const auto distance_of = [&local](const Sample &sample)
  { return (sample.point - local).norm_square(); };
  const Sample *nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Sample &candidate : branch.samples)
    if (distance_of(candidate) < least)
    {
      nearest = &candidate;
      least = distance_of(candidate);
    }
  Sample sample = *nearest;
  if (!find_place(branch, local, sample))
  {
    // The nearest sample may lie on the other side of a corner.
    std::vector<Sample> samples = branch.samples;
    std::sort(samples.begin(), samples.end(),
              [&](const Sample &a, const Sample &b) { return distance_of(a) < distance_of(b); });
    const bool found = std::any_of(samples.begin(), samples.end(),
                                   [&](const Sample &start)
                                   {
                                     sample = start;
                                     return find_place(branch, local, sample);
                                   });
    if (!found)
      throw std::runtime_error("a point is not in its branch of the bifurcation");
  }
  // The plane of symmetry is hit exactly.
  return {branch.reach * (1. - sample.t), branch.halves[sample.half].sign * sample.y,
          local[2] == 0. ? 0. : sample.z};
}

double BifurcationShape::least_scaled_determinant() const
{
  constexpr unsigned int n_along = 16, n_around = 12;
  double least = std::numeric_limits<double>::infinity();
  for (const Branch &branch : branches)
    for (const Half &half : branch.halves)
      for (unsigned int i = 0; i <= n_along; ++i)
        for (unsigned int j = 0; j <= n_around; ++j)
          for (const auto &[radius, in_wall] :
               {std::make_pair(0., false), std::make_pair(0.25, false), std::make_pair(0.5, false),
                std::make_pair(0.75, false), std::make_pair(1., false), std::make_pair(1., true),
                std::make_pair(1.5, true), std::make_pair(2., true)})
          {
            const double turn = 0.5 * dealii::numbers::PI * j / n_around;
            std::array<Tensor<1, 3>, 3> d =
                local_point(branch, half, static_cast<double>(i) / n_along, radius * std::cos(turn),
                            radius * std::sin(turn), in_wall)
                    .derivatives;
            // In the wall the directions that matter are along the radius and around.
            const Tensor<1, 3> outwards = std::cos(turn) * d[1] + std::sin(turn) * d[2];
            const Tensor<1, 3> around = std::cos(turn) * d[2] - std::sin(turn) * d[1];
            const double volume = -d[0] * dealii::cross_product_3d(outwards, around);
            const double lengths = d[0].norm() * outwards.norm() * around.norm();
            least = std::min(least, lengths > 0. ? volume / lengths : 0.);
          }
  return least;
}
} // namespace Continua
