// A table of measurements at stations: places and units of its columns, and what is refused.

#include <continua/base/input_error.h>
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

MeasuredWaves read(const std::string &content)
{
  std::ofstream(file) << content;
  return MeasuredWaves(file, {0.1, 0.3}, {"pressure", "flow rate", "wall distension"});
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

  check::equal("unit of a field", dimension_of_station_field("flow rate").unit(), "m^3/s");
  std::remove(file.c_str());
}
} // namespace test_of_measured_waves
