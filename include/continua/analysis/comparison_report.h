#ifndef continua_analysis_comparison_report_h
#define continua_analysis_comparison_report_h

#include <continua/analysis/comparison_parameters.h>
#include <continua/base/summary.h>
#include <continua/postprocess/grid_convergence.h>

#include <string>
#include <vector>

namespace Continua
{
/// What one run of a comparison left, as its summary.json says.
struct ComparedRun
{
  std::string name;      ///< of its folder: "taylor-hood-0"
  unsigned int way = 0;  ///< 0 or 1: which of the two values
  unsigned int mesh = 0; ///< how often the cells of the file's mesh are divided
  std::string failure;   ///< why it failed; empty if it finished
  double n_cells = 0.;   ///< [1]
  double n_dofs = 0.;    ///< [1] of all fields
  double cell_size = 0.; ///< [m], the dim-th root of volume over cells
  double time_step = 0.; ///< [s]; 0: none
  double wall_time = 0.; ///< [s]
  double n_steps = 0.;   ///< [1]
  std::vector<Quantity> quantities;
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

  /// `orders`: of the two ways. Throws RunError for a quantity that was asked for and that no run
  /// has.
  ComparisonReport(const ComparisonParameters &parameters,
                   const std::vector<ConvergenceOrders> &orders,
                   const std::vector<ComparedRun> &runs);

  /// Throws RunError for a quantity that was asked for and that this run has not.
  static void check_asked(const ComparisonParameters &parameters, const ComparedRun &run);
  /// Whether a quantity tells of the computation (an error, a count) rather than of the body.
  static bool is_of_the_computation(const std::string &name);

  const std::vector<Row> &rows() const { return all_rows; }
  /// The tables for the log: runs, quantities, what was left out. No wall times.
  std::vector<std::string> lines() const;
  /// Of each quantity "PROBE: NAME": `WAY finest`, `WAY extrapolated`, `WAY estimated error`, `WAY
  /// order`, `difference`, `relative difference`, `difference over errors`, `agree` (1 or 0); of
  /// the whole `quantities compared`, `quantities that agree`, `... differ`, `... not judged`,
  /// `failed runs`. What does not exist is not added.
  void add_quantities(Summary &summary) const;
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
  /// The labels that count, in the order of the summaries.
  std::vector<std::string> labels() const;
  void compare(Row &row) const;
};
} // namespace Continua

#endif
