// Errors, orders and unknowns at equal error, of values made by hand.

#include <continua/base/input_error.h>
#include <continua/studies/refinement_report.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "../unit_test.h"

namespace test_of_refinement_report
{
using namespace Continua;

namespace
{
/// Uniform cells of size 2^-k: unknowns 100 * 4^k, error 0.1 * 2^-k of 2. Adaptive: unknowns 100 *
/// 2^k, error 0.1 * 4^-k.
std::vector<StudiedRun> runs_of()
{
  std::vector<StudiedRun> runs;
  for (unsigned int cycle = 0; cycle < 5; ++cycle)
    for (const unsigned int variant : {0, 1})
    {
      StudiedRun run;
      run.variant = variant;
      run.mesh = cycle;
      run.name = (variant == 0 ? "uniform-" : "adaptive-") + std::to_string(cycle);
      run.n_cells = std::pow(variant == 0 ? 4. : 2., cycle);
      run.n_dofs = 100. * run.n_cells;
      run.cell_size = std::pow(run.n_cells, -0.5);
      run.wall_time = 1.25;
      run.quantities = {{"final displacement y",
                         2. + 0.2 * std::pow(variant == 0 ? 0.5 : 0.25, cycle), "m", "tip"},
                        {"frequency", 3. - std::pow(0.25, cycle), "Hz", "tip"},
                        {"work of the loads", 5., "J", ""},
                        {"energy residual", 1e-12, "1", ""}};
      // As a mesh that changes has it: half as many unknowns in the mean.
      if (variant == 1)
        run.quantities.push_back({"unknowns (mean)", 0.5 * run.n_dofs, "1", ""});
      runs.push_back(run);
    }
  return runs;
}

double quantity(const Summary &summary, const std::string &probe, const std::string &name)
{
  for (const Quantity &candidate : summary.quantities())
    if (candidate.name == name && candidate.probe == probe)
      return candidate.value;
  return std::nan("");
}
} // namespace

UNIT_TEST(refinement_report)
{
  RefinementStudyParameters parameters;
  parameters.variants = {"uniform", "adaptive"};
  parameters.cycles = 4;
  parameters.error_levels = {0.01, 1e-6};
  parameters.references = {parse_expected_value("tip: final displacement y", "2000 mm +- 0")};
  const RefinementReport report(parameters, 2, runs_of());
  check::is_true("quantities of the body", report.rows().size() == 3);

  const RefinementReport::Row &tip = report.rows()[0];
  check::absolute("reference in its own unit", tip.reference, 2., 1e-12);
  check::absolute("error of the coarsest", tip.curves[0].errors[0], 0.2, 1e-12);
  check::absolute("order of uniform cells", tip.curves[0].orders[4], 1., 1e-12);
  // e ~ N^-2: order 4 in N^(-1/2).
  check::absolute("order of adaptive cells", tip.curves[1].orders[4], 4., 1e-12);
  check::absolute("unknowns are those of the mean", tip.curves[1].unknowns[2], 200., 1e-12);
  // 0.1 * 2^-k = 0.01: N = 100 * 4^k = 100 * 100; 0.1 * 4^-k = 0.01: N = 50 * 2^k = 50 sqrt(10).
  check::relative("unknowns, uniform", tip.curves[0].unknowns_at(0.02), 1e4, 1e-12);
  check::relative("unknowns, adaptive", tip.curves[1].unknowns_at(0.02), 50. * std::sqrt(10.),
                  1e-12);
  check::is_true("an error that none has", std::isnan(tip.curves[0].unknowns_at(1e-6)));
  check::is_true("an error that the coarsest has", std::isnan(tip.curves[0].unknowns_at(0.3)));

  const RefinementReport::Row &frequency = report.rows()[1];
  check::equal("without a value the finest is the reference", frequency.reference_run, "uniform-4");
  check::is_true("which has no error", std::isnan(frequency.curves[0].errors[4]));
  check::relative("others are to it", frequency.curves[0].errors[0], 1. - std::pow(0.25, 4), 1e-12);
  check::is_true("and no order", std::isnan(frequency.curves[0].orders[4]) &&
                                     std::isfinite(frequency.curves[0].orders[3]));

  RefinementReport::Curve back;
  back.unknowns = {10., 100., 1000., 10000.};
  back.errors = {1., 0.001, 1., 0.01};
  back.orders.assign(4, 1.);
  check::relative("an error that is small by chance", back.unknowns_at(0.1), 1000. * std::sqrt(10.),
                  1e-12);

  Summary summary;
  report.add_quantities(summary);
  const std::string label = "tip: final displacement y";
  check::relative("summary: error", quantity(summary, label, "uniform error"), 0.1 / 16., 1e-12);
  check::relative("summary: ratio",
                  quantity(summary, label, "adaptive over uniform unknowns at 1 % error"),
                  50. * std::sqrt(10.) / 1e4, 1e-12);
  check::relative("summary: equal error", quantity(summary, label, "equal error"), 0.1 / 16.,
                  1e-12);
  // 0.1 * 4^-k = 0.1 / 16: N = 200.
  check::relative("summary: unknowns at equal error",
                  quantity(summary, label, "adaptive over uniform unknowns at equal error"),
                  200. / 25600., 1e-12);
  check::is_true("summary: nothing where there is nothing",
                 std::isnan(quantity(summary, label, "uniform unknowns at 0.0001 % error")));
  for (const std::string &line : report.lines())
    std::cout << line << std::endl;

  parameters.references = {parse_expected_value("tip: final displacement y", "2 s +- 0")};
  check::throws<RunError>(
      "a reference of another dimension", [&]() { RefinementReport(parameters, 2, runs_of()); },
      "no unit of a quantity in 'm'");
  parameters.references = {parse_expected_value("tip: deflection", "2 m +- 0")};
  check::throws<RunError>(
      "a reference of nothing", [&]() { RefinementReport(parameters, 2, runs_of()); },
      "no run has the quantity 'tip: deflection'");

  std::vector<StudiedRun> failed = runs_of();
  failed[9].failure = "it diverged";
  failed[9].quantities.clear();
  parameters.references.clear();
  const RefinementReport with_failure(parameters, 2, failed);
  check::is_true("a run that failed is left out",
                 with_failure.rows()[0].curves[1].runs.size() == 4 &&
                     with_failure.lines()[10] == "adaptive-4 failed: it diverged");
  with_failure.write_runs("refinement-test.csv");
  std::ostringstream text;
  text << std::ifstream("refinement-test.csv").rdbuf();
  check::is_true("rows", text.str().find("\n\"uniform\",1,\"uniform-1\",4,400,0.5,,,,1.25,\"tip: "
                                         "frequency\",\"Hz\",2.75,2.99609375,0.24609375,") !=
                                 std::string::npos &&
                             text.str().find(",\"it diverged\"\n") != std::string::npos);
  std::filesystem::remove("refinement-test.csv");
}
} // namespace test_of_refinement_report
