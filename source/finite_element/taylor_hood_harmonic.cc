#include <continua/finite_element/taylor_hood_harmonic.h>

#include <continua/finite_element/products/region_operators.h>

namespace Continua
{
template <int dim>
TaylorHoodHarmonic<dim>::TaylorHoodHarmonic(const Space<dim> &space,
                                            const Problem &problem,
                                            const std::vector<RegionOperators> &operators,
                                            const BoundaryConstraints<dim> &constraints,
                                            const Loads<dim> &loads,
                                            const LinearProducts<dim> &products,
                                            const HarmonicState &state)
    : space(space),
      operators(operators),
      constraints(constraints),
      state(state),
      port_model(problem),
      equations(space, problem, operators, constraints, loads, products, port_model),
      loads(space, problem, constraints, loads, port_model),
      solver(space, operators, constraints, equations, port_model),
      ledger(space, problem, operators, loads, products, equations, port_model)
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
void TaylorHoodHarmonic<dim>::show(const HarmonicSolution &solution, const Complex factor)
{
  const auto set =
      [](const Complex of_all, const std::vector<Complex> &values, DistributedVector &vector)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
      vector.begin()[i] = (of_all * values[i]).real();
  };
  set(factor, solution.displacement, state.displacement);
  set(factor * solution.s, solution.displacement, state.velocity);
  set(factor, solution.pressure, state.pressure);
  const HarmonicCoefficients at_s = equations.coefficients(solution.s);
  state.mixtures.resize(operators.size());
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    if (state.mixtures[region].size() != state.velocity.size())
      state.mixtures[region].reinit(state.velocity);
    set(factor * at_s.stiffness[region], solution.displacement, state.mixtures[region]);
  }
}

template class TaylorHoodHarmonic<2>;
template class TaylorHoodHarmonic<3>;
} // namespace Continua
