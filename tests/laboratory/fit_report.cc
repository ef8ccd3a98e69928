// What the log says of a fit: angles in degrees, what is in doubt, residuals in order, a search
// without an end.

#include <continua/laboratory/fit_report.h>

#include <continua/base/input_error.h>
#include <continua/base/undefined.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <random>
#include <vector>

#include "../unit_test.h"

namespace test_of_fit_report
{
using namespace Continua;

namespace
{
void test_of_order()
{
  std::vector<double> smooth, white;
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  for (unsigned int i = 0; i < 40; ++i)
  {
    smooth.push_back(std::cos(0.1 * i));
    white.push_back(normal(generator));
  }
  check::is_true("a curve is warned of", check::matches(warning_of_order("the table", smooth),
                                                        "of the table is no independent error"));
  check::equal("noise is not", warning_of_order("the table", white), "");
  check::equal("nor are three rows", warning_of_order("the table", {1., 2., 3.}), "");
}
} // namespace

UNIT_TEST(fit_report)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_of_order();
  FitParameter angle, modulus;
  angle.name = "angle";
  angle.unit = "rad";
  modulus.name = "modulus";
  modulus.unit = "Pa";
  FitResult result;
  result.estimates = {std::acos(-1.) / 3., 5.};
  result.standard_errors = {std::acos(-1.) / 180., undefined};
  result.intervals = {{std::acos(-1.) / 4., std::acos(-1.) / 2., false, false},
                      {undefined, undefined, false, false}};
  result.at_bound = {false, false};
  result.free = {0, 1};
  result.correlation.reinit(2, 2);
  result.correlation(0, 1) = undefined;
  result.notes = {"a note", "a doubt"};
  result.doubts = {"a doubt"};
  result.converged = false;
  result.stop_reason = "of a reason";
  // Its lines stand in the output of this test.
  Log log(MPI_COMM_WORLD);
  Summary summary;
  report_fit({angle, modulus}, result, log, summary);
  check::is_true("a doubt is a warning", log.warnings() == std::vector<std::string>{"a doubt"});
  check::throws<RunError>(
      "a search without an end", [&]() { require_end(result, "the wall"); },
      "of the wall did not come to its end: of a reason");
  result.converged = true;
  require_end(result, "the wall");
}
} // namespace test_of_fit_report
