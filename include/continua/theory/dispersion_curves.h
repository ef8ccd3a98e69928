#ifndef continua_theory_dispersion_curves_h
#define continua_theory_dispersion_curves_h

#include <continua/theory/wave_families.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * The exact waves of a tube over frequency, on the line omega = 2 pi f - i shift: each family is
 * followed from the lowest frequency, where its first guess is good, and interpolated between the
 * frequencies where it was computed by cubic splines.
 */
class DispersionCurves : public WaveFamilies
{
public:
  using Complex = std::complex<double>;

  /// From f = 0 to the highest frequency [Hz], with a shift [1/s] > 0: the curves are as smooth as
  /// that makes them, so the distance of the frequencies computed grows with f. Throws RunError if
  /// a family is lost.
  DispersionCurves(const TubeSection &section, double shift, double highest_frequency);
  /// At these frequencies [Hz], increasing, four at least, the first one positive if shift = 0.
  DispersionCurves(const TubeSection &section,
                   double shift,
                   const std::vector<double> &frequencies);
  ~DispersionCurves() override;

  /// The frequencies [Hz] that the first constructor computes.
  static std::vector<double>
  frequencies_of(const TubeSection &section, double shift, double highest_frequency);

  const std::vector<ExactDispersion::Family> &families() const override
  {
    return dispersion.families();
  }
  void evaluate(double frequency, std::vector<WaveMode> &modes) const override;

private:
  struct Splines;
  ExactDispersion dispersion;
  std::vector<double> frequencies;               ///< [Hz]
  bool is_supported = false;                     ///< along the axis of the wall
  std::vector<std::unique_ptr<Splines>> splines; ///< by family

  void build(double shift);
  std::vector<WaveMode> follow(ExactDispersion::Family family,
                               double shift,
                               const std::vector<std::vector<WaveMode>> &others) const;
};
} // namespace Continua

#endif
