#ifndef continua_signal_energy_frequency_h
#define continua_signal_energy_frequency_h

#include <cstddef>
#include <functional>
#include <vector>

namespace Continua
{
/**
 * The frequency [Hz] below which `part` (between 0 and 1) of the energy of a signal's fluctuation
 * lies: of the squares of the samples' differences from their mean, resolved by frequency with the
 * discrete Fourier transform of the samples padded with zeros to eight times their number. One
 * number that a pulse, an oscillation and a jump all have: with part = 0.9 a sine has its own
 * frequency, a pulse sin^2(pi t/T) 0.95/T and a rectangular one of length T 0.85/T, in a record
 * much longer than they. `interval` [s] is the time between samples. 0 if the signal does not
 * fluctuate.
 */
double energy_frequency(const std::vector<double> &samples, double interval, double part = 0.9);

/**
 * Samples of a signal of time [s] at an interval of end_time/n: n of them from 0 on, or 2 n, 4 n or
 * 8 n if the end of the time cuts off a pulse that is over by then. A pulse that is cut off is a
 * jump, and would seem much shorter than it is. What is not over in eight times the time, as an
 * oscillation or a ramp, remains as it is. Over: from then on, for as long as it took until
 * then, the signal changes by no more than a hundredth of its range.
 */
std::vector<double>
samples_of_whole_pulse(const std::function<double(double)> &signal, double end_time, std::size_t n);
} // namespace Continua

#endif
