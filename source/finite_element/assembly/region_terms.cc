#include <continua/finite_element/assembly/region_terms.h>

#include <continua/finite_element/assembly/convective_terms.h>
#include <continua/finite_element/assembly/deformation_terms.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <memory>

namespace Continua
{
template <int dim>
RegionTerms<dim>::RegionTerms(const Space<dim> &space,
                              const Problem &problem,
                              const LinearSolverParameters &solver,
                              MetricHistory<dim> *const metrics)
    : space(space), problem(problem)
{
  if (problem.has_regions_of(RegionModel::finite_solid))
    terms.push_back(std::make_unique<DeformationTerms<dim>>(space, problem, metrics));
  if (problem.has_regions_of(RegionModel::flow))
    terms.push_back(std::make_unique<ConvectiveTerms<dim>>(
        space, problem,
        solver.is_matrix_free(space.degree()) ? std::optional(solver.instruction_set)
                                              : std::nullopt));
}

template <int dim>
NonlinearCellTerms<dim> &RegionTerms<dim>::terms_of(const unsigned int region) const
{
  const auto found =
      std::find_if(terms.begin(), terms.end(),
                   [region](const auto &of_model) { return of_model->are_of(region); });
  AssertThrow(found != terms.end(), dealii::ExcInternalError());
  return **found;
}

template <int dim>
void RegionTerms<dim>::reinit(MemoryUse &memory_use)
{
  for (const auto &of_model : terms)
  {
    of_model->reinit();
    memory_use.mark("cells of the terms that are not linear");
  }
}

template <int dim>
void RegionTerms<dim>::forget_derivative()
{
  for (const auto &of_model : terms)
    of_model->forget_derivative();
}

template <int dim>
void RegionTerms<dim>::add(const StepSolution &state,
                           DistributedVector &momentum,
                           DistributedVector &mass)
{
  for (const auto &of_model : terms)
    of_model->add(state, momentum, mass);
}

template <int dim>
void RegionTerms<dim>::add_powers(const unsigned int region,
                                  const StepSolution &state,
                                  const DistributedVector &of_velocity,
                                  const TermsTaken taken,
                                  NonlinearPowers &powers,
                                  DistributedVector *const momentum)
{
  terms_of(region).add_powers(region, state, of_velocity, taken, powers, momentum);
}

template <int dim>
NonlinearEnergy RegionTerms<dim>::energy_of(const unsigned int region, const State &state)
{
  return terms_of(region).energy_of(region, state);
}

template <int dim>
double RegionTerms<dim>::relaxation_power(const unsigned int region) const
{
  return problem.region_model(region) != RegionModel::linear
             ? terms_of(region).relaxation_power(region)
             : 0.;
}

template <int dim>
void RegionTerms<dim>::raise_sizes(typename NonlinearCellTerms<dim>::Sizes &sizes) const
{
  for (const auto &of_model : terms)
  {
    const typename NonlinearCellTerms<dim>::Sizes of_terms = of_model->sizes_of_terms();
    sizes.stress = std::max(sizes.stress, of_terms.stress);
    sizes.velocity = std::max(sizes.velocity, of_terms.velocity);
  }
}

template <int dim>
void RegionTerms<dim>::add_derivative_product(const DistributedVector &velocity,
                                              const DistributedVector &pressure,
                                              DistributedVector &momentum,
                                              DistributedVector &mass)
{
  for (const auto &of_model : terms)
    of_model->add_derivative_product(velocity, pressure, momentum, mass);
}

template <int dim>
void RegionTerms<dim>::add_reaction(const DistributedVector &profile,
                                    DistributedVector &of_velocity,
                                    DistributedVector &of_pressure,
                                    DistributedVector &momentum,
                                    DistributedVector &mass)
{
  if (terms.empty())
    return;
  DistributedVector rows = space.velocity_vector(), columns = rows;
  DistributedVector volumes = space.pressure_vector(), pressures = volumes;
  for (const auto &of_model : terms)
    of_model->add_products_with(profile, rows, volumes, columns, pressures);
  momentum.add(-1., rows);
  mass.add(-1., volumes);
  of_velocity.add(1., columns);
  of_pressure.add(-1., pressures);
}

template <int dim>
void RegionTerms<dim>::start_from(const DistributedVector &displacement)
{
  for (const auto &of_model : terms)
    of_model->start_from(displacement);
}

template <int dim>
void RegionTerms<dim>::visit(StateVisitor &visitor)
{
  for (const auto &of_model : terms)
    of_model->visit_state(visitor);
}

template <int dim>
void RegionTerms<dim>::take_own_state()
{
  for (const auto &of_model : terms)
    of_model->take_own_state();
}

template <int dim>
void RegionTerms<dim>::finish_step(const StepSolution &solution, const State &state)
{
  for (const auto &of_model : terms)
    of_model->finish_step(solution, state);
}

template <int dim>
const DistributedVector *RegionTerms<dim>::wall_potentials() const
{
  for (const auto &of_model : terms)
    if (of_model->wall_potentials() != nullptr)
      return of_model->wall_potentials();
  return nullptr;
}

template <int dim>
const DistributedVector *RegionTerms<dim>::unloaded_displacement() const
{
  for (const auto &of_model : terms)
    if (of_model->unloaded_displacement() != nullptr)
      return of_model->unloaded_displacement();
  return nullptr;
}

template <int dim>
void RegionTerms<dim>::set_unloaded_displacement(const DistributedVector &displacement)
{
  for (const auto &of_model : terms)
    of_model->set_unloaded_displacement(displacement);
}

template class RegionTerms<2>;
template class RegionTerms<3>;
} // namespace Continua
