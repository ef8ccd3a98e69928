#ifndef continua_signal_wave_analysis_h
#define continua_signal_wave_analysis_h

#include <string>
#include <vector>

namespace Continua
{
/// What stations along a tube have recorded of a wave that enters at the first of them or before.
struct WaveRecord
{
  /// [m] along the tube in the direction in which the first pulse travels, increasing.
  std::vector<double> positions;
  std::vector<double> times;                  ///< [s], increasing, not necessarily uniform
  std::vector<std::vector<double>> pressure;  ///< [Pa], one history a station
  std::vector<std::vector<double>> flow_rate; ///< [m^3/s] in the direction of travel, or empty
  /// Z = rho c/A of each station [Pa s/m^3], where there are flow rates.
  std::vector<double> characteristic_impedance;
  bool begins_at_rest = true; ///< or within a beat, whose foot may lie before the record
};

/// A number for each definition of when a pulse arrives: times [s], or speeds made of them [m/s].
struct ByArrival
{
  double peak;         ///< vertex of the parabola through the highest sample and its neighbours
  double half;         ///< half-way between the level before the pulse and its peak
  double tangent_foot; ///< where the tangent of the steepest rise meets the level before
  double phase;        ///< by the phase of the cross-spectrum with the first station
};

/// Why a station has no first pulse.
enum class MissingPulse
{
  none,     ///< it has one
  no_peak,  ///< the pressure does not rise and fall again
  rises,    ///< its largest value is the last one: what comes is not known
  not_come, ///< what there is, is below a quarter of the pulse at the station before
  overlaps, ///< the pulse overlaps with a reflection, here or at a station before
};

/// Why there is no speed where only one station has the pulse, or none.
constexpr const char *too_few_stations = "a speed needs two stations that have it";

/// For each quantity that the record cannot carry, why; empty for the others.
struct MissingOfWave
{
  std::string peak, half, tangent_foot, phase; ///< of the speeds
  std::string attenuation;
};

/// The first pulse at one station, and the reflection that follows.
struct StationWave
{
  ByArrival arrival;
  double amplitude; ///< of the first pulse's peak, above the first sample [Pa]
  double level;     ///< before the pulse, above the first sample [Pa]
  /// The largest backward wave from the half-height of the forward pulse on, with its sign, over
  /// the peak of the forward pulse; it contains the loss on the way to the end and back. NaN if it
  /// is less than a millionth, or still rises when the record ends.
  double reflection_coefficient;
  MissingPulse missing = MissingPulse::none;
};

/**
 * Speed, attenuation and reflection of the first pulse. What cannot be had is NaN, never a guess.
 *
 * *The first pulse* is the first maximum of p that is higher than a quarter of the record's largest
 * value and is followed by a fall of 5 % of itself; both above the first sample, which is the state
 * of rest. A forerunner of a few per cent, such as the axial wall wave of a tube with clamped ends,
 * is lower than that. Near a reflecting end the first pulse has no peak of its own: the maximum is
 * that of two overlapping pulses, higher or later after the rise than before. So where the
 * amplitude is more than 1.25 times, or the time from half the amplitude to the peak more than 1.3
 * times, that of the last station before, this station and all beyond it are left out (NaN). So is
 * a station where the backward wave is more than a tenth of the forward one when the pressure is
 * largest; the foot, which comes before the reflection, stays. A station whose largest value is the
 * last one of the record is left out, and one where the pulse is less than a quarter as high as at
 * the last station before: there the record ends before the pulse has come, and what has come is a
 * forerunner. The first station is taken on trust.
 *
 * *The level before* is the mean of p from three to one and a half rise times before the time at
 * half-height, the rise time being that from half-height to the peak; where the record begins
 * later, what there is of it, or the first sample. A record that begins within the rise, and not at
 * rest, has no foot.
 *
 * *Phase*: of every station the level before is subtracted and a window is cut out around the
 * peak, from 4 rise times before to 2.5 after it (of the first station's rise time, the same at all
 * stations), with cosine tapers over its first and last 15 %, so that nothing that comes after the
 * pulse counts. The phase of the cross-spectrum, with the delay of the peaks taken off, is fitted
 * by a straight line through the origin with the modulus as the weight, over the frequencies where
 * the first station's amplitude exceeds 10 % of its largest. The arrival is the peak's at the first
 * station, and elsewhere that plus the delay. NaN where the record ends inside the window, or the
 * pressure has not fallen below 15 % of the amplitude before it rises again, so that a reflection
 * is inside.
 *
 * *Speed*: the slope of the straight line through position against arrival by least squares, of two
 * stations at least. NaN unless the arrivals increase along the stations and lie three rows of the
 * record apart from the first station to the last. A pulse that travels alone keeps its shape:
 * where the peak, half the height or the phase take less than two thirds or more than three halves
 * of the time that the foot takes, pulses overlap, and only the speed of the foot is left.
 *
 * *Attenuation*: minus the slope of the logarithm of the amplitude against position, of three
 * stations at least. Another wave, such as the axial one of a wall with clamped ends, raises and
 * lowers the amplitudes. Where they lie off the line (root mean square) by more than a thousandth
 * and more than a fifth of what the line falls from the first station to the last, the attenuation
 * is that of fit_two_waves(), if there are flow rates from rest on, the record is half as long
 * again as the pulse needs to the last station, the fit leaves less than a hundredth of the record
 * and its attenuation is certain within a tenth; else NaN.
 */
struct WaveAnalysis
{
  std::vector<StationWave> stations;
  ByArrival speed;    ///< [m/s]
  double attenuation; ///< [1/m]
  MissingOfWave missing;
};

/// Throws std::invalid_argument if the lists of the record are not equally long or positions or
/// times do not increase.
WaveAnalysis analyse_wave(const WaveRecord &record);

/// The forward wave (p + Z Q)/2 and the backward wave (p - Z Q)/2 of one station [Pa].
struct SeparatedWaves
{
  std::vector<double> forward;
  std::vector<double> backward;
};
/// Throws std::invalid_argument if the histories are not equally long.
SeparatedWaves separate_waves(const std::vector<double> &pressure,
                              const std::vector<double> &flow_rate,
                              double characteristic_impedance);
} // namespace Continua

#endif
