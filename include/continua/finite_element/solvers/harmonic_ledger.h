#ifndef continua_finite_element_solvers_harmonic_ledger_h
#define continua_finite_element_solvers_harmonic_ledger_h

#include <continua/continuum/harmonic_system.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/assembly/linear_products.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/solvers/harmonic_equations.h>
#include <continua/finite_element/solvers/harmonic_ports.h>
#include <continua/finite_element/space/space.h>

#include <complex>
#include <vector>

namespace Continua
{
/// Mean powers and flow rates of a motion exp(s t). What a method does is said in HarmonicSystem
/// under the same name. Collective.
template <int dim>
class HarmonicLedger
{
public:
  using Complex = std::complex<double>;

  /// All must outlive it.
  HarmonicLedger(const Space<dim> &space,
                 const Problem &problem,
                 const std::vector<RegionOperators> &operators,
                 const LinearProducts<dim> &products,
                 HarmonicEquations<dim> &equations,
                 const HarmonicPorts &ports)
      : space(space),
        problem(problem),
        operators(operators),
        products(products),
        equations(equations),
        ports(ports)
  {
  }

  HarmonicPowers powers(const HarmonicSolution &solution, const HarmonicLoad &load);
  Complex
  power_of(const HarmonicLoad &part, const HarmonicSolution &solution, const HarmonicLoad &load);
  Complex flow_rate(unsigned int condition, const HarmonicSolution &solution);

private:
  const Space<dim> &space;
  const Problem &problem;
  const std::vector<RegionOperators> &operators;
  const LinearProducts<dim> &products;
  HarmonicEquations<dim> &equations;
  const HarmonicPorts &ports;

  /// What moves the prescribed velocities [N]: A D - B^T p + q P - f.
  std::vector<Complex> reactions(const HarmonicSolution &solution, const HarmonicLoad &load);
};
} // namespace Continua

#endif
