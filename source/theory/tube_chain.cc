#include <continua/theory/tube_chain.h>

#include <continua/theory/constants.h>
#include <continua/theory/dispersion_curves.h>
#include <continua/theory/matched_impedance.h>
#include <continua/theory/scaled_system.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <stdexcept>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
using Complex = std::complex<double>;
using Matrix = ComplexMatrix;

/// The quantities that join segments of these families.
std::vector<WaveMode::Junction>
joined_quantities(const std::vector<ExactDispersion::Family> &families)
{
  switch (families.size())
  {
  case 1:
    return {WaveMode::traction, WaveMode::flow_rate};
  case 3: // held axially
    return {WaveMode::traction, WaveMode::flow_rate,      WaveMode::radial_displacement,
            WaveMode::rotation, WaveMode::bending_moment, WaveMode::shear_force};
  default:
    return {WaveMode::traction,           WaveMode::flow_rate,  WaveMode::radial_displacement,
            WaveMode::axial_displacement, WaveMode::rotation,   WaveMode::axial_force,
            WaveMode::bending_moment,     WaveMode::shear_force};
  }
}

/// A quantity of a wave at a joint. Where the radius steps, the ring between both is wall: its
/// motion displaces liquid, whose pressure acts on it. So the flow through the moving section and
/// the force of wall and liquid together are what is continuous.
Complex joint_value(const WaveMode &mode,
                    const WaveMode::Junction quantity,
                    const double area,
                    const Complex &omega)
{
  const Complex value = mode.junction[quantity];
  if (quantity == WaveMode::flow_rate)
    return value - imaginary * omega * area * mode.junction[WaveMode::axial_displacement];
  if (quantity == WaveMode::axial_force)
    return value - area * mode.junction[WaveMode::traction];
  return value;
}

Complex decay(const WaveMode &mode, const double length)
{
  return std::exp(-imaginary * mode.wave_number * length);
}

/// The equations of an end, one a row: what they make of each forward wave at the end.
Matrix end_conditions(const std::vector<WaveMode> &modes,
                      const WaveMode::Junction liquid,
                      const WallEnd wall,
                      const Complex &load_impedance,
                      const double direction)
{
  const unsigned int n = modes.size();
  std::vector<WaveMode::Junction> rows = {liquid};
  for (const WaveMode::Junction quantity : zero_quantities(wall, n))
    rows.push_back(quantity);
  Matrix matrix(n, n);
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n; ++i)
    {
      const double sign = direction > 0. ? 1. : WaveMode::parity[rows[i]];
      matrix(i, j) = sign * modes[j].junction[rows[i]];
    }
  // Of a loaded end: traction - Z flow.
  if (load_impedance != 0.)
    for (unsigned int j = 0; j < n; ++j)
      matrix(0, j) =
          modes[j].junction[WaveMode::traction] -
          (direction > 0. ? 1. : -1.) * load_impedance * modes[j].junction[WaveMode::flow_rate];
  return matrix;
}

/// Backward waves at the end of the last segment over forward ones at its start.
Matrix far_end_reflection(const TubeWaveProblem &problem,
                          const std::vector<WaveMode> &modes,
                          const Complex &omega,
                          const Complex &load_of_branches)
{
  using Outlet = TubeWaveProblem::Outlet;
  const unsigned int n = modes.size();
  const TubeSegment &segment = problem.segments.back();
  const WallEnd wall = problem.wall_outlet_end;
  // A tube that goes on for ever.
  if (problem.outlet == Outlet::absorbing && wall == WallEnd::absorbing)
    return Matrix(n, n);
  if (wall == WallEnd::absorbing)
    throw std::invalid_argument("The wall's end absorbs, but the liquid's does not.");
  Complex load = 0.;
  if (problem.outlet == Outlet::absorbing)
    load = matched_impedance(modes, wall, omega, segment.section.wall_area())(0, 0);
  else if (problem.outlet == Outlet::matched)
    load = modes[0].junction[WaveMode::traction] / modes[0].junction[WaveMode::flow_rate];
  else if (problem.outlet == Outlet::loaded)
    load = problem.load.value(imaginary * omega)(0, 0);
  else if (problem.outlet == Outlet::divided)
    load = load_of_branches;
  const WaveMode::Junction liquid =
      problem.outlet == Outlet::closed ? WaveMode::flow_rate : WaveMode::traction;
  Matrix forward = end_conditions(modes, liquid, wall, load, 1.);
  const Matrix backward = end_conditions(modes, liquid, wall, load, -1.);
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n; ++i)
      forward(i, j) *= -decay(modes[j], segment.length);
  return solve_scaled(backward, forward);
}

