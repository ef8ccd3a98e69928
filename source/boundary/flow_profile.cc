#include <continua/boundary/flow_profile.h>

#include <deal.II/base/numbers.h>

#include <gsl/gsl_sf_bessel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
/// With the tail the error of a profile of Womersley number 140 is below 1e-4 of the mean velocity.
constexpr unsigned int n_kept_modes = 200;
constexpr std::size_t rows_of_block = 512;
/// Closer to the rim than this, relative to the radius, is on it.
constexpr double rim_tolerance = 1e-6;
} // namespace

FlowProfile::FlowProfile(const Shape shape,
                         const Waveform &flow_rate,
                         const Disc &disc,
                         const FlowHistory &history)
    : is_flat(shape == Shape::flat),
      flow_rate(flow_rate),
      disc(disc),
      present_time(std::numeric_limits<double>::quiet_NaN())
{
  if (shape == Shape::womersley)
    tabulate(history);
  present.resize(1 + rates.size());
}

double FlowProfile::mean_velocity(const double time) const
{
  const double origin[3] = {0., 0., 0.};
  return flow_rate(origin, time) / (PI * disc.radius * disc.radius);
}

void FlowProfile::tabulate(const FlowHistory &history)
{
  for (unsigned int m = 1; m <= n_kept_modes + 1; ++m)
  {
    const double zero = gsl_sf_bessel_zero_Jnu(2., m);
    if (m <= n_kept_modes)
      zeros.push_back(zero);
    rates.push_back(history.kinematic_viscosity * zero * zero / (disc.radius * disc.radius));
  }
  row_length = history.time_step;
  // One row beyond the end, for a last step that passes it.
  n_rows = static_cast<std::size_t>(std::ceil(history.end_time / row_length)) + 2;
  const std::size_t n_modes = rates.size();
  const std::size_t n_blocks = (n_rows - 1) / rows_of_block + 1;
  first_rows.assign(n_modes, mean_velocity(0.));
  block.resize((rows_of_block + 1) * n_modes);
  for (std::size_t index = 0; index < n_blocks; ++index)
  {
    fill_block(index);
    if (index + 1 < n_blocks)
      first_rows.insert(first_rows.end(), block.end() - n_modes, block.end());
  }
}

void FlowProfile::fill_block(const std::size_t index) const
{
  const std::size_t n_modes = rates.size();
  std::copy_n(first_rows.begin() + index * n_modes, n_modes, block.begin());
  std::vector<double> decays(n_modes), fillings(n_modes);
  for (std::size_t m = 0; m < n_modes; ++m)
  {
    decays[m] = std::exp(-rates[m] * row_length);
    fillings[m] = -std::expm1(-rates[m] * row_length) / (rates[m] * row_length);
  }
  double start = mean_velocity(index * rows_of_block * row_length);
  for (std::size_t row = 0; row < rows_of_block; ++row)
  {
    const double end = mean_velocity((index * rows_of_block + row + 1) * row_length);
    const double *const from = &block[row * n_modes];
    double *const to = &block[(row + 1) * n_modes];
    for (std::size_t m = 0; m < n_modes; ++m)
      to[m] = decays[m] * from[m] + fillings[m] * (end - start);
    start = end;
  }
  present_block = index;
}

void FlowProfile::advance(const double *from,
                          const double length,
                          const double change,
                          double *to) const
{
  for (std::size_t m = 0; m < rates.size(); ++m)
  {
    const double decay = rates[m] * length;
    const double filling = decay > 0. ? -std::expm1(-decay) / decay : 1.;
    to[m] = std::exp(-decay) * from[m] + filling * change;
  }
}

std::vector<double> FlowProfile::shapes(const double relative_radius) const
{
  std::vector<double> result(1 + rates.size(), 0.);
  if (relative_radius > 1. - rim_tolerance)
    return result;
  const double square = relative_radius * relative_radius;
  result[0] = is_flat ? 1. : 2. * (1. - square);
  if (rates.empty())
    return result;

  // sum over all modes of S_m/j_m^2, from the profile's expansion for small s.
  double rest = (1. - square * square) / 8. - (1. - square) / 6.;
  for (std::size_t m = 0; m < zeros.size(); ++m)
  {
    const double zero = zeros[m];
    result[1 + m] = 4. / (zero * zero) * (::j0(zero * relative_radius) / ::j0(zero) - 1.);
    rest -= result[1 + m] / (zero * zero);
  }
  const double tail_zero = std::sqrt(rates.back() / rates.front()) * zeros.front();
  result.back() = tail_zero * tail_zero * rest;
  return result;
}

std::vector<double> FlowProfile::shapes_at(const std::array<double, 3> &point) const
{
  const double distance =
      std::hypot(point[0] - disc.centre[0], point[1] - disc.centre[1], point[2] - disc.centre[2]);
  return shapes(distance / disc.radius);
}

double FlowProfile::area() const
{
  return disc.fraction * PI * disc.radius * disc.radius;
}

const std::vector<double> &FlowProfile::amplitudes(const double time) const
{
  if (time == present_time)
    return present;
  present_time = time;
  present[0] = mean_velocity(time);
  if (rates.empty())
    return present;
  // Before the start the liquid is at rest, but what the scheme asks for just before t = 0 is meant
  // to be the value there.
  const double since_start = std::max(0., time);
  const std::size_t row = std::min(static_cast<std::size_t>(since_start / row_length), n_rows - 1);
  if (row / rows_of_block != present_block)
    fill_block(row / rows_of_block);
  const double start = row * row_length;
  advance(&block[row % rows_of_block * rates.size()], since_start - start,
          mean_velocity(since_start) - mean_velocity(start), &present[1]);
  return present;
}

bool FlowProfile::depends_on_time() const
{
  return !flow_rate.is_zero() && (!rates.empty() || flow_rate.depends_on_time());
}
} // namespace Continua
