// Waves that were computed before are the same, and are not computed again for another load.

#include <continua/theory/kept_waves.h>

#include "waves.h"

#include "../unit_test.h"

namespace test_of_kept_waves
{
using namespace waves;

UNIT_TEST(kept_waves)
{
  TubeWaveProblem problem;
  problem.segments = {{2., tube(0.01, 1e-3, 1100., 1e6, 0.49, 1000., 1e-3)}};
  problem.segments.front().section.tethered = true;
  const auto inlet = [](const double time) { return 100. * pulse(time, 0.3); };
  const auto other_inlet = [](const double time) { return 70. * pulse(time, 0.3); };
  const std::vector<double> times = times_up_to(1., 0.02);
  KeptWaves kept;
  const auto pressure = [&](const TubeWaveProblem &of, const std::function<double(double)> &load,
                            KeptWaves *const waves)
  { return TubeWaveTheory(of, load, 1., 1e-2, waves).histories({1.2}, times)[0].pressure; };
  const std::vector<double> without = pressure(problem, inlet, nullptr);
  check::absolute("the same as without",
                  largest_difference(pressure(problem, inlet, &kept), without), 0., 0.);
  check::is_true("computed once", kept.n_computed() == 1);
  std::vector<double> of_other = pressure(problem, other_inlet, &kept);
  for (double &value : of_other)
    value *= 100. / 70.;
  check::absolute("another load", largest_difference(of_other, without), 0., 1e-9);
  TubeWaveProblem open = problem;
  open.outlet = TubeWaveProblem::Outlet::open;
  pressure(open, inlet, &kept);
  check::is_true("another load and another end need no others", kept.n_computed() == 1);
  TubeWaveProblem softer = problem;
  softer.segments.front().section = tube(0.01, 1e-3, 1100., 0.9e6, 0.49, 1000., 1e-3);
  softer.segments.front().section.tethered = true;
  check::is_true("another wall",
                 largest_difference(pressure(softer, inlet, &kept), without) > 0.01);
  check::is_true("needs others", kept.n_computed() == 2);
  const TubeSection &section = problem.segments.front().section;
  kept.waves(section, 20., 5.);
  kept.waves(section, 20., 4.);
  check::is_true("up to a lower frequency", kept.n_computed() == 3);
  kept.waves(section, 20., 6.);
  kept.waves(section, 30., 5.);
  check::is_true("beyond, and with another shift", kept.n_computed() == 5);
}
} // namespace test_of_kept_waves
