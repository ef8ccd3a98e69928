#ifndef continua_continuum_wall_directions_parameters_h
#define continua_continuum_wall_directions_parameters_h

#include <continua/base/parameter_section.h>
#include <continua/continuum/tube_directions.h>
#include <continua/signal/expression.h>

#include <set>
#include <string>
#include <vector>

namespace Continua
{
/// The section Wall directions: what is along the axis and around the circumference of a wall, for
/// its fibres and its prestretch.
struct WallDirectionsParameters
{
  enum class Type
  {
    straight_axis, ///< TubeDirections
    potentials,    ///< by the slopes of two solutions of Laplace's equation
    expressions    ///< given as functions of place
  };
  Type type = Type::straight_axis;
  /// Boundary ids where the potential across the wall is 0 and 1, and likewise the one along it.
  std::set<unsigned int> inside, outside, begin, end;
  std::vector<Expression> axis, circumference; ///< three components of any length

  /// `boundaries`: names by id. Throws InputError.
  void read(ParameterSection section, const std::vector<std::string> &boundaries, Model model);

  bool has_potentials() const { return type == Type::potentials; }
  /// The directions at a place of the mesh. `slopes`: the gradients of the potentials along (first
  /// row) and across the wall (second row) [1/m], where there are such. Throws RunError where they
  /// do not give a direction, or one that is oblique to the plane of two dimensions.
  template <int dim>
  TubeDirections
  at(Model model, const dealii::Point<dim> &place, const dealii::Tensor<2, 3> &slopes) const;
  /// The same for pictures and probes, zero where there is no direction.
  template <int dim>
  TubeDirections
  find(Model model, const dealii::Point<dim> &place, const dealii::Tensor<2, 3> &slopes) const;
};
} // namespace Continua

#endif
