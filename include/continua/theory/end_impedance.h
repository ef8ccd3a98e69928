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
 * The impedance matched_impedance() of a tube's end at one s after the other, exactly: the waves are
 * followed up to each frequency from a thirtieth of it, where their first guess is good. What was
 * computed is kept.
 */
class EndImpedance
{
public:
  using Complex = std::complex<double>;

  /// `factor`: the impedance of a part of the section over that of the whole.
  EndImpedance(TubeSection section, WallEnd wall, double factor);
  /// Z [Pa s/m^3] at s [1/s], Re s >= 0 and Im s != 0. Throws RunError if a wave is lost or there is
  /// none at this s.
  dealii::FullMatrix<Complex> operator()(Complex s) const;

private:
  TubeSection section;
  WallEnd wall;
  double factor;
  mutable std::map<std::pair<double, double>, dealii::FullMatrix<Complex>> known;
};
} // namespace Continua

#endif
