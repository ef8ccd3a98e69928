// Waves in a long tube over time: d'Alembert's at its ends, a chain of equal segments, a step of
// the wall against impedances, and branches.

#include "waves.h"

#include "../unit_test.h"

#include <array>
#include <functional>

namespace test_of_tube_wave_theory
{
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
/// Tubes that divide: into one that is what would have followed, into two, and a branch that goes
/// on in another one.
void branches(const LongTube &tube, const WaveHistory &whole)
{
  const std::vector<double> times = times_up_to(1.2, 2e-3);
  const auto inlet = [](const double time) { return 100. * pulse(time, LongTube::duration); };
  const auto piece = [&tube](const double length)
  {
    TubeWaveProblem problem;
    problem.segments = {{length, tube.section}};
    problem.wall_inlet_end = WallEnd::free;
    return problem;
  };
  const auto divide = [](TubeWaveProblem &problem, const std::vector<TubeWaveProblem> &into)
  {
    problem.outlet = TubeWaveProblem::Outlet::divided;
    problem.wall_outlet_end = WallEnd::free;
    problem.branches = into;
  };
  // Three pieces one behind the other, the last one closed: the station at 3 m is in the third.
  TubeWaveProblem first = piece(1.3), second = piece(1.2);
  first.wall_inlet_end = WallEnd::clamped;
  divide(second, {piece(1.5)});
  divide(first, {second});
  const WaveHistory third = TubeWaveTheory(first, inlet, 1.2, 1e-3).histories({0.5}, times, 2)[0];
  check::absolute("a branch of a branch, pressure",
                  largest_difference(whole.pressure, third.pressure), 0., 1e-6);
  check::absolute("a branch of a branch, flow",
                  largest_difference(whole.flow_rate, third.flow_rate), 0., 1e-6);

  // Into two like itself, one of them closed: a third of the pressure returns with the other sign,
  // two thirds go on, and come back from the closed end.
  TubeWaveProblem parent = piece(2.), open = piece(3.), closed = piece(1.);
  open.outlet = TubeWaveProblem::Outlet::matched;
  divide(parent, {open, closed});
  const TubeWaveTheory theory(parent, inlet, 1.2, 1e-3);
  const auto passed = [&](const double length) { return length / tube.speed; };
  const std::vector<WaveHistory> at = {theory.histories({1.}, times, 0)[0],
                                       theory.histories({0.5}, times, 1)[0],
                                       theory.histories({0.5}, times, 2)[0]};
  std::vector<std::vector<double>> pressure(3), flow(3);
  for (const double time : times)
  {
    // Waves into the junction from the parent, and from the closed branch, at that time there.
    const auto incoming = [&](const double when) { return inlet(when - passed(2.)); };
    std::function<double(double)> into_closed, back_from_closed, into_parent, into_open;
    const std::function<double(double)> from_parent = [&](const double when)
    {
      // The inlet holds its pressure, so what comes back there returns with the other sign.
      return when < 0. ? 0. : incoming(when) - into_parent(when - passed(4.));
    };
    back_from_closed = [&](const double when)
    { return when < 0. ? 0. : into_closed(when - passed(2.)); };
    into_closed = [&](const double when)
    { return when < 0. ? 0. : 2. / 3. * from_parent(when) - 1. / 3. * back_from_closed(when); };
    into_parent = [&](const double when)
    { return when < 0. ? 0. : -1. / 3. * from_parent(when) + 2. / 3. * back_from_closed(when); };
    into_open = [&](const double when)
    { return when < 0. ? 0. : 2. / 3. * from_parent(when) + 2. / 3. * back_from_closed(when); };
    const double forward = inlet(time - passed(1.)) - into_parent(time - passed(3.)),
                 backward = into_parent(time - passed(1.));
    pressure[0].push_back(forward + backward);
    flow[0].push_back((forward - backward) / tube.impedance());
    pressure[1].push_back(into_open(time - passed(0.5)));
    flow[1].push_back(into_open(time - passed(0.5)) / tube.impedance());
    const double on = into_closed(time - passed(0.5)), back = into_closed(time - passed(1.5));
    pressure[2].push_back(on + back);
    flow[2].push_back((on - back) / tube.impedance());
  }
  for (unsigned int b = 0; b < 3; ++b)
  {
    const std::string name =
        std::array<const char *, 3>{{"parent", "open branch", "closed branch"}}[b];
    check::absolute(name + ", pressure", largest_difference(pressure[b], at[b].pressure), 0., 0.01);
    check::absolute(name + ", flow", largest_difference(flow[b], at[b].flow_rate), 0., 0.01);
  }
  // What goes in comes out: at the junction, at all times.
  const std::vector<double> few = {0.3, 0.5, 0.7, 0.9, 1.1};
  const std::vector<double> in = theory.histories({2.}, few, 0)[0].flow_rate,
                            one = theory.histories({0.}, few, 1)[0].flow_rate,
                            other = theory.histories({0.}, few, 2)[0].flow_rate;
  for (unsigned int i = 0; i < few.size(); ++i)
    check::absolute("balance of the flow, " + std::to_string(i), in[i] - one[i] - other[i], 0.,
                    1e-10 / tube.impedance());

  // Walls four times as stiff have twice the impedance: two of them take all.
  for (TubeWaveProblem *const daughter : {&open, &closed})
  {
    daughter->segments[0].length = 4.;
    daughter->outlet = TubeWaveProblem::Outlet::matched;
    daughter->segments[0].section.layers[0].compression = Compression();
    daughter->segments[0].section.layers[0].shear.branches[0].shear_modulus *= 4.;
  }
  divide(parent, {open, closed});
  const WaveHistory unreflected =
      TubeWaveTheory(parent, inlet, 1.2, 1e-3).histories({1.}, times)[0];
  std::vector<double> alone;
  for (const double time : times)
    alone.push_back(inlet(time - passed(1.)));
  check::absolute("no reflection where admittances are equal",
                  largest_difference(alone, unreflected.pressure), 0., 0.01);
}

/// What the time grows with: three waves of a tethered tube, whose frequencies lie first a third of
/// the shift over 2 pi apart and from ten times that on a tenth of themselves; and one solve of
/// each segment for each line of the spectrum.
void work(const LongTube &tube)
{
  constexpr double end_time = 1.2, tolerance = 1e-3;
  const auto inlet = [](const double time) { return 100. * pulse(time, LongTube::duration); };
  TubeWaveProblem problem;
  problem.segments = {{1.3, tube.section}, {2.7, tube.section}};
  problem.outlet = TubeWaveProblem::Outlet::matched;
  const double last = TubeWaveTheory(problem, inlet, end_time, tolerance).highest_frequency(),
               finest = std::log(1e6) / (2. * end_time) / (2. * pi) / 3.;
  const double n_frequencies = 11. + std::log(last / (10. * finest)) / std::log(1.1);
  const TubeWaveTheory::Work one = TubeWaveTheory::work(problem, inlet, end_time, tolerance);
  check::absolute("work: roots of one section", one.n_roots, 3. * n_frequencies, 6.);
  check::relative("work: solves", one.n_segment_solves, 2. * last * 2. * end_time, 0.01);
  // A branch of another wall adds its own.
  TubeWaveProblem branch = problem;
  branch.segments.resize(1);
  branch.segments[0].section.layers[0].compression = Compression();
  branch.segments[0].section.layers[0].shear.branches[0].shear_modulus *= 4.;
  problem.outlet = TubeWaveProblem::Outlet::divided;
  problem.branches = {branch};
  const TubeWaveTheory::Work both = TubeWaveTheory::work(problem, inlet, end_time, tolerance);
  check::absolute("work: roots of two sections", both.n_roots, 6. * n_frequencies, 12.);
  check::relative("work: solves with a branch", both.n_segment_solves, 3. * last * 2. * end_time,
                  0.01);
}
} // namespace

UNIT_TEST(tube_wave_theory)
{
  const LongTube tube;
  const WaveHistory whole = ends(tube);
  joints(tube, whole);
  branches(tube, whole);
  windkessel(tube);
  work(tube);
}
} // namespace test_of_tube_wave_theory
