#ifndef continua_signal_energy_frequency_h
#define continua_signal_energy_frequency_h

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
} // namespace Continua

#endif
