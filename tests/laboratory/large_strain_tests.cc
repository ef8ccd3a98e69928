// The analysis of a hyperelastic law from its parameter file to its tables: an inflation with
// fibres by hand, relaxation at large strains, and input that is refused.

#include "../parameter_text.h"

#include <continua/base/csv_table.h>
#include <continua/program/analyses.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "../unit_test.h"

namespace test_of_large_strain_tests
{
using namespace Continua;

namespace
{
std::string large_strain_file(const std::string &wall,
                              const std::string &laboratory,
                              const std::string &other = "")
{
  return "set Analysis = material\nsubsection Materials\nsubsection wall\n"
         "set Density = 1000 kg/m^3\nset Young's modulus = 3 MPa\n" +
         wall + "end\nend\nsubsection Laboratory\nset Deformation = finite\n" + laboratory +
         "end\n" + other;
}

const std::string rubber = "set Type = hookean\nset Poisson's ratio = 0.5\n";

/// Performs the analysis in a folder; its tables are left there.
void perform_tests(const std::string &folder, const std::string &text)
{
  ParameterFile file = parameters_of(text);
  const std::unique_ptr<Analysis> laboratory = analyses().make(file, CommandLine(), MPI_COMM_WORLD);
  const OutputDirectory directory(folder, OutputDirectory::Mode::overwrite, MPI_COMM_WORLD);
  Log log(MPI_COMM_WORLD, false);
  Summary summary;
  laboratory->perform(directory, log, summary);
}

std::vector<double> column_of(const std::string &file, const std::string &name)
{
  const CsvTable table(file, "");
  const std::size_t column = table.find(name);
  std::ifstream stream(file);
  std::vector<double> result;
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line))
  {
    std::istringstream cells(line);
    std::string cell;
    for (std::size_t i = 0; i <= column; ++i)
      std::getline(cells, cell, ',');
    result.push_back(std::stod(cell));
  }
  return result;
}

/// A thin tube of Holzapfel, Gasser and Ogden's law, incompressible.
void check_inflation()
{
  perform_tests("inflation",
                large_strain_file(rubber + "set Strain law = holzapfel gasser ogden\n"
                                           "set Fibre stiffness = 2 MPa\nset Fibre exponent = 1.5\n"
                                           "set Fibre angle = 50 deg\n",
                                  "set Tests = inflation\nset Largest stretch = 1.4\n"
                                  "set Axial stretch = 1.1\nset Radius = 10 mm\n"
                                  "set Wall thickness = 1 mm\nset Points = 401\n"));
  const std::string file = "inflation/inflation.csv";
  const std::vector<double> stretch = column_of(file, "stretch"),
                            pressure = column_of(file, "pressure"),
                            force = column_of(file, "axial force"),
                            around = column_of(file, "circumferential stress"),
                            along = column_of(file, "axial stress"),
                            distensibility = column_of(file, "distensibility");
  const double mu = 1e6, k1 = 2e6, k2 = 1.5, lz = 1.1, sine = std::sin(50. * M_PI / 180.),
               cosine = std::cos(50. * M_PI / 180.);
  check::absolute("rows", stretch.size(), 401., 0.);
  double of_around = 0., of_along = 0., of_pressure = 0., of_force = 0.;
  for (std::size_t i = 0; i < stretch.size(); ++i)
  {
    const double l = stretch[i], lr = 1. / (l * lz);
    const double e = std::pow(l * sine, 2) + std::pow(lz * cosine, 2) - 1.;
    const double fibre = e > 0. ? 4. * k1 * e * std::exp(k2 * e * e) : 0.; // of both families
    const double circumferential = mu * (l * l - lr * lr) + fibre * std::pow(l * sine, 2),
                 axial = mu * (lz * lz - lr * lr) + fibre * std::pow(lz * cosine, 2);
    const double radius = 0.01 * l, thickness = 0.001 * lr;
    const double by_laplace = circumferential * thickness / radius;
    const double by_hand =
        2. * M_PI * radius * thickness * axial - M_PI * radius * radius * by_laplace;
    of_around = std::max(of_around, std::abs(around[i] / circumferential - 1.));
    of_along = std::max(of_along, std::abs(along[i] / axial - 1.));
    of_pressure = std::max(of_pressure, std::abs(pressure[i] / by_laplace - 1.));
    of_force = std::max(of_force, std::abs(force[i] - by_hand));
  }
  check::absolute("inflation: circumferential stress", of_around, 0., 1e-11);
  check::absolute("inflation: axial stress", of_along, 0., 1e-11);
  check::absolute("inflation: pressure", of_pressure, 0., 1e-11);
  check::absolute("inflation: axial force", of_force, 0., 1e-9);
  // (1/A) dA/dp with A = pi r^2.
  const std::size_t i = 300;
  check::relative("inflation: distensibility", distensibility[i],
                  2. / stretch[i] * (stretch[i + 1] - stretch[i - 1]) /
                      (pressure[i + 1] - pressure[i - 1]),
                  1e-4);
}

