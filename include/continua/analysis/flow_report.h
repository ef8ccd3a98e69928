#ifndef continua_analysis_flow_report_h
#define continua_analysis_flow_report_h

#include <continua/analysis/run.h>
#include <continua/case/before_the_run/flow_numbers.h>

#include <optional>

namespace Continua
{
/// What a run with convection says of the numbers of its flow, before its first step and after its
/// last one. Without convection it says nothing.
template <int dim>
class FlowReport
{
public:
  explicit FlowReport(Run<dim> &run) : run(run) {}

  /// Before the first step. `frequency` of the load [Hz], 0 if none varies; `tube_speed` [m/s] of
  /// the pressure wave, 0 if the body is no tube with a wall.
  void start(double frequency, double tube_speed);
  /// A step of a size [s] that stands; 0 of a steady flow.
  void take(const StepReport &report, double size);
  /// The numbers that the flow has attained.
  void finish();
  static void name_quantities(const Case<dim> &input, QuantityNames &names);

  void save(ArchiveWriter &archive) const;
  void load(const ArchiveReader &archive);

private:
  Run<dim> &run;
  std::optional<FlowNumbers> numbers;
  double largest_speed = 0.;   ///< [m/s]
  double largest_courant = 0.; ///< [1]
  bool is_in_time = false;
};
} // namespace Continua

#endif
