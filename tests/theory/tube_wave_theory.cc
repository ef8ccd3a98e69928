// Waves in a long tube over time: d'Alembert's at its ends, a chain of equal segments, and a step
// of the wall against impedances.

#include "waves.h"

#include "../unit_test.h"

using namespace waves;

namespace
{
/// A long thin tethered tube with next to no viscosity, whose waves are d'Alembert's: Korteweg's
/// speed with Lame's psi.
struct LongTube
{
  static constexpr double length = 4., duration = 0.4, thickness = 1e-4, young = 8e6;
  TubeSection section = tube(0.01, thickness, 1., young, 0.5, 1000., 1e-6);
  double speed = std::sqrt(young * thickness / (2. * 0.01 * 1000. * psi(thickness)));
  LongTube() { section.tethered = true; }
  static double psi(const double h) { return h / 0.01 * 1.5 + 0.02 / (0.02 + h) * 0.75; }
  double impedance() const { return 1000. * speed / (pi * 1e-4); }
};

WaveHistory ends(const LongTube &tube)
{
  const double transit = tube.length / tube.speed, z = 3.;
  const std::vector<double> times = times_up_to(1.2, 2e-3);
  const auto inlet = [](const double time) { return 100. * pulse(time, LongTube::duration); };
  WaveHistory closed;
  for (const auto &[name, outlet, factor] :
       {std::make_tuple("closed", TubeWaveProblem::Outlet::closed, 1.),
        std::make_tuple("open", TubeWaveProblem::Outlet::open, -1.)})
  {
    TubeWaveProblem problem;
    problem.segments = {{tube.length, tube.section}};
    problem.outlet = outlet;
    const WaveHistory history = TubeWaveTheory(problem, inlet, 1.2, 1e-3).histories({z}, times)[0];
    if (factor > 0.)
      closed = history;
    std::vector<double> pressure, flow;
    for (const double time : times)
    {
      // Up to the first return from the inlet.
      const double forward = inlet(time - z / tube.speed),
                   backward = factor * inlet(time - (2. * transit - z / tube.speed));
      pressure.push_back(forward + backward);
      flow.push_back((forward - backward) / tube.impedance());
    }
    check::absolute(std::string(name) + " end, pressure",
                    largest_difference(pressure, history.pressure), 0., 0.01);
    check::absolute(std::string(name) + " end, flow", largest_difference(flow, history.flow_rate),
                    0., 0.01);
  }
  // A flow rate at the inlet makes Z Q.
  TubeWaveProblem problem;
  problem.segments = {{tube.length, tube.section}};
  problem.outlet = TubeWaveProblem::Outlet::matched;
  problem.inlet = TubeWaveProblem::Inlet::flow_rate;
  const WaveHistory history =
      TubeWaveTheory(
          problem, [](const double time) { return 1e-6 * pulse(time, LongTube::duration); }, 1.2,
          1e-3)
          .histories({1.}, times)[0];
  check::relative("flow inlet, flow", peak(times, history.flow_rate).second, 1e-6, 5e-3);
  check::relative("flow inlet, pressure", peak(times, history.pressure).second,
                  1e-6 * tube.impedance(), 5e-3);
  check::relative(
      "flow inlet, distension", peak(times, history.wall_distension).second,
      // 2 R (p R/(Y h)) psi
      2. * 0.01 * peak(times, history.pressure).second * 0.01 / 800. * LongTube::psi(1e-4), 5e-3);
  check::relative("flow inlet, hoop stress", peak(times, history.hoop_stress).second,
                  peak(times, history.pressure).second * 100., 2e-2);
  check::relative("time of travel", peak(times, history.pressure).first, 0.2 + 1. / tube.speed,
                  5e-3);
  return closed;
}

void joints(const LongTube &tube, const WaveHistory &whole)
{
  const std::vector<double> times = times_up_to(1.2, 2e-3);
  const auto inlet = [](const double time) { return 100. * pulse(time, LongTube::duration); };
  TubeWaveProblem chain, step;
  chain.segments = {{1.3, tube.section}, {2.7, tube.section}};
  const WaveHistory pieces = TubeWaveTheory(chain, inlet, 1.2, 1e-3).histories({3.}, times)[0];
  check::absolute("a chain of equal segments", largest_difference(whole.pressure, pieces.pressure),
                  0., 1e-9);
  check::absolute("a chain of equal segments, shear stress",
                  largest_difference(whole.wall_shear_stress, pieces.wall_shear_stress), 0., 1e-9);

  // A wall four times as stiff: twice the speed and impedance, so a third of the pressure returns
  // and four thirds go on; p Q of both is that of the incoming wave.
  step.segments = {{2., tube.section}, {6., tube.section}};
  step.segments[1].section.layers[0].compression = Compression();
  step.segments[1].section.layers[0].shear.branches[0].shear_modulus *= 4.;
  step.outlet = TubeWaveProblem::Outlet::matched;
  const auto check_step = [&](const std::string &name)
  {
    const std::vector<WaveHistory> histories =
        TubeWaveTheory(step, inlet, 1.2, 1e-3).histories({1., 4.}, times);
    const auto [time, transmitted] = peak(times, histories[1].pressure);
    const double flow = peak(times, histories[1].flow_rate).second;
    std::vector<double> p = histories[0].pressure, q = histories[0].flow_rate;
    double reflected = 0., incoming = 0.;
    for (std::size_t i = 0; i < times.size(); ++i)
    {
      reflected = std::max(reflected, 0.5 * (p[i] - tube.impedance() * q[i]));
      incoming = std::max(incoming, 0.5 * (p[i] + tube.impedance() * q[i]));
    }
    check::absolute(name + ", transmitted", transmitted / incoming, 4. / 3., 0.01);
    check::absolute(name + ", reflected", reflected / incoming, 1. / 3., 0.01);
    check::absolute(name + ", power",
                    (transmitted * flow + reflected * reflected / tube.impedance()) /
                        (incoming * incoming / tube.impedance()),
                    1., 0.01);
    check::absolute(name + ", time", time, 0.2 + 2. / tube.speed + 1. / tube.speed, 5e-3);
  };
  check_step("step of the wall's modulus");
}

/// A windkessel whose proximal resistance is the tube's impedance Z sends back
/// R_d/(R_d + 2 Z (1 + s tau)) of the pulse, tau = R_d C: a first-order response, here stepped
/// along.
void windkessel(const LongTube &tube)
{
  const double z = 3., distal = 3. * tube.impedance(), time_constant = 0.2;
  const std::vector<double> times = times_up_to(1.2, 1e-3);
  const auto inlet = [](const double time) { return 100. * pulse(time, LongTube::duration); };
  TubeWaveProblem problem;
  problem.segments = {{tube.length, tube.section}};
  problem.outlet = TubeWaveProblem::Outlet::loaded;
  problem.load = Impedance::windkessel(tube.impedance(), distal, time_constant / distal);
  const WaveHistory history = TubeWaveTheory(problem, inlet, 1.2, 1e-3).histories({z}, times)[0];
  const double gain = distal / (2. * tube.impedance() * time_constant),
               rate = gain + 1. / time_constant;
  std::vector<double> pressure;
  double reflected = 0.;
  for (const double time : times)
  {
    const double arrived = time - (2. * tube.length - z) / tube.speed;
    pressure.push_back(inlet(time - z / tube.speed) + reflected);
    // Exact for a pulse that is constant over the step, taken in its middle.
    const double decay = std::exp(-rate * 1e-3);
    reflected = decay * reflected + gain / rate * (1. - decay) * inlet(arrived + 0.5e-3);
  }
  check::absolute("windkessel", largest_difference(pressure, history.pressure), 0., 0.01);
}
} // namespace

UNIT_TEST(tube_wave_theory)
{
  const LongTube tube;
  joints(tube, ends(tube));
  windkessel(tube);
}
