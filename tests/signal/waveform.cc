#include "../unit_test.h"

#include <continua/base/parameter_file.h>
#include <continua/signal/jump.h>
#include <continua/signal/waveform.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

using namespace Continua;

namespace
{
const std::string prm = "waveform-test.prm";
const std::string csv = "waveform-test.csv";
const double point[3] = {1., 0., 0.};
const std::string by_file = "set Waveform = table\n set Table = " + csv + "\n";

Waveform read(const std::string &entries, const bool required = false)
{
  std::ofstream(prm) << "subsection Load\n" << entries << "end\n";
  ParameterFile file(prm);
  ParameterSection section = file.root().subsection("Load");
  const Waveform waveform =
      Waveform::read(section, "Pressure", Dimensions::pressure, "The pressure.", required);
  file.refuse_unknown();
  return waveform;
}

/// A step finds no jump, wherever the steps lie to the pulse.
bool never_jumps(const Waveform &waveform, const double step, const double end)
{
  const auto function = [&waveform](const double time) { return waveform(point, time); };
  for (unsigned int i = 0; i * step < end; ++i)
    for (const double shift : {-1e-6, -1e-7, 0., 1e-7, 0.37})
      if (jumps_within(function, (i + shift) * step, (i + shift + 1. - 2e-6) * step))
        return false;
  return true;
}

void refused(const std::string &name, const std::string &entries, const std::string &pattern)
{
  check::throws<InputError>(
      name, [&entries]() { read(entries, true); }, pattern);
}
} // namespace

