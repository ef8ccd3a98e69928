#ifndef continua_inference_flat_direction_h
#define continua_inference_flat_direction_h

#include <continua/inference/fit_parameter.h>

#include <string>
#include <vector>

namespace Continua
{
/// A direction in the space of the parameters that the data do not see.
struct FlatDirection
{
  /// Change of each parameter along it, in sizes of its coordinate [1], the largest one 1. On
  /// logarithmic scales the exponents: along it the parameters move as factor^component.
  std::vector<double> components;
  /// How far one may go along it until all predicted values together have changed by one standard
  /// deviation of the noise, in units of `components` [1]; infinite: the data see nothing.
  double standard_error;
  /// "'Young's modulus' and 'Wall thickness': the data see only their product ..."
  std::string sentence;
};

/**
 * The flat directions of whitened derivatives: right singular vectors of the Jacobian by the sizes
 * of the coordinates along which one standard error, the inverse singular value, moves the
 * parameter that moves most by more than ln `flat_factor` sizes; and those whose singular value is
 * below 1e-5 of the largest one, where differences are not to be trusted. Several flat directions
 * are combined so that each has as few parameters as possible. `columns`: d prediction / d
 * coordinate, whitened, without the rows of priors; one for each parameter, empty for one that is
 * held.
 */
std::vector<FlatDirection> flat_directions(const std::vector<FitParameter> &parameters,
                                           const std::vector<std::vector<double>> &columns,
                                           double flat_factor);
} // namespace Continua

#endif