const std::string branches = "set Type = prony\nset Poisson's ratio = 0.5\n"
                             "set Shear moduli = 2 MPa, 0.5 MPa\n"
                             "set Relaxation times = 0.1 s, 3 s\n";

std::string steps(const std::string &step)
{
  return "subsection Time\nset Time step = " + step + "\nset End time = 1 s\nend\n";
}

void check_relaxation()
{
  // A sudden stretch of neo-Hookean springs: each branch forgets its share exp(-t/tau).
  perform_tests("relaxation", large_strain_file(branches,
                                                "set Tests = stretch relaxation, shear relaxation\n"
                                                "set Held stretch = 1.8\nset Held shear = 1.2\n",
                                                steps("0.05 s")));
  const std::string file = "relaxation/stretch-relaxation.csv";
  const std::vector<double> times = column_of(file, "time"),
                            stress = column_of(file, "nominal stress"),
                            shear = column_of("relaxation/shear-relaxation.csv", "nominal stress");
  double largest = 0., of_shear = 0.;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const double modulus = 1e6 + 2e6 * std::exp(-times[i] / 0.1) + 0.5e6 * std::exp(-times[i] / 3.);
    largest = std::max(largest, std::abs(stress[i] / (modulus * (1.8 - 1. / (1.8 * 1.8))) - 1.));
    of_shear = std::max(of_shear, std::abs(shear[i] / (modulus * 1.2) - 1.));
  }
  check::absolute("rows of a relaxation", times.size(), 21., 0.);
  check::absolute("a sudden stretch", largest, 0., 1e-11);
  check::absolute("a sudden shear", of_shear, 0., 1e-12);

  // A loading: in shear exact as in the linear branch, in a stretch of order 2.
  std::vector<double> ends;
  for (const std::string step : {"20 ms", "10 ms", "5 ms"})
  {
    perform_tests("loading", large_strain_file(branches,
                                               "set Tests = stretch relaxation, shear relaxation\n"
                                               "set Held stretch = 1.8\nset Held shear = 1.2\n"
                                               "set Loading time = 0.2 s\n",
                                               steps(step)));
    const std::string table = "loading/shear-relaxation.csv";
    const std::vector<double> found = column_of(table, "nominal stress"),
                              exact = column_of(table, "stress of the closed solution");
    double error = 0.;
    for (std::size_t i = 0; i < found.size(); ++i)
      error = std::max(error, std::abs(found[i] / 1e6 - exact[i] / 1e6));
    check::absolute("a loading in shear: the closed solution", error, 0., 1e-12);
    ends.push_back(column_of("loading/stretch-relaxation.csv", "nominal stress").back());
  }
  check::absolute("a loading in a stretch: order 2", (ends[0] - ends[1]) / (ends[1] - ends[2]), 4.,
                  0.1);
  // Both branches by hand: mu tau/T (exp((T - t)/tau) - exp(-t/tau)).
  const auto forgotten = [](const double tau)
  { return tau / 0.2 * (std::exp(-0.8 / tau) - std::exp(-1. / tau)); };
  check::relative("a loading in shear: the end",
                  column_of("loading/shear-relaxation.csv", "nominal stress").back(),
                  1.2 * (1e6 + 2e6 * forgotten(0.1) + 0.5e6 * forgotten(3.)), 1e-12);
}

