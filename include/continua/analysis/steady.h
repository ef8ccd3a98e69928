#ifndef continua_analysis_steady_h
#define continua_analysis_steady_h

#include <continua/analysis/flow_report.h>
#include <continua/analysis/range_report.h>
#include <continua/analysis/run.h>
#include <continua/base/table_writer.h>
#include <continua/postprocess/loop_record.h>

#include <memory>

namespace Continua
{
/**
 * The state at rest under the loads at t = 0: one solve for a body that is all solid (static) or
 * all fluid (Stokes); a mixture steps to a steady state with backward Euler. With refinement cycles
 * the mesh is refined by the traction jump and solved again; refinement.csv has a row for each
 * cycle. Where the loads come in steps, load-steps.csv has the probes over them.
 */
template <int dim>
class Steady
{
public:
  explicit Steady(Run<dim> &run) : run(run), flow(run), range(run) {}
  void perform();

  /// A state at rest needs something that holds the body, and has no use for what moves it. Throws
  /// InputError.
  static void check(const Case<dim> &input, ParameterSection root);
  static void name_quantities(const Case<dim> &input, QuantityNames &names);

private:
  Run<dim> &run;
  unsigned int n_steps = 0, n_factors = 0;
  LoopRecord<dim> loop;
  FlowReport<dim> flow;
  RangeReport<dim> range;

  std::unique_ptr<TableWriter> load_table; ///< load-steps.csv
  double last_load = 0.;                   ///< of its last row [1]

  /// `loads_come`: the state is that before any load.
  void solve(bool loads_come);
  /// A row of load-steps.csv: the probes under this part of the loads [1]. Collective.
  void record_load(double load);
};
} // namespace Continua

#endif
