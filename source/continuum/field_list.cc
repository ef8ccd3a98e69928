#include <continua/continuum/field_list.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
const char *const axes[3] = {"x", "y", "z"};

/// A direction across another one.
template <int dim>
dealii::Tensor<1, dim> across(const dealii::Tensor<1, dim> &direction)
{
  unsigned int least = 0;
  for (unsigned int c = 1; c < dim; ++c)
    if (std::abs(direction[c]) < std::abs(direction[least]))
      least = c;
  dealii::Tensor<1, dim> result;
  result[least] = 1.;
  return result - direction[least] * direction;
}
} // namespace

template <int dim>
typename FieldDefinition<dim>::Directions
FieldDefinition<dim>::directions(const dealii::Point<dim> &point) const
{
  Directions result;
  dealii::Tensor<1, dim> distance = point - axis.point;
  distance -= (distance * axis.direction) * axis.direction;
  if (dim == 2 || distance.norm() == 0.)
    distance = across(axis.direction);
  distance /= distance.norm();
  for (unsigned int c = 0; c < dim; ++c)
  {
    result.axial[c] = axis.direction[c];
    result.radial[c] = distance[c];
  }
  for (unsigned int c = 0; c < 3; ++c)
    result.hoop[c] = result.axial[(c + 1) % 3] * result.radial[(c + 2) % 3] -
                     result.axial[(c + 2) % 3] * result.radial[(c + 1) % 3];
  return result;
}

template <int dim>
std::array<double, 6> FieldDefinition<dim>::factors(const dealii::Point<dim> &point) const
{
  std::array<double, 6> result = {{0., 0., 0., 0., 0., 0.}};
  if (combination == Combination::component)
  {
    result[component] = 1.;
    return result;
  }
  if (combination == Combination::along)
  {
    std::copy(direction.begin(), direction.end(), result.begin());
    return result;
  }
  if (combination == Combination::trace)
  {
    std::fill_n(result.begin(), 3, 1.);
    return result;
  }
  const Directions here = directions(point);
  // a.sigma.b by the components of the stress.
  const auto set_product = [&result](const dealii::Tensor<1, 3> &a, const dealii::Tensor<1, 3> &b)
  {
    for (unsigned int k = 0; k < result.size(); ++k)
    {
      const unsigned int i = stress_pairs[k][0], j = stress_pairs[k][1];
      result[k] = i == j ? a[i] * b[i] : a[i] * b[j] + a[j] * b[i];
    }
  };
  const auto set_vector = [&result](const dealii::Tensor<1, 3> &vector)
  {
    for (unsigned int c = 0; c < 3; ++c)
      result[c] = vector[c];
  };
  switch (combination)
  {
  case Combination::radial:
    set_vector(here.radial);
    break;
  case Combination::axial:
    set_vector(here.axial);
    break;
  case Combination::hoop:
    set_product(here.hoop, here.hoop);
    break;
  case Combination::drag:
    set_product(here.axial, here.radial);
    for (double &factor : result)
      factor = -factor;
    break;
  case Combination::component:
  case Combination::along:
  case Combination::trace:
  case Combination::through:
    break;
  }
  return result;
}

template <int dim>
bool FieldDefinition<dim>::is_average() const
{
  return quantity == Quantity::average_wall_shear_stress ||
         quantity == Quantity::oscillatory_shear_index ||
         quantity == Quantity::relative_residence_time;
}

template <int dim>
FieldDefinition<dim> field_along(const typename FieldDefinition<dim>::Quantity quantity,
                                 const dealii::Tensor<1, dim> &direction)
{
  FieldDefinition<dim> field;
  field.quantity = quantity;
  field.combination = FieldDefinition<dim>::Combination::along;
  for (unsigned int c = 0; c < dim; ++c)
    field.direction[c] = direction[c];
  return field;
}

