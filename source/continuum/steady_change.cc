#include <continua/continuum/steady_change.h>

#include <continua/continuum/branch_history.h>
#include <continua/linear_algebra/linear_combination.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace Continua
{
using namespace dealii;

SteadyChange::SteadyChange(const Problem &problem, Operators &operators)
    : problem(problem), operators(operators)
{
}

double SteadyChange::force_of(const unsigned int region,
                              const Step &step,
                              const DistributedVector &velocity)
{
  const Material &material = problem.materials[region];
  operators.products().multiply_stiffness(region, forces, velocity);
  forces *= material.shear.viscosity;
  operators.products().multiply_mass(region, inertia, velocity);
  forces.add(step.a0 * material.density, inertia);
  return forces.linfty_norm();
}

double SteadyChange::operator()(const Step &step,
                                const DistributedVector &velocity,
                                const DistributedVector &displacement,
                                const StepSolution &solution)
{
  // What round-off leaves of a region that nothing loads is no change.
  constexpr double least_share = 1e-5;
  // The mesh may have changed, which one rank alone does not know.
  for (DistributedVector *vector : {&change_of_velocity, &forces, &inertia})
    vector->reinit(velocity);
  const std::vector<std::vector<unsigned int>> nodes = operators.velocity_nodes();
  const double displacement_by_velocity = BranchHistory::step_displacement(step);
  const std::size_t n = problem.materials.size();
  // By region: the change, and what it is a part of.
  std::vector<double> sizes(2 * n, 0.);
  for (unsigned int region = 0; region < n; ++region)
  {
    double &change = sizes[region], &total = sizes[n + region];
    if (problem.materials[region].is_solid())
    {
      for (const unsigned int i : nodes[region])
      {
        const double of_step = displacement_by_velocity * solution.velocity.begin()[i];
        change = std::max(change, std::abs(of_step));
        total = std::max(total, std::abs(displacement.begin()[i] + of_step));
      }
      continue;
    }
    total = force_of(region, step, solution.velocity);
    change_of_velocity.equ(1., solution.velocity);
    change_of_velocity.add(-1., velocity);
    change = force_of(region, step, change_of_velocity);
    operators.products().multiply_gradient(region, forces, solution.pressure);
    total = std::max(total, least_share * forces.linfty_norm());
  }
  Utilities::MPI::max(sizes, problem.communicator, sizes);
  std::array<double, 2> largest{}; // of liquids, of solids
  for (unsigned int region = 0; region < n; ++region)
    largest[problem.materials[region].is_solid()] =
        std::max(largest[problem.materials[region].is_solid()], sizes[n + region]);
  double result = 0.;
  for (unsigned int region = 0; region < n; ++region)
    if (sizes[region] > 0.)
      result = std::max(result,
                        sizes[region] /
                            std::max(sizes[n + region],
                                     least_share * largest[problem.materials[region].is_solid()]));
  return result;
}
} // namespace Continua
