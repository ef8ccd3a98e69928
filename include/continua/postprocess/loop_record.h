#ifndef continua_postprocess_loop_record_h
#define continua_postprocess_loop_record_h

#include <continua/postprocess/record.h>

namespace Continua
{
/// What the steps of a run say of a solver that corrects its solution in a loop, and of an
/// iterative linear solver; of others, nothing.
template <int dim>
class LoopRecord : public Record<dim>
{
public:
  /// Takes the report of a step that ended at `time` [s]; warns of the first that reached the cap
  /// of corrections and notes the others in log.txt.
  void take(const StepReport &report, double time, Log &log) override;
  /// Adds `corrections a step (mean)` and `(maximum)`, `largest residual` (with which a step's loop
  /// ended) and `steps that reached the cap`; of a linear solver `linear iterations a step (mean)`
  /// and `(maximum)`.
  void finish(Summary &summary) const;
  void finish(const RecordedEnd<dim> &end) override { finish(end.summary); }
  /// The names of what finish() adds.
  static void name_quantities(QuantityNames &names);

  /// The numbers so far, for a restart.
  void save(ArchiveWriter &archive) const override;
  void load(const ArchiveReader &archive) override;

private:
  unsigned long n_steps = 0, n_corrections = 0, most_corrections = 0, n_capped = 0;
  unsigned long n_linear = 0, most_linear = 0; ///< iterations
  double largest_residual = 0.;                ///< [1]
};
} // namespace Continua

#endif
