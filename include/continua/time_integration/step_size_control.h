#ifndef continua_time_integration_step_size_control_h
#define continua_time_integration_step_size_control_h

#include <continua/base/archive.h>

namespace Continua
{
/// What bounds the sizes of steps that follow an error estimate.
struct StepSizeParameters
{
  double first = 0.;       ///< [s]
  double tolerance = 1e-4; ///< of the relative local error of a step [1]
  double smallest = 0.;    ///< [s]
  double largest = 0.;     ///< [s]
  unsigned int steps_between_increases = 10;
  unsigned int order = 2; ///< of the scheme
};

/**
 * Chooses the sizes of time steps by their local errors. All sizes are the first one times a power
 * of two, so that there are few of them, and few matrices. A step above the tolerance is to be made
 * again, of a size at which half the tolerance is expected; a step becomes twice as long after
 * several in a row of which half the tolerance is expected even then. Where such an increase is
 * taken back at once, as in a vibration, whose local error goes to zero twice in each period, the
 * next one waits twice as long.
 *
 * Errors are rounded to three digits before anything is decided, so that the round-off of another
 * number of ranks decides nothing.
 */
class StepSizeControl
{
public:
  explicit StepSizeControl(const StepSizeParameters &parameters);

  /// Of the next step, if nothing but its accuracy matters [s].
  double size() const { return size_of(exponent); }
  /// The size times two to the power of `exponent` [s].
  double size_of(int exponent) const;
  int present_exponent() const { return exponent; }
  int smallest_exponent_used() const { return smallest_used; }

  /**
   * Takes the relative local error [1] of a step of the size of `used_exponent`, which may be
   * smaller than what was chosen, and chooses the size of the next one. Returns false if the step
   * is to be made again; a step of the smallest size always stands.
   */
  bool judge(double error, int used_exponent);
  /// A load has jumped: not larger than the first step any more.
  void return_to_first();

  unsigned int n_rejected() const { return rejected; }
  /// Steps of the smallest size with a larger error than the tolerance.
  unsigned int n_above_tolerance() const { return above_tolerance; }

  void save(ArchiveWriter &archive) const;
  void load(const ArchiveReader &archive);

private:
  StepSizeParameters parameters;
  int smallest_exponent, largest_exponent;
  double factor_of_halving; ///< of the error
  int exponent = 0, smallest_used = 0;
  unsigned int small_errors = 0; ///< in a row
  unsigned int wait;             ///< how many make an increase
  unsigned int trial = 0;        ///< steps that the last increase has yet to stand
  unsigned int rejected = 0, above_tolerance = 0;

  void change(int new_exponent);
};
} // namespace Continua

#endif
