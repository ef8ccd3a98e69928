#include <continua/finite_element/solvers/tangent_system.h>

#include <continua/base/input_error.h>
#include <continua/finite_element/solvers/condensed_system.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <stdexcept>

namespace Continua
{
using namespace dealii;

template <int dim>
TangentSystem<dim>::TangentSystem(const Space<dim> &space,
                                  const std::vector<RegionOperators> &operators,
                                  const BoundaryConstraints<dim> &constraints,
                                  const DirectSolver direct_solver)
    : space(space), operators(operators), constraints(constraints), direct_solver(direct_solver)
{
}

template <int dim>
void TangentSystem<dim>::reinit()
{
  made_factor = nullptr;
  entries.forget();
  packed.resize(space.velocity_owned.n_elements() + space.pressure_owned.n_elements());
}

template <int dim>
void TangentSystem<dim>::factorize(const SystemCoefficients &coefficients,
                                   const StepSolution &state,
                                   const NonlinearTerms<dim> &terms)
{
  std::vector<int> owned;
  owned.reserve(packed.size());
  for (const auto index : space.velocity_owned)
    owned.push_back(index);
  for (const auto index : space.pressure_owned)
    owned.push_back(space.velocity_dofs.n_dofs() + index);
  const SymmetricTriplets lower = condensed_triplets(space, operators, constraints, coefficients);
  // Adding the terms is collective, and so is adding them once more.
  bool is_summed = false;
  while (!is_summed)
  {
    entries.begin(lower.n);
    for (std::size_t k = 0; k < lower.values.size(); ++k)
    {
      entries.add(lower.rows[k], lower.columns[k], lower.values[k]);
      if (lower.rows[k] != lower.columns[k])
        entries.add(lower.columns[k], lower.rows[k], lower.values[k]);
    }
    for (const auto &of_model : terms)
      of_model->add_derivative(state, constraints.all(), entries);
    is_summed = Utilities::MPI::min(entries.finish() ? 1 : 0, space.communicator) == 1;
  }
  try
  {
    if (!made_factor)
      made_factor = make_unsymmetric_factor(direct_solver, space.communicator);
  }
  catch (const std::invalid_argument &error)
  {
    throw RunError(error.what());
  }
  made_factor->factorize(entries.matrix(), owned);
}

template <int dim>
void TangentSystem<dim>::forget_analysis()
{
  if (made_factor)
    made_factor->forget_analysis();
}

template <int dim>
void TangentSystem<dim>::solve(const DistributedVector &momentum,
                               const DistributedVector &mass,
                               DistributedVector &velocity,
                               DistributedVector &pressure)
{
  const auto middle = std::copy(momentum.begin(), momentum.end(), packed.begin());
  std::copy(mass.begin(), mass.end(), middle);
  made_factor->solve(packed);
  std::copy(packed.begin(), middle, velocity.begin());
  std::copy(middle, packed.end(), pressure.begin());
}

template class TangentSystem<2>;
template class TangentSystem<3>;
} // namespace Continua
