#ifndef continua_analysis_periodic_mean_h
#define continua_analysis_periodic_mean_h

#include <continua/analysis/run.h>
#include <continua/continuum/harmonic_system.h>

#include <complex>
#include <vector>

namespace Continua
{
/**
 * The mean state of a body under periodic loads: the limit for s to zero of the response u(s) to
 * loads that have grown with exp(s t) for ever, 2 u(s) - u(2 s), since a liquid has no displacement
 * at rest. It is compared with 2 u(2 s) - u(4 s), and s becomes smaller where they differ.
 */
template <int dim>
class PeriodicMean
{
public:
  using Complex = std::complex<double>;

  /// Both must outlive it.
  PeriodicMean(Run<dim> &run, HarmonicSystem<dim> &system) : run(run), system(system) {}

  /// Of each column of the probes. `ranges`: of each over the period; `is_compared`: whether it
  /// must be known within Periodic response/Tolerance. Throws RunError if it is not. Collective.
  std::vector<Complex> find(const HarmonicLoad &load,
                            const std::vector<double> &ranges,
                            const std::vector<bool> &is_compared);
  /// Of two means of a compared column, over its range or its mean [1].
  double difference() const { return difference_of_two; }
  /// The mean as a sum of solutions times numbers; empty before find().
  const std::vector<WeightedSolution> &solutions() const { return parts; }

private:
  Run<dim> &run;
  HarmonicSystem<dim> &system;
  double difference_of_two = 0.;
  std::vector<WeightedSolution> parts;
};
} // namespace Continua

#endif
