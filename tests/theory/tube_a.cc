// The pressure pulse in tube A with clamped ends: the published row of first peaks, which finite
// elements confirm; the axial wave ahead of it; the window of the transform.

#include "waves.h"

#include "../unit_test.h"

namespace test_of_tube_a
{
using namespace waves;

namespace
{
const auto thousand_pascal = [](const double time) { return 1000. * pulse(time, 0.05); };

void tube_a()
{
  TubeSection section = tube(12.5e-3, 0.1e-3, 880., 1.72e6, 0.49, 998., 1e-3);
  section.fluid.compression = Compression::elastic(1. / 2.2e9);
  TubeWaveProblem problem;
  problem.segments = {{0.446, section}};
  const TubeWaveTheory theory(problem, thousand_pascal, 0.25, 1e-4);
  const std::vector<double> times = times_up_to(0.19, 0.1e-3);
  std::vector<double> stations;
  for (unsigned int k = 1; k <= 8; ++k)
    stations.push_back(0.0446 * k);
  const std::vector<WaveHistory> histories = theory.histories(stations, times);
  const double peak_times[] = {42.40, 59.60, 77.55, 95.43, 113.22, 130.93, 148.58, 166.17};
  const double pressures[] = {1002., 1012., 1010., 1001., 989., 975., 960., 945.};
  for (unsigned int k = 0; k < 8; ++k)
  {
    const auto [time, value] = peak(times, histories[k].pressure);
    check::absolute("tube A, peak time " + std::to_string(k + 1), time * 1e3, peak_times[k], 0.1);
    check::relative("tube A, peak " + std::to_string(k + 1), value, pressures[k], 1e-3);
  }
  // Nothing is there before the wave but the axial wave's 4 to 6 %, ahead of the pulse.
  const double ahead = histories[7].pressure[600]; // 60 ms at z = 357 mm
  check::is_true("tube A, the axial wave ahead", std::abs(ahead) > 20. && std::abs(ahead) < 80.);

  // A window twice as long.
  const TubeWaveTheory longer(problem, thousand_pascal, 0.5, 1e-4);
  check::absolute("window",
                  largest_difference(longer.histories({0.2}, times)[0].pressure,
                                     theory.histories({0.2}, times)[0].pressure),
                  0., 1e-4);
}

} // namespace

UNIT_TEST(tube_a)
{
  tube_a();
}
} // namespace test_of_tube_a
