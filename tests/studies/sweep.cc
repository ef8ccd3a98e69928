// A sweep: what it is refused for, its runs against closed formulas, what a restart takes as it
// was, and --sweep.

#include <continua/base/input_error.h>
#include <continua/base/input_file.h>
#include <continua/program/analyses.h>
#include <continua/studies/sweep_command.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "../unit_test.h"
#include "pulled_bar.h"

namespace test_of_sweep
{
using namespace Continua;

namespace
{
const std::string parameter_file = "sweep-test.prm", output = "sweep-test";

std::string sweep_of(const std::string &entries, const std::string &others = "")
{
  return "set Analysis = sweep\n" + std::string(pulled_bar) +
         "subsection Sweep\nset Analysis = steady\n" + "set Parallel runs = 1\n" + others +
         "subsection Entries\n" + entries + "end\nend\n";
}

/// Reads the file and, if asked for, performs it; the quantities by "PROBE: NAME".
std::map<std::string, double>
perform(const std::string &text, const OutputDirectory::Mode mode, std::string &printed)
{
  std::ofstream(parameter_file) << text;
  CommandLine command_line;
  command_line.parameter_file = parameter_file;
  command_line.output_directory = output;
  command_line.restart = mode == OutputDirectory::Mode::restart;
  command_line.overwrite = mode == OutputDirectory::Mode::overwrite;
  ParameterFile file(parameter_file, command_line.overrides);
  const std::unique_ptr<Analysis> sweep = analyses().make(file, command_line, MPI_COMM_WORLD);
  const OutputDirectory directory(output, mode, MPI_COMM_WORLD, file.input_files());
  std::ostringstream screen;
  std::streambuf *const before = std::cout.rdbuf(screen.rdbuf());
  Summary summary;
  {
    Log log(MPI_COMM_WORLD);
    try
    {
      sweep->perform(directory, log, summary);
    }
    catch (const RunError &)
    {
      // Of runs that fail; the summary has it, too.
    }
  }
  std::cout.rdbuf(before);
  printed = screen.str();
  std::map<std::string, double> result;
  for (const Quantity &quantity : summary.quantities())
    result[(quantity.probe.empty() ? "" : quantity.probe + ": ") + quantity.name] = quantity.value;
  return result;
}

void refuses(const std::string &name, const std::string &text, const std::string &pattern)
{
  check::throws<InputError>(
      name,
      [&text]
      {
        std::ofstream(parameter_file) << text;
        CommandLine command_line;
        command_line.parameter_file = parameter_file;
        ParameterFile file(parameter_file);
        analyses().make(file, command_line, MPI_COMM_WORLD);
      },
      pattern);
}

unsigned int count(const std::string &printed, const std::string &what)
{
  unsigned int n = 0;
  for (std::size_t at = printed.find(what); at != std::string::npos;
       at = printed.find(what, at + 1))
    ++n;
  return n;
}
} // namespace

UNIT_TEST(sweep)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::filesystem::remove_all(output);
  using Mode = OutputDirectory::Mode;
  const std::string modulus = "set Materials/body/Young's modulus = 1 MPa, 2 MPa\n",
                    ratio = "set Materials/body/Poisson's ratio = 0 to 0.25 in 2, 0.4\n",
                    again = ": was finished before\n", anew = ": finished\n";
  std::string printed;
  const std::map<std::string, double> grid =
      perform(sweep_of(modulus + ratio), Mode::fresh, printed);
  check::is_true("six runs", count(printed, anew) == 6 && grid.at("runs") == 6. &&
                                 grid.at("failed runs") == 0.);
  bool all_right = true;
  for (const int megapascals : {1, 2})
    for (const auto &[poisson, text] :
         {std::pair<double, const char *>{0., "0"}, {0.25, "0.25"}, {0.4, "0.4"}})
    {
      const std::string label = "end: final displacement x: young's modulus " +
                                std::to_string(megapascals) + " MPa, poisson's ratio " + text;
      all_right = all_right && grid.count(label) == 1 &&
                  std::abs(grid.at(label) - 0.002 * (1. - poisson * poisson) / megapascals) < 1e-12;
    }
  check::is_true("(1 - nu^2)/Y times traction and length", all_right);
  unsigned int n_values = 0;
  for (const auto &[label, value] : grid)
    n_values += label.find("final displacement x: young's modulus") != std::string::npos ? 1 : 0;
  check::is_true("of each run", n_values == 6);

  perform(sweep_of(modulus + ratio), Mode::restart, printed);
  check::is_true("a restart runs none", count(printed, again) == 6);
  perform(sweep_of(modulus + "set Materials/body/Poisson's ratio = 0.1, 0, 0.25, 0.4\n"),
          Mode::restart, printed);
  check::is_true("and takes those of a longer list",
                 count(printed, again) == 6 && count(printed, anew) == 2);
  std::ofstream(output + "/young-s-modulus-1-mpa-poisson-s-ratio-0-4/summary.json") << "{";
  perform(sweep_of(modulus + ratio), Mode::restart, printed);
  check::is_true("a damaged summary", count(printed, again) == 5 && count(printed, anew) == 1);
  std::string other_case = sweep_of(modulus + ratio);
  other_case.replace(other_case.find("2 m, 0.5 m"), 10, "1 m, 0.5 m");
  perform(other_case, Mode::restart, printed);
  check::is_true("another case is run again", count(printed, anew) == 6);
  std::string other_modulus = other_case;
  other_modulus.replace(other_modulus.find("= 1 MPa\n"), 8, "= 7 MPa\n");
  perform(other_modulus, Mode::restart, printed);
  check::is_true("what is swept is no part of the case", count(printed, again) == 6);

