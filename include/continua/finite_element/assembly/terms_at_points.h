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
} // namespace Continua

#endif
