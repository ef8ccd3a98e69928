// Synthetic waves of known speed, attenuation and reflection: d'Alembert with damping between an
// inlet that absorbs and a closed or open end, with and without the forerunner of a clamped wall.

#include "../unit_test.h"

#include <continua/signal/wave_analysis.h>

#include <functional>
#include <stdexcept>

namespace test_of_wave_analysis
{
using namespace Continua;

namespace
{
constexpr double speed = 2.5, damping = 0.15, tube_length = 0.446, impedance = 5e6;
constexpr double pulse_length = 0.05;

double sine_squared(const double t)
{
  return t <= 0. || t >= pulse_length ? 0. : 1e3 * std::pow(std::sin(M_PI * t / pulse_length), 2);
}
double gaussian(const double t)
{
  return 1e3 * std::exp(-std::pow((t - 0.03) / 0.01, 2));
}

double long_pulse(const double t)
{
  return t <= 0. || t >= 0.6 ? 0. : 1e3 * std::pow(std::sin(M_PI * t / 0.6), 2);
}

struct Case
{
  std::function<double(double)> inlet = sine_squared;
  double reflection = 1.;
  double forerunner = 0.; ///< part of the inlet pressure that a wall wave carries ahead at 40 m/s
  double end_time = 0.5;
  double interval = 2e-4;
  double uneven = 0.; ///< how far, of an interval, the samples are from a uniform spacing
};

WaveRecord make(const Case &wave, const std::vector<double> &positions)
{
  WaveRecord record;
  record.positions = positions;
  for (unsigned int i = 0; i * wave.interval <= wave.end_time; ++i)
    record.times.push_back((i + wave.uneven * std::sin(1.7 * i) * (i > 0)) * wave.interval);
  for (const double z : positions)
  {
    std::vector<double> pressure, flow_rate;
    for (const double t : record.times)
    {
      const double back = 2. * tube_length - z;
      const double forward = std::exp(-damping * z) * wave.inlet(t - z / speed);
      const double backward =
          wave.reflection * std::exp(-damping * back) * wave.inlet(t - back / speed);
      pressure.push_back(forward + backward + wave.forerunner * wave.inlet(t - z / 40.));
      flow_rate.push_back((forward - backward) / impedance);
    }
    record.pressure.push_back(pressure);
    record.flow_rate.push_back(flow_rate);
    record.characteristic_impedance.push_back(impedance);
  }
  return record;
}

std::vector<double> stations(const unsigned int n)
{
  std::vector<double> positions;
  for (unsigned int k = 1; k <= n; ++k)
    positions.push_back(k * tube_length / 10.);
  return positions;
}

void check_speeds(const std::string &name, const ByArrival &speeds, const double tolerance)
{
  check::relative(name + ": speed of the peak", speeds.peak, speed, tolerance);
  check::relative(name + ": speed at half-height", speeds.half, speed, tolerance);
  check::relative(name + ": speed of the foot", speeds.tangent_foot, speed, tolerance);
  check::relative(name + ": speed by the phase", speeds.phase, speed, tolerance);
}
} // namespace

UNIT_TEST(wave_analysis)
{
  {
    const WaveRecord record = make(Case(), stations(7));
    const WaveAnalysis analysis = analyse_wave(record);
    check_speeds("closed end", analysis.speed, 1e-3);
    check::relative("closed end: attenuation", analysis.attenuation, damping, 1e-3);
    const StationWave &third = analysis.stations[2];
    const double arrival = record.positions[2] / speed;
    check::absolute("peak", third.arrival.peak, arrival + 0.025, 1e-5);
    check::relative("amplitude", third.amplitude, 1e3 * std::exp(-damping * record.positions[2]),
                    1e-4);
    check::absolute("half-height", third.arrival.half, arrival + 0.0125, 1e-5);
    // The tangent at half-height, of slope pi/T, meets zero T/(2 pi) earlier.
    check::absolute("foot", third.arrival.tangent_foot,
                    arrival + 0.0125 - pulse_length / (2. * M_PI), 2e-5);
    check::absolute("level", third.level, 0., 1e-9);
    check::relative("reflection coefficient", third.reflection_coefficient,
                    std::exp(-2. * damping * (tube_length - record.positions[2])), 1e-3);
    check::absolute("first station: phase is the peak", analysis.stations[0].arrival.phase,
                    analysis.stations[0].arrival.peak, 0.);
  }
  {
    // At 8/10 the reflection comes 71 ms after the pulse, at 9/10 36 ms, at the end with it.
    const WaveAnalysis analysis = analyse_wave(make(Case(), stations(10)));
    check::is_true("the peak before the reflection is one",
                   std::isfinite(analysis.stations[8].arrival.peak));
    check::is_true("its phase is not, being cut by the reflection",
                   std::isnan(analysis.stations[8].arrival.phase));
    check::is_true("the end has no first pulse of its own",
                   std::isnan(analysis.stations[9].arrival.peak) &&
                       std::isnan(analysis.stations[9].amplitude));
    check_speeds("with the end", analysis.speed, 1e-3);
    check::relative("with the end: attenuation", analysis.attenuation, damping, 2e-3);
    check::relative("at the end all is reflected", analysis.stations[9].reflection_coefficient, 1.,
                    1e-3);
  }
  {
    // The reflection reaches 0.41 m 29 ms after the pulse, whose peak comes after 25 ms; from 0.418
    // m on the two have a common peak, and not even the first of these stations counts.
    const std::vector<double> positions = {0.1, 0.2, 0.41, 0.418, 0.425, 0.435, 0.444};
    const WaveAnalysis analysis = analyse_wave(make(Case(), positions));
    check::absolute("a peak just before the reflection", analysis.stations[2].arrival.peak,
                    0.41 / speed + 0.025, 1e-5);
    bool none = true;
    for (unsigned int i = 3; i < positions.size(); ++i)
      none = none && std::isnan(analysis.stations[i].arrival.peak);
    check::is_true("overlapping pulses are left out", none);
    check_speeds("the stations before are left", analysis.speed, 1e-3);
  }
  {
    Case open;
    open.reflection = -0.8;
    open.inlet = gaussian;
    const WaveAnalysis analysis = analyse_wave(make(open, stations(6)));
    check_speeds("open end", analysis.speed, 1e-3);
    check::relative("open end: reflection coefficient", analysis.stations[0].reflection_coefficient,
                    -0.8 * std::exp(-2. * damping * 0.9 * tube_length), 1e-3);
  }
  {
    // The forerunner raises what comes with it: a few per mille of the speed, as in a real tube.
    Case clamped;
    clamped.forerunner = 0.05;
    const WaveAnalysis analysis = analyse_wave(make(clamped, stations(7)));
    check_speeds("forerunner", analysis.speed, 1e-2);
    check::is_true("forerunner: is no pulse", analysis.stations[6].arrival.peak > 0.12 &&
                                                  analysis.stations[6].amplitude > 900.);
  }
  {
    Case uneven;
    uneven.uneven = 0.3;
    const WaveAnalysis analysis = analyse_wave(make(uneven, stations(7)));
    check_speeds("uneven samples", analysis.speed, 1e-3);
  }
  {
    Case matched;
    matched.reflection = 0.;
    const WaveAnalysis analysis = analyse_wave(make(matched, stations(5)));
    check::is_true("no reflection",
                   !(std::abs(analysis.stations[2].reflection_coefficient) > 1e-9));
  }
  {
    Case brief;
    brief.end_time = 0.09;
    const WaveAnalysis analysis = analyse_wave(make(brief, stations(7)));
    check::is_true("a pulse that has not come is none",
                   std::isfinite(analysis.stations[0].arrival.peak) &&
                       std::isnan(analysis.stations[6].arrival.peak));
    check::is_true("a reflection that has not come is none",
                   std::isnan(analysis.stations[0].reflection_coefficient));
    const WaveAnalysis single = analyse_wave(make(Case(), {0.1}));
    check::is_true("one station has no speed",
                   std::isnan(single.speed.peak) && std::isnan(single.attenuation));
    WaveRecord still = make(Case(), stations(2));
    for (auto &history : still.pressure)
      history.assign(history.size(), 7.);
    const WaveAnalysis rest = analyse_wave(still);
    check::is_true("rest has no pulse",
                   std::isnan(rest.stations[1].arrival.half) && std::isnan(rest.speed.half));
  }
  {
    // The pulse needs 0.15 s to the sixth station; what there is of it until then is the forerunner
    // of the wall's wave, whose peak comes at 32 ms to all stations.
    Case clamped;
    clamped.forerunner = 0.05;
    clamped.end_time = 0.11;
    const WaveAnalysis analysis = analyse_wave(make(clamped, stations(8)));
    check_speeds("pulses that have not come", analysis.speed, 2e-2);
    check::is_true("a forerunner is no pulse",
                   std::isnan(analysis.stations[7].arrival.peak) &&
                       analysis.stations[7].missing == MissingPulse::not_come &&
                       std::isnan(analysis.stations[7].amplitude));
    check::is_true("a pulse that still rises is none",
                   analysis.stations[4].missing == MissingPulse::rises);
    check::is_true("what is there needs no reason", analysis.missing.peak.empty());
  }
  {
    // The peak comes to all stations at once, as of a wave that stands.
    WaveRecord standing = make(Case(), stations(4));
    for (auto &history : standing.pressure)
      history = standing.pressure.front();
    standing.flow_rate.clear();
    const WaveAnalysis analysis = analyse_wave(standing);
    check::is_true("no speed where the times do not rise",
                   std::isnan(analysis.speed.peak) && std::isnan(analysis.speed.half) &&
                       analysis.missing.peak.find("no later") != std::string::npos);
  }
  {
    // It goes from the first to the second station within 18 ms.
    Case seldom;
    seldom.interval = 0.01;
    const WaveAnalysis analysis = analyse_wave(make(seldom, stations(2)));
    check::is_true("no speed of two rows",
                   std::isnan(analysis.speed.peak) &&
                       analysis.missing.peak.find("rows") != std::string::npos);
  }
  {
    // A pulse of 0.6 s in a tube through which it goes in 0.18 s: the pressure is the sum of pulse
    // and reflection everywhere, and its peak comes later to a station nearer to the inlet.
    Case overlapping;
    overlapping.inlet = long_pulse;
    overlapping.end_time = 2.;
    WaveRecord record = make(overlapping, stations(8));
    const WaveAnalysis with_flow = analyse_wave(record);
    check::is_true("no speed of pulses that overlap, by the flow",
                   std::isnan(with_flow.speed.peak) && std::isnan(with_flow.attenuation) &&
                       with_flow.stations[3].missing == MissingPulse::overlaps);
    record.flow_rate.clear();
    const WaveAnalysis without_flow = analyse_wave(record);
    check::is_true("no speed of pulses that overlap, by the pressure alone",
                   std::isnan(without_flow.speed.peak) && std::isnan(without_flow.speed.phase) &&
                       !without_flow.missing.peak.empty());
  }
  {
    // Another wave raises and lowers the heights by 4 %; the loss over the stations is 4 %.
    WaveRecord record = make(Case(), stations(7));
    for (unsigned int i = 0; i < 7; ++i)
      for (double &value : record.pressure[i])
        value *= i % 2 == 0 ? 1.04 : 0.96;
    record.flow_rate.clear();
    const WaveAnalysis analysis = analyse_wave(record);
    check::is_true("no attenuation where another wave changes the heights",
                   std::isnan(analysis.attenuation) &&
                       analysis.missing.attenuation.find("another wave") != std::string::npos);
    check_speeds("but the speed", analysis.speed, 1e-3);
    const WaveAnalysis two = analyse_wave(make(Case(), stations(2)));
    check::is_true("no attenuation of two stations",
                   std::isfinite(two.speed.peak) && std::isnan(two.attenuation) &&
                       two.missing.attenuation.find("three stations") != std::string::npos);
  }
  {
    // A beat that begins within the rise has no foot.
    WaveRecord record = make(Case(), stations(3));
    std::size_t cut = 0;
    while (record.times[cut] < record.positions[0] / speed + 0.012)
      ++cut;
    record.times.erase(record.times.begin(), record.times.begin() + cut);
    for (auto &history : record.pressure)
      history.erase(history.begin(), history.begin() + cut);
    record.flow_rate.clear();
    record.begins_at_rest = false;
    check::is_true("no foot before the record",
                   std::isnan(analyse_wave(record).stations[0].arrival.tangent_foot));
    record.begins_at_rest = true;
    check::is_true("from rest on there is one",
                   std::isfinite(analyse_wave(record).stations[0].arrival.tangent_foot));
  }
  const SeparatedWaves waves = separate_waves({10., 4.}, {2., -2.}, 3.);
  check::is_true("separation", waves.forward[0] == 8. && waves.backward[0] == 2. &&
                                   waves.forward[1] == -1. && waves.backward[1] == 5.);
  check::throws<std::invalid_argument>(
      "a missing history",
      []
      {
        WaveRecord record = make(Case(), stations(3));
        record.pressure.pop_back();
        analyse_wave(record);
      },
      "pressure of every station");
  check::throws<std::invalid_argument>(
      "positions out of order",
      [] {
        analyse_wave(make(Case(), {0.2, 0.1}));
      },
      "increase");
}
} // namespace test_of_wave_analysis
