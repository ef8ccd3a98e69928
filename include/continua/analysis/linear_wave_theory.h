#ifndef continua_analysis_linear_wave_theory_h
#define continua_analysis_linear_wave_theory_h

#include <continua/analysis/run.h>
#include <continua/case/theory/station_waves.h>
#include <continua/case/theory/tube_wave_case.h>

#include <vector>

namespace Continua
{
/**
 * The waves of a tube at the stations of its probes by linear theory, and by nonlinear theory where
 * that is asked for: as an analysis of its own, without a mesh's fields, or beside a transient run.
 * Writes wave.csv (wave-NAME.csv if several probes have stations), dispersion.csv and the
 * quantities of WaveReport.
 */
template <int dim>
class LinearWaveTheory
{
public:
  explicit LinearWaveTheory(Run<dim> &run) : run(run) {}

  /// The analysis: theory, beside measurements where there are any.
  void perform();
  /// After the last step of a run: what was simulated beside theory, if that covers the case, and
  /// measurements. Nothing if no probe has stations.
  void compare();

  /// Whether theory covers the case and has something to say of it. Throws InputError.
  static void check(const Case<dim> &input, ParameterSection root);
  /// The same for theory beside a run. Throws InputError.
  static void check_overlay(const Case<dim> &input, ParameterSection root);
  /// Of the analysis.
  static void name_quantities(const Case<dim> &input, QuantityNames &names);
  /// Of compare().
  static void name_quantities_of_comparison(const Case<dim> &input, QuantityNames &names);

private:
  Run<dim> &run;

  /// What a theory says, by probe.
  struct OfProbes
  {
    WaveSource source;
    std::vector<StationHistories> histories;
  };

  static void name_all(const Case<dim> &input, bool simulated, QuantityNames &names);
  /// All theories of the case, in the order of the report.
  std::vector<OfProbes>
  theories(const TubeWaveCase &wave_case, const std::vector<double> &times, bool simulated);
  OfProbes at_stations(const WaveModel &model,
                       const TubeWaveCase &wave_case,
                       const std::vector<double> &times,
                       bool simulated);
  void report(const std::vector<double> &times, bool simulated);
  /// Says how theory was computed, and tabulates its dispersion.
  void describe(const TubeWaveTheory &theory, const TubeWaveCase &wave_case);
};
} // namespace Continua

#endif
