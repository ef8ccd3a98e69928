#ifndef continua_postprocess_step_record_h
#define continua_postprocess_step_record_h

#include <continua/postprocess/record.h>

#include <limits>

namespace Continua
{
/// What became of the steps of a run: how many matrices they took, and, where the time step adapts,
/// their sizes and rejections.
template <int dim>
class StepRecord : public Record<dim>
{
public:
  /// Takes the report of a step, or part of one, whether it stands or not.
  void attempt(const StepReport &report) override;
  /// Takes the size of a step that stands.
  void record(const RecordedStep<dim> &step) override;
  /**
   * Sets `matrices factored` in the summary. Of an adaptive step adds `steps rejected`, `steps
   * above the tolerance`, `smallest time step`, `largest time step` and `mean time step`; tells of
   * them in one line, and warns of steps that stand with a larger error than the tolerance.
   */
  void finish(const RecordedEnd<dim> &end) override;
  /// The names of what finish() adds.
  static void name_quantities(QuantityNames &names);

  /// The numbers so far, for a restart.
  void save(ArchiveWriter &archive) const override;
  void load(const ArchiveReader &archive) override;

private:
  unsigned long n_factored = 0;
  double smallest = std::numeric_limits<double>::infinity(), largest = 0.; ///< [s]
};
} // namespace Continua

#endif
