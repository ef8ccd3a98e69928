// Relaxation tests whose c and n are known: tables made from the law, from the exact answer to a
// strain that rises evenly, and with a known misfit. And what is refused.

#include <continua/materials/material.h>
#include <continua/materials/relaxation_test.h>

#include "../parameter_text.h"
#include "../unit_test.h"

#include <cmath>
#include <functional>
#include <iomanip>

namespace test_of_relaxation_test
{
using namespace Continua;

namespace
{
constexpr double c = 1.3e6, n = 0.065;

/// A table of 60 rows a decade from a time `first` to 1000, the load a function of time.
void write_table(const std::string &header,
                 const double first,
                 const std::function<double(double)> &load)
{
  std::ofstream file("table.csv");
  file << "# a test\n" << header << '\n' << std::setprecision(15);
  for (int i = 0; first * std::pow(10., i / 60.) < 1001.; ++i)
  {
    const double time = first * std::pow(10., i / 60.);
    file << time << ',' << load(time) << '\n';
  }
}

RelaxationTest read_test(const std::string &entries)
{
  ParameterFile file = parameters_of("set Relaxation table = table.csv\n" + entries);
  const RelaxationTest test = read_relaxation_test(file.root());
  file.refuse_unknown();
  return test;
}

void refused(const std::string &name,
             const std::string &table,
             const std::string &entries,
             const std::string &pattern)
{
  std::ofstream("table.csv") << table;
  check::throws<InputError>(
      name, [&] { read_test(entries); }, pattern);
}
} // namespace

UNIT_TEST(relaxation_test)
{
  // 37.3 mm x 0.14 mm at 3 % (section 5.3 of the thesis), force in mN, time in ms.
  const double area = 37.3e-3 * 0.14e-3;
  write_table("time [ms], force [mN]", 10.,
              [&](const double ms) { return 1e3 * area * 0.03 * c * std::pow(1e-3 * ms, -n); });
  const RelaxationTest forces = read_test("set Cross-section = 5.222 mm^2\nset Strain = 3 %\n");
  check::relative("forces: moduli", forces.moduli.at(60), c * std::pow(forces.times.at(60), -n),
                  1e-12);
  const RelaxationFit of_forces = fit_relaxation_test(forces);
  check::relative("forces: c", of_forces.modulus, c, 1e-12);
  check::relative("forces: n", of_forces.exponent, n, 1e-12);
  check::absolute("forces: misfit", of_forces.misfit, 0., 1e-12);

  // Every second row 1 % (in the logarithm) above, the others below the law.
  bool above = false;
  write_table("time [s], stress [kPa]", 0.01,
              [&](const double time)
              {
                above = !above;
                return 1e-3 * 0.03 * c * std::pow(time, -n) * std::exp(above ? 0.01 : -0.01);
              });
  const RelaxationFit of_noise = fit_relaxation_test(read_test("set Strain = 0.03\n"));
  check::relative("noise: c", of_noise.modulus, c, 1e-3);
  check::relative("noise: n", of_noise.exponent, n, 1e-2);
  check::relative("noise: misfit", of_noise.misfit, 0.01, 1e-3);

  // A strain that rises evenly within t0 = 0.1 s: c (t^(1-n) - (t - t0)^(1-n))/((1 - n) t0), and
  // before t0 c t^(1-n)/((1 - n) t0).
  const double t0 = 0.1;
  const auto ramp = [t0](const double time)
  {
    const double late = time > t0 ? std::pow(time - t0, 1. - n) : 0.;
    return 0.03 * c * (std::pow(time, 1. - n) - late) / ((1. - n) * t0);
  };
  write_table("time [s], stress [Pa]", 0.01, ramp);
  const RelaxationTest loaded = read_test("set Strain = 0.03\nset Loading time = 0.1 s\n");
  check::is_true("ramp: all rows are kept for plots",
                 loaded.times.size() == 301 && loaded.times.front() == 0.01);
  check::is_true("ramp: rows before five loading times are left out",
                 loaded.times.at(loaded.first_used) >= 0.5 &&
                     loaded.times.at(loaded.first_used - 1) < 0.5);
  const RelaxationFit of_ramp = fit_relaxation_test(loaded);
  check::relative("ramp: c", of_ramp.modulus, c, 1e-4);
  check::relative("ramp: n", of_ramp.exponent, n, 1e-3);
  check::is_true("ramp: misfit", of_ramp.misfit < 1e-4);
  const RelaxationFit without_ramp = fit_relaxation_test(read_test("set Strain = 0.03\n"));
  check::is_true("ramp: would be felt", std::abs(without_ramp.exponent / n - 1.) > 0.05);

  // A spring.
  write_table("time [s], stress [Pa]", 0.01, [](double) { return 0.03 * c; });
  const RelaxationFit of_constant = fit_relaxation_test(read_test("set Strain = 0.03\n"));
  check::relative("constant stress: c", of_constant.modulus, c, 1e-12);
  check::is_true("constant stress: n is 0 without a sign",
                 of_constant.exponent == 0. && !std::signbit(of_constant.exponent));

  // In a material.
  write_table("time [s], stress [Pa]", 0.01,
              [](const double time) { return 0.03 * c * std::pow(time, -n); });
  const std::string law = "set Type = power law\nset Density = 880\n"
                          "set Relaxation table = table.csv\nset Strain = 3 %\n";
  ParameterFile file = parameters_of(law);
  const Material material = read_material(file.root(), Model::axisymmetric);
  check::relative("material: c", material.shear.power_law->modulus, c, 1e-12);
  check::relative("material: n", material.shear.power_law->exponent, n, 1e-12);
  check::throws<InputError>(
      "table and numbers",
      [&]
      {
        ParameterFile both = parameters_of(law + "set Exponent = 0.065\n");
        read_material(both.root(), Model::axisymmetric);
      },
      ":5: 'Exponent'.*the relaxation table gives c and n");
  write_table("time [s], stress [Pa]", 0.01, [](const double time) { return 1e5 * time; });
  check::throws<InputError>(
      "stress that rises",
      [&]
      {
        ParameterFile rising = parameters_of(law);
        read_material(rising.root(), Model::axisymmetric);
      },
      ":3: 'Relaxation table': the exponent of the power law through it is -1");
  check::throws<InputError>(
      "strain without a table",
      [&]
      {
        ParameterFile alone = parameters_of("set Strain = 3 %\n");
        read_relaxation_test(alone.root());
      },
      ":1: 'Strain': there is no relaxation table");

  const std::string strain = "set Strain = 3 %\n";
  refused("time that falls", "time [s], stress [Pa]\n1,3\n3,2\n2,1\n4,1\n", strain,
          "table.csv:4: 'time'.*not later");
  refused(
      "strain too small", "time [s], stress [Pa]\n1,3\n2,2\n3,1\n4,1\n", "set Strain = 1e-300\n",
      "'Strain': with this strain the table gives a modulus of 3e\\+300 Pa, which no material has");
  refused("stress not positive", "time [s], stress [Pa]\n1,3\n2,0\n3,1\n", strain,
          "table.csv:3: 'stress'.*must be positive");
  refused("force not positive", "time [s], force [N]\n1,3\n2,2\n3,-1\n",
          strain + "set Cross-section = 5 mm^2\n", "table.csv:4: 'force'.*must be positive");
  refused("two rows", "time [s], stress [Pa]\n0,3\n1,2\n2,1\n", strain,
          "table.csv:1: the table has 2 rows to fit");
  refused("too few rows after the loading", "time [s], stress [Pa]\n1,3\n2,2\n3,1\n4,1\n",
          strain + "set Loading time = 0.5 s\n", "table.csv:1: the table has 2 rows to fit");
  refused("no time", "t [s], stress [Pa]\n1,3\n", strain, "table.csv:1: 'time': there is no such");
  refused("no load", "time [s], load [Pa]\n1,3\n", strain,
          "table.csv:1: neither 'force' nor 'stress' is a column.*'time', 'load'");
  refused("force and stress", "time [s], force [N], stress [Pa]\n1,3,3\n", strain,
          "table.csv:1: both 'force' and 'stress'");
  refused("wrong unit", "time [s], stress [N]\n1,3\n2,2\n3,1\n", strain,
          "table.csv:1: 'stress'.*'N' is not of the dimension of Pa");
  refused("no unit", "time, stress [Pa]\n1,3\n2,2\n3,1\n", strain,
          "'time': the column has no unit");
  refused("no cross-section", "time [s], force [N]\n1,3\n2,2\n3,1\n", strain,
          "'Cross-section' is missing");
  refused("cross-section of a stress", "time [s], stress [Pa]\n1,3\n2,2\n3,1\n",
          strain + "set Cross-section = 1 mm^2\n", ":3: 'Cross-section'.*which need none");
  refused("no strain", "time [s], stress [Pa]\n1,3\n2,2\n3,1\n", "", "'Strain' is missing");
}
} // namespace test_of_relaxation_test
