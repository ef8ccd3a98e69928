#ifndef continua_theory_end_impedance_h
#define continua_theory_end_impedance_h

#include <continua/theory/tube_section.h>
#include <continua/theory/wall_end.h>

#include <deal.II/lac/full_matrix.h>

#include <complex>
#include <map>
#include <utility>

namespace Continua
{
/**
 * The impedance matched_impedance() of a tube's end at one s after the other, exactly. Where the
 * pressure wave is long beside the radius all waves are found by their first guess; shorter ones
 * are followed up to each frequency from a thirtieth of it. What was computed is kept.
 */
class EndImpedance
{
public:
  using Complex = std::complex<double>;

  /// `factor`: the impedance of a part of the section over that of the whole.
  EndImpedance(TubeSection section, WallEnd wall, double factor);
  /// Z [Pa s/m^3] at s [1/s] but zero, |arg s| below 160 degrees. Of a real s it is that of an s
  /// beside it, with an error of the part 1e-8. Left of the imaginary axis, where a free motion
  /// decays, it is the analytic continuation: its waves are followed there from the axis. Throws
  /// RunError if a wave is lost or there is none at this s.
  dealii::FullMatrix<Complex> operator()(Complex s) const;

private:
  TubeSection section;
  WallEnd wall;
  double factor;
  /// Empty where a wave is not long, or not found near its guess.
  dealii::FullMatrix<Complex> of_long_wave(const Complex &omega) const;
  dealii::FullMatrix<Complex> followed(const Complex &omega) const;
  /// From the real axis of omega to where Im omega is positive.
  dealii::FullMatrix<Complex> continued(const Complex &omega) const;

  mutable std::map<std::pair<double, double>, dealii::FullMatrix<Complex>> known;
};
} // namespace Continua

#endif
