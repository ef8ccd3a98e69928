#ifndef continua_finite_element_solvers_linear_systems_h
#define continua_finite_element_solvers_linear_systems_h

#include <continua/base/log.h>
#include <continua/continuum/linear_system.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/assembly/region_terms.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/solvers/solver_choice.h>
#include <continua/finite_element/solvers/step_system.h>
#include <continua/finite_element/solvers/tangent_system.h>
#include <continua/finite_element/space/linear_solver_parameters.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * The linear system of a step: the StepSystem where all regions are linear, else that of a step of
 * Newton's iteration, which has the derivative of the terms of the regions, too. The latter is a
 * TangentSystem with a factor, or products with the iterative solver of the StepSystem. What
 * linearise() and the methods behind it do is said in NonlinearSystem.
 */
template <int dim>
class LinearSystems : public LinearSystem
{
public:
  /// All but the parameters and the outlook must outlive it.
  LinearSystems(const Space<dim> &space,
                const Problem &problem,
                const std::vector<RegionOperators> &operators,
                const BoundaryConstraints<dim> &constraints,
                RegionTerms<dim> &terms,
                const LinearSolverParameters &parameters,
                const SolverOutlook &outlook,
                Log &log);

  /// Frees the derivative of the terms: the mesh changes.
  void forget_derivative();
  /// Forgets the factors: mesh or constraints have changed. Collective.
  void reinit();

  /// Whether mass and stiffness are products without a matrix on this mesh.
  bool has_products_without_matrix() const;
  /// Whether the steps of Newton's iteration have the iterative solver on this mesh.
  bool has_iterative_tangent() const;

  SystemChange prepare(const SystemCoefficients &coefficients, double pressure_time) override;
  void eliminate_prescribed(const DistributedVector &prescribed,
                            DistributedVector &momentum,
                            DistributedVector &mass) override;
  void solve(const DistributedVector &prescribed,
             DistributedVector &momentum,
             DistributedVector &mass,
             DistributedVector &velocity,
             DistributedVector &pressure,
             StepReport &report) override;
  void add_velocity_product(const DistributedVector &velocity, DistributedVector &result) override
  {
    system.add_velocity_product(velocity, result);
  }
  void add_divergence(const DistributedVector &velocity, DistributedVector &result) override
  {
    system.add_divergence(1., velocity, result);
  }
  void set_reaction(const DistributedVector &profile,
                    DistributedVector &of_velocity,
                    DistributedVector &of_pressure,
                    DistributedVector &momentum,
                    DistributedVector &mass) override;
  void restrict_residuals(DistributedVector &momentum, DistributedVector &mass) const override;

  bool linearise(const StepSolution &state);
  void keep_derivative(const StepSolution &state);
  void forget_linearisation() { tangent.forget_analysis(); }

  /// Sets what is known of the solver in use.
  void set_sizes(SolverSizes &sizes) const;
  /// See StepSystem.
  void free_work_space() { system.free_work_space(); }
  /// Of the linear terms; for vibrations.
  StepSystem<dim> &step_system() { return system; }

private:
  const Space<dim> &space;
  const Problem &problem;
  const BoundaryConstraints<dim> &constraints;
  RegionTerms<dim> &terms;
  const LinearSolverParameters parameters;
  Log &log;
  StepSystem<dim> system;
  TangentSystem<dim> tangent;        ///< in the system's place where there are such terms
  bool derivative_is_marked = false; ///< in MemoryUse, on this mesh
  std::string linear_solver_reported;
  DistributedVector velocity_work;
  // Of products with the tangent.
  DistributedVector tangent_change, tangent_momentum, tangent_mass;

  void solve_iterative_tangent(DistributedVector &momentum,
                               DistributedVector &mass,
                               DistributedVector &velocity,
                               DistributedVector &pressure);
  void report_linear_solver();
};
} // namespace Continua

#endif
