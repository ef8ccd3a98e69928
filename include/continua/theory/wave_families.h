#ifndef continua_theory_wave_families_h
#define continua_theory_wave_families_h

#include <continua/theory/exact_dispersion.h>

#include <vector>

namespace Continua
{
/// The waves of a uniform tube over frequency, along omega = 2 pi f - i shift, at whatever level of
/// theory.
class WaveFamilies
{
public:
  virtual ~WaveFamilies() = default;
  /// Which waves there are.
  virtual const std::vector<ExactDispersion::Family> &families() const = 0;
  /// They at a frequency [Hz], in this order.
  virtual void evaluate(double frequency, std::vector<WaveMode> &modes) const = 0;
};
} // namespace Continua

#endif
