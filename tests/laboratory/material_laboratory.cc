// The rows of the table of moduli, and the periods after which a harmonic test ends.

#include "../parameter_text.h"

#include <continua/base/csv_table.h>
#include <continua/program/analyses.h>

#include <deal.II/base/mpi.h>

#include <complex>
#include <filesystem>
#include <fstream>
#include <limits>

#include "../unit_test.h"

namespace test_of_material_laboratory
{
namespace
{
using namespace Continua;

std::vector<std::vector<double>> rows_of(const std::string &file)
{
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(stream, line))
  {
    std::istringstream cells(line);
    std::vector<double> row;
    for (std::string cell; std::getline(cells, cell, ',');)
      row.push_back(std::stod(cell));
    rows.push_back(row);
  }
  return rows;
}

/// Performs the harmonic test of a solid, at 1 Hz over two periods of 20 steps; the folder of its
/// tables.
std::string perform(const std::string &solid, const std::string &expected)
{
  ParameterFile file = parameters_of(
      "set Analysis = material\n"
      "subsection Materials\nsubsection wall\nset Density = 1000 kg/m^3\n"
      "set Young's modulus = 2600 Pa\nset Poisson's ratio = 0.3\n" +
      solid +
      "end\nend\n"
      "subsection Laboratory\nset Tests = harmonic\nset Frequencies = 1 Hz\nset Periods = 2\n"
      "set Steps per period = 20\nset Lowest frequency = 0.1 Hz\nset Highest frequency = 10 Hz\n"
      "set Points per decade = 5\nend\n"
      "subsection Time\nset Scheme = crank nicolson\nset Time step = 1 ms\nset End time = 1 s\n"
      "end\n" +
      expected);
  const std::unique_ptr<Analysis> laboratory = analyses().make(file, CommandLine(), MPI_COMM_WORLD);
  const std::string folder = "material_laboratory";
  const OutputDirectory directory(folder, OutputDirectory::Mode::overwrite, MPI_COMM_WORLD);
  Log log(MPI_COMM_WORLD, false);
  Summary summary;
  laboratory->perform(directory, log, summary);
  return directory.path();
}

/// The rows of prony.csv: a relaxation time [s], the moduli of shear and of volume change [Pa].
void check_branches(const std::string &name,
                    const std::string &solid,
                    const std::vector<std::vector<double>> &expected)
{
  const std::vector<std::vector<double>> rows = rows_of(perform(solid, "") + "/prony.csv");
  bool agree = rows.size() == expected.size();
  for (std::size_t i = 0; agree && i < rows.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      agree &= rows[i][c] == expected[i][c] ||
               std::abs(rows[i][c] - expected[i][c]) < 1e-9 * expected[i][c];
  check::is_true(name, agree);
}

void test_branches()
{
  const std::string shear = "set Type = prony\nset Shear moduli = 2000 Pa, 500 Pa\n"
                            "set Relaxation times = 0.1 s, 1 s\n";
  const double inf = std::numeric_limits<double>::infinity(), spring = 2600. / 1.2;
  check_branches("branches of the shear", shear,
                 {{0.1, 2000., 0.}, {1., 500., 0.}, {inf, 1000., spring}});
  check_branches("branches of the volume change",
                 shear + "set Volumetric relaxation = own branches\nset Bulk moduli = 3000 Pa\n"
                         "set Bulk relaxation times = 0.2 s\n",
                 {{0.1, 2000., 0.}, {0.2, 0., 3000.}, {1., 500., 0.}, {inf, 1000., spring}});
}
} // namespace

UNIT_TEST(material_laboratory)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // A Kelvin-Voigt solid, mu = 1000 Pa, K = 2600/1.2 Pa: Y(w) = 9 K G/(3 K + G) of G = mu + i w
  // eta.
  const std::string folder =
      perform("set Type = kelvin-voigt\nset Viscosity = 100 Pa s\n",
              "subsection Expected\nset harmonic at 1 Hz: periods = 2 +- 0\nend\n");

  const std::vector<std::vector<double>> moduli = rows_of(folder + "/modulus.csv");
  check::absolute("rows of two decades", moduli.size(), 11., 0.);
  check::relative("first frequency", moduli.front()[0], 0.1, 1e-12);
  check::relative("last frequency", moduli.back()[0], 10., 1e-12);
  check::relative("next to the first", moduli[1][0], 0.1 * std::pow(10., 0.2), 1e-12);
  const std::complex<double> shear(1000., 2. * M_PI * 0.1 * 100.);
  const double bulk = 2600. / 1.2;
  const std::complex<double> young = 9. * bulk * shear / (3. * bulk + shear);
  check::relative("storage modulus", moduli.front()[1], young.real(), 1e-9);
  check::relative("loss modulus", moduli.front()[2], young.imag(), 1e-9);
  // Two periods of 20 steps; the relaxation has not died away by then.
  check::absolute("rows of the loops", rows_of(folder + "/harmonic-1.csv").size(), 40., 0.);

  test_branches();
}
} // namespace test_of_material_laboratory
