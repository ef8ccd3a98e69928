#ifndef continua_analysis_periodic_response_h
#define continua_analysis_periodic_response_h

#include <continua/analysis/frequency_analysis.h>
#include <continua/analysis/load_samples.h>
#include <continua/analysis/periodic_motion.h>
#include <continua/analysis/periodic_powers.h>
#include <continua/analysis/run.h>
#include <continua/frequency/periodic_series.h>

#include <complex>
#include <memory>
#include <vector>

namespace Continua
{
/**
 * The state that a linear body under periodic loads reaches after many periods, without steps in
 * time: the sum of the responses to the harmonics of the loads, as many as the probes of the
 * section Periodic state need (PeriodicSeries). Harmonic 0 is the mean. In finite deformation it is
 * the state at rest under the mean of the loads, about which the others are small. probes.csv has
 * the rows of a run in time over one period, beats.csv its row of a settled beat, harmonics.csv the
 * amplitudes, mean-power.csv the mean powers of each harmonic. fields.pvd has the motion over one
 * period.
 */
template <int dim>
class PeriodicResponse : private FrequencyAnalysis<dim>
{
public:
  explicit PeriodicResponse(Run<dim> &run) : FrequencyAnalysis<dim>(run) {}
  void perform();

  /// What is linear, or a small motion about a state, under loads that repeat themselves. Throws
  /// InputError.
  static void check(const Case<dim> &input, ParameterSection root);
  static void name_quantities(const Case<dim> &input, QuantityNames &names);

private:
  using Complex = std::complex<double>;
  using FrequencyAnalysis<dim>::run;
  using FrequencyAnalysis<dim>::system;
  std::unique_ptr<LoadSamples<dim>> loads;
  std::vector<std::vector<Complex>> spectra; ///< by shape of the loads, by harmonic
  std::vector<double>
      load_sizes; ///< by harmonic: the sum over the shapes, each over its largest value
  std::unique_ptr<PeriodicPowers<dim>> powers;
  /// Where fields or what is not linear in the motion are asked for; else null.
  std::unique_ptr<PeriodicMotion<dim>> motion;

  void take_loads();
  HarmonicLoad load_of(unsigned int harmonic) const;
  /// Of a column of the probes: others follow from the whole motion at each time.
  bool is_linear(unsigned int column) const;
  bool is_compared(unsigned int column) const;
  /// Of each column of the probes, from harmonic 1.
  std::vector<Complex> amplitudes(unsigned int harmonic);
  bool has_mean() const;
  /// Of each column of the probes, in the state about which the motion is small.
  std::vector<Complex> values_of_state();
  bool keeps_fields() const;
  /// Whether something follows from the whole motion at each time.
  bool needs_history() const;
  /// If so, the columns of the probes at n + 1 times over the period, with the averages over it.
  std::vector<std::vector<double>> values_of_motion(std::size_t n);
  void write_history(const PeriodicSeries &series);
  void write_harmonics(const PeriodicSeries &series);
  /// Fields over one period, at Output/Field interval.
  void write_period();
};
} // namespace Continua

#endif
