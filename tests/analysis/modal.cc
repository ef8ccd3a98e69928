// The modes of a column between smooth walls: frequencies (2 k - 1) c/(4 L), the shares of its mass
// that take part in them, 8/((2 k - 1) pi)^2, and the table of modes.

#include "../parameter_text.h"
#include "../postprocess/text_file.h"
#include "column_text.h"

#include <continua/analysis/modal.h>
#include <continua/program/analyses.h>

#include <algorithm>

#include "../unit_test.h"

namespace test_of_modal
{
using namespace Continua;

namespace
{
unsigned int number = 0;

/// A parameter file's modal analysis, performed.
struct ModalAnalysis
{
  explicit ModalAnalysis(const std::string &text)
      : file(parameters_of(text)),
        input(analyses().read_case<2>(file, MPI_COMM_WORLD)),
        // Each in a folder of its own: a folder belongs to one run.
        directory(
            "modal-" + std::to_string(++number), OutputDirectory::Mode::overwrite, MPI_COMM_WORLD),
        log(MPI_COMM_WORLD, false),
        run(input, file, command_line, directory, log, summary)
  {
    Modal<2>(run).perform();
  }

  ParameterFile file;
  Case<2> input;
  CommandLine command_line;
  OutputDirectory directory;
  Log log;
  Summary summary;
  Run<2> run;
};

/// The frequencies [Hz] that it finds, in its order.
std::vector<double> frequencies(const std::string &text)
{
  const ModalAnalysis analysis(text);
  std::vector<double> result;
  for (unsigned int k = 1;; ++k)
  {
    const double value = quantity(analysis.run.summary, "mode " + std::to_string(k) + " frequency");
    if (std::isnan(value))
      return result;
    result.push_back(value);
  }
}
} // namespace

UNIT_TEST(modal)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const ModalAnalysis analysis(
      column_text::column("modal", "subsection Modal\nset Number of modes = 3\nend\n"
                                   "subsection Probes\nsubsection end\nset Point = 1 m, 0.05 m\n"
                                   "set Fields = displacement x\nend\nend\n"));
  const Run<2> &run = analysis.run;

  const double first = column_text::wave_speed / 4.;
  for (unsigned int k = 1; k <= 3; ++k)
  {
    const std::string name = "mode " + std::to_string(k) + " ";
    const double order = 2. * k - 1.;
    // Of quadratic elements of h = 0.1 m the relative error is (order pi h/2)^4/1440.
    check::relative(name + "frequency", quantity(run.summary, name + "frequency"), order * first,
                    2e-4);
    check::absolute(name + "growth rate", quantity(run.summary, name + "growth rate"), 0., 1e-6);
    check::relative(name + "share of mass along x",
                    quantity(run.summary, name + "share of mass along x"),
                    8. / (order * order * M_PI * M_PI), 1e-3);
    check::absolute(name + "share of mass along y",
                    quantity(run.summary, name + "share of mass along y"), 0., 1e-9);
  }
  check::absolute("a fourth mode is not asked for",
                  std::isnan(quantity(run.summary, "mode 4 frequency")), 1., 0.);
  check::relative("share of the three", quantity(run.summary, "share of mass along x"),
                  8. / (M_PI * M_PI) * (1. + 1. / 9. + 1. / 25.), 1e-3);
  check::relative("mass of a metre of depth", quantity(run.summary, "mass"), 140., 1e-12);
  check::is_true("residual", quantity(run.summary, "largest residual") < 1e-8);

  // In the first mode the end moves by 1 m, the largest displacement of a shape.
  const std::string table = read_text(analysis.directory.file("modes.csv"));
  check::absolute("rows of modes.csv", std::count(table.begin(), table.end(), '\n'), 4., 0.);
  const std::size_t begin = table.find('\n') + 1;
  const std::string row = table.substr(begin, table.find('\n', begin) - begin);
  check::absolute("displacement of the end", std::abs(std::stod(row.substr(row.rfind(',') + 1))),
                  1., 1e-3);

  // The highest modes of the cell-wise operator, which are sought in another way than the lowest:
  // they are the last of all 20 modes of 10 cells.
  const std::string cells = "set Discretisation = cell-wise\nsubsection Cell-wise\n"
                            "set Formulation = displacement\nend\nsubsection Modal\n";
  const std::vector<double> all =
      frequencies(column_text::column("modal", cells + "set Number of modes = 20\nend\n"));
  const std::vector<double> highest = frequencies(
      column_text::column("modal", cells + "set Which = highest\nset Number of modes = 2\nend\n"));
  check::is_true("all modes, the lowest first",
                 all.size() == 20 && std::is_sorted(all.begin(), all.end()));
  check::absolute("two of the highest", highest.size(), 2., 0.);
  check::relative("the highest", highest.front(), all.back(), 1e-6);
  check::relative("the one below", highest.back(), all[all.size() - 2], 1e-6);
}
} // namespace test_of_modal
