// Vectors from tables and pulses, with and without a prefix; a table that ends before the run: what
// is said of it, and when nothing is; means over a period.

#include <continua/base/parameter_file.h>
#include <continua/signal/waveform.h>

#include "../unit_test.h"

#include <filesystem>
#include <fstream>

namespace test_of_waveform
{
using namespace Continua;

namespace
{
/// Of a table of pressures, with more entries.
Waveform of_table(const std::string &entries, const std::string &rows)
{
  const std::string path = "waveform-test.prm";
  std::ofstream("waveform-test.csv") << "time [s], p [Pa]\n" + rows;
  std::ofstream(path) << "set Waveform = table\nset Table = waveform-test.csv\n" + entries;
  ParameterFile file(path);
  ParameterSection root = file.root();
  const Waveform waveform =
      Waveform::read(root, "Pressure", Dimensions::pressure, "A pressure.", true);
  std::filesystem::remove(path);
  std::filesystem::remove("waveform-test.csv");
  return waveform;
}

/// What is said of a table in a run to 2 s, with more entries: a line for each sentence, and
/// "warning: " before those that warn.
std::string remarks(const std::string &entries,
                    const double end_time = 2.,
                    const std::string &rows = "0, 0\n1, 5\n")
{
  std::string text;
  for (const Waveform::Remark &remark : of_table(entries, rows).table_remarks(end_time))
    text.append(text.empty() ? "" : "\n")
        .append(remark.is_warning ? "warning: " : "")
        .append(remark.text);
  return text;
}
/// The components of a vector in the plane, from a table with two columns of forces.
std::vector<Waveform>
vector(const std::string &entries, const std::string &prefix, const bool required = true)
{
  const std::string path = "waveform-test.prm";
  std::ofstream("waveform-test.csv") << "time [s], a [kPa], b [Pa]\n0, 0, 0\n2, 4, 6\n";
  std::ofstream(path) << entries;
  ParameterFile file(path);
  ParameterSection root = file.root();
  // A scalar of the same section, whose entries have no prefix.
  if (!prefix.empty())
    Waveform::read(root, "Pressure", Dimensions::pressure, "A pressure.", false);
  const std::vector<Waveform> result = Waveform::read_vector(
      root, "Traction", 2, Dimensions::pressure, "A traction.", required, prefix);
  file.refuse_unknown();
  return result;
}

void refused(const std::string &name,
             const std::string &entries,
             const std::string &prefix,
             const std::string &pattern)
{
  check::throws<InputError>(
      name, [&]() { vector(entries, prefix); }, pattern);
}

void test_vectors()
{
  const double point[3] = {3., 0., 0.};
  const std::string table = "set Waveform = table\nset Table = waveform-test.csv\n";
  std::vector<Waveform> traction = vector(table + "set Columns = a, b\n", "");
  check::relative("column of x", traction[0](point, 1.), 2000., 1e-12);
  check::relative("column of y", traction[1](point, 1.), 3., 1e-12);
  traction = vector(table + "set Column = b\nset Direction = 2, x\n", "");
  check::relative("direction x", traction[0](point, 1.), 6., 1e-12);
  check::relative("direction y", traction[1](point, 1.), 9., 1e-12);

  traction = vector("set Pressure = 7\nset Tangential waveform = table\n"
                    "set Tangential table = waveform-test.csv\nset Tangential columns = b, a\n"
                    "set Tangential after the table = zero\n",
                    "Tangential");
  check::relative("with a prefix", traction[1](point, 1.), 2000., 1e-12);
  check::absolute("after the table", traction[1](point, 3.), 0., 0.);
  traction = vector("set Tangential waveform = sine squared pulse\nset Tangential amplitude = 2 "
                    "kPa\nset Tangential duration = 2 s\nset Tangential direction = 0, 1\n",
                    "Tangential");
  check::relative("a pulse with a prefix", traction[1](point, 1.), 2000., 1e-12);
  traction = vector("set Tangential waveform = sine squared pulse\nset Tangential amplitude = 2 "
                    "kPa\nset Tangential duration = 2 s\nset Tangential direction = 0, 1\n"
                    "set Tangential offset = 300 Pa\n",
                    "Tangential");
  check::relative("a pulse on a mean value", traction[1](point, 1.), 2300., 1e-12);
  check::relative("the mean value after it", traction[1](point, 3.), 300., 1e-12);
  check::is_true("not required", vector("", "Tangential", false)[0].is_zero());

  refused("required", "", "", "Traction");
  refused("one column too few", table + "set Columns = a\n", "",
          "waveform-test.prm:3: 'Columns': there are 1 columns for 2 components");
  refused("unknown column", table + "set Columns = a, c\n", "", "waveform-test.csv.*c");
  refused("columns and direction", table + "set Columns = a, b\nset Direction = 1, 1\n", "",
          "waveform-test.prm:4: 'Direction': is given as well as 'Columns'");
  refused("entry of the other waveform", "set Tangential columns = a, b\n", "Tangential",
          "'Tangential columns': is of use with 'Tangential waveform = table' only");
  refused("no direction",
          "set Tangential waveform = table\nset Tangential table = waveform-test.csv\n"
          "set Tangential column = a\n",
          "Tangential", "'Tangential direction'");
  std::filesystem::remove("waveform-test.prm");
  std::filesystem::remove("waveform-test.csv");
}

/// Means over the second period of 2 s.
void test_means()
{
  const double point[3] = {3., 0., 0.};
  const std::string table = "set Waveform = table\nset Table = waveform-test.csv\nset Column = b\n"
                            "set Direction = 1, x\n";
  // 0 to 6 Pa in 2 s, and again.
  std::vector<Waveform> traction = vector(table + "set After the table = repeat\n", "");
  check::relative("period of a table", traction[0].table_period(), 2., 1e-15);
  for (Waveform &component : traction)
    component.set_period(2., 4.);
  check::relative("mean of a table", traction[0](point, mean_over_period), 3., 1e-7);
  check::relative("mean of a table, by place", traction[1](point, mean_over_period), 9., 1e-7);
  check::relative("its value stays", traction[1](point, 3.), 9., 1e-12);
  traction = vector(table, "");
  check::absolute("no period of a table that is held", traction[0].table_period(), 0., 0.);

  // A ramp is no part of the mean; a formula of place and time is averaged at each point.
  traction = vector("set Traction = 5 + sin(pi*t), x*(1 + step(t - 3))\nset Ramp = 4 s\n", "");
  for (Waveform &component : traction)
    component.set_period(2., 4.);
  check::relative("mean of a formula", traction[0](point, mean_over_period), 5., 1e-10);
  check::relative("mean of a formula of place", traction[1](point, mean_over_period), 4.5, 1e-2);
  // A constant with a ramp has no shape over time but the ramp's.
  std::vector<Waveform> constant = vector("set Traction = 5, x\nset Ramp = 1 s\n", "");
  for (Waveform &component : constant)
    component.set_period(2., 4.);
  check::relative("mean of a constant with a ramp", constant[0](point, mean_over_period), 5.,
                  1e-15);
  check::relative("by place", constant[1](point, mean_over_period), 3., 1e-15);
  check::relative("the ramp stays", traction[0](point, 2.), 2.5, 1e-12);
  check::relative("of a constant without a period", Waveform(7.)(point, mean_over_period), 7., 0.);
  std::filesystem::remove("waveform-test.prm");
  std::filesystem::remove("waveform-test.csv");
}
} // namespace

UNIT_TEST(waveform)
{
  test_vectors();
  test_means();
  const std::string table = "the table 'waveform-test.csv'";
  check::equal("held without a word", remarks(""),
               "warning: " + table +
                   " ends at t = 1 s, the run at 2 s: its last value holds in between. Set 'After "
                   "the table' to hold, repeat or zero");
  check::equal("as long as the run", remarks("", 1.), "");
  for (const char *const after : {"hold", "zero"})
    check::equal(after, remarks("set After the table = " + std::string(after) + "\n"), "");
  const std::string repeat = "set After the table = repeat\n", closed = "0, 0\n1, 5\n1.5, 0\n";
  check::equal("the period of the rows", remarks(repeat, 2., closed),
               table + " repeats itself after 1.5 s, from its first to its last row");
  check::equal("another period", remarks(repeat + "set Table period = 1.8 s\n", 2., closed),
               table + " repeats itself after 1.8 s");
  check::equal("a row is missing", remarks(repeat),
               table +
                   " repeats itself after 1 s, from its first to its last row\nwarning: " + table +
                   " does not end with its first value, which follows its last row at once. Set "
                   "'Table period': 1 s if the value is to jump, the period if the row that closes "
                   "it is missing");
  check::equal("a jump that is meant", remarks(repeat + "set Table period = 1 s\n"),
               table + " repeats itself after 1 s");
  check::equal("a late begin without a word", remarks("set Table shift = 0.5 s\n", 1.),
               "warning: " + table +
                   " begins at t = 0.5 s: its first value holds from the start on. Set 'Before the "
                   "table' to hold, repeat or zero");
  for (const char *const before : {"hold", "repeat", "zero"})
    check::equal(
        std::string("before: ") + before,
        remarks("set Table shift = 0.5 s\nset Before the table = " + std::string(before) + "\n",
                1.),
        "");
  check::throws<InputError>(
      "a period of no repetition", [] { remarks("set Table period = 2 s\n"); },
      "'Table period'.*not repeated.*After the table = repeat");
  check::throws<InputError>(
      "a period shorter than the rows", [&] { remarks(repeat + "set Table period = 0.9 s\n"); },
      "waveform-test.csv:3: .*1 s later.*0.9 s.*longer 'Table period'");
  check::is_true("no table", Waveform(3.).table_remarks(2.).empty());

  const auto jumps = [](const std::string &entries, const std::string &rows)
  { return of_table(entries, rows).table_begins_with_jump(); };
  check::is_true("a table of absolute pressures jumps", jumps("", "0, 80\n1, 120\n"));
  check::is_true("but not from its value at rest",
                 !jumps("set Offset = -80 Pa\n", "0, 80\n1, 120\n"));
  check::is_true("nor with a ramp", !jumps("set Ramp = 0.1 s\n", "0, 80\n1, 120\n"));
  check::is_true("nor by the noise of a record", !jumps("", "0, 1\n1, 100\n"));
  check::is_true("a twentieth is none", !jumps("", "0, 5\n1, 105\n"));
  check::is_true("more is one", jumps("", "0, 5.1\n1, 105\n"));
  check::is_true("a constant does not jump", !Waveform(3.).table_begins_with_jump());
}
} // namespace test_of_waveform
