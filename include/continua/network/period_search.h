#ifndef continua_network_period_search_h
#define continua_network_period_search_h

#include <continua/network/network.h>
#include <continua/network/shooting.h>

#include <functional>
#include <vector>

namespace Continua
{
/// The state of a network that a period leaves as it is, by Newton's method (Shooting): after a
/// period that was made as any other it moves the network to the next iterate.
class PeriodSearch
{
public:
  /// `advance` lets the network go on to a time [s]; it may throw StepFailure. Both must outlive
  /// this object.
  PeriodSearch(Network &network, std::function<void(double)> advance);

  /// At the begin of a period.
  void begin();
  /// At times within it, and at its end: of each number the range is what a change of it is
  /// measured by.
  void sample();
  /// At its end: the root mean square of what the period has changed, over these ranges [1].
  double residual();
  /// At its end, after residual(): moves the network to the next iterate. False, and the network
  /// stays, if Newton's method has none, since a step from one of its trial states failed, or if
  /// the last iterate was not better than the one before: where a valve opens or closes in
  /// another step, a difference of two periods is no derivative, and a period more helps.
  bool move();
  unsigned int n_iterations() const { return iterations; }
  unsigned int n_periods() const { return periods; } ///< of the products of all iterations

private:
  Network &network;
  std::function<void(double)> advance;
  std::vector<double> at_begin, at_end; ///< all numbers
  std::vector<double> lowest, highest, scales;
  std::vector<double> times; ///< of the samples, so that all periods have the same steps [s]
  std::size_t n_state = 0;

  double last_residual = 0., residual_of_move = 0.; ///< of this period, and where it moved last
  unsigned int iterations = 0, periods = 0;

  void set(const std::vector<double> &numbers);
};
} // namespace Continua

#endif
