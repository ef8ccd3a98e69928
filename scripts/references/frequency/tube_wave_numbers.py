#!/usr/bin/python3
"""Speed and attenuation of the pressure wave of the tube of parameter_files/examples/heart-beats.prm at 20 and 60 Hz.

    scripts/references/frequency/tube_wave_numbers.py

The exact wave by differential equations over the radius (scripts/references/waves/exact_dispersion.py, 50 digits).
"""

import math
import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../waves"))

import heart_beats  # noqa: E402

for frequency in (20, 60):
    number = heart_beats.harmonic(frequency)[0]
    print(f"{frequency} Hz: speed {2 * math.pi * frequency / number.real:.6f} m/s, attenuation {-number.imag:.7f} 1/m")
