#ifndef continua_theory_closed_form_waves_h
#define continua_theory_closed_form_waves_h

#include <continua/base/words.h>
#include <continua/theory/wave_families.h>

namespace Continua
{
/// Which theory a synthesis of waves rests on.
enum class WaveLevel
{
  exact,          ///< ExactDispersion: pressure, axial and bending waves
  closed_formula, ///< closed_form_wave_number(): pressure wave only, like those below
  membrane,       ///< membrane_wave_number(): inviscid membrane, times Womersley's factor
  /// Long waves, viscous in a thin wall without inertia; without viscosity of Korteweg's speed in a
  /// compressible liquid, with psi = 1 (axially free), or 1 - nu^2 where the wall is held axially.
  womersley
};

const Words<WaveLevel> &wave_level_words();

/**
 * The pressure wave by a closed formula. Pressure is uniform over the section; flow, wall shear
 * stress and the liquid's density are Womersley's, the wall's motion is what the flow's change
 * along the tube leaves it, u_r = k Q/(2 pi R omega) (liquid incompressible in this).
 */
class ClosedFormWaves : public WaveFamilies
{
public:
  /// `shift` [1/s] as in WaveFamilies; `level` any but exact. Layers are lumped as a membrane.
  ClosedFormWaves(const TubeSection &section, WaveLevel level, double shift);
  const std::vector<ExactDispersion::Family> &families() const override { return present; }
  void evaluate(double frequency, std::vector<WaveMode> &modes) const override;

private:
  TubeSection section;
  WaveLevel level;
  double shift;
  std::vector<ExactDispersion::Family> present = {ExactDispersion::pressure_wave};
};
} // namespace Continua

#endif
