#include <continua/case/theory/nonlinear_wave_case.h>

#include <continua/base/six_digits.h>
#include <continua/case/theory/loaded_tube_case.h>
#include <continua/network/tube_wall.h>
#include <continua/signal/energy_frequency.h>
#include <continua/vessel/tube_law.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace Continua
{
namespace
{
constexpr unsigned int n_samples_of_load = 4096;
/// Of the cells in the wave of the frequency below which 90 % of the energy of the load lies.
constexpr double cells_in_a_wave = 300.;
/// Of a tube.
constexpr double fewest_cells = 50., most_cells = 3000.;
constexpr double most_given_cells = 1e5; ///< of a tube

/// The problem of linear theory with the sections that the tube has without load.
template <int dim>
TubeWaveProblem problem_without_load(const Case<dim> &input, const TubeWaveCase &wave_case)
{
  TubeWaveProblem problem = wave_case.problem;
  if (!is_about_loaded_state(input))
    return problem;
  const std::vector<VesselBranch<dim>> branches = input.geometry->branches();
  for (std::size_t b = 0; b < branches.size(); ++b)
  {
    std::vector<TubeSegment> &segments =
        b == 0 ? problem.segments : problem.branches[b - 1].segments;
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
      const std::size_t place = wave_case.from_outlet ? segments.size() - 1 - i : i;
      segments[i].section = tube_section_of_mesh(
          input, branches[b].law, (static_cast<double>(place) + 0.5) * segments[i].length);
    }
  }
  return problem;
}

/// [m], of the tube or a branch.
double longest_of(const TubeWaveProblem &problem)
{
  double longest = problem.length();
  for (const TubeWaveProblem &branch : problem.branches)
    longest = std::max(longest, longest_of(branch));
  return longest;
}

/// The slowest long wave [m/s], about the mean pressure if there is one, and the length of the
/// longest tube [m].
std::pair<double, double> slowest_and_longest(const TubeWaveProblem &problem)
{
  double slowest = std::numeric_limits<double>::infinity();
  for (const TubeSegment &segment : problem.segments)
    slowest = std::min(
        slowest,
        std::sqrt(TubeWall(segment.section, WallTheory::thick).density_times_speed_squared() /
                  segment.section.fluid.density));
  double longest = problem.length();
  for (const TubeWaveProblem &branch : problem.branches)
  {
    const auto [of_branch, length] = slowest_and_longest(branch);
    slowest = std::min(slowest, of_branch);
    longest = std::max(longest, length);
  }
  return {slowest, longest};
}
} // namespace

template <int dim>
std::unique_ptr<NonlinearTubeWaves> make_nonlinear_waves(const Case<dim> &input,
                                                         const TubeWaveCase &wave_case)
{
  const TubeWaveProblem problem = problem_without_load(input, wave_case);
  NonlinearTubeWaves::Settings settings;
  if (is_about_loaded_state(input))
    settings.mean_pressure = input.wave_theory.mean_pressure;
  settings.cell_length = input.wave_theory.nonlinear_cell_length;
  if (settings.cell_length == 0.)
  {
    const double end = input.time.end_time;
    const double frequency = energy_frequency(
        samples_of_whole_pulse(wave_case.inlet, end, n_samples_of_load), end / n_samples_of_load);
    const auto [speed, length] = slowest_and_longest(wave_case.problem);
    settings.cell_length =
        length / std::clamp(cells_in_a_wave * frequency * length / speed, fewest_cells, most_cells);
  }
  return std::make_unique<NonlinearTubeWaves>(problem, wave_case.inlet, settings);
}

template <int dim>
void check_nonlinear_waves(const Case<dim> &input, ParameterSection root)
{
  if (!input.wave_theory.nonlinear)
    return;
  ParameterSection section = root.subsection("Wave theory");
  TubeWaveCase wave_case;
  const std::string why_not = make_tube_wave_case(input, wave_case);
  if (!why_not.empty())
    section.refuse("Nonlinear", "nonlinear wave theory does not cover this case: " + why_not,
                   "Set Nonlinear = false");
  const double cell_length = input.wave_theory.nonlinear_cell_length;
  if (cell_length > 0. && longest_of(wave_case.problem) > most_given_cells * cell_length)
    section.refuse("Nonlinear cell length",
                   "a tube of " + six_digits(longest_of(wave_case.problem)) +
                       " m has more than 100000 cells of this length",
                   "Give longer cells, or 0 for a length by the load");
  try
  {
    make_nonlinear_waves(input, wave_case);
  }
  catch (const std::domain_error &error)
  {
    section.refuse("Nonlinear",
                   std::string("nonlinear wave theory does not cover this case: the tube ") +
                       error.what(),
                   "Set Nonlinear = false");
  }
}

template std::unique_ptr<NonlinearTubeWaves> make_nonlinear_waves(const Case<2> &,
                                                                  const TubeWaveCase &);
template std::unique_ptr<NonlinearTubeWaves> make_nonlinear_waves(const Case<3> &,
                                                                  const TubeWaveCase &);
template void check_nonlinear_waves(const Case<2> &, ParameterSection);
template void check_nonlinear_waves(const Case<3> &, ParameterSection);
} // namespace Continua
