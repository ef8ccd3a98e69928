// Bessel functions of both kinds with bounds of their errors: values of Abramowitz and Stegun
// (tables 9.1), and Arb's own functions, whose balls have to overlap with these.

#include <continua/theory/cylinder_functions.h>

#include <continua/theory/arb_headers.h>

#include <algorithm>
#include <complex>
#include <string>
#include <utility>

#include "../unit_test.h"

namespace test_of_cylinder_functions
{
using namespace Continua;
using Complex = std::complex<double>;

namespace
{
/// `lost`: at most so many bits of the precision are not certain.
void compare_with_arb(const std::string &name,
                      const Complex &argument,
                      const slong precision,
                      const slong lost = 50)
{
  const WorkingPrecision working(precision);
  const Ball z(argument);
  const CylinderFunctions here(z);
  const WorkingPrecision finer(2 * precision);
  Ball j[2], y[2];
  for (unsigned int order = 0; order < 2; ++order)
    acb_hypgeom_bessel_jy(j[order].number, y[order].number, Ball(order).number, z.number,
                          Ball::precision);
  bool overlap = true;
  slong certain = precision;
  for (const auto &[one, other] : {std::pair(&here.j0, &j[0]), std::pair(&here.j1, &j[1]),
                                   std::pair(&here.y0, &y[0]), std::pair(&here.y1, &y[1])})
  {
    overlap = overlap && acb_overlaps(one->number, other->number) != 0;
    certain = std::min(certain, one->accuracy());
  }
  check::is_true(name + ": the balls overlap", overlap);
  check::is_true(name + ": most bits are certain", certain > precision - lost);
}
} // namespace

UNIT_TEST(cylinder_functions)
{
  const WorkingPrecision working(128);
  const CylinderFunctions one(Ball(1.)), twenty(Ball(20.));
  check::absolute("J0(1)", one.j0.value().real(), 0.7651976865579666, 1e-15);
  check::absolute("J1(1)", one.j1.value().real(), 0.4400505857449335, 1e-15);
  check::absolute("Y0(1)", one.y0.value().real(), 0.0882569642156769, 1e-15);
  check::absolute("Y1(1)", one.y1.value().real(), -0.7812128213002887, 1e-15);
  check::absolute("J1(20)", twenty.j1.value().real(), 0.0668331241758499, 1e-15);
  check::absolute("Y1(20)", twenty.y1.value().real(), -0.1655116143625213, 1e-15);
  for (const slong precision : {128, 288})
  {
    compare_with_arb("tiny", {1e-9, 2e-9}, precision);
    compare_with_arb("small", {0.03, -0.01}, precision);
    compare_with_arb("left of the axis", {-0.7, 0.2}, precision);
    compare_with_arb("on the axis", {3., 0.}, precision);
    compare_with_arb("below the axis", {2., -7.}, precision);
    compare_with_arb("end of the series", {11.9, 0.1}, precision);
    compare_with_arb("beyond the series", {9., -9.}, precision);
    // Arb itself loses more of them here.
    compare_with_arb("large", {60., -50.}, precision, 130);
  }
}
} // namespace test_of_cylinder_functions
