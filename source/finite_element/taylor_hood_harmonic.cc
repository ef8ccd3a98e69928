#include <continua/finite_element/taylor_hood_harmonic.h>

#include <continua/finite_element/products/region_operators.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <utility>

namespace Continua
{
template <int dim>
TaylorHoodHarmonic<dim>::TaylorHoodHarmonic(const Space<dim> &space,
                                            const Problem &problem,
                                            const std::vector<RegionOperators> &operators,
                                            const BoundaryConstraints<dim> &constraints,
                                            const Loads<dim> &loads,
                                            const LinearProducts<dim> &products,
                                            const HarmonicState &state,
                                            const FieldProbes<dim> &probes,
                                            std::unique_ptr<LoadedBody<dim>> loaded,
                                            MovingMesh<dim> *const moving_mesh)
    : space(space),
      problem(problem),
      operators(operators),
      constraints(constraints),
      products(products),
      probes(probes),
      state(state),
      loaded(std::move(loaded)),
      moving_mesh(moving_mesh),
      port_model(problem),
      equations(
          space, problem, operators, constraints, loads, products, port_model, this->loaded.get()),
      loads(space, problem, constraints, loads, port_model, equations),
      solver(space, operators, constraints, equations, port_model),
      ledger(space, problem, operators, products, equations, port_model)
{
}

template <int dim>
std::vector<std::vector<unsigned int>> TaylorHoodHarmonic<dim>::velocity_nodes() const
{
  return Continua::velocity_nodes(operators);
}

template <int dim>
std::vector<bool> TaylorHoodHarmonic<dim>::free_velocities() const
{
  std::vector<bool> result;
  for (const auto index : space.velocity_owned)
    result.push_back(!constraints.all().is_constrained(index));
  return result;
}

template <int dim>
std::vector<VelocityPlace<dim>> TaylorHoodHarmonic<dim>::velocity_places() const
{
  std::vector<VelocityPlace<dim>> result(n_local_velocities());
  const dealii::FiniteElement<dim> &element = space.velocity_element;
  std::vector<dealii::types::global_dof_index> indices(element.n_dofs_per_cell());
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    cell->get_dof_indices(indices);
    for (unsigned int i = 0; i < indices.size(); ++i)
      if (space.velocity_owned.is_element(indices[i]))
        result[space.velocity_owned.index_within_set(indices[i])] = {
            space.mapping.transform_unit_to_real_cell(cell, element.unit_support_point(i)),
            element.system_to_component_index(i).first};
  }
  return result;
}

template <int dim>
std::vector<unsigned int> TaylorHoodHarmonic<dim>::velocities_of_solids() const
{
  const std::vector<std::vector<unsigned int>> nodes = velocity_nodes();
  std::vector<unsigned int> result;
  for (unsigned int region = 0; region < nodes.size(); ++region)
    if (problem.materials[region].is_solid())
      result.insert(result.end(), nodes[region].begin(), nodes[region].end());
  return result;
}

template <int dim>
HarmonicFunctional
TaylorHoodHarmonic<dim>::functional(const std::vector<std::pair<unsigned int, double>> &terms,
                                    const Complex s) const
{
  using Source = ProbeWeights::Source;
  AssertThrow(!loaded, dealii::ExcMessage("There is no functional about a state under loads."));
  const HarmonicCoefficients at_s = equations.coefficients(s);
  HarmonicFunctional result;
  result.weights.forces.resize(n_local_velocities());
  result.weights.dilatations.resize(n_local_pressures());
  result.of_modulus.resize(operators.size());
  for (const auto &[probe, factor] : terms)
    for (const ProbeWeights::Part &part : probes.weights_of(probe).all_parts())
      for (std::size_t i = 0; i < part.indices.size(); ++i)
      {
        const unsigned int index = part.indices[i];
        const double weight = factor * part.values[i];
        if (part.source == Source::pressure)
          result.weights.dilatations[index] += weight;
        else if (part.source == Source::mixture)
        {
          result.weights.forces[index] += at_s.stiffness[part.region] * weight;
          result.of_modulus[part.region].emplace_back(index, weight);
        }
        else
          result.weights.forces[index] += part.source == Source::velocity ? s * weight : weight;
      }
  return result;
}

template <int dim>
std::vector<HarmonicLoad> TaylorHoodHarmonic<dim>::loads_of(const Problem &changed)
{
  Loads<dim> list(space, changed);
  list.build();
  BoundaryConstraints<dim> of_changed(space, changed.conditions);
  of_changed.build();
  const HarmonicLoads<dim> changed_loads(space, changed, of_changed, list, port_model, equations);
  std::vector<HarmonicLoad> result;
  for (const HarmonicLoadSource &source : sources())
    result.push_back(changed_loads.load_of(source, 0.));
  return result;
}

template <int dim>
void TaylorHoodHarmonic<dim>::show_sum(const std::vector<WeightedSolution> &parts)
{
  const auto add =
      [](const Complex of_all, const std::vector<Complex> &values, DistributedVector &vector)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
      vector.begin()[i] += (of_all * values[i]).real();
  };
  if (loaded)
  {
    state.displacement = loaded->state().displacement;
    state.pressure = loaded->state().pressure;
  }
  else
  {
    state.displacement = 0.;
    state.pressure = 0.;
  }
  state.velocity = 0.;
  state.mixtures.resize(operators.size());
  for (DistributedVector &mixture : state.mixtures)
    mixture.reinit(state.velocity);
  for (const auto &[solution, factor] : parts)
  {
    add(factor, solution.displacement, state.displacement);
    add(factor * solution.s, solution.displacement, state.velocity);
    add(factor, solution.pressure, state.pressure);
    if (loaded)
      continue;
    const HarmonicCoefficients at_s = equations.coefficients(solution.s);
    for (unsigned int region = 0; region < operators.size(); ++region)
      add(factor * at_s.stiffness[region], solution.displacement, state.mixtures[region]);
  }
  if (loaded)
    loaded->show_branches(parts);
  if (moving_mesh == nullptr)
    return;
  // The walls move. Where the mesh is inside the liquid makes no difference to what is linear.
  DistributedVector of_mesh = loaded->state().mesh_displacement;
  for (const unsigned int i : velocities_of_solids())
    of_mesh.begin()[i] = state.displacement.begin()[i];
  moving_mesh->show(of_mesh);
}

template <int dim>
double TaylorHoodHarmonic<dim>::part_for_differences(const HarmonicSolution &solution) const
{
  if (!loaded)
    return 0.;
  double largest = 0.;
  for (const unsigned int i : velocities_of_solids())
    largest = std::max(largest, std::abs(solution.displacement[i]));
  largest = dealii::Utilities::MPI::max(largest, space.communicator);
  return largest > 0. ? loaded->small_displacement() / largest : 1.;
}

template class TaylorHoodHarmonic<2>;
template class TaylorHoodHarmonic<3>;
} // namespace Continua
