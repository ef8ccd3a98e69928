#ifndef continua_inference_fit_parameter_h
#define continua_inference_fit_parameter_h

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace Continua
{
/// What is known of a number before the data: a normal distribution. On a logarithmic scale the
/// logarithm is normal, with the standard deviation over the mean.
struct Prior
{
  double mean;               ///< [unit of the parameter]
  double standard_deviation; ///< [unit of the parameter], positive
};

/// A number to be found.
struct FitParameter
{
  enum class Scale
  {
    linear,
    logarithmic
  };
  std::string name; ///< "Materials/wall/Young's modulus"
  std::string unit; ///< SI: "Pa"; "1" for a pure number
  double start;     ///< [unit]
  /// [unit]; infinite: no bound. Both equal to `start`: the number is held.
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  Scale scale = Scale::linear; ///< logarithmic: lower >= 0, start > 0
  std::optional<Prior> prior;

  /// The fit moves a coordinate: the number itself [unit], or its natural logarithm [1].
  double coordinate(double value) const;
  /// The number [unit] of a coordinate.
  double value(double coordinate) const;
  /// d value / d coordinate at a value: 1, or the value itself.
  double value_per_coordinate(double at) const;
  /// A typical change of the coordinate: 1 on a logarithmic scale (a factor e). On a linear scale
  /// the smallest of |start|, of upper - lower and of the prior's standard deviation that is
  /// positive and finite.
  double size() const;
  bool is_held() const { return lower == upper; }
};

/// Throws std::invalid_argument, with the name and what is wrong, for bounds that are reversed, a
/// start outside of them, a logarithmic scale with a bound below zero, a prior without a positive
/// standard deviation, numbers that are not finite, two equal names, and a number on a linear scale
/// that has no size (start 0, no bounds, no prior).
void check_fit_parameters(const std::vector<FitParameter> &parameters);
} // namespace Continua

#endif
