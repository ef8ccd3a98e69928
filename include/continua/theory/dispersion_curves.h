#ifndef continua_theory_dispersion_curves_h
#define continua_theory_dispersion_curves_h

#include <continua/theory/exact_dispersion.h>

#include <vector>

namespace Continua
{
/**
 * The waves of a tube over frequency, on the line omega = 2 pi f - i shift: each family is followed
 * from f = 0, where its first guess is good, and interpolated between the frequencies where it was
 * computed (cubic splines; they are as smooth as the decay `shift` makes them, so the distance of
 * these frequencies grows with f).
 */
class DispersionCurves
{
public:
  using Complex = std::complex<double>;

  /// `shift` [1/s], positive; `highest_frequency` [Hz]. Throws RunError if a family is lost.
  DispersionCurves(const TubeSection &section, double shift, double highest_frequency);
  ~DispersionCurves();
  DispersionCurves(DispersionCurves &&) noexcept;

  const std::vector<ExactDispersion::Family> &families() const { return dispersion.families(); }
  /// The waves at a frequency [Hz] between 0 and the highest one, in the order of families().
  void evaluate(double frequency, std::vector<WaveMode> &modes) const;
  const TubeSection &tube_section() const { return section; }

private:
  struct Splines;
  TubeSection section;
  ExactDispersion dispersion;
  std::vector<std::unique_ptr<Splines>> splines; ///< by family
  std::vector<double> frequencies;

  std::vector<WaveMode> follow(ExactDispersion::Family family,
                               double shift,
                               const std::vector<std::vector<WaveMode>> &others) const;
};
} // namespace Continua

#endif
