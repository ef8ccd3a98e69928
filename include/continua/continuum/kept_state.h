#ifndef continua_continuum_kept_state_h
#define continua_continuum_kept_state_h

#include <continua/base/archive.h>
#include <continua/continuum/state_visitor.h>
#include <continua/continuum/step_error_estimate.h>

#include <functional>
#include <string>
#include <vector>

namespace Continua
{
/**
 * The state before a step, in memory: to undo the step, to estimate its error, and to move the
 * older level to another distance. Before it is asked to keep anything it has and does nothing.
 * After the first two steps on a mesh nothing is allocated any more.
 *
 * With the state's own older level and the one before that, which it also has, three levels are
 * known before each step: a step of twice the size finds its older level among them, one of a
 * smaller size has it on the parabola through them, in all vectors alike. The error of that is of
 * third order, as that of a step is.
 */
class KeptState
{
public:
  /// Hands all of the solver's state to the visitor, the velocity first.
  using State = std::function<void(StateVisitor &)>;
  explicit KeptState(State state) : state(std::move(state)) {}

  /// The mesh has changed: what was kept belongs to another one.
  void forget();
  void keep();
  void give_back();

  /// To be called before a step: moves the older level to where the step wants it. False if it
  /// stays.
  bool move_older_level(const Step &step);
  /// To be called after a step.
  void advance(const Step &step);
  bool error_is_known() const { return in_use && estimate.is_known(); }
  /// Sets `error` to the estimated local error of the last step's velocity [m/s], n numbers as the
  /// state has them.
  void velocity_error(const double *velocity, double *error, std::size_t n) const;

  /// Hands the state itself to a visitor.
  void visit(StateVisitor &visitor) const { state(visitor); }
  /// What a step after a restart needs of what is kept, bit by bit; nothing if it is not in use.
  /// The visitors save and load the older level of the state: it has the eldest one in its place
  /// for as long. Load before the state itself.
  void save(ArchiveWriter &archive, StateVisitor &save_older) const;
  void load(const ArchiveReader &archive, StateVisitor &load_older);

private:
  /// The numbers of all levels, one after the other: at the present time when they were kept, one
  /// step before, and two.
  using Numbers = std::vector<double>;
  class Copy;
  class Return;
  class Move;
  class Exchange;

  State state;
  bool in_use = false;
  Numbers present, older, eldest, others;
  StepErrorEstimate estimate, kept_estimate;
};
} // namespace Continua

#endif
