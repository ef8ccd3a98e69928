// What a run ends with: the numbers of a summary that a user wants to see first.

#include <continua/analysis/answer.h>

#include "../unit_test.h"

#include <cmath>

namespace test_of_answer
{
using namespace Continua;

namespace
{
void print(const Summary &summary)
{
  for (const std::string &line : answer_lines(summary))
    std::cout << line << std::endl;
}
} // namespace

UNIT_TEST(answer)
{
  check::is_true("nothing of an empty summary", answer_lines(Summary()).empty());

  // A pulse at two stations, with theory and a measurement that has no speed by phase.
  Summary pulse;
  pulse.add({"energy residual", 1e-12, "1", ""});
  pulse.add({"wave speed", 10.0318019, "m/s", "stations"});
  pulse.add({"wave speed by phase", 10.1000823, "m/s", "stations"});
  pulse.add({"attenuation", 0.2117236, "1/m", "stations"});
  pulse.add({"theoretical wave speed", 10.0234369, "m/s", "stations"});
  pulse.add({"theoretical wave speed by phase", 10.0999308, "m/s", "stations"});
  pulse.add({"theoretical attenuation", 0.2120061, "1/m", "stations"});
  pulse.add({"measured wave speed", 9.5491666, "m/s", "stations"});
  // Two fields of a probe: the label has the field.
  pulse.add({"maximum pressure", 5168.667, "Pa", "stations 0.1 m: pressure"});
  pulse.add({"time of maximum pressure", 0.02924823, "s", "stations 0.1 m: pressure"});
  pulse.add({"minimum pressure", -2451.9953, "Pa", "stations 0.1 m: pressure"});
  pulse.add({"time of minimum pressure", 0.1930732, "s", "stations 0.1 m: pressure"});
  pulse.add({"first maximum pressure", 5168.667, "Pa", "stations 0.1 m: pressure"});
  pulse.add({"final pressure", -2205.52, "Pa", "stations 0.1 m: pressure"});
  // One field: the quantity's name has it.
  pulse.add({"maximum displacement y", 0.1, "m", "tip"});
  pulse.add({"time of maximum displacement y", 0.25, "s", "tip"});
  pulse.add({"minimum displacement y", 0., "m", "tip"});
  pulse.add({"time of minimum displacement y", 0., "s", "tip"});
  pulse.add({"frequency", 3.3624, "Hz", "tip"});
  pulse.add({"fit residual", 0.004, "1", "tip"});
  // A pulse that comes back is no oscillation.
  pulse.add({"frequency", 7.3, "Hz", "stations 0.1 m: pressure"});
  pulse.add({"fit residual", 0.18, "1", "stations 0.1 m: pressure"});
  bool all_passed = true;
  pulse.check({parse_expected_value("tip: frequency", "3.36 Hz +- 1 %"),
               parse_expected_value("wave speed by phase", "10.1 m/s +- 0.001 mm/s"),
               parse_expected_value("energy residual", "< 1e-9"),
               parse_expected_value("tip: damping", "1 +- 1 %")},
              all_passed);
  print(pulse);
  check::is_true("verdicts", pulse.checks().size() == 4 && pulse.checks()[0].passed &&
                                 !pulse.checks()[1].passed && pulse.checks()[2].passed &&
                                 !pulse.checks()[3].passed);
  check::is_true("a quantity that is missing has no value", std::isnan(pulse.checks()[3].value));

  // The last beat by probe, and all beats.
  Summary heart;
  heart.add({"systolic pressure of the last beat", 15092.25, "Pa", "outlet"});
  heart.add({"diastolic pressure of the last beat", 8153.17, "Pa", "outlet"});
  heart.add({"mean pressure of the last beat", 10987.02, "Pa", "outlet"});
  heart.add({"pulse pressure of the last beat", 6939.08, "Pa", "outlet"});
  heart.add({"difference of pressure of the last beat", 0.2838, "1", "outlet"});
  heart.add({"largest flow rate of the last beat", 4.67e-4, "m^3/s", "tube 0.1 m: flow rate"});
  heart.add({"range of flow rate of the last beat", 5.02e-4, "m^3/s", "tube 0.1 m: flow rate"});
  heart.set("beats", Summary::Columns{{"time [s]", {0.8, 1.6, 2.4}},
                                      {"beat [1]", {1., 2., 3.}},
                                      {"largest difference [1]", {std::nan(""), 0.5312, 0.2838}}});
  print(heart);

  // A steady state has final values; of many probes the first ones are shown.
  Summary steady;
  for (unsigned int i = 0; i < 14; ++i)
    steady.add({"final velocity x", 0.1 * i, "m/s", "point " + std::to_string(i)});
  print(steady);

  // Waves by theory alone have no column of simulated ones.
  Summary theory;
  theory.add({"theoretical wave speed", 8.869, "m/s", "stations"});
  print(theory);

  // A material: its moduli at the fundamental frequency and those of the tests.
  Summary material;
  material.add({"storage modulus", 1.147588e6, "Pa", "wall"});
  material.add({"loss modulus", 8.493e4, "Pa", "wall"});
  material.add({"tan delta", 0.0740074, "1", "wall"});
  material.add({"mean modulus", 1.279198e6, "Pa", "wall"});
  material.add({"final stress", 30030.04, "Pa", "relaxation"});
  material.add({"storage modulus", 1.042584e6, "Pa", "harmonic at 0.1 Hz"});
  material.add({"loss modulus", 7.593944e4, "Pa", "harmonic at 0.1 Hz"});
  material.add({"tan delta", 0.07283774, "1", "harmonic at 0.1 Hz"});
  material.add({"storage modulus of the law", 1.042501e6, "Pa", "harmonic at 0.1 Hz"});
  print(material);

  // Neither probes nor waves: what there is, twelve of them; of vibrations the frequencies.
  Summary coating;
  coating.add({"volume of solution", 1.03e-5, "m^3", ""});
  coating.add({"smallest speed", 0.5, "m/s", "trolley"});
  print(coating);
  Summary modes;
  modes.add({"mode 1 frequency", 3.3627, "Hz", ""});
  modes.add({"mode 1 share of mass along x", 0.25, "1", ""});
  print(modes);
  for (unsigned int i = 2; i < 20; ++i)
    modes.add({"mode " + std::to_string(i) + " frequency", 10. * i, "Hz", ""});
  check::equal("rows of many", answer_lines(modes).back(), "  and 7 more in summary.json");
}
} // namespace test_of_answer
