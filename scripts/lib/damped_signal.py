"""Mean and slowest mode of a freely swinging point, from evenly spaced samples."""

import numpy

# Samples that are used at most, and waves at most; a beam's tip has a handful that matter.
SAMPLES = 300
ORDER = 12


def mean_and_mode(time, values, guess):
    """(frequency [Hz], mean, factor of the amplitude an oscillation) of the largest wave within a fifth of the frequency `guess` [Hz].

    The signal is taken for a sum of a constant and damped waves, which the tip of a linear beam is exactly, whatever the
    scheme; matrix pencil (Hua and Sarkar 1990), its subspace by singular values. No starting values, no window.
    """
    stride = max(1, round(len(values) / SAMPLES))
    step, values = (time[1] - time[0]) * stride, numpy.asarray(values)[::stride]
    half = len(values) // 2
    if half < 4:
        raise ValueError("too few samples for a fit")
    hankel = numpy.lib.stride_tricks.sliding_window_view(values, half).T
    left, sizes, _ = numpy.linalg.svd(hankel, full_matrices=False)
    left = left[:, :min(ORDER, int((sizes > 1e-9 * sizes[0]).sum()))]
    poles = numpy.linalg.eigvals(numpy.linalg.lstsq(left[:-1], left[1:], rcond=None)[0]).astype(complex)
    # The constant is known to be one: what creeps by less than that over the signal is it.
    poles = numpy.append(poles[abs(numpy.log(poles)) * len(values) > 1], 1.0)
    waves = poles[None, :]**numpy.arange(len(values))[:, None]
    amplitudes = numpy.linalg.lstsq(waves, values.astype(complex), rcond=None)[0]
    rates = numpy.log(poles) / step
    frequencies = rates.imag / (2 * numpy.pi)
    # Noise, such as that of a loop stopped early, makes small waves anywhere.
    near = abs(frequencies - guess) < 0.2 * guess
    if not near.any():
        raise ValueError(f"no wave near {guess:g} Hz")
    mode = numpy.argmax(numpy.where(near, abs(amplitudes), 0.0))
    return frequencies[mode], amplitudes[-1].real, numpy.exp(rates[mode].real / frequencies[mode])
