// What the report says of a wave that is made up: a pulse of known speed and height and its
// reflection by a closed end, as simulated, a theory that is one percent higher, and measurements
// that lack a station.

#include <continua/analysis/wave_report.h>
#include <continua/base/csv_table.h>

#include <cmath>
#include <limits>

#include "../unit_test.h"

namespace test_of_wave_report
{
using namespace Continua;

namespace
{
constexpr double speed = 5., length = 1., impedance = 1e7, step = 5e-4;

double pulse(const double time)
{
  return 1000. * std::exp(-std::pow((time - 0.04) / 0.01, 2));
}

double find(const Summary &summary, const std::string &name, const std::string &probe)
{
  for (const Quantity &quantity : summary.quantities())
    if (quantity.name == name && quantity.probe == probe)
      return quantity.value;
  return std::numeric_limits<double>::quiet_NaN();
}
} // namespace

UNIT_TEST(wave_report)
{
  const WaveStations stations = {"tube",
                                 {0.1, 0.3, 0.5},
                                 {"pressure", "flow rate"},
                                 {"Pa", "m^3/s"},
                                 {impedance, impedance, impedance}};
  std::vector<double> times;
  for (unsigned int i = 0; i <= 900; ++i)
    times.push_back(i * step);
  // By station, field and time; the far end at z = 1 m reflects the whole pulse.
  WaveReport::Histories simulated;
  for (const double z : stations.positions)
  {
    simulated.push_back({{}, {}});
    for (const double time : times)
    {
      const double there = pulse(time - z / speed), back = pulse(time - (2. * length - z) / speed);
      simulated.back()[0].push_back(there + back);
      simulated.back()[1].push_back((there - back) / impedance);
    }
  }
  WaveReport::Histories theory = simulated, measured = simulated;
  for (auto &station : theory)
    for (auto &field : station)
      for (double &value : field)
        value *= 1.01;
  for (auto &station : measured)
    std::fill(station[1].begin(), station[1].end(), std::numeric_limits<double>::quiet_NaN());
  for (double &value : measured[1][0])
    value *= 1.2;
  std::fill(measured[2][0].begin(), measured[2][0].end(), std::numeric_limits<double>::quiet_NaN());

  WaveReport report(stations, times);
  report.add(WaveSource::simulated(), simulated);
  report.add(WaveSource::linear_theory(), theory);
  report.add(WaveSource::measured(), measured);
  Summary summary;
  report.add_quantities(summary);

  for (const std::string prefix : {"", "theoretical ", "measured "})
  {
    check::relative(prefix + "wave speed", find(summary, prefix + "wave speed", "tube"), 5., 1e-6);
    check::relative(prefix + "wave speed at half height",
                    find(summary, prefix + "wave speed at half height", "tube"), 5., 1e-6);
    check::absolute(prefix + "first pulse time",
                    find(summary, prefix + "first pulse time", "tube 0.3 m"), 0.1, 1e-7);
  }
  check::absolute("attenuation", find(summary, "attenuation", "tube"), 0., 1e-9);
  // Of the two stations that were measured no attenuation can be told, and an expected value says
  // so.
  check::is_true("no measured attenuation",
                 std::isnan(find(summary, "measured attenuation", "tube")));
  bool all_passed = true;
  const std::string verdict =
      summary.check({parse_expected_value("measured attenuation", "0.1 +- 1 %")}, all_passed)
          .front();
  check::is_true("the reason fails it",
                 !all_passed && verdict.find("absent: it needs three") != std::string::npos);
  check::relative("first pulse height", find(summary, "first pulse height", "tube 0.5 m"), 1000.,
                  1e-6);
  check::relative("reflection coefficient", find(summary, "reflection coefficient", "tube 0.1 m"),
                  1., 1e-6);
  check::absolute("reflected pulse time", find(summary, "reflected pulse time", "tube 0.1 m"), 0.42,
                  1e-7);
  check::relative("reflected pulse height",
                  find(summary, "theoretical reflected pulse height", "tube 0.5 m"), 1010., 1e-6);
  check::is_true("no pulse where nothing was measured",
                 std::isnan(find(summary, "measured first pulse time", "tube 0.5 m")));
  // Over the largest value of the second: 1 % of 1010 Pa there.
  check::relative("largest difference of pressure",
                  find(summary, "largest difference of pressure", "tube"), 0.01 / 1.01, 1e-6);
  check::relative("largest difference of flow rate",
                  find(summary, "largest difference of flow rate", "tube"), 0.01 / 1.01, 1e-6);
  check::relative("largest difference of first pulse height",
                  find(summary, "largest difference of first pulse height", "tube"), 0.01 / 1.01,
                  1e-6);
  check::relative("from measurement",
                  find(summary, "largest difference of pressure from measurement", "tube"), 1. / 6.,
                  1e-6);
  check::is_true(
      "no measured flow rate",
      std::isnan(find(summary, "largest difference of flow rate from measurement", "tube")));

  // Records that end before the run: one station of two, then both.
  for (const unsigned int n_short : {1u, 2u})
  {
    for (unsigned int s = 0; s < n_short; ++s)
      std::fill(measured[s][0].begin() + 101, measured[s][0].end(),
                std::numeric_limits<double>::quiet_NaN());
    WaveReport of_short(stations, times);
    of_short.add(WaveSource::simulated(), simulated);
    of_short.add(WaveSource::measured(), measured);
    Summary absent;
    std::string lines;
    for (const std::string &line : of_short.add_quantities(absent).lines)
      lines += line + "\n";
    check::is_true(
        n_short == 1 ? "a short record" : "short records alone",
        check::matches(lines, n_short == 1
                                  ? "Left out of the measured speeds.*: 0.1 m: 0 s to 0.05 s\n"
                                  : "No measured wave speed and attenuation.*no record.*0.1 m: 0 s "
                                    "to 0.05 s, 0.3 m: 0 s to 0.05 s.*Time/End time"));
  }

  // The same pulse from the other end: at z it is what was at 1 m - z, and the flow is negative.
  WaveStations turned = stations;
  turned.positions = {0.5, 0.7, 0.9};
  turned.direction = -1.;
  WaveReport::Histories mirrored = {simulated[2], simulated[1], simulated[0]};
  for (auto &station : mirrored)
    for (double &value : station[1])
      value = -value;
  WaveReport from_the_end(turned, times);
  from_the_end.add(WaveSource::simulated(), mirrored);
  Summary of_the_end;
  from_the_end.add_quantities(of_the_end);
  check::relative("from the end: wave speed", find(of_the_end, "wave speed", "tube"), 5., 1e-6);
  check::relative("from the end: reflection coefficient",
                  find(of_the_end, "reflection coefficient", "tube 0.9 m"), 1., 1e-6);
  check::absolute("from the end: reflected pulse time",
                  find(of_the_end, "reflected pulse time", "tube 0.9 m"), 0.42, 1e-7);

  // The same in the second of two beats, on a pressure and a flow that have been there: they are no
  // part of the pulse.
  std::vector<double> of_two_beats = times;
  WaveReport::Histories second = simulated;
  for (std::size_t i = 1; i < times.size(); ++i)
    of_two_beats.push_back(times.back() + times[i]);
  for (auto &station : second)
    for (unsigned int f = 0; f < 2; ++f)
    {
      const double before = f == 0 ? 8000. : 9e-5;
      std::vector<double> values(times.size() - 1, before);
      for (const double value : station[f])
        values.push_back(before + value);
      station[f] = values;
    }
  WaveReport of_beat(stations, of_two_beats);
  of_beat.add(WaveSource::simulated(), second);
  of_beat.set_beat(times.back(), 2. * times.back());
  Summary of_second;
  of_beat.add_quantities(of_second);
  check::relative("second beat: wave speed", find(of_second, "wave speed", "tube"), 5., 1e-6);
  check::absolute("second beat: first pulse time",
                  find(of_second, "first pulse time", "tube 0.3 m"), times.back() + 0.1, 1e-7);
  check::relative("second beat: first pulse height",
                  find(of_second, "first pulse height", "tube 0.5 m"), 1000., 1e-6);
  check::relative("second beat: reflection coefficient",
                  find(of_second, "reflection coefficient", "tube 0.1 m"), 1., 1e-6);

  // A second theory has a name of its own, also in the names of quantities.
  WaveReport of_two_theories(stations, times);
  of_two_theories.add(WaveSource::simulated(), simulated);
  of_two_theories.add(WaveSource::linear_theory(), theory);
  WaveReport::Histories nonlinear = simulated;
  for (auto &station : nonlinear)
    for (auto &field : station)
      for (double &value : field)
        value *= 1.03;
  of_two_theories.add(WaveSource::nonlinear_theory(), nonlinear);
  Summary summary_of_two;
  of_two_theories.add_quantities(summary_of_two);
  check::relative("nonlinear theory: first pulse height",
                  find(summary_of_two, "nonlinear theoretical first pulse height", "tube 0.3 m"),
                  1030., 1e-6);
  check::relative("from linear theory",
                  find(summary_of_two, "largest difference of pressure", "tube"), 0.01 / 1.01,
                  1e-6);
  check::relative(
      "from nonlinear theory",
      find(summary_of_two, "largest difference of pressure from nonlinear theory", "tube"),
      0.03 / 1.03, 1e-6);
  // A theory that ends has no difference over the whole run, though what there is of it is near.
  for (auto &station : nonlinear)
    std::fill(station[0].begin() + 600, station[0].end(), std::numeric_limits<double>::quiet_NaN());
  WaveReport of_ended(stations, times);
  of_ended.add(WaveSource::simulated(), simulated);
  of_ended.add(WaveSource::nonlinear_theory(), nonlinear);
  Summary summary_of_ended;
  of_ended.add_quantities(summary_of_ended);
  bool ended_passed = true;
  const std::string verdict_of_ended =
      summary_of_ended
          .check({parse_expected_value("largest difference of pressure from nonlinear theory",
                                       "< 0.1")},
                 ended_passed)
          .front();
  check::is_true("a theory that ends fails it",
                 !ended_passed && verdict_of_ended.find("absent: the values of 'nonlinear theory' "
                                                        "end before the run") != std::string::npos);
  check::relative(
      "a field that does not end",
      find(summary_of_ended, "largest difference of flow rate from nonlinear theory", "tube"),
      0.03 / 1.03, 1e-6);
  QuantityNames names;
  WaveReport::name_quantities(
      stations,
      {WaveSource::simulated(), WaveSource::linear_theory(), WaveSource::nonlinear_theory()},
      names);
  bool all_named = true;
  for (const Quantity &quantity : summary_of_two.quantities())
    all_named = all_named && names.has(quantity.name, quantity.probe);
  check::is_true("all quantities have been named", all_named);
  of_two_theories.write("wave_report_of_two.csv");
  const CsvTable table_of_two("wave_report_of_two.csv", "");
  check::is_true("columns of two theories", table_of_two.n_columns() == 1 + 3 * (2 * 5 + 6));
  check::absolute(
      "difference from nonlinear theory",
      table_of_two.values(table_of_two.find("tube 0.1 m: pressure, simulated - nonlinear theory"),
                          Dimensions::pressure)[120],
      -30., 1e-6);
  std::remove("wave_report_of_two.csv");

  const std::string file = "wave_report.csv";
  report.write(file);
  const CsvTable table(file, "");
  // Time, then by station 2 fields of 3 sources and 2 differences, 2 waves of 2 sources.
  check::is_true("columns", table.n_columns() == 1 + 3 * (2 * 5 + 4));
  const auto column = [&table](const std::string &name)
  { return table.values(table.find(name), Dimensions::pressure); };
  const std::vector<double> forward = column("tube 0.1 m: forward wave, simulated"),
                            backward = column("tube 0.1 m: backward wave, simulated"),
                            difference = column("tube 0.1 m: pressure, simulated - theory");
  check::absolute("forward wave", forward[120], 1000., 1e-6);
  check::absolute("backward wave", backward[840], 1000., 1e-6);
  check::absolute("difference", difference[120], -10., 1e-6);
  std::remove(file.c_str());
}
} // namespace test_of_wave_report
