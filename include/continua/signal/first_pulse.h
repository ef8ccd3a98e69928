#ifndef continua_signal_first_pulse_h
#define continua_signal_first_pulse_h

#include <cstddef>
#include <vector>

namespace Continua
{
/// Where the first pulse of a history is; WaveAnalysis says how it is found and what the words
/// mean. All values are above the first sample; NaN where there is no such pulse.
struct FirstPulse
{
  double peak_time;         ///< [s]
  double amplitude;         ///< value at the peak
  double level;             ///< before the pulse
  double half_time;         ///< [s]
  double tangent_foot_time; ///< [s]
  bool has_fallen;          ///< below 15 % of the amplitude (from the level) before it rises again

  double rise_time() const { return peak_time - half_time; }
};
/// `times` [s] increase; both lists are equally long.
FirstPulse find_first_pulse(const std::vector<double> &times, const std::vector<double> &values);

/// The vertex of the parabola through the sample `i`, an extremum, and its neighbours; at the ends
/// of the record the sample.
struct Vertex
{
  double time, value;
};
Vertex
refine_extremum(const std::vector<double> &times, const std::vector<double> &values, std::size_t i);
} // namespace Continua

#endif
