#ifndef continua_continuum_field_list_h
#define continua_continuum_field_list_h

#include <continua/continuum/continuum_solver.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/stress_and_strain.h>

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace Continua
{
/**
 * A field that can be probed: a component of one of the quantities of the solution, or a linear
 * combination of its components whose factors depend on the place (those about an axis).
 */
template <int dim>
struct FieldDefinition
{
  enum class Quantity
  {
    velocity,
    displacement,
    unloaded_displacement, ///< from the mesh to the unloaded shape
    pressure,
    stress,
    strain,
    vorticity,         ///< curl of the velocity; a component of x, y, z
    q_criterion,       ///< no linear function of the state
    wall_shear_stress, ///< tangential part of the traction on a wall: a component of x, y, z
    wall_shear_stress_magnitude,
    average_wall_shear_stress, ///< the mean of the magnitude over time
    oscillatory_shear_index,
    relative_residence_time ///< 1/((1 - 2 index) mean of the magnitude)
  };
  /// Of the components; e_r points away from the axis and e_theta round it.
  enum class Combination
  {
    component, ///< one of them
    along,     ///< v.direction
    trace,     ///< of a strain: the sum of those along the axes
    radial,    ///< e_r.v
    axial,     ///< e_axis.v
    hoop,      ///< e_theta.sigma.e_theta
    drag,      ///< -e_axis.sigma.e_r: what a fluid exerts downstream on a wall around it
    through    ///< v.n with the present normal of a section that moves
  };
  /// Through a point along a direction of length one; by default the x axis.
  struct Axis
  {
    dealii::Point<dim> point; ///< [m]
    dealii::Tensor<1, dim> direction = dealii::Point<dim>::unit_vector(0);
  };
  FieldComponent name;
  Quantity quantity = Quantity::pressure;
  Combination combination = Combination::component;
  unsigned int component = 0;
  std::array<double, 3> direction = {{0., 0., 0.}};
  Axis axis;

  /// Whether the field is kept over the steps of a run.
  bool is_average() const;
  /// Of length one, at a point of the undeformed body. On the axis, where there is no e_r, it is
  /// any across it; in axisymmetry z goes round the axis.
  struct Directions
  {
    dealii::Tensor<1, 3> axial, radial, hoop;
  };
  Directions directions(const dealii::Point<dim> &point) const;
  /// The factors of the components (of a vector x, y, z; of a stress those of stress_pairs) at a
  /// point of the undeformed body.
  std::array<double, 6> factors(const dealii::Point<dim> &point) const;
};

/// A velocity or a displacement along a direction, which need not have length 1.
template <int dim>
FieldDefinition<dim> field_along(typename FieldDefinition<dim>::Quantity quantity,
                                 const dealii::Tensor<1, dim> &direction);

/// All fields of the model, in the order in which they are offered. `radial velocity`, `axial
/// velocity`, `radial displacement`, `hoop stress` and `wall shear stress` exist in axisymmetry and
/// three dimensions, `unloaded displacement` where that shape is looked for.
template <int dim>
std::vector<FieldDefinition<dim>> field_list(const Problem &problem);
/// The fields that exist on boundaries and interfaces alone, in the order in which they are
/// offered: wall shear stress x, ..., magnitude of wall shear stress, time-averaged wall shear
/// stress, oscillatory shear index, relative residence time.
template <int dim>
std::vector<FieldDefinition<dim>> wall_field_list();
template <int dim>
std::vector<FieldComponent> wall_field_names();
/// Their names and units: what there is to probe, whatever the discretisation.
template <int dim>
std::vector<FieldComponent> field_names(const Problem &problem);
} // namespace Continua

#endif
