#ifndef continua_theory_kept_waves_h
#define continua_theory_kept_waves_h

#include <continua/theory/dispersion_curves.h>

#include <list>
#include <memory>
#include <mutex>

namespace Continua
{
/**
 * Exact waves that were computed before, for theories that have a section in common: another load,
 * another end or another clock needs no new dispersion. Several threads may use it at once.
 */
class KeptWaves
{
public:
  /// Of the section, up to that frequency [Hz] or beyond it, with that shift [1/s]: computed if
  /// there are none. Throws as DispersionCurves.
  std::shared_ptr<const DispersionCurves>
  waves(const TubeSection &section, double shift, double highest_frequency);
  unsigned int n_computed() const; ///< how often waves were computed

private:
  struct Row
  {
    TubeSection section;
    double shift, highest_frequency;
    std::shared_ptr<const DispersionCurves> curves;
  };
  mutable std::mutex mutex;
  std::list<Row> rows; ///< the last used one first
  unsigned int computed = 0;
};
} // namespace Continua

#endif
