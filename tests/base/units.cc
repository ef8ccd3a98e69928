#include <continua/base/unit_scale.h>

#include "../unit_test.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <tuple>

namespace test_of_units
{
using namespace Continua;

namespace
{
void quantity(const std::string &text, const Dimension &dimension, const double reference)
{
  check::relative(text, parse_quantity(text, dimension), reference, 1e-14);
}

void refused(const std::string &text, const Dimension &dimension, const std::string &pattern)
{
  check::throws<std::invalid_argument>(
      "refused: '" + text + "'", [&] { parse_quantity(text, dimension); }, pattern);
}

/// The same number whatever decimal unit it has, and its shortest name.
void check_decimals()
{
  bool same = true, shortest = true, named = true;
  for (int i = 1; i <= 2000; ++i)
  {
    // By the compiler's own reading of decimal texts.
    const std::string metres = std::to_string(i / 10000) + "." +
                               std::to_string(10000 + i % 10000).substr(1),
                      tenths = std::to_string(i / 10) + "." + std::to_string(i % 10);
    const double value = std::strtod(metres.c_str(), nullptr);
    for (const std::string &text :
         {tenths + " mm", std::to_string(i) + "e-1 mm", std::to_string(i * 100) + " um",
          std::to_string(i * 1e-2) + " cm", std::to_string(i) + "e-7 km", metres + " m", metres})
      same = same && parse_quantity(text, Dimensions::length) == value;
    const std::string name = named_value(value, "m");
    shortest =
        shortest && name.size() <= metres.size() + 2 && std::strtod(name.c_str(), nullptr) == value;
    named = named && with_value_in_si("stations " + tenths + " mm") == "stations " + name;
  }
  check::is_true("decimal units: one number", same);
  check::is_true("decimal units: the shortest name", shortest);
  check::is_true("decimal units: names", named);
  bool of_other_units = true;
  for (const auto &[text, dimension, value] :
       {std::make_tuple("0.7 kPa", Dimensions::pressure, 700.),
        std::make_tuple("1.1 g/cm^3", Dimensions::density, 1100.),
        std::make_tuple("0.3 N/mm^2", Dimensions::pressure, 0.3e6),
        std::make_tuple("4.1 cP", Dimensions::viscosity, 0.0041),
        std::make_tuple("0.7 ml/s", Dimensions::flow_rate, 0.7e-6),
        std::make_tuple("13 %", Dimensions::none, 0.13),
        std::make_tuple("1.3 min", Dimensions::time, 78.)})
    of_other_units = of_other_units && parse_quantity(text, dimension) == value;
  check::is_true("decimal units: others", of_other_units);
  check::is_true("a power of ten: round-off", times_power_of_ten(43., -3) == 0.043);
  check::is_true("a power of ten: too large", std::isinf(times_power_of_ten(1e300, 20)));
  check::is_true("a power of ten: too small", times_power_of_ten(1e-300, -40) == 0.);
  check::is_true("a power of ten: negative", times_power_of_ten(-2.5e-7, 9) == -250.);
  check::equal("no position", with_value_in_si("tip 2"), "tip 2");
  check::equal("a word", with_value_in_si("wall inlet end"), "wall inlet end");
  check::equal("a pressure", with_value_in_si("at 3 Pa"), "at 3 Pa");
  check::equal("nothing", with_value_in_si(""), "");
}
} // namespace

UNIT_TEST(units)
{
  using namespace Dimensions;
  check_decimals();
  quantity("0.35", length, 0.35);
  quantity("10 mm", length, 0.01);
  quantity("10mm", length, 0.01);
  quantity("  1e-3   km ", length, 1.);
  quantity("+2 cm", length, 0.02);
  quantity("-3 dm", length, -0.3);
  quantity("5 um", length, 5e-6);
  quantity("5 \u00b5m", length, 5e-6);
  quantity("5 \u03bcm", length, 5e-6);
  quantity("2 ms", Dimensions::time, 2e-3);
  quantity("2 us", Dimensions::time, 2e-6);
  quantity("3 min", Dimensions::time, 180.);
  quantity("2 h", Dimensions::time, 7200.);
  quantity("3.3 Hz", frequency, 3.3);
  quantity("3.3 1/s", frequency, 3.3);
  quantity("3.3 s^-1", frequency, 3.3);
  quantity("1.5 kHz", frequency, 1500.);
  quantity("2.2 GPa", pressure, 2.2e9);
  quantity("1.2 MPa", pressure, 1.2e6);
  quantity("30 kPa", pressure, 3e4);
  quantity("1013 hPa", pressure, 101300.);
  quantity("1 bar", pressure, 1e5);
  quantity("4 mbar", pressure, 400.);
  // NIST SP 811, table B.8: 1 mmHg = 133.3224 Pa, 1 cmH2O = 98.0665 Pa (conventional)
  check::absolute("mmHg", parse_quantity("1 mmHg", pressure), 133.3224, 5e-5);
  check::absolute("cmH2O", parse_quantity("1 cmH2O", pressure), 98.0665, 1e-9);
  quantity("3 N/mm^2", pressure, 3e6);
  quantity("1100 kg/m^3", density, 1100.);
  quantity("1.1 g/cm^3", density, 1100.);
  quantity("1 t/m^3", density, 1000.);
  quantity("7 mg/ml", density, 7.);
  quantity("2 cm3/sec", flow_rate, 2e-6);
  quantity("2 cc/s", flow_rate, 2e-6);
  quantity("2 mL s-1", flow_rate, 2e-6);
  quantity("2 cm\u00b3/s", flow_rate, 2e-6);
  quantity("2 mL\u00b7s\u207b\u00b9", flow_rate, 2e-6);
  quantity("2 N/mm\u00b2", pressure, 2e6);
  quantity("3 msec", Dimensions::time, 3e-3);
  quantity("3 seconds", Dimensions::time, 3.);
  quantity("2 kg m-3", density, 2.);
  quantity("1 mPa s", viscosity, 1e-3);
  quantity("1 mPa*s", viscosity, 1e-3);
  quantity("4 cP", viscosity, 4e-3);
  quantity("1 P", viscosity, 0.1);
  quantity("2 kg/m/s", viscosity, 2.);
  quantity("2 kg/(m s)", viscosity, 2.);
  quantity("6 l/min", flow_rate, 1e-4);
  quantity("5 dl/s", flow_rate, 5e-4);
  quantity("9.81 m/s^2", acceleration, 9.81);
  quantity("36 km/h", velocity, 10.);
  quantity("9.81 kN/m^3", force_density, 9810.);
  quantity("2 mm^2", area, 2e-6);
  quantity("3 mW", power, 3e-3);
  quantity("3 J/s", power, 3.);
  quantity("5 %", none, 0.05);
  quantity("0.4 rad", none, 0.4);
  quantity("0.4 1", none, 0.4);
  quantity("2 mm/m", none, 2e-3);

  refused("10 mm", pressure, "'10 mm' has the wrong unit: it is in m, not in Pa");
  refused("5 %", length, "it is in 1, not in m");
  refused("10 parsec", length, "unit 'parsec' is unknown");
  refused("10 Mm2", length, "it is in m\\^2, not in m");
  refused("10 m0", length, "unit 'm0' is unknown");
  refused("10 m12", length, "unit 'm12' is unknown");
  refused("10 -2", length, "unit '-2' is unknown");
  refused("10 m^x", length, "whole number after '\\^'");
  refused("10 m/", length, "incomplete");
  refused("10 N/(m s", length, "lacks a '\\)'");
  refused("10 m)", length, "too many");
  check::throws<std::invalid_argument>(
      "nested too deep",
      []
      {
        Dimension dimension;
        unit_factor(std::string(100000, '(') + "m" + std::string(100000, ')'), dimension);
      },
      "more than 20 brackets");
  refused("nan", none, "no finite number");
  refused("inf m", length, "no finite number");
  refused("-inf", none, "no finite number");
  refused("1e999", none, "beyond the numbers");
  refused("1e308 km", length, "beyond the numbers");
  refused("ten", none, "'ten' is no number");
  refused("", none, "no number");
  refused("1,5 m", length, "decimal sign is a point");
  refused("1 + 2", none, "unknown");

  check::equal("unit of pressure", pressure.unit(), "Pa");
  check::equal("unit of viscosity", viscosity.unit(), "Pa s");
  check::equal("unit of density", density.unit(), "kg/m^3");
  check::equal("unit of length", length.unit(), "m");
  check::equal("unit of area", area.unit(), "m^2");
  check::equal("unit of time", Dimensions::time.unit(), "s");
  check::equal("unit of velocity", velocity.unit(), "m/s");
  check::equal("unit of acceleration", acceleration.unit(), "m/s^2");
  check::equal("unit of flow rate", flow_rate.unit(), "m^3/s");
  check::equal("unit of force density", force_density.unit(), "N/m^3");
  check::equal("unit of pressure over velocity", Dimension{1, -2, -1}.unit(), "Pa s/m");
  check::equal("unit of frequency", frequency.unit(), "1/s");
  check::equal("unit of power", power.unit(), "W");
  check::equal("unit of nothing", none.unit(), "1");
  check::equal("a unit without a name", Dimension{2, 1, -3}.unit(), "kg^2 m/s^3");
  bool all_read_back = true;
  for (int mass = -2; mass <= 2; ++mass)
    for (int length_power = -3; length_power <= 3; ++length_power)
      for (int time_power = -3; time_power <= 3; ++time_power)
      {
        const Dimension dimension{mass, length_power, time_power};
        Dimension found;
        all_read_back =
            all_read_back && unit_factor(dimension.unit(), found) == 1. && found == dimension;
      }
  check::is_true("every SI unit reads back", all_read_back);

  Dimension dimension;
  check::relative("factor of m^2/s in mm^2/s", unit_factor("mm^2/s", dimension), 1e-6, 1e-14);
  check::is_true("its dimension", dimension == Dimension{0, 2, -1});
  check::equal("usual units of pressure", usual_units(pressure),
               "Pa, kPa, MPa, GPa, bar, mmHg, cmH2O");
  check::equal("usual units of pressure over length", usual_units(force_density),
               "N/m^3, kN/m^3, Pa/m, kPa/m, MPa/m");
  check::equal("usual units of a number", usual_units(none), "%");
  check::equal("small number", shortest_number(0.0002), "0.0002");
  check::equal("everyday number", shortest_number(-1450000.), "-1450000");
  check::equal("large number", shortest_number(2.2e9), "2.2e+09");
}
} // namespace test_of_units