template <int dim>
std::vector<FieldDefinition<dim>> field_list(const Problem &problem)
{
  using Field = FieldDefinition<dim>;
  using Quantity = typename Field::Quantity;
  using Combination = typename Field::Combination;
  const auto none = Combination::component;
  std::vector<Field> list;
  const auto add = [&list](const std::string &name, const std::string &unit,
                           const Quantity quantity, const Combination combination,
                           const unsigned int component = 0)
  {
    Field field;
    field.name = {name, unit};
    field.quantity = quantity;
    field.combination = combination;
    field.component = component;
    list.push_back(field);
  };
  for (unsigned int c = 0; c < dim; ++c)
    add(std::string("velocity ") + axes[c], "m/s", Quantity::velocity, none, c);
  for (unsigned int c = 0; c < dim; ++c)
    add(std::string("displacement ") + axes[c], "m", Quantity::displacement, none, c);
  add("pressure", "Pa", Quantity::pressure, none);
  const auto pair = [](const unsigned int k)
  { return std::string(axes[stress_pairs[k][0]]) + axes[stress_pairs[k][1]]; };
  for (unsigned int k = 0; k < n_stresses<dim>(); ++k)
    add("stress " + pair(k), "Pa", Quantity::stress, none, k);
  for (unsigned int k = 0; k < n_stresses<dim>(); ++k)
    add("strain " + pair(k), "1", Quantity::strain, none, k);
  add("dilatation", "1", Quantity::strain, Combination::trace);
  const bool has_axis =
      problem.model == Model::axisymmetric || problem.model == Model::three_dimensional;
  if (problem.finds_unloaded_shape())
  {
    for (unsigned int c = 0; c < dim; ++c)
      add(std::string("unloaded displacement ") + axes[c], "m", Quantity::unloaded_displacement,
          none, c);
    if (has_axis)
      add("radial unloaded displacement", "m", Quantity::unloaded_displacement,
          Combination::radial);
  }
  if (has_axis)
  {
    add("radial velocity", "m/s", Quantity::velocity, Combination::radial);
    add("axial velocity", "m/s", Quantity::velocity, Combination::axial);
    add("radial displacement", "m", Quantity::displacement, Combination::radial);
    add("hoop stress", "Pa", Quantity::stress, Combination::hoop);
    add("wall shear stress", "Pa", Quantity::stress, Combination::drag);
  }
  // In two dimensions the curl has one component, in axisymmetry that round the axis.
  for (unsigned int c = dim == 2 ? 2 : 0; c < 3; ++c)
    add(std::string("vorticity ") + axes[c], "1/s", Quantity::vorticity, none, c);
  add("Q criterion", "1/s^2", Quantity::q_criterion, none);
  return list;
}

template <int dim>
std::vector<FieldDefinition<dim>> wall_field_list()
{
  using Field = FieldDefinition<dim>;
  using Quantity = typename Field::Quantity;
  std::vector<Field> list;
  const auto add = [&list](const std::string &name, const std::string &unit,
                           const Quantity quantity, const unsigned int component = 0)
  {
    Field field;
    field.name = {name, unit};
    field.quantity = quantity;
    field.component = component;
    list.push_back(field);
  };
  for (unsigned int c = 0; c < dim; ++c)
    add(std::string("wall shear stress ") + axes[c], "Pa", Quantity::wall_shear_stress, c);
  add("magnitude of wall shear stress", "Pa", Quantity::wall_shear_stress_magnitude);
  add("time-averaged wall shear stress", "Pa", Quantity::average_wall_shear_stress);
  add("oscillatory shear index", "1", Quantity::oscillatory_shear_index);
  add("relative residence time", "1/Pa", Quantity::relative_residence_time);
  return list;
}

template <int dim>
std::vector<FieldComponent> wall_field_names()
{
  std::vector<FieldComponent> names;
  for (const FieldDefinition<dim> &field : wall_field_list<dim>())
    names.push_back(field.name);
  return names;
}

template <int dim>
std::vector<FieldComponent> field_names(const Problem &problem)
{
  std::vector<FieldComponent> names;
  for (const FieldDefinition<dim> &field : field_list<dim>(problem))
    names.push_back(field.name);
  return names;
}

template struct FieldDefinition<2>;
template struct FieldDefinition<3>;
template FieldDefinition<2> field_along(FieldDefinition<2>::Quantity, const dealii::Tensor<1, 2> &);
template FieldDefinition<3> field_along(FieldDefinition<3>::Quantity, const dealii::Tensor<1, 3> &);
template std::vector<FieldDefinition<2>> field_list(const Problem &);
template std::vector<FieldDefinition<3>> field_list(const Problem &);
template std::vector<FieldDefinition<2>> wall_field_list();
template std::vector<FieldDefinition<3>> wall_field_list();
template std::vector<FieldComponent> wall_field_names<2>();
template std::vector<FieldComponent> wall_field_names<3>();
template std::vector<FieldComponent> field_names<2>(const Problem &);
template std::vector<FieldComponent> field_names<3>(const Problem &);
} // namespace Continua
