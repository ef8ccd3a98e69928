// The table of a sweep: numbers and words, a run that failed, quantities that are not everywhere,
// smallest and largest.

#include <continua/base/input_file.h>
#include <continua/base/quantity_names.h>
#include <continua/studies/sweep_report.h>

#include "../unit_test.h"

#include <filesystem>

namespace test_of_sweep_report
{
using namespace Continua;

namespace
{
SweptRun run_of(const std::string &name,
                const std::string &values,
                const std::vector<Quantity> &quantities,
                const std::string &failure = "")
{
  SweptRun run;
  run.name = name;
  run.values = values;
  run.quantities = quantities;
  run.failure = failure;
  return run;
}

double number(const Summary &summary, const std::string &name, const std::string &probe)
{
  for (const Quantity &quantity : summary.quantities())
    if (quantity.name == name && quantity.probe == probe)
      return quantity.value;
  return -1e300;
}
} // namespace

UNIT_TEST(sweep_report)
{
  const std::vector<SweptEntry> entries = {
      {"Materials/wall/Young's modulus", "Pa", {"1e6", "2e6", "3e6"}},
      {"Time/Scheme", "", {"crank nicolson", "bdf", "bdf"}}};
  std::vector<SweptRun> runs = {
      run_of(
          "a", "modulus 1 MPa",
          {{"frequency", 2., "Hz", "tip"}, {"energy error", 1., "1", ""}, {"mass", 4., "kg", ""}}),
      run_of("b", "modulus 2 MPa", {{"frequency", 3., "Hz", "tip"}}),
      run_of("c", "modulus 3 MPa", {{"frequency", 9., "Hz", "tip"}}, "it \"diverges\"")};
  runs[0].wall_time = 1.5;
  const SweepReport all({}, entries, runs);
  const std::string file = "sweep-report-test.csv";
  all.write_runs(file);
  check::equal("table", read_input_file(file),
               "run,\"Materials/wall/Young's modulus [Pa]\",\"Time/Scheme\",\"tip: frequency "
               "[Hz]\",\"mass [kg]\",wall time [s],failure\n"
               "\"a\",1e6,\"crank nicolson\",2,4,1.5,\"\"\n"
               "\"b\",2e6,\"bdf\",3,,,\"\"\n"
               "\"c\",3e6,\"bdf\",,,,\"it \"\"diverges\"\"\"\n");
  std::filesystem::remove(file);
  Summary summary;
  all.add_quantities(summary);
  check::absolute("a value", number(summary, "modulus 1 MPa", "tip: frequency"), 2., 0.);
  check::absolute("another", number(summary, "modulus 2 MPa", "tip: frequency"), 3., 0.);
  check::absolute("none of a run that failed", number(summary, "modulus 3 MPa", "tip: frequency"),
                  -1e300, 0.);
  check::absolute("smallest", number(summary, "smallest", "tip: frequency"), 2., 0.);
  check::absolute("largest", number(summary, "largest", "tip: frequency"), 3., 0.);
  check::absolute("one alone", number(summary, "largest", "mass"), 4., 0.);
  check::absolute("none of the computation", number(summary, "largest", "energy error"), -1e300,
                  0.);
  check::absolute("runs", number(summary, "runs", ""), 3., 0.);
  check::absolute("failed runs", number(summary, "failed runs", ""), 1., 0.);

  std::string lines;
  for (const std::string &line : SweepReport({"frequency"}, entries, runs).lines())
    lines += line + "\n";
  check::equal("lines", lines,
               "Materials/wall/Young's modulus [Pa]     Time/Scheme  tip: frequency [Hz]\n"
               "1e6                                  crank nicolson                    2\n"
               "2e6                                             bdf                    3\n"
               "3e6                                             bdf                    -\n"
               "c failed: it \"diverges\"\n");

  // Where all tells of the computation by its name, as in wave theory, all is shown.
  const SweepReport theory({}, {{"A", "", {"x"}}},
                           {run_of("a", "a x", {{"theoretical wave speed", 5., "m/s", "tube"}})});
  Summary of_theory;
  theory.add_quantities(of_theory);
  check::absolute("theory", number(of_theory, "a x", "tube: theoretical wave speed"), 5., 0.);

  QuantityNames of_run, names;
  of_run.add("frequency", "tip");
  of_run.add("energy error");
  SweepReport::name_quantities({}, "modulus 1 MPa", of_run, names);
  check::is_true("names", names.has("modulus 1 MPa", "tip: frequency") &&
                              names.has("smallest", "tip: frequency") && names.has("runs", "") &&
                              !names.has("largest", "energy error"));
  QuantityNames names_of_asked;
  SweepReport::name_quantities({"tip: mass"}, "modulus 1 MPa", of_run, names_of_asked);
  check::is_true("none of a run without what is asked for",
                 !names_of_asked.has("modulus 1 MPa", "tip: frequency"));
  QuantityNames of_theory_run, names_of_theory;
  of_theory_run.add("theoretical wave speed", "tube");
  SweepReport::name_quantities({}, "a x", of_theory_run, names_of_theory);
  check::is_true("names of theory", names_of_theory.has("a x", "tube: theoretical wave speed"));
}
} // namespace test_of_sweep_report
