#include "../unit_test.h"

#include <continua/base/input_error.h>
#include <continua/signal/time_table.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace test_of_time_table
{
using namespace Continua;

namespace
{
const std::string path = "time-table-test.csv";

using Outside = TimeTable::Outside;

TimeTable table(const std::string &content,
                const TimeTable::Reading &reading = {},
                const std::string &column = "",
                const Dimension &dimension = Dimensions::pressure)
{
  std::ofstream(path, std::ios::binary) << content;
  return TimeTable(path, dimension, reading, column);
}

TimeTable::Reading after(const Outside outside, const double offset = 0.)
{
  TimeTable::Reading reading;
  reading.after = outside;
  reading.offset = offset;
  return reading;
}

void refused(const std::string &name,
             const std::string &content,
             const std::string &pattern,
             const std::string &column = "")
{
  check::throws<InputError>(
      name, [&]() { table(content, {}, column); }, pattern);
}

void test_formats()
{
  const std::string rows = "0, 1\n100, 3\n200, 2\n";
  const TimeTable plain = table("# measured\n\ntime [ms], pressure [kPa]\n# more\n" + rows);
  check::relative("at a row", plain(0.1), 3000., 1e-14);
  check::relative("between rows", plain(0.05), 2000., 1e-14);
  check::relative("before", plain(-1.), 1000., 1e-14);
  check::relative("last row", plain(0.2), 2000., 1e-14);
  check::relative("after", plain(7.), 2000., 1e-14);
  check::absolute("first time", plain.first_time(), 0., 0.);
  check::relative("last time", plain.last_time(), 0.2, 1e-14);

  check::relative("byte order mark and carriage returns",
                  table("\xEF\xBB\xBFtime [s],p [Pa]\r\n0,1\r\n2,+5e0\r\n")(1.), 3., 1e-14);
  check::relative("semicolons", table("t [s];p [Pa]\n0;1\n2;5")(1.), 3., 1e-14);
  check::relative("tabs", table("t [s]\tp [Pa]\n0\t1\n2\t5\n")(1.), 3., 1e-14);
  check::relative("blanks", table("t [s]  p [Pa]\n 0   1 \n 2 5\n")(1.), 3., 1e-14);
  check::relative("blanks in a unit", table("t [s] v [N / m^2]\n0 1\n2 5\n")(1.), 3., 1e-14);
  check::relative("quotes", table("\"t [s]\",\"p [Pa]\"\n0,1\n2,5\n")(1.), 3., 1e-14);
  const std::string three = "t [s], flow [l/min], p [Pa], note\n0, 1, 2, a\n1, 6, 4, b\n";
  check::relative("chosen column", table(three, {}, "p")(0.5), 3., 1e-14);
  check::relative("chosen flow rate", table(three, {}, "flow", Dimensions::flow_rate)(1.), 1e-4,
                  1e-14);
  check::relative("factor without unit",
                  table("t [s], factor\n0, 1\n1, 3\n", {}, "", Dimensions::none)(0.5), 2., 1e-14);
}

void test_continuation()
{
  const std::string content = "t [s], p [Pa]\n1, 10\n2, 20\n3, 10\n";
  const TimeTable zero = table(content, after(Outside::zero, 5.));
  check::relative("offset", zero(1.5), 20., 1e-14);
  check::relative("offset before", zero(0.), 15., 1e-14);
  check::relative("zero at the end", zero(3.), 15., 1e-14);
  check::absolute("zero after", zero(3.001), 0., 0.);
  const TimeTable repeat = table(content, after(Outside::repeat, 5.));
  check::relative("repeated", repeat(9.5), 20., 1e-13);
  check::relative("repeated at the seam", repeat(5.), 15., 1e-13);
  const TimeTable jump = table("t [s], p [Pa]\n0, 1\n1, 3\n", after(Outside::repeat));
  check::relative("before the jump", jump(1.), 3., 1e-13);
  check::relative("after the jump", jump(1.25), 1.5, 1e-13);
  check::relative("size of the jump", jump.jump(), 1., 1e-14);
  check::absolute("no jump", repeat.jump(), 0., 0.);
}

/// A cosine at 30 phases of a beat of 0.6 s, as they are published: from 0 to 0.58 s.
void test_period()
{
  const auto beat = [](const double time)
  { return std::cos(2. * dealii::numbers::PI * time / 0.6); };
  std::string rows = "t [s], p [Pa]\n";
  for (int i = 0; i < 30; ++i)
    rows += std::to_string(i * 0.02) + ", " + std::to_string(beat(i * 0.02)) + "\n";
  TimeTable::Reading reading;
  reading.before = reading.after = Outside::repeat;
  check::relative("period without a word", table(rows, reading).period(), 0.58, 1e-12);
  reading.period = 0.6;
  for (const TimeTable::Interpolation kind :
       {TimeTable::Interpolation::linear, TimeTable::Interpolation::cubic})
  {
    reading.interpolation = kind;
    const TimeTable given = table(rows, reading);
    double largest_error = 0.;
    for (int i = -600; i <= 1800; ++i)
      largest_error = std::max(largest_error, std::abs(given(i * 1e-3) - beat(i * 1e-3)));
    // Of chords 0.02 s long: (2 pi 0.02/0.6)^2/8.
    check::absolute("three beats before and after", largest_error, 0., 6e-3);
    check::absolute("the first value follows the last", given(0.59), 0.5 * (1. + beat(0.58)), 6e-3);
  }
  check::relative("period", table(rows, reading).period(), 0.6, 1e-14);

  reading.interpolation = TimeTable::Interpolation::linear;
  reading.factor = -2.;
  reading.offset = 1.;
  reading.shift = 0.15;
  const TimeTable turned = table(rows, reading);
  check::relative("factor, offset and shift", turned(0.15 + 0.08), 1. - 2. * beat(0.08), 1e-5);
  check::relative("shifted, before its first row", turned(0.07), 1. - 2. * beat(-0.08), 1e-5);
  check::relative("first time", turned.first_time(), 0.15, 1e-14);
  check::relative("last time", turned.last_time(), 0.73, 1e-14);

  const std::string late = "t [ms], p [Pa]\n5, 1\n6, 0\n";
  TimeTable::Reading before;
  before.before = Outside::zero;
  check::absolute("zero before", table(late, before)(0.0049), 0., 0.);
  check::relative("from the first row on", table(late, before)(0.0055), 0.5, 1e-12);
  before.before = Outside::nothing;
  check::is_true("nothing before", std::isnan(table(late, before)(0.0049)));

  reading.period = 0.57;
  check::throws<InputError>(
      "period shorter than the table", [&] { table(rows, reading); },
      ":31: .*0.58 s later.*0.57 s.*longer 'Table period'");
}

void test_cubic()
{
  TimeTable::Reading cubic;
  cubic.interpolation = TimeTable::Interpolation::cubic;
  const TimeTable line = table("t [s], p [Pa]\n0, 1\n1, 3\n1.5, 4\n4, 9\n", cubic);
  check::relative("straight line", line(0.3), 1.6, 1e-14);
  check::relative("straight line, long interval", line(3.3), 7.6, 1e-14);
  check::relative("two rows", table("t [s], p [Pa]\n0, 1\n1, 3\n", cubic)(0.25), 1.5, 1e-14);

  // (t - 1)^2 on rows 0.1 apart: errors of the order of 0.1^2 next to the vertex, 0.1^3 further
  // away.
  std::string rows = "t [s], p [Pa]\n";
  for (int i = 0; i <= 20; ++i)
    rows += std::to_string(i / 10.) + ", " + std::to_string((i / 10. - 1.) * (i / 10. - 1.)) + "\n";
  const TimeTable parabola = table(rows, cubic);
  check::absolute("parabola", parabola(1.55), 0.3025, 2e-4);
  check::absolute("parabola at the end", parabola(1.95), 0.9025, 2e-4);
  check::absolute("parabola near the vertex", parabola(1.05), 0.0025, 2.6e-3);

  // A pulse with a plateau: neither over nor under it.
  const TimeTable pulse =
      table("t [s], p [Pa]\n0, 0\n1, 0\n1.1, 8\n2, 10\n3, 10\n3.1, 0\n4, 0\n", cubic);
  double lowest = std::numeric_limits<double>::max();
  double highest = -lowest;
  double decrease = 0.;
  for (int i = 0; i <= 4000; ++i)
  {
    const double value = pulse(i * 1e-3);
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
    if (i <= 2000 && i > 0)
      decrease = std::max(decrease, pulse((i - 1) * 1e-3) - value);
  }
  check::absolute("no undershoot", lowest, 0., 1e-14);
  check::absolute("no overshoot", highest, 10., 1e-14);
  check::absolute("rises monotonously", decrease, 0., 1e-14);
  const double step = 1e-5;
  check::absolute("smooth at a row", (pulse(1.1 + step) - pulse(1.1)) / step,
                  (pulse(1.1) - pulse(1.1 - step)) / step, 0.1);

  cubic.after = Outside::repeat;
  const TimeTable periodic = table("t [s], p [Pa]\n0, 0\n1, 2\n2, 0\n3, -2\n4, 0\n", cubic);
  check::relative("slope across the seam",
                  (periodic(4. + step) - periodic(4. - step)) / (2. * step), 2., 1e-4);
  check::relative("period", periodic(8.3), periodic(0.3), 1e-12);
}

void test_refusals()
{
  const std::string header = "time [ms], pressure [mmHg]\n";
  std::filesystem::remove(path);
  check::throws<InputError>(
      "missing file",
      []() { TimeTable("no-such-file.csv", Dimensions::pressure, TimeTable::Reading()); },
      "no-such-file.csv: .*does not exist");
  refused("empty file", "", "time-table-test.csv: .*is empty");
  refused("header as a comment", "# time [ms]\n0\n1\n", ":1: .*one column.*#");
  refused("numbers as a header", "0, 1\n1, 2\n",
          ":1: the table has no header.*Insert a line such as 'time \\[ms\\], pressure "
          "\\[mmHg\\]'.*above this line");
  refused("no unit of time", "time, pressure [Pa]\n0, 1\n1, 2\n",
          ":1: .*time.*no unit.*time \\[UNIT\\]");
  refused("no unit", "time [s], pressure\n0, 1\n1, 2\n", ":1: .*pressure.*no unit.*Pa");
  refused("unknown unit", "time [s], pressure [foo]\n0, 1\n", ":1: .*pressure.*foo");
  refused("unit of wrong dimension", "time [s], pressure [mm]\n0, 1\n", ":1: .*pressure.*mm.*Pa");
  refused("time of wrong dimension", "time [mm], pressure [Pa]\n0, 1\n", ":1: .*time.*mm");
  refused("several columns", "t [s], p [Pa], q [Pa]\n0, 1, 2\n", ":1: .*'p', 'q'.*Column");
  refused("missing column", header + "0, 1\n", ":1: .*velocity.*'pressure'", "velocity");
  refused("same name", "t [s], p [Pa], p [Pa]\n0, 1, 2\n", ":1: .*p.*two columns", "p");
  refused("empty cell", header + "0, 1\n1,\n", ":3: .*pressure.*missing");
  refused("missing cell", header + "0, 1\n\n1\n", ":4: .*1 cells, the header 2");
  refused("extra cell", header + "0, 1\n1, 2, 3\n", ":3: .*3 cells, the header 2");
  refused("decimal comma", "t [s]; p [Pa]\n0; 1,5\n", ":2: .*p.*'1,5'.*decimal comma");
  refused("not a number", header + "0, 1\n1, nan\n", ":3: .*pressure.*value is missing");
  refused("equal times", header + "0, 1\n1, 2\n1, 3\n", ":4: .*time.*1 is not later");
  refused("one row", header + "0, 1\n", "time-table-test.csv: .*1 rows.*2 at least");
  std::filesystem::remove(path);
}
} // namespace

UNIT_TEST(time_table)
{
  test_formats();
  test_continuation();
  test_period();
  test_cubic();
  test_refusals();
}
} // namespace test_of_time_table
