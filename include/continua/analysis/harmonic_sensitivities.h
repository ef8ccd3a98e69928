#ifndef continua_analysis_harmonic_sensitivities_h
#define continua_analysis_harmonic_sensitivities_h

#include <continua/analysis/run.h>
#include <continua/analysis/wave_number_table.h>
#include <continua/continuum/harmonic_derivatives.h>

#include <complex>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * How the responses of probes change with entries of the file: one adjoint solution for each column
 * of the probes and each frequency, with the factor of that frequency, whatever the number of
 * entries. sensitivities.csv has a row for each frequency, response and entry; where the stations
 * of a probe have waves, their speed and attenuation are responses, too, by differences of the fit.
 */
template <int dim>
class HarmonicSensitivities
{
public:
  using Complex = std::complex<double>;

  /// Both must outlive it. Collective.
  HarmonicSensitivities(Run<dim> &run, HarmonicSystem<dim> &system);

  /// Within the sink of HarmonicSystem::solve_at(), with the number of the frequency there;
  /// `values`: of all columns of the probes in the solution. Collective.
  void take(std::size_t number,
            double frequency,
            const HarmonicSolution &solution,
            const std::vector<Complex> &values);
  /// Writes the table of what was taken.
  void write() const;
  /// The same with the waves of stations; then the quantities, and the largest on the screen.
  void finish(const std::vector<WaveFit> &fits);
  static void name_quantities(const Case<dim> &input, QuantityNames &names);

private:
  /// The response of a column at one frequency.
  struct Response
  {
    Complex value;
    std::vector<Complex> by_entry; ///< its derivatives [unit over that of the entry]
    /// Of the same by the coarser formula of differences.
    std::vector<Complex> by_entry_coarser;
  };
  /// A row of the table.
  struct Row
  {
    double frequency;  ///< [Hz]
    std::string probe; ///< with the station
    std::string label; ///< of the probe in the summary
    std::string field; ///< "displacement x", "speed"
    std::string unit;  ///< of the response
    std::size_t entry;
    double amplitude;
    double by_entry;       ///< d amplitude/d entry [SI]
    double phase_by_entry; ///< [rad over the unit of the entry]; NaN of what has no phase
    double error;          ///< of the entry times each of both, over the amplitude [1]
    bool is_amplitude;     ///< of a complex response, not a speed or an attenuation
  };
  Run<dim> &run;
  HarmonicSystem<dim> &system;
  std::vector<unsigned int> columns;  ///< of the probes
  std::vector<ProblemChange> changes; ///< by entry, and then with the coarser formula
  std::unique_ptr<HarmonicDerivatives> derivatives;
  std::map<double, std::map<unsigned int, Response>> taken; ///< by frequency [Hz] and column
  std::vector<Row> of_waves;

  std::size_t n_entries() const { return run.input.entry_changes.size(); }
  const NumericEntry &entry(const std::size_t number) const
  {
    return run.input.entry_changes[number].entry.entry;
  }
  /// The load of the motion at each node of a change; none where it stays as it is.
  std::vector<HarmonicLoad> loads_of(const EntryChange &change) const;
  void add_change(const EntryChange &change,
                  const std::vector<double> &weights,
                  const std::vector<HarmonicLoad> &loads);
  std::vector<Row> rows() const;
  /// Of speed and attenuation.
  void add_waves(const StationsProbe &probe, const WaveFit &fit);
  double logarithmic(const Row &row, double by_entry) const;
  void show_largest(const std::vector<Row> &all) const;
};
} // namespace Continua

#endif
