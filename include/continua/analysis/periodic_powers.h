#ifndef continua_analysis_periodic_powers_h
#define continua_analysis_periodic_powers_h

#include <continua/analysis/run.h>
#include <continua/continuum/harmonic_system.h>

#include <vector>

namespace Continua
{
/// The mean powers of the harmonics of a periodic motion, from harmonic 1: mean-power.csv, and how
/// far they are from balance. Those of the mean are not among them.
template <int dim>
class PeriodicPowers
{
public:
  /// Both must outlive it.
  PeriodicPowers(Run<dim> &run, HarmonicSystem<dim> &system) : run(run), system(system) {}

  /// Of the next harmonic. Collective.
  void add(const HarmonicSolution &solution, const HarmonicLoad &load);
  /// Writes the table and adds the quantity.
  void write();

private:
  Run<dim> &run;
  HarmonicSystem<dim> &system;
  std::vector<HarmonicPowers> powers;  ///< by harmonic, from 1
  std::vector<double> sizes_of_powers; ///< likewise, of what the loads move to and fro, too [W]
};
} // namespace Continua

#endif
