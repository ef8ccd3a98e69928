#ifndef continua_analysis_resonances_h
#define continua_analysis_resonances_h

#include <continua/analysis/frequency_analysis.h>
#include <continua/analysis/resonance_search.h>
#include <continua/analysis/run.h>
#include <continua/frequency/winding_number.h>

#include <cstddef>
#include <vector>

namespace Continua
{
/**
 * Free motions exp(s t) of a linear body of solids and liquids with all their damping, in finite
 * deformation small ones about the state at rest under the loads of the file: frequency, damping
 * ratio, quality factor and shape (ResonanceSearch). resonances.csv has a row for each,
 * with the probes' values of its shape as real and imaginary part; fields.pvd lists the real parts
 * under the resonances' numbers, and the imaginary parts half a number behind.
 */
template <int dim>
class Resonances : private FrequencyAnalysis<dim>
{
public:
  explicit Resonances(Run<dim> &run) : FrequencyAnalysis<dim>(run) {}
  void perform();

  /// What is linear, or a small motion about a state. Throws InputError.
  static void check(const Case<dim> &input, ParameterSection root);
  static void name_quantities(const Case<dim> &input, QuantityNames &names);

private:
  using FrequencyAnalysis<dim>::run;
  using FrequencyAnalysis<dim>::system;

  void write(std::vector<Resonance> &found);
  /// Of the determinant, as s goes once round a sector.
  WindingNumber turns_round(const PlaneSector &sector);
  /// How many resonances are equal to one of those that were found.
  int multiplicity(const std::vector<Resonance> &found, std::size_t number);
  /// The number by the winding of the determinant. Throws RunError if resonances are missing; a
  /// warning says if there are fewer.
  void count(const std::vector<Resonance> &found);
};
} // namespace Continua

#endif
