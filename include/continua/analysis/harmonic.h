#ifndef continua_analysis_harmonic_h
#define continua_analysis_harmonic_h

#include <continua/analysis/frequency_analysis.h>
#include <continua/analysis/harmonic_sensitivities.h>
#include <continua/analysis/harmonic_tables.h>
#include <continua/analysis/run.h>
#include <continua/continuum/harmonic_system.h>
#include <continua/frequency/frequency_refinement.h>

#include <complex>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * The linear motion exp(i omega t) of the body under loads that do the same, at one frequency after
 * the other, with the complex moduli of its materials. response.csv has a row for each frequency
 * with amplitude and phase of each probe; impedance.csv, transfer.csv and mean-power.csv see
 * HarmonicTables. fields.pvd lists the real parts under the numbers of the frequencies, and the
 * imaginary parts half a number behind. sensitivities.csv see HarmonicSensitivities.
 */
template <int dim>
class Harmonic : private FrequencyAnalysis<dim>
{
public:
  explicit Harmonic(Run<dim> &run) : FrequencyAnalysis<dim>(run) {}
  void perform();

  /// Only what is linear, with loads that are amplitudes. Throws InputError.
  static void check(const Case<dim> &input, ParameterSection root);
  static void name_quantities(const Case<dim> &input, QuantityNames &names);

private:
  using Complex = std::complex<double>;
  using FrequencyAnalysis<dim>::run;
  using FrequencyAnalysis<dim>::system;
  std::vector<NamedLoad> loads; ///< with their phases
  HarmonicLoad total;
  std::unique_ptr<HarmonicTables<dim>> tables;
  std::unique_ptr<HarmonicSensitivities<dim>> sensitivities; ///< null where none are asked for
  std::unique_ptr<FrequencyRefinement> refinement;
  std::map<double, HarmonicSolution> known; ///< of a refined range, by frequency [Hz]

  void take_loads();
  void solve_all();
  /// At given frequencies, one after the other.
  void solve_range();
  /// At as many as the responses of the probes need; then the frequencies are these, too. What was
  /// computed before an error or an interruption is recorded.
  void solve_refined_range();
  void refine();
  /// Values of the probes at each of the frequencies, which are known then. Throws Interrupted.
  std::vector<std::vector<Complex>> solve_at_frequencies(const std::vector<double> &frequencies);
  /// In increasing order.
  void record_known();
  void write_interpolated() const;
  /// For an error: what was computed before it.
  std::string rows_kept() const;
  /// Of one frequency, by its number.
  void record(std::size_t number, const HarmonicSolution &solution);
};
} // namespace Continua

#endif
