#ifndef continua_studies_sweep_h
#define continua_studies_sweep_h

#include <continua/studies/study.h>
#include <continua/studies/sweep_parameters.h>
#include <continua/studies/sweep_report.h>
#include <continua/studies/swept_axis.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * `Analysis = sweep`: performs any analysis but a study for several values of one or more entries
 * of the file, and puts what the runs state into one table (SweepReport).
 *
 * The values are checked before the first run. Of up to 64 runs the input of each is read and
 * checked. Of more it is read for the values of each entry (of a grid with the first values of the
 * others, and for the corners of the grid); of an entry of numbers for about 64 of its values,
 * which lie evenly in the list, and for each that the entry does not accept. Any other run is
 * checked as it begins.
 */
class Sweep : public Study
{
public:
  /// Throws InputError.
  explicit Sweep(const AnalysisInput &input);

  std::vector<std::string> outline() const override;

private:
  /// The input of a run, read.
  struct ReadRun
  {
    QuantityNames quantities;
    double memory = 0.;           ///< by estimate [bytes]
    std::string content_of_files; ///< by their names
  };
  using Settings = std::vector<std::pair<std::string, std::string>>;

  SweepParameters parameters;
  std::vector<SweptAxis> axes;
  std::map<unsigned int, ReadRun> read_runs; ///< by the number of the run

  ParameterSection entries() const { return section().subsection("Entries"); }
  void choose_analysis();
  void choose_parallel();
  /// Reads the input of the file alone: what is wrong with it is not said of a run.
  void read_input();
  void find_entries();
  /// Whether a value of an entry is read before the first run; each is of an entry of words.
  static bool is_read(const SweptAxis &axis, std::size_t place);
  std::vector<unsigned int> runs_to_read() const;
  void read_run(unsigned int run);
  void name_quantities();
  /// The paths and texts that make a run of the file.
  Settings settings(unsigned int run) const;
  /// The command that performs a run, without its folder.
  CommandLine command_line_of(unsigned int run) const;
  /// Of the file without what is swept, and of the values of the run.
  std::string identity(const std::string &of_file, unsigned int run) const;
  std::vector<SweptEntry> swept_entries() const;
  /// All different. A name depends on the values of its run, and not on the place of the run among
  /// the others: a sweep of other values must not take its folder for another run. A name that is
  /// cut, or would be that of several runs, has a checksum of the values.
  std::vector<std::string> names_of_folders() const;

  std::vector<PlannedRun> plan_runs(const std::string &output) const override;
  std::optional<unsigned int> stating_group(unsigned int) const override { return {}; }
  std::unique_ptr<StudyReport> make_report(const std::vector<RunResult> &runs) const override;
  void describe_runs(Summary &summary) const override;
};
} // namespace Continua

#endif
