#ifndef continua_studies_comparison_report_h
#define continua_studies_comparison_report_h

#include <continua/base/summary.h>
#include <continua/postprocess/grid_convergence.h>
#include <continua/studies/comparison_parameters.h>
#include <continua/studies/run_series.h>

#include <string>
#include <vector>

namespace Continua
{
/// One run of a comparison.
struct ComparedRun : RunResult
{
  unsigned int way = 0;  ///< 0 or 1: which of the two values
  unsigned int mesh = 0; ///< how often the cells of the file's mesh are divided
  double time_step = 0.; ///< [s]; 0: none
};

/**
 * The quantities that two ways to compute the same case have in common, over meshes: what each way
 * says of the limit, and whether the two limits agree within their estimated errors.
 */
class ComparisonReport
{
public:
  enum class Verdict
  {
    agree,
    differ,
    not_judged ///< one of the two has no limit
  };
  /// Of one quantity.
  struct Row
  {
    std::string label; ///< "PROBE: NAME"
    std::string unit;
    std::vector<double>
        values[2]; ///< by way and mesh as in the parameters; NaN where there is none
    std::vector<GridConvergence> convergence; ///< by way
    double difference;  ///< of the limits, second less first; NaN where one is missing
    double over_errors; ///< its magnitude over the sum of the estimated errors and the floor [1]
    Verdict verdict;
    double round_off; ///< differences up to this are none
  };

  /// `orders`: of the two ways.
  ComparisonReport(const ComparisonParameters &parameters,
                   const std::vector<ConvergenceOrders> &orders,
                   const std::vector<ComparedRun> &runs);

  const std::vector<Row> &rows() const { return all_rows; }
  /// The tables for the log: runs, quantities, what was left out. No wall times.
  std::vector<std::string> lines() const;
  /// Of each quantity "PROBE: NAME": `WAY finest`, `WAY extrapolated`, `WAY estimated error`, `WAY
  /// order`, `difference`, `relative difference`, `difference over errors`, `agree` (1 or 0); of
  /// the whole `quantities compared`, `quantities that agree`, `... differ`, `... not judged`,
  /// `failed runs`. What does not exist is not added.
  void add_quantities(Summary &summary) const;
  /// The names of what add_quantities() adds when the runs can state `of_runs`.
  static void name_quantities(const ComparisonParameters &parameters,
                              const QuantityNames &of_runs,
                              QuantityNames &names);
  /// A row for each quantity: its label with unit, of each way the values on the meshes, limit,
  /// estimated error, observed order and what the sequence does, then difference and verdict.
  void write_quantities(const std::string &file) const;
  /// A row for each run: name, way, mesh, cells, cell size, time step, steps, unknowns, wall time,
  /// failure.
  void write_runs(const std::string &file) const;

private:
  ComparisonParameters parameters;
  std::vector<ConvergenceOrders> orders;
  std::vector<ComparedRun> runs;
  std::vector<Row> all_rows;
  std::vector<std::string> left_out; ///< labels that neither way has on two meshes

  const ComparedRun *run(unsigned int way, unsigned int mesh) const;
  void compare(Row &row) const;
};
} // namespace Continua

#endif
