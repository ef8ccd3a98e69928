#ifndef continua_analysis_harmonic_tables_h
#define continua_analysis_harmonic_tables_h

#include <continua/analysis/run.h>
#include <continua/base/table_writer.h>
#include <continua/continuum/harmonic_system.h>

#include <complex>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// A load with the name of its boundary, or "body force".
struct NamedLoad
{
  std::string name;
  int condition = -1; ///< its number in Problem::conditions; -1: body force
  HarmonicLoad load;
};

/// The loads of a harmonic analysis: that of Unit load at, or those of the file, with their phases.
template <int dim>
std::vector<NamedLoad> named_loads(const Case<dim> &input, HarmonicSystem<dim> &system);

/// What the probes show at one frequency.
struct ProbeResponse
{
  double frequency = 0.;                    ///< [Hz]
  std::vector<std::complex<double>> values; ///< by column of the probes [SI]
};

/// Real and imaginary part of all columns of the probes in a solution, which the solver then shows.
/// Collective.
template <int dim>
std::vector<std::complex<double>>
probe_values(HarmonicSystem<dim> &system, Probes<dim> &probes, const HarmonicSolution &solution);

/**
 * The tables of a harmonic analysis, a row for each frequency:
 *
 *   response.csv        of each column of the probes amplitude, phase, real and imaginary part
 *   impedance.csv       of each loaded boundary the input impedance: the complex power 1/2 P Q*
 *                       that goes in there over |Q|^2/2, that of a tangential load included. Of
 *                       each other outlet its own impedance, with Q out of the body
 *   transfer.csv        of each probe with stations the value of a field at each over that at the
 *                       first station; empty where that is none but for round-off
 *   mean-power.csv  the mean powers of the loads, and of what takes them
 */
template <int dim>
class HarmonicTables
{
public:
  using Complex = std::complex<double>;

  HarmonicTables(Run<dim> &run, HarmonicSystem<dim> &system, const std::vector<NamedLoad> &loads);

  /// Collective.
  void record(double frequency, const HarmonicSolution &solution, const HarmonicLoad &total);
  /// Adds the quantities.
  void finish();
  /// Of all frequencies so far.
  const std::vector<ProbeResponse> &recorded() const { return responses; }
  static void name_quantities(const Case<dim> &input, QuantityNames &names);

private:
  /// A boundary whose impedance is asked for.
  struct End
  {
    std::string name;
    unsigned int condition;
    int load; ///< its number among the loads; -1: an outlet without one
  };
  struct Ratio
  {
    std::string name;
    unsigned int column, reference; ///< of the probes
  };
  Run<dim> &run;
  HarmonicSystem<dim> &system;
  const std::vector<NamedLoad> &loads;
  std::vector<End> ends;
  std::vector<Ratio> ratios;
  std::unique_ptr<TableWriter> response, impedance, transfer, power;
  std::vector<ProbeResponse> responses;
  double largest_imbalance = 0.; ///< of the mean powers [1]

  void open();
  void
  record_impedances(double frequency, const HarmonicSolution &solution, const HarmonicLoad &total);
  void record_powers(double frequency, const HarmonicSolution &solution, const HarmonicLoad &total);
};
} // namespace Continua

#endif
