#ifndef continua_case_before_the_run_load_spectrum_h
#define continua_case_before_the_run_load_spectrum_h

#include <continua/continuum/problem.h>

#include <vector>

namespace Continua
{
/**
 * How much of what drives a body there is from a frequency on, relative to the largest value of its
 * spectrum: of the waveforms of boundaries, outlets and body forces, at x = y = z = 0, the largest.
 * A constant one counts, too, as the jump at t = 0 that it is. Empty where nothing that is known
 * drives the body.
 */
class LoadSpectrum
{
public:
  /// Sampled over the run, from 0 to `end_time` [s], at the time step [s].
  LoadSpectrum(const Problem &problem, double end_time, double time_step);

  /// What that takes while it is made [bytes].
  static double memory(double end_time, double time_step);

  bool is_empty() const { return envelope.empty() || envelope.front() == 0.; }
  /// From a frequency [Hz] on; 1 at 0.
  double from(double frequency) const;
  /// Where less than a thousandth is left [Hz].
  double highest_frequency() const;
  /// Below which 90 % of the energy lies [Hz].
  double energy_frequency() const { return reference; }

private:
  double reference = 0.;        ///< [Hz]
  double spacing = 0.;          ///< of the values [Hz]
  std::vector<double> envelope; ///< [1]
};
} // namespace Continua

#endif
