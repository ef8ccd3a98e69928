// The report of a comparison: two variants whose values have known limits and orders.

#include <continua/base/input_error.h>
#include <continua/studies/chosen_quantities.h>
#include <continua/studies/comparison_report.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>

#include "../parameter_text.h"
#include "../unit_test.h"

namespace test_of_comparison_report
{
using namespace Continua;
using Verdict = ComparisonReport::Verdict;

namespace
{
/// Variant 0 has order 4, variant 1 order 2; the first deflection has one limit, the second two.
std::vector<StudiedRun> runs_of(const ComparisonParameters &parameters)
{
  std::vector<StudiedRun> runs;
  for (const unsigned int mesh : {0, 1, 2})
    for (const unsigned int variant : {0, 1})
    {
      StudiedRun run;
      run.variant = variant;
      run.mesh = parameters.meshes_of(variant)[mesh];
      run.name = (variant == 0 ? "taylor-hood-" : "cell-wise-") + std::to_string(run.mesh);
      run.cell_size = std::pow(0.5, run.mesh);
      run.n_cells = std::pow(4., run.mesh);
      run.n_dofs = 10. * run.n_cells;
      run.wall_time = 1.25;
      const double error = std::pow(run.cell_size, variant == 0 ? 4. : 2.);
      run.quantities = {
          {"final displacement y", 0.3 + (variant == 0 ? 0.01 : -0.05) * error, "m", "tip"},
          {"mean displacement y", 0.2 + 0.01 * variant + 0.01 * error, "m", "tip"},
          {"final displacement x", 1e-16 * (mesh + variant), "m", "tip"},
          {"final pressure", std::pow(-1., mesh) * error, "Pa", "bottom, left"},
          {"frequency", 3. + (variant == 0 ? error : -0.1 * mesh), "Hz", "tip"},
          {"work of the loads", 5., "J", ""},
          {"energy residual", 1e-12, "1", ""},
          {"relative L2 error of velocity", error, "1", ""},
          {"corrections a step (mean)", 3. + mesh, "1", ""}};
      if (mesh == 2)
        run.quantities.push_back({"maximum displacement y", 0.6, "m", "tip"});
      runs.push_back(run);
    }
  return runs;
}

const ComparisonReport::Row &row(const ComparisonReport &report, const std::string_view label)
{
  for (const ComparisonReport::Row &candidate : report.rows())
    if (candidate.label == label)
      return candidate;
  throw std::runtime_error("there is no row " + std::string(label));
}

double quantity(const Summary &summary, const std::string &probe, const std::string &name)
{
  for (const Quantity &candidate : summary.quantities())
    if (candidate.name == name && candidate.probe == probe)
      return candidate.value;
  return std::nan("");
}

std::string content(const std::string &file)
{
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// The numbers of a row of a table, by the columns' places; text cells are 0.
std::vector<double> numbers_of_row(const std::string &table, const std::string &label)
{
  std::vector<double> numbers;
  std::string cell;
  bool is_quoted = false;
  const std::size_t begin = table.find("\n\"" + label + "\"") + 1;
  for (const char letter : table.substr(begin, table.find('\n', begin) + 1 - begin))
  {
    is_quoted = is_quoted != (letter == '"');
    if (is_quoted || (letter != ',' && letter != '\n'))
      cell += letter;
    else
    {
      numbers.push_back(std::strtod(cell.c_str(), nullptr));
      cell.clear();
    }
  }
  return numbers;
}
} // namespace

UNIT_TEST(comparison_report)
{
  ComparisonParameters parameters;
  parameters.second_meshes = {1, 2, 3};
  const std::vector<ConvergenceOrders> orders = {{2., 4.}, {2., 2.}};
  const std::vector<StudiedRun> runs = runs_of(parameters);
  const ComparisonReport report(parameters, orders, runs);

  const ComparisonReport::Row &same = row(report, "tip: final displacement y");
  check::absolute("order of the first", same.convergence[0].order, 4., 1e-6);
  check::absolute("order of the second", same.convergence[1].order, 2., 1e-6);
  check::absolute("limit of the first", same.convergence[0].limit, 0.3, 1e-12);
  check::absolute("limit of the second", same.convergence[1].limit, 0.3, 1e-12);
  check::is_true("agree", same.verdict == Verdict::agree && same.over_errors < 1e-6);

  const ComparisonReport::Row &other = row(report, "tip: mean displacement y");
  check::absolute("difference of the limits", other.difference, 0.01, 1e-12);
  // 1.25 x 0.01 (4^-4 + 4^-3) and floors that are far smaller.
  check::relative("over the estimated errors", other.over_errors,
                  0.01 / (0.0125 * (1. / 256. + 1. / 64.)), 1e-3);
  check::is_true("differ", other.verdict == Verdict::differ);
  ComparisonParameters generous = parameters;
  generous.tolerance = 50.;
  check::is_true(
      "agree within a larger tolerance",
      row(ComparisonReport(generous, orders, runs), "tip: mean displacement y").verdict ==
          Verdict::agree);
  ParameterFile file = parameters_of("subsection Comparison\nset Relative floor = 0.05\nend\n");
  ComparisonParameters read;
  read.read(file.root());
  file.refuse_unknown();
  generous = parameters;
  generous.floor = read.floor;
  check::is_true(
      "agree within a larger floor",
      row(ComparisonReport(generous, orders, runs), "tip: mean displacement y").verdict ==
          Verdict::agree);

  check::is_true("round-off against the largest of its unit",
                 row(report, "tip: final displacement x").convergence[0].behaviour ==
                     GridConvergence::Behaviour::settled);
  check::is_true("oscillating",
                 row(report, "bottom, left: final pressure").convergence[1].behaviour ==
                     GridConvergence::Behaviour::oscillatory);
  check::is_true("not judged without a limit",
                 row(report, "tip: frequency").verdict == Verdict::not_judged);
  check::is_true("not judged where the errors are as large as the limits",
                 row(report, "bottom, left: final pressure").verdict == Verdict::not_judged);
  generous = parameters;
  generous.largest_error = 1e6;
  check::is_true(
      "judged all the same with a larger bound",
      row(ComparisonReport(generous, orders, runs), "bottom, left: final pressure").verdict ==
          Verdict::agree);
  check::is_true("exact in both", row(report, "work of the loads").verdict == Verdict::agree);

  check::is_true("what tells of the computation is left out", report.rows().size() == 6);
  check::is_true("a rule by words",
                 is_of_the_computation("largest difference of first pulse time") &&
                     is_of_the_computation("theoretical wave speed") &&
                     !is_of_the_computation("wave speed") &&
                     !is_of_the_computation("time of first maximum pressure"));
  ComparisonParameters asked = parameters;
  asked.quantities = {"energy residual", "tip: frequency"};
  check::is_true("what is asked for", ComparisonReport(asked, orders, runs).rows().size() == 2);
  check_asked("Comparison/Quantities", asked.quantities, runs[0]);
  asked.quantities = {"tip: frequenzy"};
  check::throws<RunError>(
      "asked for what is not there",
      [&]() { check_asked("Comparison/Quantities", asked.quantities, runs[0]); },
      "taylor-hood-0 has no quantity 'tip: frequenzy'. Did you mean 'tip: frequency'");

  Summary summary;
  report.add_quantities(summary);
  const std::string tip = "tip: final displacement y";
  check::absolute("summary: extrapolated", quantity(summary, tip, "cell-wise extrapolated"), 0.3,
                  1e-12);
  check::absolute("summary: finest", quantity(summary, tip, "taylor hood finest"),
                  0.3 + 0.01 / 256., 1e-12);
  check::absolute("summary: order", quantity(summary, tip, "cell-wise order"), 2., 1e-6);
  check::absolute("summary: agree", quantity(summary, tip, "agree"), 1., 0.);
  check::is_true("summary: no order where there is none",
                 std::isnan(quantity(summary, "work of the loads", "cell-wise order")));
  check::is_true("summary: counts", quantity(summary, "", "quantities compared") == 6. &&
                                        quantity(summary, "", "quantities not judged") == 2. &&
                                        quantity(summary, "", "failed runs") == 0.);

  for (const std::string &line : report.lines())
    std::cout << line << std::endl;

  // One run of the second has failed: two meshes remain.
  std::vector<StudiedRun> failed = runs;
  failed[1].failure = "it diverged";
  failed[1].quantities.clear();
  const ComparisonReport with_failure(parameters, orders, failed);
  check::is_true("two meshes are left", row(with_failure, tip).convergence[1].behaviour ==
                                            GridConvergence::Behaviour::two_meshes);
  check::is_true("the failure is told",
                 with_failure.lines()[6] == "cell-wise-1 failed: it diverged");
  for (unsigned int i = 3; i < 6; i += 2)
    failed[i].failure = "it diverged";
  const ComparisonReport first_alone(parameters, orders, failed);
  check::is_true("the other way alone",
                 row(first_alone, tip).verdict == Verdict::not_judged &&
                     std::abs(row(first_alone, tip).convergence[0].limit - 0.3) < 1e-12 &&
                     row(first_alone, tip).convergence[1].behaviour ==
                         GridConvergence::Behaviour::too_few);

  report.write_quantities("comparison-test.csv");
  const std::string table = content("comparison-test.csv");
  check::is_true("quantities: units",
                 table.find("\n\"tip: final displacement y [m]\",0.31,") != std::string::npos);
  check::is_true("quantities: names",
                 table.find("\"taylor hood, mesh 0\"") != std::string::npos &&
                     table.find("\"cell-wise, mesh 3\"") != std::string::npos &&
                     table.find("\"not judged\"") != std::string::npos);
  // The label, then of each way three values, limit, estimated error, order and the sequence's
  // name.
  const std::vector<double> cells = numbers_of_row(table, "tip: mean displacement y [m]");
  check::is_true("quantities: all columns", cells.size() == 1 + 2 * 7 + 3);
  check::absolute("quantities: limit of the first", cells.at(4), 0.2, 1e-12);
  check::absolute("quantities: order of the first", cells.at(6), 4., 1e-6);
  check::absolute("quantities: limit of the second", cells.at(11), 0.21, 1e-12);
  check::absolute("quantities: order of the second", cells.at(13), 2., 1e-6);
  report.write_runs("comparison-test.csv");
  check::is_true("runs",
                 content("comparison-test.csv")
                         .find("\n\"cell-wise-2\",\"cell-wise\",2,16,0.25,,,160,1.25,\"\"\n") !=
                     std::string::npos);
  std::filesystem::remove("comparison-test.csv");
}
} // namespace test_of_comparison_report
