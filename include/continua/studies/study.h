#ifndef continua_studies_study_h
#define continua_studies_study_h

#include <continua/analysis/analysis_table.h>
#include <continua/base/log.h>
#include <continua/base/output_directory.h>
#include <continua/studies/run_series.h>
#include <continua/studies/study_parameters.h>
#include <continua/studies/study_report.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Continua
{
/**
 * An analysis that performs several runs of a parameter file with other entries, each in a folder
 * of its own (RunSeries), and reports what the runs state. A run that fails is reported with its
 * reason; the others go on. A derived class plans the runs and makes the report.
 */
class Study : public Analysis
{
public:
  bool has_own_table() const override { return true; }
  /// From what its runs have left.
  bool has_checkpoints() const override { return true; }
  /// Refuses the folder of a run that was none of a study.
  void check_restart(const OutputDirectory &directory) const override;
  QuantityNames quantity_names() const override { return quantities; }

protected:
  /// `section_name`: of the study, in the file.
  Study(const AnalysisInput &input, std::string section_name);

  const AnalysisTable &analyses;
  QuantityNames quantities; ///< that the study can state
  double volume = 0.;       ///< of the mesh [m^dim]; 0: there is none

  ParameterSection section() const { return file.root().subsection(section_name); }
  unsigned int n_dimensions() const { return dimension; }
  void set_parameters(const StudyParameters &of_study) { parameters = of_study; }
  /// "TITLE: TEXT" for the title of a run.
  std::string title_of_run(const std::string &text) const;

private:
  const std::string section_name;
  const unsigned int dimension;
  StudyParameters parameters;

  /// With --restart the runs that are finished are taken as they are; see RunSeries. Throws
  /// RunError at the end if a run failed.
  void compute(const OutputDirectory &directory, Log &log, Summary &summary) override;
  /// The runs in their order, in folders of `output`.
  virtual std::vector<PlannedRun> plan_runs(const std::string &output) const = 0;
  /// Of the runs with one number the first that finishes must state every quantity that is asked
  /// for; else the study ends. Nothing: a run may do without.
  virtual std::optional<unsigned int> stating_group(unsigned int run) const = 0;
  /// `runs`: in the order of the plans.
  virtual std::unique_ptr<StudyReport> make_report(const std::vector<RunResult> &runs) const = 0;
  /// Sets in the summary what the runs differ in.
  virtual void describe_runs(Summary &summary) const = 0;
};
} // namespace Continua

#endif
