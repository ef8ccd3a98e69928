#include "../unit_test.h"

#include <continua/inference/fit_parameter.h>

#include <cmath>
#include <stdexcept>

namespace test_of_fit_parameter
{
using namespace Continua;

namespace
{
FitParameter modulus()
{
  FitParameter parameter;
  parameter.name = "modulus";
  parameter.unit = "Pa";
  parameter.start = 2e6;
  parameter.scale = FitParameter::Scale::logarithmic;
  return parameter;
}

FitParameter shift(const double start)
{
  FitParameter parameter;
  parameter.name = "shift";
  parameter.unit = "s";
  parameter.start = start;
  return parameter;
}

void refuses(const std::string &name, const FitParameter &parameter, const std::string &pattern)
{
  check::throws<std::invalid_argument>(
      name, [&]() { check_fit_parameters({parameter}); }, pattern);
}

void test_refusals()
{
  check::throws<std::invalid_argument>(
      "twice",
      [&]() {
        check_fit_parameters({modulus(), modulus()});
      },
      "'modulus' is there twice");
  FitParameter parameter = modulus();
  parameter.lower = 3e6;
  parameter.upper = 1e6;
  refuses("reversed", parameter, "lower bound above");
  parameter.upper = 4e6;
  refuses("outside", parameter, "outside of its bounds");
  parameter = modulus();
  parameter.lower = -1.;
  refuses("negative bound", parameter, "logarithmic");
  parameter = modulus();
  parameter.prior = Prior{1e6, 0.};
  refuses("prior", parameter, "standard deviation");
  parameter.prior = Prior{-1e6, 1.};
  refuses("mean of the prior", parameter, "mean");
  refuses("no size", shift(0.), "two bounds or a prior");
  refuses("not a number", shift(std::nan("")), "not a number");
  parameter = shift(0.);
  parameter.lower = parameter.upper = 0.;
  check_fit_parameters({parameter, modulus()});
  check::is_true("held at zero", parameter.is_held() && !modulus().is_held());
}
} // namespace

UNIT_TEST(fit_parameter)
{
  check::relative("logarithm", modulus().coordinate(1e6), std::log(1e6), 1e-15);
  check::relative("back", modulus().value(std::log(3.)), 3., 1e-15);
  check::relative("slope", modulus().value_per_coordinate(5.), 5., 0.);
  check::relative("size of a logarithm", modulus().size(), 1., 0.);
  check::relative("linear", shift(2.).coordinate(7.) + shift(2.).value(7.), 14., 0.);
  check::relative("linear slope", shift(2.).value_per_coordinate(5.), 1., 0.);
  check::relative("size of the start", shift(-2.).size(), 2., 0.);
  FitParameter bounded = shift(0.);
  bounded.lower = -0.01;
  bounded.upper = 0.02;
  check::relative("size of the bounds", bounded.size(), 0.03, 1e-15);
  bounded.prior = Prior{0., 0.001};
  check::relative("size of the prior", bounded.size(), 0.001, 0.);
  test_refusals();
}
} // namespace test_of_fit_parameter
