#ifndef continua_analysis_frequency_analysis_h
#define continua_analysis_frequency_analysis_h

#include <continua/analysis/run.h>
#include <continua/base/table_writer.h>
#include <continua/continuum/harmonic_system.h>
#include <continua/postprocess/field_writer.h>

#include <complex>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// What the analyses in the frequency domain have in common: the run with its HarmonicSystem,
/// tables with complex values of the probes, and fields as real and imaginary part.
template <int dim>
class FrequencyAnalysis
{
public:
  using Complex = std::complex<double>;

protected:
  explicit FrequencyAnalysis(Run<dim> &run) : run(run) {}

  /// Initialises the run and makes the system, in finite deformation about the state at rest under
  /// the loads of the file at a time [s], or under their mean with `mean_over_period`. Throws
  /// RunError where the discretisation has none, or there is no such state.
  void start(double time_of_loads = 0.);
  /// A table of `first` columns, and behind them real and imaginary part of each column of the
  /// probes. Null on all ranks but the one that writes.
  std::unique_ptr<TableWriter> complex_table(const std::string &name,
                                             const std::vector<std::string> &first) const;
  /// Adds a row to such a table, if there is one.
  static void add_row(const std::unique_ptr<TableWriter> &table,
                      std::vector<double> first,
                      const std::vector<Complex> &of_probes);
  /// Into fields.pvd: the real part under this number, the imaginary part half a number behind.
  void write_fields(const HarmonicSolution &solution, double number);
  /// The state that the solver shows, under a number or a time [s].
  void write_state(double number);
  void finish_fields();
  /// The summary of the whole; `time` [s]: up to which the run got, 0 where there is none.
  void finish(double time);

  Run<dim> &run;
  std::unique_ptr<HarmonicSystem<dim>> system;

private:
  std::unique_ptr<FieldWriter<dim>> writer;
};
} // namespace Continua

#endif
