#ifndef continua_signal_up_crossings_h
#define continua_signal_up_crossings_h

#include <vector>

namespace Continua
{
/**
 * The times [s] at which a signal goes up through `level`: each time from `margin` below it to
 * `margin` above it. Where it crosses several times on its way, the middle of the first and the
 * last of them. `times` [s] increase, `values` are as many.
 */
std::vector<double> find_up_crossings(const std::vector<double> &times,
                                      const std::vector<double> &values,
                                      double level,
                                      double margin);

struct SignalAverages
{
  double mean, mean_square;
};
/// The averages of a signal and of its square between two times [s] of the record, by the
/// trapezoidal rule.
SignalAverages average_signal(const std::vector<double> &times,
                              const std::vector<double> &values,
                              double start,
                              double end);
} // namespace Continua

#endif
