#ifndef continua_finite_element_assembly_region_terms_h
#define continua_finite_element_assembly_region_terms_h

#include <continua/base/memory_use.h>
#include <continua/continuum/nonlinear_terms.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state.h>
#include <continua/continuum/state_visitor.h>
#include <continua/continuum/step_solution.h>
#include <continua/finite_element/assembly/metric_history.h>
#include <continua/finite_element/assembly/nonlinear_cell_terms.h>
#include <continua/finite_element/space/linear_solver_parameters.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
/// The terms of all regions that are not linear: the sum over the models of such regions that the
/// problem has. What a method does is said in NonlinearCellTerms or in NonlinearSystem under the
/// same name.
template <int dim>
class RegionTerms
{
public:
  /// The first two and the history must outlive it. `metrics`: null where nothing relaxes in finite
  /// deformation.
  RegionTerms(const Space<dim> &space,
              const Problem &problem,
              const LinearSolverParameters &solver,
              MetricHistory<dim> *metrics);

  /// Whether all regions are linear.
  bool empty() const { return terms.empty(); }
  /// Of each model.
  const NonlinearTerms<dim> &of_models() const { return terms; }

  /// The mesh has changed. Collective.
  void reinit(MemoryUse &memory_use);
  void forget_derivative();

  // The residual.
  void add(const StepSolution &state, DistributedVector &momentum, DistributedVector &mass);
  void add_powers(unsigned int region,
                  const StepSolution &state,
                  const DistributedVector &of_velocity,
                  TermsTaken taken,
                  NonlinearPowers &powers,
                  DistributedVector *momentum);
  NonlinearEnergy energy_of(unsigned int region, const State &state);
  /// 0 in a region that is linear.
  double relaxation_power(unsigned int region) const;
  /// Raises the sizes of what cancels in the rows that were added last to those of the terms.
  void raise_sizes(typename NonlinearCellTerms<dim>::Sizes &sizes) const;

  // Its derivative.
  void add_derivative_product(const DistributedVector &velocity,
                              const DistributedVector &pressure,
                              DistributedVector &momentum,
                              DistributedVector &mass);
  /// Adds what LinearSystem::set_reaction() sets.
  void add_reaction(const DistributedVector &profile,
                    DistributedVector &of_velocity,
                    DistributedVector &of_pressure,
                    DistributedVector &momentum,
                    DistributedVector &mass);

  // The state.
  void start_from(const DistributedVector &displacement);
  void visit(StateVisitor &visitor);
  void take_own_state();
  void finish_step(const StepSolution &solution, const State &state);
  const DistributedVector *wall_potentials() const;
  const DistributedVector *unloaded_displacement() const;
  void set_unloaded_displacement(const DistributedVector &displacement);

private:
  const Space<dim> &space;
  const Problem &problem;
  NonlinearTerms<dim> terms;

  /// The terms of a region that is not linear.
  NonlinearCellTerms<dim> &terms_of(unsigned int region) const;
};
} // namespace Continua

#endif
