#ifndef continua_analysis_mean_of_loads_h
#define continua_analysis_mean_of_loads_h

#include <continua/case/case.h>
#include <continua/continuum/problem.h>

namespace Continua
{
/// A load whose mean is below this part of its largest value has none.
constexpr double no_mean_of_load = 1e-9;

/// Whether a load of the file has a mean over a period, wherever it acts. What depends on place and
/// time together does not count: its samples on the mesh alone tell.
bool loads_have_mean(const Problem &problem, const PeriodicStateParameters &beats);

/// Whether a solid comes to no rest under a load that stays.
bool creeps_for_ever(const Material &material);

/// The longest time in which a stress or a windkessel comes to rest [s]; 0: none.
double longest_relaxation(const Problem &problem);
} // namespace Continua

#endif
