#include <continua/postprocess/error_norms.h>

#include <cmath>

namespace Continua
{
namespace
{
Expression negative(const Expression &expression)
{
  if (expression.depends_on_time() || expression.depends_on_space())
    return Expression("-(" + expression.text() + ")", Dimensions::none);
  const double origin[3] = {0., 0., 0.};
  return Expression(-expression(origin, 0.));
}

/// The L2 norm's unit: that of the field's square integrated, under the root.
std::string unit_of_norm(const Dimension &field, const Model model)
{
  if (model == Model::plane_strain || model == Model::plane_stress)
  {
    Dimension norm = field;
    ++norm.length;
    return norm.unit();
  }
  return field.unit() + " m^(3/2)";
}
} // namespace

template <int dim>
void ErrorNorms<dim>::read(ParameterSection section)
{
  const auto add = [&](const std::string &key, const std::string &name, const ComparedField what,
                       const Dimension &dimension, const unsigned int n_components,
                       const std::string &components)
  {
    Field field{name, what, dimension, std::vector<Expression>(n_components)};
    add_expressions(section, key, field.exact, n_components, dimension,
                    "Exact " + name + components + " of (x, y, z, t) [" + dimension.unit() +
                        "], with which the state at the end is compared");
    if (section.given(key))
      fields.push_back(field);
  };
  const std::string each = ", one expression a component";
  add("Velocity", "velocity", ComparedField::velocity, Dimensions::velocity, dim, each);
  add("Displacement", "displacement", ComparedField::displacement, Dimensions::length, dim, each);
  add("Pressure", "pressure", ComparedField::pressure, Dimensions::pressure, 1, "");
  add("Stress", "stress", ComparedField::stress, Dimensions::pressure, dim == 2 ? 4 : 6,
      std::string(", the components xx, yy, zz, xy") + (dim == 2 ? "" : ", xz, yz") +
          " (zz is the hoop stress in axisymmetry)");
}

template <int dim>
void ErrorNorms<dim>::finish(ContinuumSolver<dim> &solver,
                             const double time,
                             const Model model,
                             Summary &summary) const
{
  for (const Field &field : fields)
  {
    const double error = solver.error_norm(field.compared, field.exact, time);
    summary.add({"L2 error of " + field.name, error, unit_of_norm(field.dimension, model), ""});

    // The solver measures only distances from its state u. The norm of the exact solution e follows
    // from |u - e|^2 + |u + e|^2 = 2 |u|^2 + 2 |e|^2.
    std::vector<Expression> opposite;
    for (const Expression &component : field.exact)
      opposite.push_back(negative(component));
    const std::vector<Expression> zero(field.exact.size());
    const double distance_to_opposite = solver.error_norm(field.compared, opposite, time);
    const double norm_of_state = solver.error_norm(field.compared, zero, time);
    const double twice_square = error * error + distance_to_opposite * distance_to_opposite -
                                2. * norm_of_state * norm_of_state;
    // Below this there is nothing but round-off.
    if (twice_square > 1e-12 * norm_of_state * norm_of_state)
      summary.add(
          {"relative L2 error of " + field.name, error / std::sqrt(twice_square / 2.), "1", ""});
  }
}

template <int dim>
void ErrorNorms<dim>::name_quantities(QuantityNames &names) const
{
  for (const Field &field : fields)
  {
    names.add("L2 error of " + field.name);
    names.add("relative L2 error of " + field.name);
  }
}

template class ErrorNorms<2>;
template class ErrorNorms<3>;
} // namespace Continua
