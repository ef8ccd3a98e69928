#include "../check.h"

#include <continua/base/parameter_file.h>
#include <continua/signal/waveform.h>

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

void refused(const std::string &name, const std::string &entries, const std::string &pattern)
{
  check::throws<InputError>(
      name, [&entries]() { read(entries, true); }, pattern);
}
} // namespace

int main()
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

  refused("missing", "", "waveform-test.prm.*Pressure.*missing");
  refused("both", by_file + "set Pressure = 1 Pa\n",
          "waveform-test.prm:4: .*Pressure.*Waveform = table.*Remove");
  refused("table without the choice", "set Table = " + csv + "\n", ":2: .*Table.*Waveform = table");
  refused("no table", "set Waveform = table\n", "waveform-test.prm.*Table.*missing");
  refused("missing table", "set Waveform = table\n set Table = no.csv\n", ":3: .*Table.*no.csv");
  refused("no column chosen", by_file, "waveform-test.csv:1: .*'a', 'b'.*Column");
  refused("unknown kind", "set Waveform = tabel\n", ":2: .*Waveform");
  refused("wrong unit", "set Pressure = 1 mm\n", ":2: .*Pressure.*mm");
  std::filesystem::remove(prm);
  std::filesystem::remove(csv);
}
