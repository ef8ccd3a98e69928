#ifndef continua_finite_element_solvers_iterative_stiff_factor_limit_h
#define continua_finite_element_solvers_iterative_stiff_factor_limit_h

#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/space/linear_solver_parameters.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/velocity_blocks.h>

#include <optional>

namespace Continua
{
/// How large the factor of a stiff block may be. Where `Stiff block` is automatic, StiffBlockLimits
/// decide between a factor and multigrid. What has turned out too large on this mesh is remembered,
/// for stiff blocks of the same size.
template <int dim>
class StiffFactorLimit
{
public:
  /// The first two must outlive it.
  StiffFactorLimit(const Space<dim> &space,
                   const BoundaryConstraints<dim> &constraints,
                   const LinearSolverParameters &parameters);

  /// What follows is about a stiff block of so many velocities on all ranks.
  void set_size(const unsigned int n_stiff_of_all) { n_stiff = n_stiff_of_all; }
  /// Most bytes of its factor; zero if it has multigrid.
  double most_bytes() const;
  /// Throws FactorTooLarge if an estimate of the stiff block's factor, before any of its entries
  /// is assembled, is more than it may have. Collective.
  void refuse_large_factor(const VelocityBlocks &parts);
  /// Its factor needs `bytes` of entries, by an estimate or the analysis, and is too large.
  void refuse(double bytes);
  /// Bytes of a refused factor of this block; empty if none was refused.
  std::optional<double> refused_bytes() const;

  /// Most bytes of the factor for linear velocities in the multigrid of this block; zero without
  /// one.
  double most_linear_bytes() const;
  /// The factor for linear velocities is too large.
  void refuse_linear_factor() { n_stiff_without_linear_factor = n_stiff; }

private:
  /// A stiff block whose factor was refused on this mesh.
  struct RefusedFactor
  {
    unsigned int n_stiff; ///< velocities of the block on all ranks
    double bytes;         ///< of its entries, by an estimate or the analysis
  };

  const Space<dim> &space;
  const BoundaryConstraints<dim> &constraints;
  const LinearSolverParameters parameters;
  std::optional<RefusedFactor> refused_factor;
  unsigned int n_stiff = 0;                       ///< velocities of the stiff block on all ranks
  unsigned int n_stiff_without_linear_factor = 0; ///< with so many it was too large
  unsigned int n_stiff_with_small_estimate = 0;   ///< with so many no estimate is needed any more

  double n_unknowns() const; ///< of all ranks
};
} // namespace Continua

#endif