/// Of a cubic through them.
constexpr unsigned int fewest_nodes = 4;

/// Of runs of segments with the same section.
std::vector<std::size_t> first_segments(const TubeWaveProblem &problem)
{
  const std::vector<TubeSegment> &segments = problem.segments;
  std::vector<std::size_t> firsts;
  for (std::size_t s = 0; s < segments.size(); ++s)
    if (s == 0 || !(segments[s].section == segments[s - 1].section))
      firsts.push_back(s);
  return firsts;
}

/// Whether the waves of some segments are interpolated, where there are so many sections.
bool is_interpolated(const TubeWaveProblem &problem, const std::size_t n_sections)
{
  return problem.level == WaveLevel::exact &&
         n_sections > std::max(problem.n_computed_sections, fewest_nodes);
}
} // namespace

TubeChain::TubeChain(const TubeWaveProblem &problem,
                     const double shift,
                     const double last_frequency,
                     KeptWaves *const kept)
    : problem(problem), shift(shift)
{
  compute_sections(last_frequency, kept);
}

std::vector<std::size_t> TubeChain::computed_segments(const TubeWaveProblem &problem)
{
  const std::vector<std::size_t> firsts = first_segments(problem);
  if (!is_interpolated(problem, firsts.size()))
    return firsts;
  // Nodes along the chain.
  const unsigned int n_nodes = std::max(problem.n_computed_sections, fewest_nodes);
  std::vector<std::size_t> nodes;
  for (unsigned int i = 0; i < n_nodes; ++i)
    nodes.push_back((problem.segments.size() - 1) * i / (n_nodes - 1));
  return nodes;
}

void TubeChain::compute_sections(const double last_frequency, KeptWaves *const kept)
{
  const std::vector<TubeSegment> &segments = problem.segments;
  const std::vector<std::size_t> nodes = computed_segments(problem);
  for (const std::size_t node : nodes)
    if (problem.level != WaveLevel::exact)
      waves.push_back(
          std::make_shared<ClosedFormWaves>(segments[node].section, problem.level, shift));
    else if (kept != nullptr)
      waves.push_back(kept->waves(segments[node].section, shift, last_frequency));
    else
      waves.push_back(
          std::make_shared<DispersionCurves>(segments[node].section, shift, last_frequency));
  sections_of.resize(segments.size());
  if (!is_interpolated(problem, first_segments(problem).size()))
  {
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t s = nodes[i]; s < (i + 1 < nodes.size() ? nodes[i + 1] : segments.size());
           ++s)
        sections_of[s] = {{i, 1.}};
    return;
  }
  // A cubic through the four nearest nodes.
  for (std::size_t s = 0; s < segments.size(); ++s)
  {
    std::size_t upper = 1;
    while (upper + 1 < nodes.size() && nodes[upper] < s)
      ++upper;
    const std::size_t first = std::min(upper < 2 ? 0 : upper - 2, nodes.size() - 4);
    for (std::size_t i = first; i < first + 4; ++i)
    {
      double weight = 1.;
      for (std::size_t j = first; j < first + 4; ++j)
        if (j != i)
          weight *=
              (static_cast<double>(s) - nodes[j]) / (static_cast<double>(nodes[i]) - nodes[j]);
      sections_of[s].emplace_back(i, weight);
    }
  }
}

std::vector<std::vector<WaveMode>> TubeChain::modes_at(const double frequency) const
{
  std::vector<std::vector<WaveMode>> computed(waves.size());
  for (std::size_t i = 0; i < waves.size(); ++i)
    waves[i]->evaluate(frequency, computed[i]);
  std::vector<std::vector<WaveMode>> modes(problem.segments.size());
  for (std::size_t s = 0; s < modes.size(); ++s)
  {
    modes[s].resize(computed[0].size());
    for (std::size_t m = 0; m < modes[s].size(); ++m)
    {
      std::array<Complex, WaveMode::n_numbers> sum = {};
      for (const auto &[section, weight] : sections_of[s])
      {
        const auto numbers = computed[section][m].numbers();
        for (unsigned int i = 0; i < sum.size(); ++i)
          sum[i] += weight * numbers[i];
      }
      modes[s][m] = WaveMode::from_numbers(sum);
    }
  }
  return modes;
}

