// The rows of the table of moduli, and the periods after which a harmonic test ends.

#include "../parameter_text.h"

#include <continua/base/csv_table.h>
#include <continua/program/analyses.h>

#include <deal.II/base/mpi.h>

#include <complex>
#include <filesystem>
#include <fstream>

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
} // namespace

UNIT_TEST(material_laboratory)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // A Kelvin-Voigt solid, mu = 1000 Pa, K = 2600/1.2 Pa: Y(w) = 9 K G/(3 K + G) of G = mu + i w
  // eta.
  ParameterFile file = parameters_of(
      "set Analysis = material\n"
      "subsection Materials\nsubsection wall\nset Type = kelvin-voigt\n"
      "set Density = 1000 kg/m^3\nset Young's modulus = 2600 Pa\nset Poisson's ratio = 0.3\n"
      "set Viscosity = 100 Pa s\nend\nend\n"
      "subsection Laboratory\nset Tests = harmonic\nset Frequencies = 1 Hz\nset Periods = 2\n"
      "set Steps per period = 20\nset Lowest frequency = 0.1 Hz\nset Highest frequency = 10 Hz\n"
      "set Points per decade = 5\nend\n"
      "subsection Time\nset Scheme = crank nicolson\nset Time step = 1 ms\nset End time = 1 s\n"
      "end\n"
      "subsection Expected\nset harmonic at 1 Hz: periods = 2 +- 0\nend\n");
  const std::unique_ptr<Analysis> laboratory = analyses().make(file, CommandLine(), MPI_COMM_WORLD);
  const std::string folder = "material_laboratory";
  const OutputDirectory directory(folder, OutputDirectory::Mode::overwrite, MPI_COMM_WORLD);
  Log log(MPI_COMM_WORLD, false);
  Summary summary;
  laboratory->perform(directory, log, summary);

  const std::vector<std::vector<double>> moduli = rows_of(directory.file("modulus.csv"));
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
  check::absolute("rows of the loops", rows_of(directory.path() + "/harmonic-1.csv").size(), 40.,
                  0.);
}
} // namespace test_of_material_laboratory
