// What clamped ends of the wall do in tube A: an axial wave of 4 to 6 % ahead of the pulse, which
// is not there with free ends, and an earlier reflection.

#include "waves.h"

#include "../unit_test.h"

using namespace waves;

UNIT_TEST(tube_a_ends)
{
  TubeSection section = tube(12.5e-3, 0.1e-3, 880., 1.72e6, 0.49, 998., 1e-3);
  section.fluid.inverse_bulk_modulus = 1. / 2.2e9;
  const std::vector<double> times = times_up_to(0.4, 0.1e-3);
  double ahead[2], reflected[2];
  for (const bool is_free : {false, true})
  {
    TubeWaveProblem problem;
    problem.segments = {{0.446, section}};
    if (is_free)
      problem.wall_inlet_end = problem.wall_outlet_end = WallEnd::free;
    const std::vector<WaveHistory> histories =
        TubeWaveTheory(
            problem, [](const double time) { return 1000. * pulse(time, 0.05); }, 0.4, 1e-4)
            .histories({0.223, 0.3568}, times);
    // The pulse is at z = 357 mm from 140 ms on, and comes back to z = 223 mm after 200 ms.
    ahead[is_free] = 0.;
    std::vector<double> returned = histories[0].pressure;
    for (std::size_t i = 0; i < times.size(); ++i)
    {
      if (times[i] < 0.1)
        ahead[is_free] = std::max(ahead[is_free], std::abs(histories[1].pressure[i]));
      if (times[i] < 0.2 || times[i] > 0.3)
        returned[i] = 0.;
    }
    reflected[is_free] = peak(times, returned).first;
  }
  check::absolute("clamped ends, ahead of the pulse of 1000 Pa", ahead[false], 50., 10.);
  check::absolute("free ends, ahead of the pulse of 1000 Pa", ahead[true], 0., 5.);
  // 2/(beta c), 1/beta = sqrt(R h)/(3 (1 - nu^2))^(1/4), is 0.73 ms; the axial waves of the two
  // differ besides.
  check::absolute("earlier reflection of clamped ends [ms]",
                  (reflected[true] - reflected[false]) * 1e3, 0.73, 0.5);
}
