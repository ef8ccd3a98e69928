#ifndef continua_finite_element_solvers_tangent_system_h
#define continua_finite_element_solvers_tangent_system_h

#include <continua/continuum/system_coefficients.h>
#include <continua/finite_element/assembly/nonlinear_cell_terms.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/entry_sums.h>
#include <continua/linear_algebra/unsymmetric_factor.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * The tangent of a step's equations that are not linear: the matrix of the linear terms (see
 * StepSystem) and the derivative of the others at a state, unsymmetric, with boundary
 * constraints and hanging nodes eliminated on both sides, and its factor.
 */
template <int dim>
class TangentSystem
{
public:
  TangentSystem(const Space<dim> &space,
                const std::vector<RegionOperators> &operators,
                const BoundaryConstraints<dim> &constraints,
                DirectSolver direct_solver);

  /// Forgets the factor: mesh or constraints have changed.
  void reinit();
  /// Factors the tangent at the state. Throws RunError.
  void factorize(const SystemCoefficients &coefficients,
                 const StepSolution &state,
                 const NonlinearTerms<dim> &terms);
  /// The next factor is made as the first one.
  void forget_analysis();
  /// Solves for free dofs; constrained and hanging entries of the result are 0. The right-hand
  /// sides must be restricted, and that of volume has the sign of the symmetric system.
  void solve(const DistributedVector &momentum,
             const DistributedVector &mass,
             DistributedVector &velocity,
             DistributedVector &pressure);
  /// Null if there is none.
  const UnsymmetricFactor *factor() const { return made_factor.get(); }

private:
  const Space<dim> &space;
  const std::vector<RegionOperators> &operators;
  const BoundaryConstraints<dim> &constraints;
  DirectSolver direct_solver;
  EntrySums entries; ///< of the matrix
  std::unique_ptr<UnsymmetricFactor> made_factor;
  std::vector<double> packed; ///< velocities, then pressures
};
} // namespace Continua

#endif
