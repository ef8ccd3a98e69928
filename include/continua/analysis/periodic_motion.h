#ifndef continua_analysis_periodic_motion_h
#define continua_analysis_periodic_motion_h

#include <continua/continuum/harmonic_system.h>

#include <vector>

namespace Continua
{
/// A periodic motion of the whole body as the sum of its harmonics.
template <int dim>
class PeriodicMotion
{
public:
  /// `period` [s]. The system must outlive it.
  PeriodicMotion(HarmonicSystem<dim> &system, double period) : system(system), period(period) {}

  /// Harmonic 0, as a sum of solutions; none by itself.
  void set_mean(const std::vector<WeightedSolution> &solutions) { mean = solutions; }
  /// The next harmonic, from 1.
  void add(const HarmonicSolution &solution) { harmonics.push_back({solution, 1.}); }
  /// Makes the motion at a time [s] the state of the solver. Collective.
  void show(double time);

private:
  HarmonicSystem<dim> &system;
  const double period;
  std::vector<WeightedSolution> mean, harmonics;
};
} // namespace Continua

#endif
