#ifndef continua_laboratory_nonlinear_wave_theory_h
#define continua_laboratory_nonlinear_wave_theory_h

#include <continua/analysis/analysis.h>
#include <continua/base/expected_value.h>
#include <continua/base/quantity_names.h>
#include <continua/network/network_parameters.h>
#include <continua/network/network_stations.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * Waves of finite height along the vessels of a network, in one dimension, and what has no length
 * in it: probes.csv has the stations over time, network-vessels.csv and network-elements.csv the
 * network for a drawing, and the summary the values of the last beat (or of the whole run) at each
 * station. With a period the run goes on until a beat is like the one before.
 */
class NonlinearWaveTheory : public Analysis
{
public:
  /// Throws InputError.
  explicit NonlinearWaveTheory(const AnalysisInput &input);

  QuantityNames quantity_names() const override { return quantities; }
  std::vector<std::string> outline() const override;

private:
  /// What has been recorded so far.
  struct Records
  {
    std::vector<double> times;
    std::vector<std::vector<double>> histories; ///< by NetworkStations::columns()
    unsigned int n_beats = 0;                   ///< that are complete; a run without beats is one
    unsigned int n_iterations = 0, n_search_beats = 0; ///< of Newton's method, beside these beats
    double moved_volume = 0.;                          ///< by these iterations [m^3]
    double difference = 0.;   ///< of the last beat from the one before, of pressures [1]
    double residual = 0.;     ///< Newton's method: what the last beat has changed [1]
    bool is_periodic = false; ///< the run has ended by these
  };
  NetworkParameters parameters;
  std::unique_ptr<const NetworkStations> stations;
  std::vector<ExpectedValue> expected;
  QuantityNames quantities; ///< that the analysis can state

  /// Every rank does it, and rank 0 writes.
  void compute(const OutputDirectory &directory, Log &log, Summary &summary) override;
  bool search(const Network &network,
              class PeriodSearch &period,
              unsigned int beat,
              Log &log,
              Records &records) const;
  void run(Network &network, class TableWriter *table, Log &log, Records &records) const;
  void record(const Network &network, class TableWriter *table, Records &records) const;
  void add_quantities(const Network &network, const Records &records, Summary &summary) const;
  void add_chamber(std::size_t station,
                   const std::vector<double> &volume,
                   const std::vector<double> &work,
                   const Records &records,
                   Summary &summary) const;
  void write_vessels(const OutputDirectory &directory, const Network &network) const;
  void write_elements(const OutputDirectory &directory) const;
};
} // namespace Continua

#endif
