// A table that ends before the run: what is said of it, and when nothing is.

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
} // namespace

UNIT_TEST(waveform)
{
  check::equal(
      "held without a word", warning(""),
      "the table 'waveform-test.csv' ends at t = 1 s, the run at 2 s: its last value holds "
      "in between. Set 'After the table' to hold, repeat or zero");
  check::equal("as long as the run", warning("", 1.), "");
  for (const char *const after : {"hold", "repeat", "zero"})
    check::equal(after, warning("set After the table = " + std::string(after) + "\n"), "");
  check::equal("no table", Waveform(3.).table_warning(2.), "");
}
