#ifndef continua_analysis_wave_number_table_h
#define continua_analysis_wave_number_table_h

#include <continua/analysis/harmonic_tables.h>
#include <continua/analysis/run.h>
#include <continua/frequency/travelling_waves.h>

#include <complex>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace Continua
{
/// The waves that the stations of a probe have at one frequency [Hz].
struct WaveFit
{
  std::string probe;
  double frequency;
  TravellingWaves waves;
};

/// Before a number of one of the waves that are fitted: "wave 2 ", or nothing where there is one.
std::string name_of_wave(std::size_t n_waves, std::size_t wave);

/**
 * Speed and attenuation of the waves along a tube at each frequency of a harmonic analysis, from
 * each probe with enough stations: a fit of waves in both directions (fit_travelling_waves()) to
 * all fields of its stations. wave-numbers.csv has a row for each frequency, with the standard
 * deviations of the fit, and beside them the exact waves of the tube's section in the middle of the
 * stations where theory covers the case; of a tube that changes along its length both are means.
 */
template <int dim>
class WaveNumberTable
{
public:
  using Complex = std::complex<double>;

  /// `responses`: of the probes, by frequency.
  WaveNumberTable(Run<dim> &run, const std::vector<ProbeResponse> &responses);
  /// Writes the table where a probe has enough stations, and adds the quantities.
  void write();
  /// The fits of the table, when it is written.
  const std::vector<WaveFit> &fits() const { return all_fits; }
  static void name_quantities(const Case<dim> &input, QuantityNames &names);
  /// For a fit of its waves.
  static bool has_enough_stations(const Case<dim> &input, const StationsProbe &probe);

private:
  /// Of the section: by frequency, propagation g = i k [1/m] of the pressure wave, and of the axial
  /// wave where there is one.
  struct Theory
  {
    std::vector<std::string> names;
    std::map<double, std::vector<Complex>> propagations;
  };
  Run<dim> &run;
  std::vector<ProbeResponse> rows; ///< of positive frequencies
  std::vector<std::string> header;
  std::vector<std::vector<double>> cells; ///< by row
  std::vector<WaveFit> all_fits;

  Theory theory_of(const StationsProbe &probe) const;
  TravellingWaves
  fit(const StationsProbe &probe, const ProbeResponse &row, const Theory &theory) const;
  void add_columns(const StationsProbe &probe);
  void add_quantities(const StationsProbe &probe, double frequency, const TravellingWaves &fitted);
};
} // namespace Continua

#endif
