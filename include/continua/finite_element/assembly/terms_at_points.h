#ifndef continua_finite_element_assembly_terms_at_points_h
#define continua_finite_element_assembly_terms_at_points_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/finite_element/space/numbers_at_points.h>

namespace Continua
{
/// The powers of terms that are asked for.
struct PowersAtPoints
{
  NumbersAtPoints<const double> velocity; ///< of the powers, with its derivatives [m/s]
  TermsTaken taken = TermsTaken::all;
  NonlinearPowers &powers; ///< to which they are added
};

/// What terms give at all points of a cell, times the weights: by the values of test functions and
/// by their derivatives along the coordinates of the reference cell.
struct TestedAtPoints
{
  NumbersAtPoints<double> momentum;
  double *volume = nullptr; ///< by the values alone
};

/// What the derivative gives at a point in one direction: of the rows of momentum, by the value and
/// the derivatives of a test function for each component, and of the row of volume.
template <int dim>
constexpr unsigned int n_numbers_of_direction = dim *(dim + 1) + 1;
/// The directions in which terms are differentiated at a point: a velocity by its value and its
/// derivatives for each component, a pressure by its value and, where that is asked for, by its
/// derivatives.
template <int dim>
constexpr unsigned int n_directions(const bool has_pressure_gradient)
{
  return dim * (dim + 1) + 1 + (has_pressure_gradient ? dim : 0);
}
} // namespace Continua

#endif
