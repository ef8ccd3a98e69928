// The lines of the section Expected.

#include <continua/base/expected_value.h>
#include <continua/base/parameter_file.h>

#include "../unit_test.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace test_of_expected_value
{
using namespace Continua;

namespace
{
void refused(const std::string &name,
             const std::string &key,
             const std::string &text,
             const std::string &pattern)
{
  check::throws<std::invalid_argument>(
      name, [&]() { parse_expected_value(key, text); }, pattern);
}
} // namespace

UNIT_TEST(expected_value)
{
  const ExpectedValue frequency = parse_expected_value("frequency", "3.3624 Hz +- 0.2 %");
  check::equal("name", frequency.name, "frequency");
  check::equal("any probe", frequency.probe, "");
  check::absolute("value", frequency.value, 3.3624, 0.);
  check::equal("unit", frequency.unit, "Hz");
  check::relative("relative tolerance", frequency.tolerance, 0.0067248, 1e-14);
  check::equal("tolerance as written", frequency.tolerance_text, "0.2 %");
  check::equal("value as written", frequency.value_text, "3.3624 Hz");
  check::is_true("no bound", !frequency.upper_bound && !frequency.lower_bound);

  const ExpectedValue tip = parse_expected_value("tip:  maximum displacement", " 0.605 m+-2 mm ");
  check::equal("probe", tip.probe, "tip");
  check::equal("name behind a probe", tip.name, "maximum displacement");
  check::relative("tolerance in another unit", tip.tolerance, 0.002, 1e-14);

  const ExpectedValue negative = parse_expected_value("pressure", "-80 mmHg +- 1e-1 %");
  check::absolute("negative value", negative.value, -80., 0.);
  check::relative("tolerance of a negative value", negative.tolerance, 0.08, 1e-14);
  check::absolute("tolerance in the value's unit",
                  parse_expected_value("c", "11 m/s +- 0.5").tolerance, 0.5, 0.);
  check::absolute("exact value", parse_expected_value("steps", "+100 +- 0").tolerance, 0., 0.);
  check::absolute("zero", parse_expected_value("drift", "0 mm +- 0.1 mm").tolerance, 0.1, 1e-15);

  const ExpectedValue upper = parse_expected_value("energy residual", "< 1e-9");
  check::is_true("upper bound", upper.upper_bound && !upper.lower_bound);
  check::absolute("upper bound's value", upper.value, 1e-9, 0.);
  check::equal("upper bound as written", upper.value_text, "1e-9");
  const ExpectedValue lower = parse_expected_value("order", ">2.9");
  check::is_true("lower bound", lower.lower_bound && !lower.upper_bound);
  check::absolute("lower bound's value", lower.value, 2.9, 0.);

  refused("no tolerance", "frequency", "3 Hz", "tolerance is missing");
  refused("bound with a tolerance", "frequency", "< 3 Hz +- 1 Hz", "bound has no tolerance");
  refused("% of zero", "drift", "0 m +- 1 %", "% of the value 0");
  refused("no number", "frequency", "fast +- 1 %", "value 'fast'");
  refused("not finite", "frequency", "nan +- 1 %", "value 'nan'");
  refused("nothing", "frequency", "", "tolerance is missing");
  refused("no value", "frequency", "+- 1 %", "value ''");
  refused("empty bound", "frequency", "<", "value ''");
  refused("no number in the tolerance", "frequency", "3 Hz +- some", "tolerance 'some'");
  refused("negative tolerance", "frequency", "3 Hz +- -1 Hz", "tolerance is negative");
  refused("unknown unit", "frequency", "3 Hzz +- 1 %", "Hzz");
  refused("tolerance of another dimension", "frequency", "3 Hz +- 1 mm", "'mm'.*dimension.*'Hz'");
  refused("only the tolerance has a unit", "frequency", "3 +- 1 mHz", "value has none");
  refused("empty probe", ": frequency", "3 +- 1", "PROBE: QUANTITY");
  refused("empty name", "tip:", "3 +- 1", "PROBE: QUANTITY");

  // The section of a file, in its order.
  const std::string file = "expected-value-test.prm";
  std::ofstream(file) << "subsection Expected\n"
                         "  set tip: frequency = 3.3624 Hz +- 0.2 %  # measured\n"
                         "  set energy residual = < 1e-9\n"
                         "end\n";
  {
    ParameterFile parameters(file);
    const std::vector<ExpectedValue> all = read_expected(parameters.root().subsection("Expected"));
    check::is_true("section", all.size() == 2 && all[0].probe == "tip" &&
                                  all[0].name == "frequency" && all[1].name == "energy residual" &&
                                  all[1].upper_bound);
    parameters.refuse_unknown();
  }
  std::ofstream(file) << "set Title = x\n";
  {
    ParameterFile parameters(file);
    check::is_true("no section", read_expected(parameters.root().subsection("Expected")).empty());
  }
  std::ofstream(file) << "subsection Expected\n"
                         "  set frequency = 3 Hz +- 1 %\n"
                         "  set drift = 0 m +- 1 %\n"
                         "end\n";
  {
    ParameterFile parameters(file);
    check::throws<InputError>(
        "file, line, key, problem and remedy",
        [&parameters]() { read_expected(parameters.root().subsection("Expected")); },
        "expected-value-test.prm:3: 'Expected/drift': .*% of the value 0.*Write for example");
  }
  std::filesystem::remove(file);
}
} // namespace test_of_expected_value
