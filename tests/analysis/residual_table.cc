// The table of the segregated loop's residuals: a row for each correction, in order, down to the
// tolerance; of a loop that diverges, too.

#include "../parameter_text.h"
#include "../postprocess/text_file.h"
#include "column_text.h"

#include <continua/base/input_error.h>
#include <continua/program/analyses.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <sstream>
#include <vector>

#include "../unit_test.h"

namespace test_of_residual_table
{
using namespace Continua;

namespace
{
/// Time, number, both residuals and imbalance.
using Row = std::array<double, 5>;

std::string entries(const std::string &of_loop)
{
  return "set Discretisation = cell-wise\n"
         "subsection Cell-wise\nset Formulation = velocity-pressure\nset Solution = segregated\n"
         "set Residual history = true\n" +
         of_loop +
         "end\n"
         "subsection Initial state\nset Velocity = sin(pi * x / 2), 0\nend\n"
         "subsection Time\nset Scheme = euler implicit\nset Time step = 20 us\n"
         "set End time = 60 us\nend\n";
}

void perform(const std::string &of_loop, Summary &summary)
{
  ParameterFile file = parameters_of(column_text::column("transient", entries(of_loop)));
  const std::unique_ptr<Analysis> analysis = analyses().make(file, CommandLine(), MPI_COMM_WORLD);
  const OutputDirectory directory("residual_table", OutputDirectory::Mode::overwrite,
                                  MPI_COMM_WORLD);
  Log log(MPI_COMM_WORLD, false);
  analysis->perform(directory, log, summary);
}

std::vector<Row> rows()
{
  std::istringstream lines(read_text("residual_table/residuals.csv"));
  std::string line;
  std::getline(lines, line);
  check::equal("header", line,
               "time [s],correction [1],momentum residual [1],continuity residual [1],"
               "momentum imbalance [N]");
  std::vector<Row> result;
  while (std::getline(lines, line))
  {
    std::istringstream cells(line);
    Row row;
    for (double &value : row)
    {
      std::string cell;
      std::getline(cells, cell, ',');
      value = std::stod(cell);
    }
    result.push_back(row);
  }
  return result;
}
} // namespace

UNIT_TEST(residual_table)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  {
    Summary summary;
    perform("set Tolerance = 1e-9\n", summary);
    const std::vector<Row> table = rows();
    check::absolute("rows: as many as corrections", table.size(),
                    3. * quantity(summary, "corrections a step (mean)"), 1e-9);
    unsigned int n_steps = 0;
    bool in_order = true, below = true, falls = true;
    for (std::size_t i = 0; i < table.size(); ++i)
    {
      const bool is_first = i == 0 || table[i][0] != table[i - 1][0];
      const bool is_last = i + 1 == table.size() || table[i + 1][0] != table[i][0];
      n_steps += is_first;
      in_order = in_order && table[i][1] == (is_first ? 1. : table[i - 1][1] + 1.) &&
                 std::abs(table[i][0] - 20e-6 * n_steps) < 1e-12;
      below = below && is_last == (table[i][2] < 1e-9 && table[i][3] < 1e-9);
      falls = falls && (!is_last || is_first || table[i][4] < table[i - table[i][1] + 1][4]);
    }
    check::absolute("steps", n_steps, 3., 0.);
    check::is_true("times and numbers in order", in_order);
    check::is_true("both residuals are below the tolerance in the last row of a step alone", below);
    check::is_true("the imbalance falls in a step", falls);
  }
  {
    Summary summary;
    check::throws<RunError>(
        "a loop that diverges",
        [&]()
        {
          perform("set Variant = thesis\nset Stencil coefficient = shear\n"
                  "set Maximum corrections = 100\n",
                  summary);
        },
        "the segregated loop diverges");
    const std::vector<Row> table = rows();
    check::is_true("its residuals are there", table.size() >= 2);
    check::is_true("they grow", table.size() >= 2 && table.back()[4] > table[table.size() - 2][4]);
  }
}
} // namespace test_of_residual_table
