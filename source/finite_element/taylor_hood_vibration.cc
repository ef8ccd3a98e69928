#include <continua/finite_element/taylor_hood_vibration.h>

#include <deal.II/base/function.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/component_mask.h>
#include <deal.II/numerics/vector_tools.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

namespace
{
/// A vector field as a deal.II function.
template <int dim>
class FieldFunction : public Function<dim>
{
public:
  explicit FieldFunction(const std::function<Tensor<1, dim>(const Point<dim> &)> &field)
      : Function<dim>(dim), field(field)
  {
  }
  double value(const Point<dim> &point, const unsigned int component) const override
  {
    return field(point)[component];
  }

private:
  const std::function<Tensor<1, dim>(const Point<dim> &)> &field;
};
} // namespace

template <int dim>
TaylorHoodVibration<dim>::TaylorHoodVibration(const Space<dim> &space,
                                              const Problem &problem,
                                              const std::vector<RegionOperators> &operators,
                                              const BoundaryConstraints<dim> &constraints,
                                              StepSystem<dim> &system,
                                              const VibratingState &state)
    : space(space),
      problem(problem),
      operators(operators),
      constraints(constraints),
      system(system),
      state(state),
      zero(space.velocity_vector()),
      displacement(space.velocity_vector()),
      force(space.velocity_vector()),
      product(space.velocity_vector()),
      pressure(space.pressure_vector()),
      mass(space.pressure_vector())
{
  system.counts_pivots = true;
}

template <int dim>
std::vector<unsigned int> TaylorHoodVibration<dim>::directions() const
{
  std::vector<unsigned int> result(n_local_unknowns(), 0);
  for (unsigned int d = 1; d < dim; ++d)
  {
    ComponentMask component(dim, false);
    component.set(d, true);
    for (const auto index : DoFTools::extract_dofs(space.velocity_dofs, component))
      result[space.velocity_owned.index_within_set(index)] = d;
  }
  return result;
}

template <int dim>
void TaylorHoodVibration<dim>::weigh()
{
  force = 0.;
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    operators[region].multiply_mass(product, displacement);
    force.add(problem.materials[region].density, product);
  }
  constraints.restrict_to_free(force);
}

template <int dim>
void TaylorHoodVibration<dim>::multiply_mass(const std::vector<double> &x, std::vector<double> &y)
{
  std::copy(x.begin(), x.end(), displacement.begin());
  constraints.set_constrained(displacement, zero);
  weigh();
  std::copy(force.begin(), force.end(), y.begin());
}

template <int dim>
std::vector<double>
TaylorHoodVibration<dim>::momentum(const std::function<Tensor<1, dim>(const Point<dim> &)> &field)
{
  VectorTools::interpolate(space.mapping, space.velocity_dofs, FieldFunction<dim>(field),
                           displacement);
  space.set_hanging_velocities_to_zero(displacement);
  weigh();
  return {force.begin(), force.end()};
}

template <int dim>
void TaylorHoodVibration<dim>::set_shift(const double new_shift)
{
  shift = new_shift;
  SystemCoefficients coefficients;
  for (const Material &material : problem.materials)
  {
    coefficients.mass.push_back(-shift * material.density);
    coefficients.stiffness.push_back(material.long_term_shear_modulus());
    coefficients.compressibility.push_back(material.long_term_inverse_bulk_modulus());
  }
  coefficients.support_stiffness = 1.;
  system.prepare(coefficients);
}

template <int dim>
std::size_t TaylorHoodVibration<dim>::n_below_shift() const
{
  // The rows of pressures have one negative pivot each, whether the material is compressible (their
  // block is -C) or not (a pressure and the velocities it constrains make a pair of either sign);
  // so have hanging pressures, with -1 on the diagonal. Velocities that are held have +1.
  return system.n_negative_pivots() - space.pressure_dofs.n_dofs();
}

template <int dim>
void TaylorHoodVibration<dim>::solve_system()
{
  constraints.restrict_to_free(force);
  mass = 0.;
  system.solve(force, mass, displacement, pressure);
  constraints.set_constrained(displacement, zero);
}

template <int dim>
void TaylorHoodVibration<dim>::solve(std::vector<double> &x)
{
  std::copy(x.begin(), x.end(), force.begin());
  solve_system();
  std::copy(displacement.begin(), displacement.end(), x.begin());
}

template <int dim>
void TaylorHoodVibration<dim>::set_shape(const std::vector<double> &x, const double eigenvalue)
{
  std::copy(x.begin(), x.end(), displacement.begin());
  constraints.set_constrained(displacement, zero);
  state.displacement.equ(1., displacement);
  state.velocity = 0.;
  weigh();
  force *= eigenvalue - shift;
  solve_system();
  state.pressure.equ(1., pressure);
}

template class TaylorHoodVibration<2>;
template class TaylorHoodVibration<3>;
} // namespace Continua
