#include <continua/finite_element/solvers/iterative/fluid_mobility.h>

#include <continua/linear_algebra/function_as_matrix.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/vector_memory.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

namespace
{
/// Of w.
constexpr double tolerance = 1e-2;
constexpr unsigned int most_iterations = 50;
/// Of a stiff velocity without inertia, over that of its stiffness: so much that what is left of
/// its Schur complement is the mass form.
constexpr double without_stiffness = 1e4;
} // namespace

template <int dim>
void add_friction(const Space<dim> &space,
                  const std::vector<RegionOperators> &operators,
                  const BoundaryConstraints<dim> &constraints,
                  const VelocityOperator &velocity,
                  const StepPreconditioner<dim> &made,
                  DistributedVector &mobility)
{
  DistributedVector is_fluid = space.velocity_vector(), load = is_fluid, mass = is_fluid,
                    uniform = is_fluid, of_region = is_fluid, motion = is_fluid;
  for (unsigned int i = 0; i < is_fluid.locally_owned_size(); ++i)
    if (!made.is_stiff[i] &&
        !constraints.all().is_constrained(space.velocity_owned.nth_index_in_set(i)))
      is_fluid.begin()[i] = 1.;
  uniform = 1.;
  for (const RegionOperators &region : operators)
  {
    region.multiply_mass(of_region, uniform);
    load.add(1., of_region);
    mass.add(1., region.mass_diagonal());
  }
  load.scale(is_fluid);

  const auto multiply = [&](DistributedVector &target, const DistributedVector &source)
  {
    velocity.multiply(target, source);
    target.scale(is_fluid);
  };
  const auto precondition = [&](DistributedVector &target, const DistributedVector &source)
  {
    made.velocity->relax_fluid(target, source);
    target.scale(is_fluid);
  };
  IterationNumberControl control(most_iterations, tolerance * load.l2_norm());
  GrowingVectorMemory<DistributedVector> memory;
  try
  {
    SolverCG<DistributedVector>(control, memory)
        .solve(FunctionAsMatrix<decltype(multiply)>{multiply}, motion, load,
               FunctionAsMatrix<decltype(precondition)>{precondition});
  }
  catch (const SolverControl::NoConvergence &)
  {
    // A product is no number; the iteration around says so. D is then 1/A_ii.
    motion = 0.;
  }
  memory.release_unused_memory(); // the run goes on

  for (unsigned int i = 0; i < mobility.locally_owned_size(); ++i)
  {
    double &of_node = mobility.begin()[i];
    const double by_stiffness = 1. / velocity.diagonal().begin()[i];
    if (is_fluid.begin()[i] > 0.)
    {
      const double with_friction = std::max(motion.begin()[i] / mass.begin()[i], by_stiffness);
      of_node = of_node > 0. ? std::min(of_node, with_friction) : with_friction;
    }
    else if (made.is_stiff[i] && of_node == 0.)
      of_node = without_stiffness * by_stiffness;
  }
}

template void add_friction(const Space<2> &,
                           const std::vector<RegionOperators> &,
                           const BoundaryConstraints<2> &,
                           const VelocityOperator &,
                           const StepPreconditioner<2> &,
                           DistributedVector &);
template void add_friction(const Space<3> &,
                           const std::vector<RegionOperators> &,
                           const BoundaryConstraints<3> &,
                           const VelocityOperator &,
                           const StepPreconditioner<3> &,
                           DistributedVector &);
} // namespace Continua
