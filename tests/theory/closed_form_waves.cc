// The modes of the closed formulas: wave numbers of the formulas that they are called after,
// balances of mass and momentum of the mode itself, and what Lame and Korteweg say of long waves.

#include <continua/theory/closed_form_waves.h>

#include "../unit_test.h"

namespace test_of_closed_form_waves
{
using namespace Continua;

namespace
{
constexpr double pi = 3.14159265358979323846;

TubeSection tube_a(const double viscosity)
{
  TubeSection section;
  section.inner_radius = 0.0125;
  section.fluid.density = 998.;
  section.fluid.compression = Compression();
  section.fluid.shear.viscosity = viscosity;
  section.layer_thicknesses = {1e-4};
  Material wall;
  wall.density = 880.;
  wall.compression = Compression();
  Branch spring;
  spring.shear_modulus = 1.72e6 / 3.;
  wall.shear.branches.push_back(spring);
  section.layers = {wall};
  return section;
}

WaveMode mode_of(const TubeSection &section, const WaveLevel level, const double frequency)
{
  std::vector<WaveMode> modes;
  ClosedFormWaves(section, level, 0.).evaluate(frequency, modes);
  return modes.at(0);
}
} // namespace

UNIT_TEST(closed_form_waves)
{
  check::equal("first name", wave_level_words().at(0).first, "exact");
  check::is_true("level of a name",
                 value_of(wave_level_words(), "closed formula") == WaveLevel::closed_formula);

  // Without viscosity Womersley's theory has the speed of Moens and Korteweg, 2.6256 m/s, at any
  // frequency: sqrt(Y h/(2 R rho)).
  const double moens_korteweg = std::sqrt(1.72e6 * 1e-4 / (0.025 * 998.));
  const WaveMode inviscid = mode_of(tube_a(0.), WaveLevel::womersley, 10.);
  check::relative("womersley, inviscid: speed", 20. * pi / inviscid.wave_number.real(),
                  moens_korteweg, 1e-9);
  check::absolute("womersley, inviscid: no loss", inviscid.wave_number.imag(), 0., 1e-9);

  // A long wave by the closed formula: thick wall, axially free, psi = (h/R)(1 + nu) + 2R/(2R + h).
  const double psi = 0.008 * 1.5 + 0.025 / 0.0251;
  const WaveMode slow = mode_of(tube_a(0.), WaveLevel::closed_formula, 1e-3);
  check::relative("closed formula, long wave: speed", 2e-3 * pi / slow.wave_number.real(),
                  moens_korteweg / std::sqrt(psi), 1e-6);

  for (const WaveLevel level :
       {WaveLevel::closed_formula, WaveLevel::membrane, WaveLevel::womersley})
  {
    const std::string name = word_of(wave_level_words(), level) + ": ";
    const double frequency = 20., omega = 2. * pi * frequency, area = pi * 0.0125 * 0.0125;
    const WaveMode mode = mode_of(tube_a(1e-3), level, frequency);
    const std::complex<double> i(0., 1.), flow = mode.junction[WaveMode::flow_rate];
    check::is_true(name + "runs to +z and decays", mode.wave_number.real() > 0. &&
                                                       mode.wave_number.imag() < 0. &&
                                                       mode.wave_number.imag() > -1.);
    // Mass: dQ/dz = -2 pi R du_r/dt.
    check::absolute(
        name + "mass",
        std::abs(mode.wave_number * flow / (2. * pi * 0.0125 * omega * mode.wall_displacement) -
                 1.),
        0., 1e-9);
    // Momentum: rho dQ/dt = -A dp/dz + 2 pi R sigma_rz.
    check::absolute(name + "momentum",
                    std::abs((998. * i * omega * flow - 2. * pi * 0.0125 * mode.wall_shear_stress) /
                                 (i * mode.wave_number * area * mode.section_pressure) -
                             1.),
                    0., 1e-9);
    check::is_true(name + "uniform pressure", mode.axis_pressure == mode.section_pressure);
  }

  // In a rigid tube the liquid's compression takes up what flows in: dQ/dz = -A/K dp/dt.
  TubeSection rigid = tube_a(1e-3);
  rigid.layers.clear();
  rigid.layer_thicknesses.clear();
  rigid.fluid.compression = Compression::elastic(1. / 2.2e9);
  for (const WaveLevel level :
       {WaveLevel::closed_formula, WaveLevel::membrane, WaveLevel::womersley})
  {
    const std::string name = "rigid, " + word_of(wave_level_words(), level) + ": ";
    const WaveMode mode = mode_of(rigid, level, 100.);
    const std::complex<double> taken = 200. * pi * pi * 0.0125 * 0.0125 / 2.2e9;
    check::absolute(name + "mass",
                    std::abs(mode.wave_number * mode.junction[WaveMode::flow_rate] / taken - 1.),
                    0., 1e-9);
    check::is_true(name + "the wall rests", mode.wall_displacement == 0. && mode.hoop_stress == 0.);
  }
}
} // namespace test_of_closed_form_waves