TubeChain::Solution TubeChain::solve(const double frequency, const Complex &load) const
{
  const Complex omega(2. * PI * frequency, -shift);
  Solution solution;
  solution.modes = modes_at(frequency);
  const std::vector<std::vector<WaveMode>> &modes = solution.modes;
  const unsigned int n_segments = problem.segments.size(), n = modes[0].size();
  const std::vector<WaveMode::Junction> quantities = joined_quantities(waves[0]->families());
  const auto value_of = [&](const unsigned int segment, const unsigned int family,
                            const unsigned int row, const bool forward)
  {
    const double radius = problem.segments[segment].section.inner_radius;
    return (forward ? 1. : WaveMode::parity[quantities[row]]) *
           joint_value(modes[segment][family], quantities[row], PI * radius * radius, omega);
  };

  // From the far end: backward waves at a segment's end = reflection x forward waves at its start.
  std::vector<Matrix> reflections(n_segments, Matrix(n, n)),
      transmissions(n_segments, Matrix(n, n));
  for (unsigned int s = n_segments; s-- > 0;)
  {
    const double length = problem.segments[s].length;
    if (s + 1 == n_segments)
    {
      reflections[s] = far_end_reflection(problem, modes[s], omega, load);
      continue;
    }
    // Liquid and wall are continuous: unknown are the backward waves here and the forward ones
    // behind the joint.
    Matrix system(2 * n, 2 * n), right(2 * n, n);
    for (unsigned int i = 0; i < 2 * n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        system(i, j) = value_of(s, j, i, false);
        Complex behind = value_of(s + 1, j, i, true);
        for (unsigned int m = 0; m < n; ++m)
          behind += value_of(s + 1, m, i, false) *
                    decay(modes[s + 1][m], problem.segments[s + 1].length) *
                    reflections[s + 1](m, j);
        system(i, n + j) = -behind;
        right(i, j) = -value_of(s, j, i, true) * decay(modes[s][j], length);
      }
    const Matrix waves_at_joint = solve_scaled(system, right);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        reflections[s](i, j) = waves_at_joint(i, j);
        transmissions[s](i, j) = waves_at_joint(n + i, j);
      }
  }

  // The inlet, then forwards.
  const WaveMode::Junction driven =
      problem.inlet == TubeWaveProblem::Inlet::pressure ? WaveMode::traction : WaveMode::flow_rate;
  Matrix system = end_conditions(modes[0], driven, problem.wall_inlet_end, 0., 1.);
  const Matrix of_backward = end_conditions(modes[0], driven, problem.wall_inlet_end, 0., -1.);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int m = 0; m < n; ++m)
        system(i, j) += of_backward(i, m) * decay(modes[0][m], problem.segments[0].length) *
                        reflections[0](m, j);
  Matrix right(n, 1);
  right(0, 0) = 1.;
  std::vector<Complex> start(solve_scaled(system, right).entries);
  for (unsigned int s = 0; s < n_segments; ++s)
  {
    std::vector<Complex> next(n, 0.), back(n, 0.);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        back[i] += reflections[s](i, j) * start[j];
        next[i] += transmissions[s](i, j) * start[j];
      }
    solution.forward.push_back(start);
    solution.backward.push_back(back);
    start = next;
  }
  return solution;
}

void TubeChain::Values::scale(const Complex &factor)
{
  for (Complex *const value : {&pressure, &axis_pressure, &flow_rate, &wall_distension,
                               &wall_shear_stress, &hoop_stress, &traction})
    *value *= factor;
}

TubeChain::Values TubeChain::values(const Solution &solution, const double position) const
{
  unsigned int s = 0;
  double start = 0.;
  while (s + 1 < problem.segments.size() && position > start + problem.segments[s].length)
    start += problem.segments[s++].length;
  const double place = position - start;
  Values values = {};
  for (unsigned int m = 0; m < solution.modes[s].size(); ++m)
  {
    const WaveMode &mode = solution.modes[s][m];
    const Complex ahead = solution.forward[s][m] * decay(mode, place);
    const Complex back = solution.backward[s][m] * decay(mode, problem.segments[s].length - place);
    values.pressure += mode.section_pressure * (ahead + back);
    values.axis_pressure += mode.axis_pressure * (ahead + back);
    values.flow_rate += mode.junction[WaveMode::flow_rate] * (ahead - back);
    values.wall_distension += 2. * mode.wall_displacement * (ahead + back);
    values.wall_shear_stress -= mode.wall_shear_stress * (ahead - back);
    values.hoop_stress += mode.hoop_stress * (ahead + back);
    values.traction += mode.junction[WaveMode::traction] * (ahead + back);
  }
  return values;
}
} // namespace Continua
