#ifndef continua_analysis_periodic_state_h
#define continua_analysis_periodic_state_h

#include <continua/analysis/run.h>
#include <continua/postprocess/run_table.h>

#include <optional>
#include <string>
#include <vector>

namespace Continua
{
/**
 * The beats of a run in time, as the section Periodic state asks for them: the table beats.csv with
 * a row for each, and whether the last one is as the one before. All follows from the histories of
 * the probes, so that a restart needs nothing else. Without the section it does nothing. Methods
 * are collective.
 */
template <int dim>
class PeriodicState
{
public:
  explicit PeriodicState(Run<dim> &run);

  /// Starts the table, once the probes are open. Throws RunError on all ranks.
  void open();
  /// Goes on with it after a restart at `time` [s], once the probes have their histories.
  void resume(double time);
  /// Whether a beat ends at `time` [s], which a step has led to.
  bool ends_beat(double time) const;
  /// Adds the beat that ends at `time` [s], of which the probes have the last row.
  void add_beat(double time);
  /// Whether the run is to end, since its beats have settled.
  bool ends_run() const { return is_at_end_of_beat && parameters().stops && has_settled(); }

  /// The quantities of the last beat, the table, and a warning if the beats have not settled.
  void finish();
  static void name_quantities(const Case<dim> &input, QuantityNames &names);

  /// At `time` [s].
  void save(ArchiveWriter &archive, double time) const;
  /// Whether a run that goes on from a checkpoint is at its end by it, before it has its histories.
  static bool ended_run(const Case<dim> &input, const ArchiveReader &archive);
  void flush_to_disk() { table_file.flush_to_disk(); }
  std::optional<WrittenTable> table() const { return table_file.written(); }

private:
  Run<dim> &run;
  RunTable table_file;
  std::vector<bool> is_compared;         ///< by column of the probes
  std::vector<std::vector<double>> rows; ///< of the table, by beat
  bool is_at_end_of_beat = false;
  unsigned int settled_at = 0;  ///< the first beat that had settled; 0: none
  double largest_difference;    ///< of the last beat [1]; NaN: not known
  std::string place_of_largest; ///< the label of the column that has it

  const PeriodicStateParameters &parameters() const { return run.input.periodic_state; }
  bool has_settled() const { return largest_difference <= parameters().tolerance; }
  void find_compared();
  std::vector<std::string> header() const;
  /// Evaluates the beat `number`, from 1, and adds its row to `rows`.
  void evaluate(std::size_t number);
  /// "beat 3 differs from the one before by 0.0123 of its range (outlet: pressure)".
  std::string text_of_difference() const;
};
} // namespace Continua

#endif
