// Ends that let waves leave, against a tube that goes on.

#include "waves.h"

#include "../unit_test.h"

namespace test_of_absorbing_end
{
using namespace waves;

/// Behind an end that absorbs, nothing is different from a tube that goes on: as long as nothing
/// has come back from the end of that one.
UNIT_TEST(absorbing_end)
{
  const TubeSection free = tube(12.5e-3, 0.1e-3, 880., 1.72e6, 0.49, 998., 1e-3);
  TubeSection held = free;
  held.tethered = true;
  // As long as 50 ms of a sine squared, with a spectrum that ends: what costs is the frequencies.
  const auto inlet = [](const double time)
  { return 1000. * std::exp(-std::pow((time - 0.05) / 0.014, 2)); };
  const std::vector<double> times = times_up_to(0.3, 1e-3);
  const auto history = [&](const TubeWaveProblem &problem)
  { return TubeWaveTheory(problem, inlet, 0.3, 1e-3).histories({0.3}, times)[0]; };
  for (const TubeSection &section : {free, held})
  {
    // The wave of the wall is back from 8 m after 0.36 s.
    TubeWaveProblem longer;
    longer.segments = {{8., section}};
    const WaveHistory goes_on = history(longer);
    const auto compare = [&](const std::string &name, const WallEnd wall, const double tolerance)
    {
      TubeWaveProblem problem;
      problem.segments = {{0.446, section}};
      problem.outlet = TubeWaveProblem::Outlet::absorbing;
      problem.wall_outlet_end = wall;
      const WaveHistory absorbed = history(problem);
      const double difference = largest_difference(goes_on.pressure, absorbed.pressure);
      check::absolute(name + ", pressure", difference, 0., tolerance);
      check::absolute(name + ", flow", largest_difference(goes_on.flow_rate, absorbed.flow_rate),
                      0., tolerance);
      if (tolerance > 0.01)
        check::is_true(name + " is not quite absorbing", difference > 0.01);
    };
    if (section.tethered)
    {
      compare("held wall, clamped end", WallEnd::clamped, 2e-3);
      compare("held wall, free end", WallEnd::free, 2e-3);
    }
    else
    {
      compare("wall and liquid absorb", WallEnd::absorbing, 2e-3);
      // The axial wave that a clamped end sends back, of 4 to 6 % of the pulse (tube_a_ends.cc).
      compare("clamped end", WallEnd::clamped, 0.1);
    }
  }
  TubeWaveProblem half;
  half.segments = {{0.446, free}};
  half.wall_outlet_end = WallEnd::absorbing;
  check::throws<std::invalid_argument>(
      "wall absorbs, liquid does not", [&]() { history(half); }, "the liquid's does not");
}
} // namespace test_of_absorbing_end
