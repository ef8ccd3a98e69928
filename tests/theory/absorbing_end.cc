// Ends that let waves leave, against a tube that goes on.

#include "waves.h"

using namespace waves;

/// Behind an end that absorbs, nothing is different from a tube that goes on: as long as nothing
/// has come back from the end of that one.
int main()
{
  const TubeSection free = tube(12.5e-3, 0.1e-3, 880., 1.72e6, 0.49, 998., 1e-3);
  TubeSection held = free;
  held.tethered = true;
  const auto inlet = [](const double time) { return 1000. * pulse(time, 0.05); };
  const std::vector<double> times = times_up_to(0.3, 1e-3);
  for (const auto &[name, section, wall, tolerance] :
       {std::make_tuple("wall and liquid absorb", free, WallEnd::absorbing, 2e-3),
        std::make_tuple("held wall, clamped end", held, WallEnd::clamped, 2e-3),
        std::make_tuple("held wall, free end", held, WallEnd::free, 2e-3),
        // The axial wave that a clamped end sends back, of 4 to 6 % of the pulse (tube_a_ends.cc).
        std::make_tuple("clamped end", free, WallEnd::clamped, 0.1)})
  {
    TubeWaveProblem problem, longer;
    problem.segments = {{0.446, section}};
    problem.outlet = TubeWaveProblem::Outlet::absorbing;
    problem.wall_outlet_end = wall;
    // The wave of the wall is back from 8 m after 0.36 s.
    longer.segments = {{8., section}};
    const WaveHistory absorbed =
        TubeWaveTheory(problem, inlet, 0.3, 1e-3).histories({0.3}, times)[0];
    const WaveHistory goes_on = TubeWaveTheory(longer, inlet, 0.3, 1e-3).histories({0.3}, times)[0];
    check::absolute(std::string(name) + ", pressure",
                    largest_difference(goes_on.pressure, absorbed.pressure), 0., tolerance);
    check::absolute(std::string(name) + ", flow",
                    largest_difference(goes_on.flow_rate, absorbed.flow_rate), 0., tolerance);
    if (tolerance > 0.01)
      check::is_true(std::string(name) + " is not quite absorbing",
                     largest_difference(goes_on.pressure, absorbed.pressure) > 0.01);
  }
  TubeWaveProblem half;
  half.segments = {{0.446, free}};
  half.wall_outlet_end = WallEnd::absorbing;
  check::throws<std::invalid_argument>(
      "wall absorbs, liquid does not",
      [&]() { TubeWaveTheory(half, inlet, 0.3, 1e-3).histories({0.3}, times); },
      "the liquid's does not");
}
