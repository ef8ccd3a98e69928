#ifndef continua_finite_element_field_list_h
#define continua_finite_element_field_list_h

#include <continua/continuum/continuum_solver.h>
#include <continua/materials/model.h>

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace Continua
{
/// The components of a stress or strain as (i, j): xx, yy, zz, xy, and in three dimensions xz, yz.
inline constexpr unsigned int stress_pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};

/// The number of components that exist in the model: 4 in two dimensions, else 6.
template <int dim>
constexpr unsigned int n_stresses()
{
  return dim == 2 ? 4 : 6;
}

/**
 * A field that can be probed: a component of one of the quantities of the solution, or a linear
 * combination of its components whose factors depend on the place (those about the x axis).
 */
template <int dim>
struct FieldDefinition
{
  enum class Quantity
  {
    velocity,
    displacement,
    pressure,
    stress,
    strain
  };
  /// Of the components; about the x axis e_r points away from it and e_theta round it.
  enum class Combination
  {
    component, ///< one of them
    radial,    ///< e_r.v
    hoop,      ///< e_theta.sigma.e_theta
    drag       ///< -e_x.sigma.e_r: what a fluid exerts downstream on a wall around it
  };
  FieldComponent name;
  Quantity quantity = Quantity::pressure;
  Combination combination = Combination::component;
  unsigned int component = 0;

  /// The factors of the components (of a vector x, y, z; of a stress those of stress_pairs) at a
  /// point of the undeformed body. On the x axis, where there is no e_r, it is e_y.
  std::array<double, 6> factors(const dealii::Point<dim> &point) const;
};

/// All fields of the model, in the order in which they are offered. `radial velocity`, `radial
/// displacement`, `hoop stress` and `wall shear stress` exist in axisymmetry and three dimensions.
template <int dim>
std::vector<FieldDefinition<dim>> field_list(Model model);
} // namespace Continua

#endif
