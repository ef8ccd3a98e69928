#ifndef continua_inference_start_points_h
#define continua_inference_start_points_h

#include <continua/inference/fit_parameter.h>

#include <vector>

namespace Continua
{
/// Starts of a fit [unit of each parameter]: the given one, then points of Halton's sequence. They
/// lie within the bounds, in the coordinates; where a bound is missing within two standard
/// deviations of the prior, or within three sizes of the start (a factor of 20 on a logarithmic
/// scale).
std::vector<std::vector<double>> start_points(const std::vector<FitParameter> &parameters,
                                              unsigned int n_starts);
} // namespace Continua

#endif
