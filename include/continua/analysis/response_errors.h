#ifndef continua_analysis_response_errors_h
#define continua_analysis_response_errors_h

#include <continua/analysis/harmonic_tables.h>
#include <continua/analysis/run.h>
#include <continua/analysis/wave_number_table.h>
#include <continua/base/parameter_file.h>

#include <complex>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * Errors of the responses of a harmonic analysis by its mesh, estimated with velocities and
 * pressures of the next degree on the same mesh. The equations are linear: the residual of the
 * solution, tested with the adjoint solution of the richer spaces less its part in the poorer ones
 * (the dual-weighted residual), is the response of the richer spaces less that of the solution. So
 * one solution of the richer spaces at each frequency gives the errors of all probes at once.
 * errors.csv has a row for each frequency.
 */
template <int dim>
class ResponseErrors
{
public:
  using Complex = std::complex<double>;
  /// Of the velocity; there are no elements beyond it.
  static constexpr unsigned int highest_degree = 5;

  /// Reads the case with elements of the next degree, before the mesh of the run is refined.
  /// Collective; throws InputError, as said of Harmonic/Estimate errors.
  explicit ResponseErrors(Run<dim> &run);

  /// Solves at the frequencies of the responses and writes the table; adds the quantities, and
  /// shows the largest. Collective.
  void estimate(const std::vector<ProbeResponse> &responses, const std::vector<WaveFit> &fits);
  static void name_quantities(const Case<dim> &input, QuantityNames &names);

private:
  /// A number at one frequency with its estimated error: what has to be added to it.
  struct Estimate
  {
    double frequency;        ///< [Hz]
    std::string name, label; ///< of the probe, with the station; in the summary
    std::string what, unit;  ///< "amplitude displacement x", "phase displacement x", "speed"
    double value, error;
    bool has_size; ///< a phase has none, so that its error is over nothing
  };
  Run<dim> &run;
  ParameterFile file;
  std::unique_ptr<Case<dim>> richer;
  std::vector<Estimate> estimates;

  /// Of all columns of the probes, by frequency [Hz].
  std::map<double, std::vector<Complex>> richer_values(const std::vector<ProbeResponse> &responses);
  void add_response(const ProbeResponse &response, const std::vector<Complex> &values);
  void add_waves(const WaveFit &fit, const std::vector<Complex> &values);
  void write() const;
  void add_quantities() const;
  void show_largest() const;
};
} // namespace Continua

#endif
