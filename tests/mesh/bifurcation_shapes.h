#ifndef continua_tests_bifurcation_shapes_h
#define continua_tests_bifurcation_shapes_h

// Shapes for the tests of the bifurcation, and what is exact about them.

#include <continua/mesh/bifurcation_shape.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace bifurcation_shapes
{
using dealii::Point;
using dealii::Tensor;

struct Daughter
{
  double angle;                        ///< [degrees]
  double inner_radius, wall_thickness; ///< [m]
};

/// A parent of inner radius 1 and wall thickness 0.2 that comes along the x axis to x = 5.
inline Continua::BifurcationShape make(const Daughter &first, const Daughter &second)
{
  constexpr double degree = dealii::numbers::PI / 180.;
  return {Point<3>(5., 0., 0.),
          {{{180. * degree, 1., 0.2},
            {-second.angle * degree, second.inner_radius, second.wall_thickness},
            {first.angle * degree, first.inner_radius, first.wall_thickness}}}};
}

struct Measures
{
  double fluid = 0., wall = 0., outside = 0.;
};

/// Volumes and outer surface of all three tubes up to where they are round, from the derivative of
/// the shape.
inline Measures measure(const Continua::BifurcationShape &shape, const unsigned int n_points = 10)
{
  const dealii::QGauss<1> gauss(n_points);
  Measures result;
  for (unsigned int tube = 0; tube < 3; ++tube)
    for (unsigned int quarter = 0; quarter < 4; ++quarter)
      for (unsigned int i = 0; i < n_points; ++i)
        for (unsigned int j = 0; j < n_points; ++j)
        {
          const double a = shape.reach(tube) * gauss.point(i)[0];
          const double turn = 0.5 * dealii::numbers::PI * (quarter + gauss.point(j)[0]);
          const double weight =
              shape.reach(tube) * gauss.weight(i) * 0.5 * dealii::numbers::PI * gauss.weight(j);
          const auto at = [&](const double radius)
          { return Point<3>(a, radius * std::cos(turn), radius * std::sin(turn)); };
          for (unsigned int k = 0; k < n_points; ++k)
          {
            const double radius = gauss.point(k)[0];
            result.fluid += weight * gauss.weight(k) * radius *
                            dealii::determinant(shape.derivative(tube, at(radius)));
            result.wall += weight * gauss.weight(k) * (1. + radius) *
                           dealii::determinant(shape.derivative(tube, at(1. + radius)));
          }
          const Tensor<2, 3> derivative = shape.derivative(tube, at(2.));
          const Tensor<1, 3> along = derivative * Tensor<1, 3>(Point<3>(1., 0., 0.));
          const Tensor<1, 3> around =
              derivative * Tensor<1, 3>(Point<3>(0., -2. * std::sin(turn), 2. * std::cos(turn)));
          result.outside += weight * dealii::cross_product_3d(along, around).norm();
        }
  return result;
}
} // namespace bifurcation_shapes

#endif