  const std::map<std::string, double> together =
      perform(sweep_of(modulus + "set Geometry/Size 2 = 1 m, 2 m\n", "set Combine = together\n"),
              Mode::overwrite, printed);
  check::is_true("two runs together", count(printed, anew) == 2 && together.at("runs") == 2.);
  check::is_true("a number of a list, beside the others",
                 check::matches(read_input_file(output + "/young-s-modulus-2-mpa-size-2-2-m/"
                                                         "parameters.prm"),
                                "set Size += 2( m)?, 2"));

  // A folder is named after values, and not after their order.
  perform(sweep_of("set Boundaries/right/Traction = (1 kPa, 0 Pa), (2 kPa, 0 Pa)\n"),
          Mode::overwrite, printed);
  const std::string of_one = output + "/traction-1-kpa-0-pa/summary.json";
  const auto written = std::filesystem::last_write_time(of_one);
  perform(sweep_of("set Boundaries/right/Traction = (-1 kPa, 0 Pa), (1 kPa, 0 Pa)\n"),
          Mode::restart, printed);
  check::is_true("values below zero have folders of their own",
                 count(printed, again) == 1 && count(printed, "traction-minus-1-kpa") == 1 &&
                     std::filesystem::last_write_time(of_one) == written);
  perform(sweep_of("set Boundaries/right/Traction = (1 MPa, 0 Pa), (1 mPa, 0 Pa)\n"), Mode::restart,
          printed);
  check::is_true("and so have those that would have one name",
                 count(printed, "traction-1-mpa-0-pa-") == 2 && count(printed, anew) == 2);

  // A folder of another kind of run.
  {
    std::filesystem::remove(output + "/checkpoint/finished runs");
    std::ofstream(parameter_file) << sweep_of(modulus);
    CommandLine command_line;
    command_line.parameter_file = parameter_file;
    ParameterFile file(parameter_file);
    const std::unique_ptr<Analysis> sweep = analyses().make(file, command_line, MPI_COMM_WORLD);
    const OutputDirectory directory(output, Mode::restart, MPI_COMM_WORLD, file.input_files());
    check::is_true("it has checkpoints", sweep->has_checkpoints());
    check::throws<InputError>(
        "the folder of an ordinary run", [&] { sweep->check_restart(directory); },
        "--restart.*none of a study");
  }

  const std::string one = "set Materials/body/Young's modulus = 1 MPa, 2 MPa\n";
  refuses("an unknown entry", sweep_of("set Materials/body/Young modulus = 1 MPa, 2 MPa\n"),
          "Young modulus");
  refuses("a value that the entry refuses",
          sweep_of("set Materials/body/Young's modulus = 1 MPa, -1 MPa\n"),
          "with young's modulus -1 MPa the input is refused.*out of range");
  refuses("another dimension", sweep_of("set Materials/body/Young's modulus = 1 mm, 2 mm\n"),
          "Entries/.*Young's modulus.*with a unit like Pa");
  refuses("a list and one of its numbers",
          sweep_of("set Mesh/Cells = (1, 2), (2, 4)\nset Mesh/Cells 2 = 2, 3\n"),
          "Mesh/Cells 2.*of the same list as 'Mesh/Cells'");
  refuses("no such place", sweep_of("set Geometry/Size 7 = 1 m, 2 m\n"),
          "Give a place from 1 to 2");
  refuses("a study",
          "set Analysis = sweep\n" + std::string(pulled_bar) +
              "subsection Sweep\nset Analysis = comparison\nsubsection Entries\n" + one +
              "end\nend\n",
          "'comparison' is a study");
  refuses("no analysis",
          "set Analysis = sweep\n" + std::string(pulled_bar) +
              "subsection Sweep\nset Analysis = stedy\nsubsection Entries\n" + one + "end\nend\n",
          "Did you mean 'steady'");
  refuses("nothing is swept", sweep_of(""), "no entry is swept");
  refuses("a quantity that no run has", sweep_of(one, "set Quantities = end: frequenzy\n"),
          "Sweep/Quantities.*frequenzy");
  refuses("an expected one", sweep_of(one, "subsection Expected\nset frequency = 1 +- 1\nend\n"),
          "Sweep/Expected");

  // --sweep makes a sweep of the file's own analysis.
  std::ofstream(parameter_file) << "set Analysis = modal\n" << pulled_bar;
  CommandLine typed;
  typed.parameter_file = parameter_file;
  typed.sweeps = {"Materials/body/Young's modulus=1 MPa, 2 MPa", "Mesh/Cells 1 = 1 to 2 in 2"};
  const CommandLine made = with_sweeps(typed);
  const std::vector<std::string> overrides = {
      "Analysis=sweep", "Sweep/Analysis=modal",
      "Sweep/Entries/\"Materials/body/Young's modulus\"=1 MPa, 2 MPa",
      "Sweep/Entries/\"Mesh/Cells 1\"=1 to 2 in 2"};
  check::is_true("--sweep", made.overrides == overrides && made.sweeps.empty());
  typed.sweeps = {"Mesh/Cells 1=1, 2", " Mesh / Cells  1 = 3, 4"};
  check::throws<InputError>(
      "--sweep twice", [&typed] { with_sweeps(typed); }, "Mesh / Cells  1.*swept twice");
  std::filesystem::remove_all(output);
  std::filesystem::remove(parameter_file);
}
} // namespace test_of_sweep
