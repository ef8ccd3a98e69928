// Vectors from tables and pulses, with and without a prefix; a table that ends before the run: what
// is said of it, and when nothing is.

#include <continua/base/parameter_file.h>
#include <continua/signal/waveform.h>

#include "../unit_test.h"

#include <filesystem>
#include <fstream>

using namespace Continua;

namespace
{
/// The warning in a run to 2 s, with more entries.
std::string warning(const std::string &entries, const double end_time = 2.)
{
  const std::string path = "waveform-test.prm";
  std::ofstream("waveform-test.csv") << "time [s], p [Pa]\n0, 0\n1, 5\n";
  std::ofstream(path) << "set Waveform = table\nset Table = waveform-test.csv\n" + entries;
  ParameterFile file(path);
  ParameterSection root = file.root();
  const Waveform waveform =
      Waveform::read(root, "Pressure", Dimensions::pressure, "A pressure.", true);
  std::filesystem::remove(path);
  std::filesystem::remove("waveform-test.csv");
  return waveform.table_warning(end_time);
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
} // namespace

UNIT_TEST(waveform)
{
  test_vectors();
  check::equal(
      "held without a word", warning(""),
      "the table 'waveform-test.csv' ends at t = 1 s, the run at 2 s: its last value holds "
      "in between. Set 'After the table' to hold, repeat or zero");
  check::equal("as long as the run", warning("", 1.), "");
  for (const char *const after : {"hold", "repeat", "zero"})
    check::equal(after, warning("set After the table = " + std::string(after) + "\n"), "");
  check::equal("no table", Waveform(3.).table_warning(2.), "");
}
