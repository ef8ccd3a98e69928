#!/usr/bin/python3
"""A three-element windkessel under a given flow: references of parameter_files/verification/windkessel*.prm and of the tests
of outlets.

A resistance R_p before a compliance C beside a resistance R_d (N. Westerhof, J.-W. Lankhaar, B. E. Westerhof, Med. Biol. Eng.
Comput. 47, 2009), under Q = Q0 sin^2(pi t/T) until T and nothing after. The compliance's volume x obeys dx/dt = Q - x/tau,
tau = R_d C, so that with w = 2 pi/T

    x = x0 e^(-t/tau) + Q0/2 [tau (1 - e^(-t/tau)) - ((cos w t - e^(-t/tau))/tau + w sin w t)/(1/tau^2 + w^2)],  t <= T,

then decays; p = R_p Q + x/C. The formula is compared with a numerical integration. Needs mpmath.
"""

import mpmath as mp

mp.mp.dps = 30


class Windkessel:
    """In SI; `initial` is the compliance's pressure at t = 0 (above the pressure behind)."""

    def __init__(self, proximal, distal, compliance, amplitude, duration, initial=0):
        self.proximal, self.compliance = mp.mpf(proximal), mp.mpf(compliance)
        self.tau = mp.mpf(distal) * self.compliance
        self.amplitude, self.duration = mp.mpf(amplitude), mp.mpf(duration)
        self.initial = mp.mpf(initial) * self.compliance

    def flow(self, time):
        return self.amplitude * mp.sin(mp.pi * time / self.duration) ** 2 if time < self.duration else mp.mpf(0)

    def volume(self, time):
        if time > self.duration:
            return self.volume(self.duration) * mp.exp(-(time - self.duration) / self.tau)
        decay, omega = mp.exp(-time / self.tau), 2 * mp.pi / self.duration
        oscillating = (mp.cos(omega * time) - decay) / self.tau + omega * mp.sin(omega * time)
        forced = self.tau * (1 - decay) - oscillating / (1 / self.tau**2 + omega**2)
        return self.initial * decay + self.amplitude / 2 * forced

    def inner_pressure(self, time):
        return self.volume(time) / self.compliance

    def pressure(self, time):
        return self.proximal * self.flow(time) + self.inner_pressure(time)

    def pressure_rate(self, time):
        """Of t < T."""
        flow_rate = self.amplitude * mp.pi / self.duration * mp.sin(2 * mp.pi * time / self.duration)
        return self.proximal * flow_rate + (self.flow(time) - self.volume(time) / self.tau) / self.compliance

    def left(self, time):
        """What has flowed into it as energy by that time [J]."""
        return mp.quad(lambda t: self.pressure(t) * self.flow(t), mp.linspace(0, min(time, self.duration), 5))

    def stored(self, time):
        return self.volume(time) ** 2 / (2 * self.compliance)

    def check(self, time):
        """The formula against the convolution with e^(-t/tau)."""
        end = min(time, self.duration)
        integral = mp.quad(lambda t: self.flow(t) * mp.exp(-(time - t) / self.tau), mp.linspace(0, end, 5))
        assert abs(self.volume(time) - self.initial * mp.exp(-time / self.tau) - integral) < mp.mpf("1e-20")


def show(name, value, unit):
    print(f"  {name}: {mp.nstr(value, 9)} {unit}")


def artery():
    """windkessel.prm: a stroke of the heart, from 80 mmHg."""
    mmhg = mp.mpf("13.5951") * mp.mpf("9.80665")
    model = Windkessel("8e6", "1.2e8", "1e-8", "400e-6", "0.3", 80 * mmhg)
    for time in (mp.mpf("0.15"), mp.mpf("0.8")):
        model.check(time)
    print("windkessel.prm")
    peak = mp.findroot(model.pressure_rate, (mp.mpf("0.15"), mp.mpf("0.29")), solver="anderson")
    show("largest pressure", model.pressure(peak) / 1000, "kPa")
    show("at", peak * 1000, "ms")
    for time in ("0.15", "0.3", "0.8"):
        show(f"pressure at {time} s", model.pressure(mp.mpf(time)) / 1000, "kPa")
    end = mp.mpf("0.8")
    show("energy left until 0.8 s", model.left(end), "J")
    show("of it dissipated", model.left(end) - model.stored(end) + model.stored(mp.mpf(0)), "J")


def orders():
    """tests/convergence/windkessel-*.prm: plug flow of 1 m/s sin^2 through 0.5 m in a plane channel of 1 m depth."""
    print("tests/convergence/windkessel-*.prm")
    for name, compliance in (("", "0.02"), (" of the fast one", "2e-5")):
        model = Windkessel(3, 40, compliance, mp.mpf("0.5"), 1)
        # Not at 0.75 s, where the flow has no second derivative and an error of second order vanishes.
        model.check(mp.mpf("0.6"))
        show(f"pressure{name} at 0.6 s", model.pressure(mp.mpf("0.6")), "Pa")


if __name__ == "__main__":
    artery()
    orders()
