#ifndef continua_base_interpolant_h
#define continua_base_interpolant_h

#include <vector>

namespace Continua
{
/// A function of one variable through given points, constant beyond the first and the last one.
class Interpolant
{
public:
  enum class Kind
  {
    linear,
    /// Piecewise cubic Hermite with the slopes of Fritsch and Butland (SIAM J. Sci. Stat. Comput.
    /// 5, 1984): once continuously differentiable, between two points never outside their values,
    /// so that it neither overshoots nor rings; exact for a straight line, second-order accurate
    /// next to an extremum and third-order elsewhere.
    cubic
  };

  /// Zero everywhere.
  Interpolant() = default;
  /// `points` increase; as many `values`, two at least. `periodic`: the cubic's slopes at the two
  /// ends are alike, for a function that goes on with its first value after the last one.
  Interpolant(const std::vector<double> &points,
              const std::vector<double> &values,
              Kind kind,
              bool periodic = false);

  double operator()(double x) const;
  double first_point() const { return points.front(); }
  double last_point() const { return points.back(); }

private:
  std::vector<double> points = {0., 1.};
  std::vector<double> values = {0., 0.};
  std::vector<double> slopes; ///< of the cubic, at the points; empty for the linear one
};
} // namespace Continua

#endif
