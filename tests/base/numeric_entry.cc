// Numbers of a parameter file by their paths.

#include <continua/base/input_error.h>
#include <continua/base/numeric_entry.h>

#include "../unit_test.h"

#include <cmath>
#include <stdexcept>

namespace test_of_numeric_entry
{
using namespace Continua;

namespace
{
struct Wall
{
  double modulus = 1e6, density = std::nan("");
  std::vector<double> moduli = {3e4, 2e4};
  std::vector<double> none;
  unsigned int cells = 4;
  std::string name = "latex";

  void read(ParameterSection root)
  {
    ParameterSection wall = root.subsection("Materials").subsection("wall");
    wall.add("Young's modulus", modulus, Dimensions::pressure, "Of the wall.", Range::positive());
    wall.add("Density", density, Dimensions::density, "Of the wall.");
    wall.add("Shear moduli", moduli, Dimensions::pressure, "Of the branches.", Range::positive());
    wall.add("Relaxation times", none, Dimensions::time, "Of the branches.");
    root.subsection("Mesh").add("Cells 2", cells, "Across.", 1, 8);
    wall.add("Name", name, "Of the wall.");
  }
};
} // namespace

UNIT_TEST(numeric_entry)
{
  ParameterFile file("", {"Materials/wall/Young's modulus=1.2 MPa",
                          "Materials/wall/Shear moduli=30 kPa, 25 kPa, 20 kPa"});
  Wall wall;
  wall.read(file.root());
  const ParameterSection section = file.root().subsection("Identification");
  const auto find = [&](const std::string &path)
  { return NumericEntry(file, path, section, "Parameters"); };

  const NumericEntry modulus = find("Materials / wall/Young's  modulus");
  check::equal("path", modulus.path(), "Materials/wall/Young's modulus");
  check::equal("unit", modulus.unit(), "Pa");
  check::absolute("value", modulus.value(), 1.2e6, 0.);
  check::is_true("range", !modulus.accepts(0.) && modulus.accepts(1.) &&
                              !modulus.accepts(std::nan("")) && modulus.range().lower == 0.);
  check::is_true("no value", std::isnan(find("Materials/wall/Density").value()));

  const NumericEntry first = find("Materials/wall/Shear moduli 1"),
                     third = find("Materials/wall/Shear moduli 3");
  check::equal("path with a place", third.path(), "Materials/wall/Shear moduli 3");
  check::equal("path without it", third.path_of_entry(), "Materials/wall/Shear moduli");
  check::absolute("value in a list", third.value(), 2e4, 0.);
  const NumericEntry cells = find("Mesh/Cells 2");
  check::is_true("whole number whose name ends with one",
                 cells.is_integer() && cells.value() == 4. && cells.accepts(8.) &&
                     !cells.accepts(2.5) && !cells.accepts(9.));

  const auto settings =
      NumericEntry::settings({third, modulus, first, cells}, {1.5e4, 1.3e6, 1. / 3., 5.});
  check::is_true("a setting for each entry", settings.size() == 3);
  check::equal("of a list", settings[0].first + "=" + settings[0].second,
               "Materials/wall/Shear moduli=0.3333333333333333 Pa, 25000 Pa, 15000 Pa");
  check::equal("of a number", settings[1].first + "=" + settings[1].second,
               "Materials/wall/Young's modulus=1300000 Pa");
  check::equal("of a whole number", settings[2].first + "=" + settings[2].second, "Mesh/Cells 2=5");
  std::vector<std::string> overrides;
  for (const auto &[path, text] : settings)
    overrides.push_back(path + "=" + text);
  ParameterFile changed("", overrides);
  Wall of_changed;
  of_changed.read(changed.root());
  check::absolute("read again", of_changed.moduli[0], 1. / 3., 0.);
  check::throws<std::invalid_argument>(
      "twice",
      [&]() {
        NumericEntry::settings({first, third, first}, {1., 1., 1.});
      },
      "Shear moduli 1' is named twice");

  const auto refused = [&](const std::string &path, const std::string &pattern)
  {
    check::throws<InputError>(
        path, [&]() { find(path); }, pattern);
  };
  refused("Materials/wall/Young modulus", "Did you mean 'Materials/wall/Young's modulus'");
  refused("Nothing of the kind", "has no entry 'Nothing of the kind'. Give the path of a number");
  refused("Materials/wall/Name", "is no number, but text");
  refused("Materials/wall/Shear moduli", "is a list of 3 numbers.*Shear moduli 1'");
  refused("Materials/wall/Shear moduli 4", "has 3 numbers. Give a place from 1 to 3");
  refused("Materials/wall/Shear moduli 0", "is a list of 3 numbers");
  refused("Materials/wall/Relaxation times 1", "has 0 numbers. Give the list first");
  refused("Materials/wall/Young's modulus 1", "is one number, not a list");
}
} // namespace test_of_numeric_entry
