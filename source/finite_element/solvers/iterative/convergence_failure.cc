#include <continua/finite_element/solvers/iterative/convergence_failure.h>

#include <continua/linear_algebra/convergence_factor.h>

namespace Continua
{
template <int dim>
std::string describe_convergence_failure(const Space<dim> &space,
                                         const BoundaryConstraints<dim> &constraints,
                                         const LinearSolverParameters &parameters,
                                         const SaddlePointSolver::Blocks &system,
                                         StepPreconditioner<dim> &used,
                                         const TangentTerms kind,
                                         const KrylovReport &report)
{
  // A + B^T W B, whose inverse the preconditioner of the velocities is, with the terms that A and B
  // have beside the linear ones. The row of the mass is -B.
  const DistributedVector no_pressure = space.pressure_vector();
  DistributedVector of_mass = space.pressure_vector(), of_velocity = space.velocity_vector();
  const LinearFunction matrix = [&](DistributedVector &target, const DistributedVector &source)
  {
    if (system.tangent_product)
      system.tangent_product(source, no_pressure, target, of_mass);
    else
    {
      system.velocity.multiply(target, source);
      system.divergence.multiply(of_mass, source);
      of_mass *= -1.;
    }
    of_mass.scale(used.augmentation);
    system.divergence.multiply_transposed(of_velocity, of_mass);
    target.add(-1., of_velocity);
  };
  const auto factor_of = [&](const bool of_stiff, const LinearFunction &inverse)
  {
    DistributedVector is_of_block = space.velocity_vector();
    for (unsigned int i = 0; i < is_of_block.locally_owned_size(); ++i)
      if (used.is_stiff[i] == of_stiff &&
          !constraints.all().is_constrained(space.velocity_owned.nth_index_in_set(i)))
        is_of_block.begin()[i] = 1.;
    return convergence_factor(matrix, inverse, system.velocity.diagonal(), is_of_block);
  };
  BlockFactors factors;
  factors.tangent_terms = kind;
  factors.residual = report.residual;
  factors.of_all = report.late_factor;
  factors.has_stiff = used.has_stiff;
  factors.has_fluid = used.has_fluid;
  factors.stiff_is_direct = used.stiff_is_direct;
  factors.fluid_is_viscous = used.fluid_is_viscous;
  factors.has_inertia = used.has_inertia;
  if (used.has_stiff && !used.stiff_is_direct)
    factors.of_stiff =
        factor_of(true, [&](DistributedVector &target, const DistributedVector &source)
                  { used.velocity->solve_stiff(target, source); });
  if (used.has_fluid)
    factors.of_fluid =
        factor_of(false, [&](DistributedVector &target, const DistributedVector &source)
                  { used.velocity->relax_fluid(target, source); });
  return describe_stalled_block(factors, parameters);
}

template std::string describe_convergence_failure(const Space<2> &,
                                                  const BoundaryConstraints<2> &,
                                                  const LinearSolverParameters &,
                                                  const SaddlePointSolver::Blocks &,
                                                  StepPreconditioner<2> &,
                                                  TangentTerms,
                                                  const KrylovReport &);

template std::string describe_convergence_failure(const Space<3> &,
                                                  const BoundaryConstraints<3> &,
                                                  const LinearSolverParameters &,
                                                  const SaddlePointSolver::Blocks &,
                                                  StepPreconditioner<3> &,
                                                  TangentTerms,
                                                  const KrylovReport &);
} // namespace Continua