UNIT_TEST(waveform)
{
  std::ofstream(csv) << "time [s], a [kPa], b [kPa]\n0, 1, 4\n1, 3, 0\n2, 1, 4\n";

  check::is_true("default", Waveform().is_zero() && read("").is_zero());
  check::absolute("constant", Waveform(3.)(point, 0.), 3., 0.);
  check::absolute("expression", Waveform(Expression("x+t", Dimensions::none))(point, 2.), 3., 0.);
  const Waveform formula = read("set Pressure = x*1e3*t\n", true);
  check::relative("formula", formula(point, 0.5), 500., 1e-14);
  check::is_true("formula depends", formula.depends_on_time() && formula.depends_on_space());
  const Waveform quantity = read("set Waveform = formula\n set Pressure = 2 kPa\n");
  check::relative("quantity", quantity(point, 0.5), 2000., 1e-14);
  check::is_true("quantity does not depend", !quantity.depends_on_time() &&
                                                 !quantity.depends_on_space() &&
                                                 !quantity.is_zero());

  const Waveform table = read(by_file + "set Column = a\n", true);
  check::relative("table", table(point, 0.5), 2000., 1e-14);
  check::relative("table held", table(point, 5.), 1000., 1e-14);
  check::is_true("table depends",
                 table.depends_on_time() && !table.depends_on_space() && !table.is_zero());
  const Waveform full = read(by_file + "set Column = b\n set Interpolation = cubic\n"
                                       "set Offset = 1 kPa\n set After the table = repeat\n");
  const Waveform copy = full;
  // Half-way between rows with level slopes.
  check::relative("table with all entries", copy(point, 2.5), 3000., 1e-12);
  const Waveform zero =
      read(by_file + "set Column = b\n set Offset = 1 kPa\n set After the table = zero\n");
  check::absolute("zero after the table", zero(point, 2.5), 0., 0.);

  const Waveform pulse = read("set Waveform = sine squared pulse\n set Amplitude = 2 kPa\n"
                              "set Duration = 50 ms\n set Start = 10 ms\n",
                              true);
  check::absolute("sine squared: before", pulse(point, 0.0099), 0., 0.);
  check::relative("sine squared: peak", pulse(point, 0.035), 2000., 1e-14);
  check::relative("sine squared: half", pulse(point, 0.0225), 1000., 1e-12);
  check::absolute("sine squared: after", pulse(point, 0.0601), 0., 0.);
  check::is_true("sine squared depends",
                 pulse.depends_on_time() && !pulse.depends_on_space() && !pulse.is_zero());
  const Waveform gaussian = read("set Waveform = gaussian pulse\n set Amplitude = -3\n"
                                 "set Time of the peak = 20 ms\n set Width = 5 ms\n");
  check::relative("gaussian: peak", gaussian(point, 0.02), -3., 1e-14);
  check::relative("gaussian: at the width", gaussian(point, 0.025), -3. * std::exp(-1.), 1e-12);
  check::relative("gaussian: at the start", gaussian.initial_value(point), -3. * std::exp(-16.),
                  1e-12);

  // sin^2 of a quarter of a turn.
  const Waveform ramped = read("set Pressure = 4 kPa\n set Ramp = 20 ms\n", true);
  check::relative("ramp: half-way", ramped(point, 0.01), 2000., 1e-12);
  check::relative("ramp: over", ramped(point, 0.03), 4000., 0.);
  check::is_true("ramp: depends on time",
                 ramped.depends_on_time() && !Waveform(4.).depends_on_time());
  check::absolute("ramp: from zero", ramped.initial_value(point), 0., 0.);
  const Waveform ramped_table = read(by_file + "set Column = b\n set Ramp = 1 s\n");
  check::relative("ramp of a table", ramped_table(point, 0.5), 1000., 1e-12);
  check::absolute("initial value", full.initial_value(point), 5000., 1e-9);

  check::is_true("no jump: sine squared", never_jumps(pulse, 2e-4, 0.07));
  check::is_true("no jump: sine squared in long steps", never_jumps(pulse, 7e-3, 0.07));
  check::is_true("no jump: gaussian", never_jumps(gaussian, 2e-4, 0.07));
  check::is_true("no jump: ramp", never_jumps(ramped, 3e-3, 0.07));
  // The smallest step that can be told from it.
  check::is_true(
      "a jump is found beside a ramp",
      !never_jumps(read("set Pressure = 1e3*step(t-0.0301)\n set Ramp = 50 ms\n"), 3e-3, 0.07));

  {
    std::ofstream(prm) << "subsection Load\n set Waveform = sine squared pulse\n"
                          "set Amplitude = 2\n set Duration = 2\n set Direction = 0.6, -x\n"
                          "set Ramp = 2\n end\n";
    ParameterFile file(prm);
    ParameterSection section = file.root().subsection("Load");
    const auto vector =
        Waveform::read_vector(section, "Traction", 2, Dimensions::pressure, "The traction.");
    // sin^2(pi/4) twice.
    check::relative("vector: first component", vector[0](point, 0.5),
                    0.6 * 2. * 0.5 * std::pow(std::sin(M_PI / 8.), 2), 1e-12);
    check::relative("vector: depends on place", vector[1](point, 1.), -1., 1e-12);
  }

  refused("missing", "", "waveform-test.prm.*Pressure.*missing");
  refused("both", by_file + "set Pressure = 1 Pa\n",
          "waveform-test.prm:4: .*Pressure.*Waveform = table.*Remove");
  refused("table without the choice", "set Table = " + csv + "\n", ":2: .*Table.*Waveform = table");
  refused("no table", "set Waveform = table\n", "waveform-test.prm.*Table.*missing");
  refused("missing table", "set Waveform = table\n set Table = no.csv\n", ":3: .*Table.*no.csv");
  refused("no column chosen", by_file, "waveform-test.csv:1: .*'a', 'b'.*Column");
  refused("unknown kind", "set Waveform = tabel\n", ":2: .*Waveform");
  refused("wrong unit", "set Pressure = 1 mm\n", ":2: .*Pressure.*mm");
  const std::string by_pulse = "set Waveform = sine squared pulse\n set Amplitude = 1 Pa\n";
  refused("pulse without duration", by_pulse, "Duration.*missing");
  refused("pulse with a formula", by_pulse + "set Duration = 1\n set Pressure = 1\n",
          ":5: .*Pressure.*sine squared pulse.*Remove");
  refused("width of another pulse", by_pulse + "set Duration = 1\n set Width = 1\n",
          ":5: .*Width.*gaussian pulse' only");
  refused("table of a pulse", by_pulse + "set Duration = 1\n set Table = x\n",
          ":5: .*Table.*Waveform = table");
  refused("amplitude of a formula", "set Pressure = 1\n set Amplitude = 1\n",
          ":3: .*Amplitude.*sine squared pulse' or 'Waveform = gaussian pulse'");
  refused("no duration", by_pulse + "set Duration = 0 s\n", ":4: .*Duration");
  refused("negative ramp", "set Pressure = 1\n set Ramp = -1 s\n", ":3: .*Ramp");
  refused("direction of a number", by_pulse + "set Duration = 1\n set Direction = 1, 0\n",
          ":5: .*Direction.*not a vector");
  std::filesystem::remove(prm);
  std::filesystem::remove(csv);
}
