#ifndef continua_frequency_periodic_series_h
#define continua_frequency_periodic_series_h

#include <complex>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace Continua
{
struct PeriodicSeriesOptions
{
  /// The largest change of a quantity by the last third of the harmonics, over its range [1].
  double tolerance = 1e-3;
  unsigned int least_harmonics = 6;
  unsigned int most_harmonics = 200;
  /// By quantity, whether it counts; empty: all count.
  std::vector<bool> is_compared = {};
  /// By harmonic, the size of the load [any unit], as far as it is known; empty: not known.
  std::vector<double> load = {};
  /// Of the times over a period at which changes and ranges are taken.
  std::size_t n_times = 512;
};

/**
 * The periodic state of a linear system under periodic loads, as a sum of harmonics
 *
 *   q(t) = q_0 + Re sum_n q_n e^(2 pi i n t/T),
 *
 * with as many as the quantities need. The harmonics are asked for one after the other. They
 * suffice when the last third of them has changed no quantity by more than the tolerance times its
 * range. Where the size of the load is known, what is left of it must be as little: the harmonics
 * that are left out have at most the sum of their loads, times what the last third of the harmonics
 * is for its load. A table whose rows are joined by straight lines has harmonics far behind a gap.
 * The energy of the load does not measure this: a derivative of a quantity needs more harmonics
 * than the quantity, so what is to be known must be among the quantities.
 */
class PeriodicSeries
{
public:
  using Complex = std::complex<double>;
  /// The amplitude of each quantity in harmonic n, which is the mean for n = 0.
  using Harmonic = std::function<std::vector<Complex>(unsigned int n)>;

  /// `period`: T [s]. Throws std::invalid_argument for options or a period that are not positive,
  /// or harmonics with different numbers of quantities.
  PeriodicSeries(double period,
                 const Harmonic &harmonic,
                 const PeriodicSeriesOptions &options = {});

  double period() const { return length; }
  /// Beside the mean.
  unsigned int n_harmonics() const { return static_cast<unsigned int>(amplitudes.size()) - 1; }
  bool has_converged() const { return converged; }
  /// Of each quantity: its change by the last third of the harmonics, or what the load has left if
  /// that is more, over its range [1]; 0 for a quantity that does not vary.
  const std::vector<double> &changes() const { return last_changes; }
  Complex amplitude(const std::size_t quantity, const unsigned int n) const
  {
    return amplitudes[n][quantity];
  }
  /// The quantity at a time [s].
  double value(std::size_t quantity, double time) const;

private:
  double part(std::size_t quantity, double time, unsigned int first, unsigned int end) const;
  void measure(const PeriodicSeriesOptions &options);
  double left_out(std::size_t quantity, const std::vector<double> &load) const;

  double length;
  std::vector<std::vector<Complex>> amplitudes; ///< by harmonic, by quantity
  std::vector<double> last_changes;
  bool converged = false;
};
} // namespace Continua

#endif
