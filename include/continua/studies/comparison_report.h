#ifndef continua_studies_comparison_report_h
#define continua_studies_comparison_report_h

#include <continua/postprocess/grid_convergence.h>
#include <continua/studies/comparison_parameters.h>
#include <continua/studies/studied_run.h>
#include <continua/studies/study_report.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * The quantities that two variants of a case have in common, over meshes: what each variant
 * says of the limit, and whether the two limits agree within their estimated errors.
 */
class ComparisonReport : public StudyReport
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
        values[2]; ///< by variant and mesh as in the parameters; NaN where there is none
    std::vector<GridConvergence> convergence; ///< by variant
    double difference;  ///< of the limits, second less first; NaN where one is missing
    double over_errors; ///< its magnitude over the sum of the estimated errors and the floor [1]
    Verdict verdict;
    double round_off; ///< differences up to this are none
  };

  /// `orders`: of the two variants.
  ComparisonReport(const ComparisonParameters &parameters,
                   const std::vector<ConvergenceOrders> &orders,
                   const std::vector<StudiedRun> &runs);

  const std::vector<Row> &rows() const { return all_rows; }
  /// The tables for the log: runs, quantities, what was left out. No wall times.
  std::vector<std::string> lines() const override;
  /// Of each quantity "PROBE: NAME": `VARIANT finest`, `VARIANT extrapolated`, `VARIANT estimated
  /// error`, `VARIANT order`, `difference`, `relative difference`, `difference over errors`,
  /// `agree` (1 or 0); of the whole `quantities compared`, `quantities that agree`, `... differ`,
  /// `... not judged`, `failed runs`. What does not exist is not added.
  void add_quantities(Summary &summary) const override;
  /// The names of what add_quantities() adds when the runs can state `of_runs`.
  static void name_quantities(const ComparisonParameters &parameters,
                              const QuantityNames &of_runs,
                              QuantityNames &names);
  /// Writes comparison.csv by write_quantities(), runs.csv by write_runs(), and citation.bib.
  void write(const OutputDirectory &directory) const override;
  /// A row for each quantity: its label with unit, of each variant the values on the meshes, limit,
  /// estimated error, observed order and what the sequence does, then difference and verdict.
  void write_quantities(const std::string &file) const;
  /// A row for each run: name, variant (`way`), mesh, cells, cell size, time step, steps, unknowns,
  /// wall time, failure.
  void write_runs(const std::string &file) const;

private:
  ComparisonParameters parameters;
  std::vector<ConvergenceOrders> orders;
  std::vector<StudiedRun> runs;
  std::vector<Row> all_rows;
  std::vector<std::string> left_out; ///< labels that neither variant has on two meshes

  const StudiedRun *run(unsigned int variant, unsigned int mesh) const;
  void compare(Row &row) const;
};
} // namespace Continua

#endif
