#ifndef continua_laboratory_wave_bar_h
#define continua_laboratory_wave_bar_h

#include <continua/laboratory/wave_scheme.h>

#include <optional>

namespace Continua
{
/**
 * An elastic bar of equal cells, one wavelength long, held at both ends and between smooth walls,
 * without contraction across: its standing wave sin(2 pi x / L) is an eigenvector of the cell-wise
 * operator, whatever the number of cells. The speed of waves is 1 m/s and the length 1 m.
 */
class WaveBar
{
public:
  /// `cells` in the wavelength, two or more; `courant_number` c dt/dx.
  WaveBar(WaveScheme scheme, unsigned int cells, double courant_number);

  /// G of the wave as the program steps it: of the factors in the recurrence of the states after a
  /// few steps that which is nearest to `expected`. None where round-off hides the recurrence: it
  /// does not lead to the two states that follow. Every rank runs a bar of its own.
  std::optional<Complex> measured(Complex expected) const;
  /// Speed of the wave over its exact speed, for a G: arg G / (2 pi Co / N) (equation 3.84).
  double speed_ratio(Complex factor) const;
  /// Angle of the mode in a step, of the frequency that the stencil gives it: 2 Co sin(pi/N) [rad].
  double theta() const;

private:
  const WaveScheme scheme;
  const unsigned int cells;
  const double courant_number;
};
} // namespace Continua

#endif
