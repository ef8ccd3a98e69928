#ifndef continua_studies_sweep_report_h
#define continua_studies_sweep_report_h

#include <continua/studies/run_series.h>
#include <continua/studies/study_report.h>

#include <string>
#include <vector>

namespace Continua
{
/// What a sweep has of one entry.
struct SweptEntry
{
  std::string path;
  std::string unit;                ///< SI; empty: its values are words
  std::vector<std::string> values; ///< by run: numbers in this unit, or words
};

/// One run of a sweep.
struct SweptRun : RunResult
{
  std::string values; ///< "young's modulus 2 MPa, wall thickness 1 mm"
};

/// The quantities that the runs of a sweep state, a row a run.
class SweepReport : public StudyReport
{
public:
  /// `quantities`: that are asked for; empty: all but those of the computation, or all if there are
  /// no others (as of wave theory).
  SweepReport(const std::vector<std::string> &quantities,
              const std::vector<SweptEntry> &entries,
              const std::vector<SweptRun> &runs);

  /// "PATH [UNIT]" of each entry: the columns of the table that say what differs.
  static std::vector<std::string> columns(const std::vector<SweptEntry> &entries);

  /// The table for the log: the values, and the quantities that are asked for; why runs failed.
  std::vector<std::string> lines() const override;
  /// Of each quantity "PROBE: NAME": its value in each run, by the values of the entries, and
  /// `smallest` and `largest`; of the whole `runs` and `failed runs`. What does not exist is not
  /// added.
  void add_quantities(Summary &summary) const override;
  /// The names of what add_quantities() adds for one run, of which the summary can state
  /// `of_run`.
  static void name_quantities(const std::vector<std::string> &asked,
                              const std::string &values,
                              const QuantityNames &of_run,
                              QuantityNames &names);
  /// Writes sweep.csv by write_runs(), and citation.bib.
  void write(const OutputDirectory &directory) const override;
  /// A row for each run: its folder, the values of the entries, the quantities, its wall time, and
  /// why it failed.
  void write_runs(const std::string &file) const;

private:
  std::vector<std::string> asked;
  std::vector<SweptEntry> entries;
  std::vector<SweptRun> runs;
  std::vector<std::string> labels; ///< of the quantities
  std::vector<std::string> units;  ///< theirs

  /// NaN where the run has none.
  double value(const SweptRun &run, const std::string &label) const;
};
} // namespace Continua

#endif
