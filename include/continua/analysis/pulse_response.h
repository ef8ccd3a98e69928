#ifndef continua_analysis_pulse_response_h
#define continua_analysis_pulse_response_h

#include <continua/analysis/frequency_analysis.h>
#include <continua/analysis/load_samples.h>
#include <continua/analysis/run.h>
#include <continua/frequency/damped_contour.h>

#include <complex>
#include <cstddef>
#include <memory>
#include <vector>

namespace Continua
{
/**
 * The motion of a linear body at rest under loads that begin at time zero, without steps in time:
 * by its responses at the points of a DampedContour of twice the duration. probes.csv has the rows
 * of a run in time.
 *
 * The spectrum of the loads is cut off by a smooth filter, so that what is left out stays near the
 * times where the loads have kinks; a sharp end would ring at all times, and the factor e^(a t)
 * would enlarge that. Every second point belongs to the contour of the duration itself, by which
 * the history is computed once more: its difference is what comes back from behind the end.
 */
template <int dim>
class PulseResponse : private FrequencyAnalysis<dim>
{
public:
  explicit PulseResponse(Run<dim> &run) : FrequencyAnalysis<dim>(run) {}
  void perform();

  /// What is linear, from rest. Throws InputError.
  static void check(const Case<dim> &input, ParameterSection root);
  static void name_quantities(const Case<dim> &input, QuantityNames &names);

private:
  using Complex = std::complex<double>;
  using FrequencyAnalysis<dim>::run;
  using FrequencyAnalysis<dim>::system;
  std::size_t n_steps = 0; ///< of the duration
  std::unique_ptr<DampedContour> contour;
  std::unique_ptr<LoadSamples<dim>> loads;
  /// The number of the last point that is solved.
  std::size_t last_point = 0;
  /// By point, shape of the loads and column of the probes, of a load of size one.
  std::vector<std::vector<std::vector<Complex>>> responses;

  void take_loads();
  /// The part of the loads at a point of `contour` that is kept, if that is the last one [1].
  static double filter(std::size_t point, std::size_t last);
  /// The largest difference of the filtered loads from the loads, over the largest value [1].
  double difference_of_loads(std::size_t last) const;
  void solve();
  /// Of each column of the probes, by time. `stride`: 1 on `contour`, 2 on that of the duration.
  std::vector<std::vector<double>> histories(const DampedContour &at, std::size_t stride) const;
  /// Of the rows of probes.csv.
  std::size_t steps_of_a_row() const;
  /// Where the file asks for what the analysis does not write.
  void warn_of_output() const;
  void write(const std::vector<std::vector<double>> &values);
  /// The largest difference in the first three quarters of the duration, over the range of a column
  /// [1].
  double difference(const std::vector<std::vector<double>> &values,
                    const std::vector<std::vector<double>> &others) const;
};
} // namespace Continua

#endif
