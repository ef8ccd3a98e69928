// A table of measurements at stations: places and units of its columns, and what is refused.

#include <continua/base/input_error.h>
#include <continua/base/parameter_file.h>
#include <continua/base/units.h>
#include <continua/case/measured_waves.h>

#include <cmath>
#include <fstream>

#include "../unit_test.h"

namespace test_of_measured_waves
{
using namespace Continua;

namespace
{
const std::string file = "measured_waves.csv";

MeasuredWaves read(const std::string &content,
                   const std::string &entries = "",
                   const std::vector<double> &stations = {0.1, 0.3})
{
  std::ofstream(file) << content;
  const std::string path = "measured_waves.prm";
  std::ofstream(path) << "set Measured = " + file + "\n" + entries;
  ParameterFile parameters(path);
  MeasuredWavesEntries read_entries;
  read_entries.read(parameters.root());
  const MeasuredWaves waves(read_entries, parameters.root(), stations,
                            {"pressure", "flow rate", "wall distension"});
  std::remove(path.c_str());
  return waves;
}

void test_entries()
{
  const std::string beat = "time [s], 0.1 m: pressure [Pa], 0.3 m: pressure [Pa]\n"
                           "0, 0, 10\n0.2, 2, 10\n0.4, 1, 10\n";
  const std::vector<double> times = {0.05, 0.3, 0.65, 0.9, 1.1};
  const auto histories = read(beat, "set Measured period = 0.6 s\nset Measured shift = 0.1 s\n"
                                    "set Measured factors = -1, 2\n")
                             .histories(times);
  // In the time of the table: -0.05, 0.2, 0.55, 0.8 and 1 s.
  const std::vector<double> values = {-0.25, -2., -0.25, -2., -1.};
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    check::relative("a beat at " + std::to_string(times[i]), histories[0][0][i], values[i], 1e-12);
    check::relative("its second column", histories[1][0][i], 20., 1e-12);
  }
  check::relative("one factor for all",
                  read(beat, "set Measured factors = -3\n").histories({0.})[1][0][0], -30., 1e-14);
  const auto refused =
      [&](const std::string &name, const std::string &entries, const std::string &pattern)
  {
    check::throws<InputError>(
        name, [&] { read(beat, entries); }, pattern);
  };
  refused("three factors", "set Measured factors = 1, 2, 3\n",
          "prm:2: 'Measured factors'.*3 factors, but 2 columns");
  refused("a period shorter than the table", "set Measured period = 0.3 s\n",
          "csv:4: .*0.4 s later.*longer 'Measured period'");
  // 3e-7 m apart: stations of a capillary, one place in a pipeline.
  const std::vector<double> close = {0.5e-6, 0.8e-6};
  const auto capillary = read("time [s], 0.8 um: pressure [Pa]\n0, 7\n1, 7\n", "", close);
  check::relative("the station that is meant", capillary.histories({0.})[1][0][0], 7., 1e-14);
  check::is_true("and no other one", std::isnan(capillary.histories({0.})[0][0][0]));
  check::throws<InputError>(
      "no station", [&] { read("time [s], 0.7 um: pressure [Pa]\n0, 7\n1, 7\n", "", close); },
      "no station there");
  check::is_true(
      "round-off of another unit",
      read("time [s], 4.3 cm: pressure [Pa]\n0, 7\n1, 7\n", "", {0.043}).histories({0.})[0][0][0] ==
          7.);
}
} // namespace

UNIT_TEST(measured_waves)
{
  const auto histories = read("# notebook p. 12\n"
                              "time [ms], 300 mm: pressure [mmHg], 0.1 m: wall distension [um]\n"
                              "10, 1, 0\n"
                              "20, 3, 50\n")
                             .histories({0., 0.01, 0.015, 0.02, 0.03});
  check::is_true("stations, fields and times",
                 histories.size() == 2 && histories[0].size() == 3 && histories[0][0].size() == 5);
  // 1 mmHg is 133.322387415 Pa.
  check::relative("first row", histories[1][0][1], 133.322387415, 1e-9);
  check::relative("between the rows", histories[1][0][2], 266.64477483, 1e-9);
  check::relative("last row", histories[1][0][3], 399.967162245, 1e-9);
  check::relative("another field", histories[0][2][2], 25e-6, 1e-12);
  check::is_true("before and after the table",
                 std::isnan(histories[1][0][0]) && std::isnan(histories[1][0][4]));
  check::is_true("what was not measured", std::isnan(histories[0][0][2]) &&
                                              std::isnan(histories[1][1][2]) &&
                                              std::isnan(histories[1][2][2]));

  const auto refused =
      [](const std::string &name, const std::string &content, const std::string &pattern)
  {
    check::throws<InputError>(
        name, [&content] { read(content); }, pattern);
  };
  refused("a station that is none", "time [s], 0.2 m: pressure [Pa]\n0, 1\n1, 1\n",
          "csv:1: .*no station there.*0\\.1 m, 0\\.3 m");
  refused("a field that is not recorded", "time [s], 0.1 m: hoop stress [Pa]\n0, 1\n1, 1\n",
          "csv:1: .*does not record this field");
  refused("a column without a station", "time [s], pressure [Pa]\n0, 1\n1, 1\n",
          "csv:1: .*has no station");
  refused("a station in kilograms", "time [s], 1 kg: pressure [Pa]\n0, 1\n1, 1\n",
          "csv:1: .*has no station");
  refused("no unit", "time [s], 0.1 m: pressure\n0, 1\n1, 1\n", "csv:1: .*no unit");
  refused("the unit of something else", "time [s], 0.1 m: pressure [ml/s]\n0, 1\n1, 1\n",
          "csv:1: .*ml/s");
  refused("times that do not increase", "time [s], 0.1 m: pressure [Pa]\n0, 1\n0, 1\n", "csv:3: ");
  refused("one row", "time [s], 0.1 m: pressure [Pa]\n0, 1\n", "csv");

  test_entries();
  check::equal("unit of a field", dimension_of_station_field("flow rate").unit(), "m^3/s");
  std::remove(file.c_str());
}
} // namespace test_of_measured_waves
