#ifndef continua_analysis_rest_search_h
#define continua_analysis_rest_search_h

#include <continua/analysis/run.h>

#include <functional>
#include <string>

namespace Continua
{
/**
 * Brings a body to rest, or a flow to its steady state, under the loads at one time: steps of
 * backward Euler that grow until nothing changes, as the section Steady says, the first of them
 * with a part of the loads where it asks for load steps.
 */
template <int dim>
class RestSearch
{
public:
  /// What to do with each step that stands: its report, the time [s] that has passed since the
  /// start of the search, and its size [s].
  using Sink = std::function<void(const StepReport &report, double passed, double size)>;

  /// `interrupted`: what a message says after a signal that ends the run.
  RestSearch(Run<dim> &run, const Sink &sink, const std::string &interrupted);

  /// `loads_come`: whether they come in the load steps; else the present state has them already.
  /// `time_of_loads` [s], or `mean_over_period`. Throws RunError if the body does not come to rest.
  void perform(bool loads_come, double time_of_loads = 0.);

  /// The same for the unloaded shape of a body that has that of the mesh under the loads at t = 0.
  void find_unloaded_shape(bool loads_come);

  /// Whether the body of a case has a state at rest, and something that holds it. Throws
  /// InputError; `remedy` is what the user can do instead.
  static void check(const Case<dim> &input, ParameterSection root, const std::string &remedy);

private:
  Run<dim> &run;
  const Sink sink;
  const std::string interrupted;
  unsigned int n_steps = 0, n_load_steps = 0, n_halved = 0;
  bool finds_unloaded_shape = false;
  double time_of_loads = 0.;
  double load = 1.;      ///< part of the loads that the last step had [1]
  double load_part = 1.; ///< by which it grew

  /// Makes a step towards rest after one of `last_size` [s], of a smaller size, or with a smaller
  /// part of the loads, where there is no solution. Throws RunError.
  StepReport step_of(double last_size, double &size);
};
} // namespace Continua

#endif
