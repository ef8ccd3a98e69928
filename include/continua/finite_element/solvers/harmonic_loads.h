#ifndef continua_finite_element_solvers_harmonic_loads_h
#define continua_finite_element_solvers_harmonic_loads_h

#include <continua/continuum/harmonic_system.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/conditions/loads.h>
#include <continua/finite_element/solvers/harmonic_equations.h>
#include <continua/finite_element/solvers/harmonic_ports.h>
#include <continua/finite_element/space/space.h>

#include <vector>

namespace Continua
{
/// The loads of a file as amplitudes of a motion exp(s t). What a method does is said in
/// HarmonicSystem under the same name.
template <int dim>
class HarmonicLoads
{
public:
  /// All must outlive it.
  HarmonicLoads(const Space<dim> &space,
                const Problem &problem,
                const BoundaryConstraints<dim> &constraints,
                const Loads<dim> &loads,
                const HarmonicPorts &ports,
                const HarmonicEquations<dim> &equations)
      : space(space),
        problem(problem),
        constraints(constraints),
        load_list(loads),
        ports(ports),
        equations(equations)
  {
  }

  std::vector<HarmonicLoadSource> sources() const;
  HarmonicLoad load_of(const HarmonicLoadSource &source, double time) const;
  HarmonicLoad unit_load(unsigned int condition) const;

private:
  const Space<dim> &space;
  const Problem &problem;
  const BoundaryConstraints<dim> &constraints;
  const Loads<dim> &load_list;
  const HarmonicPorts &ports;
  const HarmonicEquations<dim> &equations;
};
} // namespace Continua

#endif
