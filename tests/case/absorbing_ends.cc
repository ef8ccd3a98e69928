// Ends that absorb: the plane wave's impedance of a channel and of a round pipe, and that of a
// tube, with the band it is for; what a checkpoint has of them comes back number by number.

#include "../parameter_text.h"
#include "../postprocess/text_file.h"
#include "tube_text.h"

#include <continua/base/archive.h>
#include <continua/case/case.h>
#include <continua/program/analyses.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <filesystem>

#include "../unit_test.h"

namespace test_of_absorbing_ends
{
namespace
{
using namespace Continua;

/// K = 2.25 GPa and 1000 kg/m^3: rho c = sqrt(rho K) = 1.5e6 Pa s/m. The end is 2 cm high.
std::string channel(const bool axisymmetric)
{
  return std::string("set Analysis = transient\nset Model = ") +
         (axisymmetric ? "axisymmetric" : "plane strain") +
         "\nsubsection Geometry\nset Type = box\nset Size = 1 m, 2 cm\nend\n"
         "subsection Mesh\nset Cells = 4, 2\nend\n"
         "subsection Materials\nsubsection body\nset Type = newtonian\nset Density = 1000\n"
         "set Bulk modulus = 2.25 GPa\nset Viscosity = 0\nend\nend\n"
         "subsection Boundaries\n"
         "subsection left\nset Type = pressure\nset Pressure = sin(t)\nend\n"
         "subsection right\nset Type = absorbing\nend\n"
         "subsection " +
         (axisymmetric ? "axis\nset Type = axis" : "bottom\nset Type = roller") +
         "\nend\nsubsection " + (axisymmetric ? "outside" : "top") +
         "\nset Type = roller\nend\nend\n"
         "subsection Time\nset Scheme = crank nicolson\nset Time step = 1 us\n"
         "set End time = 1 ms\nend\n";
}
} // namespace

UNIT_TEST(absorbing_ends)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const bool axisymmetric : {false, true})
  {
    const std::string name = axisymmetric ? "pipe: " : "channel: ";
    ParameterFile file = parameters_of(channel(axisymmetric));
    const Case<2> input = analyses().read_case<2>(file, MPI_COMM_WORLD);
    check::is_true(name + "one outlet", input.problem.outlets.size() == 1);
    const Outlet &outlet = input.problem.outlets.at(0);
    check::equal(name + "its name", outlet.name, "right");
    const double area = axisymmetric ? dealii::numbers::PI * 0.02 * 0.02 : 0.02;
    check::relative(name + "rho c over the area", outlet.impedance.direct(0, 0), 1.5e6 / area,
                    1e-12);
    check::is_true(name + "a number at all frequencies",
                   outlet.impedance.n_ports() == 1 && outlet.impedance.terms.empty());
    check::is_true(name + "its condition",
                   outlet.conditions.size() == 1 &&
                       input.problem.conditions[outlet.conditions[0]].name == "right");
  }

  const std::string absorbing = "set Type = absorbing\n";
  {
    // Beside a clamped wall.
    ParameterFile file = parameters_of(tube_text::tube(tube_text::pulse(), absorbing));
    const Case<2> input = analyses().read_case<2>(file, MPI_COMM_WORLD);
    const Outlet &outlet = input.problem.outlets.at(0);
    Log log(MPI_COMM_WORLD, false);
    Summary summary;
    input.absorbing_ends.report(log, summary);
    const double error = quantity(summary, "absorbing end fit error", "outlet");
    check::is_true("tube: the fit's error", error > 0. && error <= 0.01);
    // A wave that goes on takes power along at every frequency of the band.
    bool is_passive = true;
    for (const double frequency : {1., 5., 20., 50.})
      is_passive =
          is_passive &&
          outlet.impedance.value({0., 2. * dealii::numbers::PI * frequency})(0, 0).real() > 0.;
    check::is_true("tube: takes power", is_passive);
    check::is_true("tube: one port",
                   outlet.impedance.n_ports() == 1 && outlet.conditions.size() == 1);
  }
  {
    // A run that goes on: the impedance of liquid and wall is what its checkpoint has.
    ParameterFile file = parameters_of(tube_text::tube(tube_text::pulse(), absorbing, absorbing));
    Case<2> input = analyses().read_case<2>(file, MPI_COMM_WORLD, CaseUse::restart);
    Outlet &outlet = input.problem.outlets.at(0);
    check::is_true("goes on: two ports",
                   outlet.impedance.n_ports() == 2 && outlet.conditions.size() == 2);
    check::absolute("goes on: nothing is fitted", outlet.impedance.direct.frobenius_norm(), 0., 0.);
    const std::vector<double> numbers = {1., 2., 2.,  3., 40., 5.,  6.,
                                         6., 7., 80., 9., 10., 10., 11.};
    const std::string record = "impedance of the absorbing end outlet",
                      band = "band and error of the absorbing end outlet";
    ArchiveWriter writer;
    writer.add(record, numbers);
    writer.add(band, std::vector<double>{0.5, 90., 0.004, 12., 3e7});
    writer.write("absorbing-ends-test.bin");
    input.absorbing_ends.load(ArchiveReader("absorbing-ends-test.bin"), input.problem);
    check::is_true("loaded: terms", outlet.impedance.terms.size() == 2);
    check::is_true("loaded: direct", outlet.impedance.direct(0, 0) == 1. &&
                                         outlet.impedance.direct(1, 0) == 2. &&
                                         outlet.impedance.direct(1, 1) == 3.);
    check::is_true("loaded: second term", outlet.impedance.terms[1].rate == 80. &&
                                              outlet.impedance.terms[1].residue(0, 1) == 10. &&
                                              outlet.impedance.terms[1].residue(1, 1) == 11.);
    Log log(MPI_COMM_WORLD, false);
    Summary summary;
    input.absorbing_ends.report(log, summary);
    check::absolute("loaded: error", quantity(summary, "absorbing end fit error", "outlet"), 0.004,
                    0.);
    ArchiveWriter again;
    input.absorbing_ends.save(again, input.problem);
    again.write("absorbing-ends-test.bin");
    const ArchiveReader reader("absorbing-ends-test.bin");
    check::is_true("saved again",
                   reader.values(record) == numbers &&
                       reader.values(band) == std::vector<double>{0.5, 90., 0.004, 12., 3e7});
    std::filesystem::remove("absorbing-ends-test.bin");
  }
}
} // namespace test_of_absorbing_ends
