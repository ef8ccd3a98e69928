#include <continua/theory/closed_form_waves.h>

#include <continua/theory/tube_waves_closed_form.h>
#include <continua/theory/womersley.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using dealii::numbers::PI;

const Words<WaveLevel> &wave_level_words()
{
  static const Words<WaveLevel> words = {{"exact", WaveLevel::exact},
                                         {"closed formula", WaveLevel::closed_formula},
                                         {"membrane", WaveLevel::membrane},
                                         {"womersley", WaveLevel::womersley}};
  return words;
}

ClosedFormWaves::ClosedFormWaves(const TubeSection &section,
                                 const WaveLevel level,
                                 const double shift)
    : section(section), level(level), shift(shift)
{
}

void ClosedFormWaves::evaluate(const double frequency, std::vector<WaveMode> &modes) const
{
  const Complex omega(2. * PI * frequency, -shift);
  const double radius = section.inner_radius, thickness = section.wall_thickness();
  const Material &fluid = section.fluid;
  const Womersley flow(radius, fluid.density, fluid.shear.viscosity);
  const double nu = section.poisson_ratio(omega).real();
  const LongWaveTube tube{radius, thickness, nu, fluid.density, fluid.inverse_bulk_modulus()};
  const ClosedFormTube closed_form{tube, fluid.shear.viscosity, section.wall_density()};
  const bool is_rigid = section.layers.empty();
  const Complex young = section.hoop_modulus(omega);
  const Anchoring anchoring =
      section.tethered ? Anchoring::throughout : Anchoring::expansion_joints;

  // In a rigid tube all levels are Womersley's.
  WaveMode mode = {};
  if (level == WaveLevel::membrane && !is_rigid)
    mode.wave_number =
        membrane_wave_number(closed_form, omega, section.tethered ? young / (1. - nu * nu) : young);
  else if (level == WaveLevel::closed_formula && !is_rigid)
    mode.wave_number = closed_form_wave_number(closed_form, omega, young, anchoring);
  else
    mode.wave_number =
        flow.wave_number(omega, korteweg_speed(tube, young, anchoring, WallTheory::thin));
  if (mode.wave_number.imag() > 0.)
    mode.wave_number = -mode.wave_number;
  const Complex i(0., 1.), gradient = -i * mode.wave_number; // of unit pressure
  mode.section_pressure = mode.axis_pressure = 1.;
  mode.junction.fill(0.);
  mode.junction[WaveMode::traction] = 1.;
  mode.junction[WaveMode::flow_rate] = flow.flow_rate(omega, gradient);
  mode.wall_shear_stress = -flow.wall_shear_stress(omega, gradient);
  if (!is_rigid)
  {
    mode.wall_displacement =
        mode.wave_number * mode.junction[WaveMode::flow_rate] / (2. * PI * radius * omega);
    // Of p R/h, whose h becomes thinner, dh = -h/(R + h) dR, where there is a mean pressure.
    mode.hoop_stress = radius / thickness + section.mean_pressure * mode.wall_displacement *
                                                (1. + radius / (radius + thickness)) / thickness;
  }
  modes.assign(1, mode);
}
} // namespace Continua
