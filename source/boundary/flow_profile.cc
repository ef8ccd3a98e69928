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

/// The m-th positive solution of tan z = z, m > 0.
double zero_of_tangent(const unsigned int m)
{
  // Newton's iteration of sin z - z cos z, whose derivative is z sin z.
  const double far = (m + 0.5) * PI;
  double zero = far - 1. / far;
  for (unsigned int i = 0; i < 6; ++i)
    zero -= (std::sin(zero) - zero * std::cos(zero)) / (zero * std::sin(zero));
  return zero;
}
} // namespace

const Words<FlowPast> &flow_past_words()
{
  static const Words<FlowPast> words = {{"at rest", FlowPast::at_rest},
                                        {"steady", FlowPast::steady},
                                        {"periodic", FlowPast::periodic}};
  return words;
}

FlowProfile::FlowProfile(const Shape shape,
                         const Waveform &flow_rate,
                         const Section &section,
                         const FlowHistory &history,
                         const std::shared_ptr<const ProfileTable> &table)
    : shape(shape),
      flow_rate(flow_rate),
      section(section),
      table(table),
      present_time(std::numeric_limits<double>::quiet_NaN())
{
  if (shape == Shape::womersley)
    tabulate(history);
  present.resize(1 + rates.size());
}

double FlowProfile::whole_area() const
{
  return section.is_channel ? 2. * section.radius : PI * section.radius * section.radius;
}

double FlowProfile::mean_velocity(const double time) const
{
  const double origin[3] = {0., 0., 0.};
  return flow_rate(origin, time) / whole_area();
}

void FlowProfile::tabulate(const FlowHistory &history)
{
  for (unsigned int m = 1; m <= n_kept_modes + 1; ++m)
  {
    const double zero = section.is_channel ? zero_of_tangent(m) : gsl_sf_bessel_zero_Jnu(2., m);
    if (m <= n_kept_modes)
      zeros.push_back(zero);
    rates.push_back(history.kinematic_viscosity * zero * zero / (section.radius * section.radius));
  }
  row_length = history.time_step;
  // One row beyond the end, for a last step that passes it.
  n_rows = static_cast<std::size_t>(std::ceil(history.end_time / row_length)) + 2;
  const std::size_t n_modes = rates.size();
  const std::size_t n_blocks = (n_rows - 1) / rows_of_block + 1;
  first_rows = first_amplitudes(history);
  block.resize((rows_of_block + 1) * n_modes);
  for (std::size_t index = 0; index < n_blocks; ++index)
  {
    fill_block(index);
    if (index + 1 < n_blocks)
      first_rows.insert(first_rows.end(), block.end() - n_modes, block.end());
  }
}

std::vector<double> FlowProfile::first_amplitudes(const FlowHistory &history) const
{
  std::vector<double> amplitudes(rates.size(), 0.);
  if (history.past == FlowPast::at_rest)
    amplitudes.assign(rates.size(), mean_velocity(0.));
  if (history.past != FlowPast::periodic)
    return amplitudes;
  // Of a period from a_m = 0 on; what it ends with decays for all the periods before.
  const double n_parts = std::ceil(history.period / row_length * (1. - 1e-9));
  const double length = history.period / n_parts;
  for (double part = 0.; part < n_parts; ++part)
    advance(amplitudes.data(), length,
            mean_velocity((part + 1.) * length) - mean_velocity(part * length), amplitudes.data());
  for (std::size_t m = 0; m < rates.size(); ++m)
    amplitudes[m] /= -std::expm1(-rates[m] * history.period);
  return amplitudes;
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

double FlowProfile::first_shape(const double relative_radius) const
{
  switch (shape)
  {
  case Shape::flat:
    return 1.;
  case Shape::table:
    return table->shape(relative_radius * section.radius, section.radius, section.is_channel);
  default:
    return (section.is_channel ? 1.5 : 2.) * (1. - relative_radius * relative_radius);
  }
}

double FlowProfile::shape_of_mode(const double zero, const double relative_radius) const
{
  return section.is_channel ? 2. * (std::cos(zero * relative_radius) / std::cos(zero) - 1.)
                            : 4. * (::j0(zero * relative_radius) / ::j0(zero) - 1.);
}

std::vector<double> FlowProfile::shapes(const double relative_radius) const
{
  std::vector<double> result(1 + rates.size(), 0.);
  if (std::abs(relative_radius) > 1. - rim_tolerance)
    return result;
  result[0] = first_shape(relative_radius);
  if (rates.empty())
    return result;

  // sum over all modes of S_m/j_m^2, from the profile's expansion for small s.
  const double square = relative_radius * relative_radius;
  double rest = (1. - square * square) / 8. - (1. - square) * (section.is_channel ? 0.15 : 1. / 6.);
  for (std::size_t m = 0; m < zeros.size(); ++m)
  {
    const double zero_square = zeros[m] * zeros[m];
    result[1 + m] = shape_of_mode(zeros[m], relative_radius) / zero_square;
    rest -= result[1 + m] / zero_square;
  }
  const double tail_zero = std::sqrt(rates.back() / rates.front()) * zeros.front();
  result.back() = tail_zero * tail_zero * rest;
  return result;
}

std::vector<double> FlowProfile::shapes_at(const std::array<double, 3> &point) const
{
  double square = 0., across = 0.;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const double distance = point[d] - section.centre[d];
    square += distance * distance;
    across += distance * section.across[d];
  }
  return shapes((section.is_channel ? across : std::sqrt(square)) / section.radius);
}

double FlowProfile::area() const
{
  return section.fraction * whole_area();
}

const std::vector<double> &FlowProfile::amplitudes(const double time) const
{
  if (time == present_time)
    return present;
  present_time = time;
  present[0] = mean_velocity(time);
  if (rates.empty())
    return present;
  if (time == mean_over_period)
  {
    // A steady flow has the first shape alone.
    std::fill(present.begin() + 1, present.end(), 0.);
    return present;
  }
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
