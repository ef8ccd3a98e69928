#ifndef continua_analysis_resonances_h
#define continua_analysis_resonances_h

#include <continua/analysis/frequency_analysis.h>
#include <continua/analysis/resonance_search.h>
#include <continua/analysis/run.h>

#include <vector>

namespace Continua
{
/**
 * Free motions exp(s t) of a linear body of solids and liquids with all their damping: frequency,
 * damping ratio, quality factor and shape (ResonanceSearch). resonances.csv has a row for each,
 * with the probes' values of its shape as real and imaginary part; fields.pvd lists the real parts
 * under the resonances' numbers, and the imaginary parts half a number behind.
 */
template <int dim>
class Resonances : private FrequencyAnalysis<dim>
{
public:
  explicit Resonances(Run<dim> &run) : FrequencyAnalysis<dim>(run) {}
  void perform();

  /// What is linear. Throws InputError.
  static void check(const Case<dim> &input, ParameterSection root);
  static void name_quantities(const Case<dim> &input, QuantityNames &names);

private:
  using FrequencyAnalysis<dim>::run;
  using FrequencyAnalysis<dim>::system;

  void write(std::vector<Resonance> &found);
  /// The number by the winding of the determinant, and a warning where it is another one.
  void count(const std::vector<Resonance> &found);
};
} // namespace Continua

#endif