void refused_file(const std::string &name, const std::string &text, const std::string &pattern)
{
  check::throws<InputError>(
      name,
      [&]
      {
        ParameterFile file = parameters_of(text);
        analyses().make(file, CommandLine(), MPI_COMM_WORLD);
      },
      pattern);
}
} // namespace

UNIT_TEST(large_strain_tests)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_inflation();
  check_relaxation();
  refused_file("a test of small strains", large_strain_file(rubber, "set Tests = harmonic\n"),
               ":12: 'Laboratory/Tests'.*harmonic.*uniaxial");
  refused_file("no radius", large_strain_file(rubber, "set Tests = inflation\n"),
               "'Radius' is missing");
  refused_file("a thick wall",
               large_strain_file(rubber, "set Tests = inflation\nset Radius = 1 mm\n"
                                         "set Wall thickness = 2 mm\n"),
               ":14: 'Laboratory/Wall thickness'.*thicker");
  refused_file("an empty curve",
               large_strain_file(rubber, "set Tests = uniaxial\nset Largest stretch = 0.9\n"),
               ":13: 'Laboratory/Largest stretch'.*empty");
  refused_file("viscosity",
               large_strain_file("set Type = kelvin-voigt\nset Poisson's ratio = 0.5\n"
                                 "set Viscosity = 1 Pa s\n",
                                 "set Tests = uniaxial\n"),
               ":8: 'Materials/wall/Viscosity'.*prony");
  refused_file("an incompressible st venant kirchhoff solid",
               large_strain_file(rubber + "set Strain law = st venant kirchhoff\n",
                                 "set Tests = uniaxial\n"),
               ":8: 'Materials/wall/Strain law'.*incompressible");
  refused_file("a loading that ends within a step",
               large_strain_file(branches,
                                 "set Tests = shear relaxation\nset Held shear = 1\n"
                                 "set Loading time = 7 ms\n",
                                 steps("5 ms")),
               ":16: 'Laboratory/Loading time'.*within a time step");
  std::ofstream("strains.csv") << "stretch [1], stress [kPa]\n0.001, 3\n0.1, 300\n";
  refused_file("a table of strains",
               large_strain_file(rubber, "set Uniaxial table = strains.csv\n"),
               "strains.csv:2: 'stretch'.*1 without strain.*1 \\+ e");
  std::ofstream("zero.csv") << "stretch [1], stress [kPa]\n1.1, 0\n1.2, 0\n";
  refused_file("a table without stress", large_strain_file(rubber, "set Planar table = zero.csv\n"),
               "zero.csv:2: 'stress'.*all stresses are 0");
  std::ofstream("two-rows.csv") << "stretch [1], stress [kPa]\n1.1, 300\n1.2, 600\n";
  refused_file("fewer rows than constants",
               large_strain_file(rubber + "set Strain law = holzapfel gasser ogden\n"
                                          "set Fibre stiffness = 2 MPa\nset Fibre exponent = 1.5\n"
                                          "set Fibre angle = 50 deg\n",
                                 "set Uniaxial table = two-rows.csv\n"),
               ":8: 'Materials/wall/Strain law'.*3 constants.*2 rows");
  std::ofstream("one-row.csv") << "stretch [1], stress [kPa]\n1.1, 300\n";
  refused_file("a table of one row",
               large_strain_file(rubber, "set Uniaxial table = one-row.csv\n"), "one-row.csv");
  std::ofstream("shear.csv") << "stretch [1], stress [kPa]\n1.1, 300\n1.2, 600\n";
  refused_file("a table of shear without its column",
               large_strain_file(rubber, "set Shear table = shear.csv\n"), "shear.csv:1.*'shear'");
}
} // namespace test_of_large_strain_tests
