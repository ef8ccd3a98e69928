#ifndef continua_analysis_steady_search_h
#define continua_analysis_steady_search_h

#include <continua/analysis/run.h>

#include <functional>
#include <string>

namespace Continua
{
/**
 * Brings a body to rest, or a flow to its steady state, under the loads at one time. What is found
 * obeys the steady equations (see static_step()), whatever the steps on the way there are like.
 *
 * Linear equations: static steps from the start. A solid alone has its displacement after one of
 * them, and so has a liquid alone its velocity. Where both are there, the velocity that a solid
 * still has in the first one sets the liquid in motion, which the next ones show and take away.
 *
 * Equations that are not linear: steps of backward Euler, which keep the inertia and grow until the
 * velocity hardly changes, as the section Steady says, the first of them with a part of the loads
 * where it asks for load steps. That a step changes little shows nothing of the state at rest, so
 * static steps follow. If they have no solution, the steps with inertia go on.
 */
template <int dim>
class SteadySearch
{
public:
  /// What to do with each step that stands: its report, the time [s] that has passed since the
  /// start of the search, and its size [s].
  using Sink = std::function<void(const StepReport &report, double passed, double size)>;

  /// `interrupted`: what a message says after a signal that ends the run.
  SteadySearch(Run<dim> &run, const Sink &sink, const std::string &interrupted);

  /// How the loads come.
  enum class Loads
  {
    present,   ///< the state has them already, or takes them at once
    in_parts,  ///< the load steps bring them
    along_time ///< the state has those at t = 0, and the load steps go through the times from there
  };
  /// `time_of_loads` [s], or `mean_over_period`. Throws RunError if the body does not come to rest.
  void perform(Loads loads, double time_of_loads = 0.);

  /// The same for the unloaded shape of a body that has that of the mesh under the loads at t = 0.
  void find_unloaded_shape(bool loads_come);

  /// The part of the loads, or of their time, that the last step had [1].
  double present_load() const { return load; }

  /// Whether the body of a case has a state at rest, and something that holds it. Throws
  /// InputError; `remedy` is what the user can do instead.
  static void check(const Case<dim> &input, ParameterSection root, const std::string &remedy);

private:
  Run<dim> &run;
  const Sink sink;
  const std::string interrupted;
  unsigned int n_steps = 0, n_load_steps = 0, n_shortened = 0;
  bool finds_unloaded_shape = false;
  double time_of_loads = 0.;
  bool goes_along_time = false;
  double load = 1.;      ///< part of the loads, or of the time, that the last step had [1]
  double load_part = 1.; ///< by which it grew

  unsigned int n_static = 0; ///< static steps of the last balance()

  void perform_linear();
  /// Makes static steps until they change the displacement of each solid and the forces of each
  /// liquid by less than the tolerance; false if they do not come to that. `last_size` [s]: of the
  /// step before them.
  bool balance(double last_size);
  /// A part of the loads or of their time [1], and what the equations leave out.
  void set_loads(Step &step, double part = 1.) const;
  /// Makes a step towards a steady state after one of `last_size` [s], of a smaller size, or with a
  /// smaller part of the loads, where there is no solution. Throws RunError.
  StepReport step_of(double last_size, double &size);
};
} // namespace Continua

#endif
