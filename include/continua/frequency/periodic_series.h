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
 * range. The energy of the load does not measure this: a derivative of a quantity needs more
 * harmonics than the quantity, so what is to be known must be among the quantities.
 */
class PeriodicSeries
{
public:
  using Complex = std::complex<double>;
  /// The amplitude of each quantity in harmonic n, which is the mean for n = 0.
  using Harmonic = std::function<std::vector<Complex>(unsigned int n)>;

  /// `period`: T [s]. Throws std::invalid_argument for options or a period that are not positive,
  /// or harmonics with different numbers of quantities.
  PeriodicSeries(double period, const Harmonic &harmonic, const PeriodicSeriesOptions &options = {});

  double period() const { return length; }
  /// Beside the mean.
  unsigned int n_harmonics() const { return static_cast<unsigned int>(amplitudes.size()) - 1; }
  bool has_converged() const { return converged; }
  /// Of each quantity: its change by the last third of the harmonics, over its range [1]; 0 for a
  /// quantity that does not vary.
  const std::vector<double> &changes() const { return last_changes; }
  Complex amplitude(const std::size_t quantity, const unsigned int n) const
  {
    return amplitudes[n][quantity];
  }
  /// The quantity at a time [s].
  double value(std::size_t quantity, double time) const;

private:
  double part(std::size_t quantity, double time, unsigned int first, unsigned int end) const;
  void measure(std::size_t n_times);

  double length;
  std::vector<std::vector<Complex>> amplitudes; ///< by harmonic, by quantity
  std::vector<double> last_changes;
  bool converged = false;
};
} // namespace Continua

#endif
