#ifndef continua_studies_refinement_report_h
#define continua_studies_refinement_report_h

#include <continua/studies/refinement_study_parameters.h>
#include <continua/studies/studied_run.h>
#include <continua/studies/study_report.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * The errors of quantities over finer and finer meshes: to a value that is given, or to that of the
 * run with the most unknowns, which then has no error of its own.
 */
class RefinementReport : public StudyReport
{
public:
  /// A quantity along the cycles of one variant, of the runs that have it.
  struct Curve
  {
    std::vector<unsigned int> runs; ///< by number
    std::vector<double> unknowns;   ///< mean over the time [1]
    std::vector<double> sizes;      ///< of the cells [m]; adaptive: unknowns^(-1/dim) [1]
    std::vector<double> values;
    std::vector<double> errors; ///< magnitudes; NaN of the reference itself
    /// log(e1/e2)/log(h1/h2) of a run and the one before; NaN where there is none.
    std::vector<double> orders;

    /// The unknowns from which on errors stay at or below a level, by interpolation of logarithms
    /// between two runs; NaN if they never do, or do so on the coarsest mesh.
    double unknowns_at(double error) const;
    /// Of the last run that has one; NaN if none has.
    double last_error() const;
    double last_order() const;
  };
  struct Row
  {
    std::string label; ///< "PROBE: NAME"
    std::string unit;
    double reference = 0.;
    std::string reference_run; ///< empty: the reference was given
    double round_off = 0.;     ///< errors up to this are none
    std::vector<Curve> curves; ///< by variant
    double scale() const;      ///< |reference|, or 1 if that is 0
  };

  /// Throws RunError for a reference that no run has or whose unit is of another dimension.
  RefinementReport(const RefinementStudyParameters &parameters,
                   unsigned int dimension,
                   const std::vector<StudiedRun> &runs);

  const std::vector<Row> &rows() const { return all_rows; }
  std::vector<std::string> lines() const override;
  /**
   * Of each quantity "PROBE: NAME", relative to the reference: `VARIANT error` on the finest mesh,
   * `VARIANT order`, `VARIANT unknowns at 1 % error` of each level; with two variants `adaptive
   * over uniform unknowns at 1 % error`, and at the error that both reach, `equal error`, `adaptive
   * over uniform unknowns at equal error`. Of the whole `failed runs`. What does not exist is not
   * added.
   */
  void add_quantities(Summary &summary) const override;
  /// The names of what add_quantities() adds when the runs can state `of_runs`.
  static void name_quantities(const RefinementStudyParameters &parameters,
                              const QuantityNames &of_runs,
                              QuantityNames &names);
  /// Writes refinement.csv by write_runs(), and citation.bib.
  void write(const OutputDirectory &directory) const override;
  /// A row for each quantity of each run, and for runs that failed.
  void write_runs(const std::string &file) const;

private:
  RefinementStudyParameters parameters;
  unsigned int dimension;
  std::vector<StudiedRun> runs;
  std::vector<Row> all_rows;

  void set_reference(Row &row) const;
  Curve curve(const Row &row, unsigned int variant) const;
  /// Adaptive over uniform, in whichever order they are.
  double ratio(const Row &row, double error) const;
};
} // namespace Continua

#endif
