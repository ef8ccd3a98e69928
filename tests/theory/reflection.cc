// Reflections by hand, and a tube between two ends against the sum of its reflections one by one
// (scripts/references/closed_form_theory.py).

#include <continua/theory/reflection.h>

#include "../unit_test.h"

#include <limits>
#include <stdexcept>

using namespace Continua;

namespace
{
void close(const std::string &name, const Complex value, const Complex reference)
{
  check::absolute(name, std::abs(value - reference), 0., 1e-13 * std::max(1., std::abs(reference)));
}
} // namespace

UNIT_TEST(reflection)
{
  close("impedance", characteristic_impedance(1000., 5., 0.001), 5e6);
  close("closed", reflection_coefficient(5., std::numeric_limits<double>::infinity()), 1.);
  close("open", reflection_coefficient(5., 0.), -1.);
  close("matched", reflection_coefficient({5., 1.}, {5., 1.}), 0.);
  close("twice the impedance", reflection_coefficient(5., 10.), 1. / 3.);
  close("junction without branches is closed", junction_reflection(5., {}), 1.);
  close("junction with one branch", junction_reflection(5., {10.}), 1. / 3.);
  close("matched bifurcation", junction_reflection(5., {10., 10.}), 0.);
  // 1/5 against 1/5 + 1/5: (1 - 2)/(1 + 2).
  close("bifurcation", junction_reflection(5., {5., 5.}), -1. / 3.);
  close("bifurcation, transmission", junction_transmission(5., {5., 5.}), 2. / 3.);

  Resonator tube;
  tube.wave_number = {40., -2.};
  tube.impedance = {5e6, 1e5};
  tube.length = 0.446;
  tube.near_reflection = 0.9;
  tube.far_reflection = -0.7;
  const Complex entering(1., 0.5);
  const Complex pressure(-1.0069215865043778, 0.43623715732642434);
  const Complex flow_rate(-1.3281029653349479e-7, 9.6587474249818564e-8);
  close("pressure", tube.pressure(0.1, entering), pressure);
  close("flow rate", 1e7 * tube.flow_rate(0.1, entering), 1e7 * flow_rate);
  close("input impedance", 1e-6 * tube.input_impedance(0.1), 1e-6 * pressure / flow_rate);
  close("pressure of a prescribed one",
        tube.pressure_of_prescribed(0.1, tube.pressure(0., entering)), pressure);

  tube.far_reflection = 1.;
  close("closed end", tube.flow_rate(0.446, entering), 0.);
  tube.far_reflection = 0.;
  close("matched end", tube.input_impedance(0.3), tube.impedance);
  // Without losses a tube with two closed ends resonates at k L = pi.
  tube.wave_number = 3.14159265358979324 / 0.446;
  tube.near_reflection = tube.far_reflection = 1.;
  check::throws<std::domain_error>(
      "resonance", [&] { tube.pressure(0.1, 1.); }, "resonance");
  // Long and lossy: no exponential grows.
  tube.wave_number = {40., -2.};
  tube.length = 1e6;
  check::is_true("long", std::isfinite(std::abs(tube.pressure(10., entering))));
}
