#include <continua/continuum/field_list.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
const char *const axes[3] = {"x", "y", "z"};
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
  // e_r = (0, c, s) and e_theta = (0, -s, c); in axisymmetry e_r = e_y, and z goes round the axis.
  const double r = dim == 3 ? std::hypot(point[1], point[dim - 1]) : 0.;
  const double c = r > 0. ? point[1] / r : 1., s = r > 0. ? point[dim - 1] / r : 0.;
  switch (combination)
  {
  case Combination::radial:
    result[1] = c;
    result[2] = s;
    break;
  case Combination::hoop:
    result[1] = s * s;
    result[2] = c * c;
    result[5] = -2. * s * c;
    break;
  case Combination::drag:
    result[3] = -c;
    result[4] = -s;
    break;
  case Combination::component:
  case Combination::along:
  case Combination::trace:
    break;
  }
  return result;
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
std::vector<FieldDefinition<dim>> field_list(const Model model)
{
  using Field = FieldDefinition<dim>;
  using Quantity = typename Field::Quantity;
  using Combination = typename Field::Combination;
  const auto none = Combination::component;
  std::vector<Field> list;
  for (unsigned int c = 0; c < dim; ++c)
    list.push_back({{std::string("velocity ") + axes[c], "m/s"}, Quantity::velocity, none, c});
  for (unsigned int c = 0; c < dim; ++c)
    list.push_back(
        {{std::string("displacement ") + axes[c], "m"}, Quantity::displacement, none, c});
  list.push_back({{"pressure", "Pa"}, Quantity::pressure, none, 0});
  const auto pair = [](const unsigned int k)
  { return std::string(axes[stress_pairs[k][0]]) + axes[stress_pairs[k][1]]; };
  for (unsigned int k = 0; k < n_stresses<dim>(); ++k)
    list.push_back({{"stress " + pair(k), "Pa"}, Quantity::stress, none, k});
  for (unsigned int k = 0; k < n_stresses<dim>(); ++k)
    list.push_back({{"strain " + pair(k), "1"}, Quantity::strain, none, k});
  list.push_back({{"dilatation", "1"}, Quantity::strain, Combination::trace, 0});
  if (model == Model::axisymmetric || model == Model::three_dimensional)
  {
    list.push_back({{"radial velocity", "m/s"}, Quantity::velocity, Combination::radial, 0});
    list.push_back({{"radial displacement", "m"}, Quantity::displacement, Combination::radial, 0});
    list.push_back({{"hoop stress", "Pa"}, Quantity::stress, Combination::hoop, 0});
    list.push_back({{"wall shear stress", "Pa"}, Quantity::stress, Combination::drag, 0});
  }
  return list;
}

template <int dim>
std::vector<FieldComponent> field_names(const Model model)
{
  std::vector<FieldComponent> names;
  for (const FieldDefinition<dim> &field : field_list<dim>(model))
    names.push_back(field.name);
  return names;
}

template struct FieldDefinition<2>;
template struct FieldDefinition<3>;
template FieldDefinition<2> field_along(FieldDefinition<2>::Quantity, const dealii::Tensor<1, 2> &);
template FieldDefinition<3> field_along(FieldDefinition<3>::Quantity, const dealii::Tensor<1, 3> &);
template std::vector<FieldDefinition<2>> field_list(Model);
template std::vector<FieldDefinition<3>> field_list(Model);
template std::vector<FieldComponent> field_names<2>(Model);
template std::vector<FieldComponent> field_names<3>(Model);
} // namespace Continua
