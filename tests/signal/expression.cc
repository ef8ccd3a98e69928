#include "../unit_test.h"

#include <continua/base/parameter_file.h>
#include <continua/signal/expression.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace test_of_expression
{
using namespace Continua;

namespace
{
const double point[3] = {2., 3., 5.};

double value(const std::string &text,
             const double time = 0.5,
             const Dimension &dimension = Dimensions::none)
{
  return Expression(text, dimension)(point, time);
}

void refused(const std::string &name, const std::string &text, const std::string &pattern)
{
  check::throws<std::invalid_argument>(
      name, [&text]() { Expression(text, Dimensions::pressure); }, pattern);
}

void test_values()
{
  check::relative("quantity", value("10 mmHg", 0., Dimensions::pressure), 1333.22387415, 1e-11);
  check::relative("negative quantity", value("-2.5e-1 kPa", 0., Dimensions::pressure), -250.,
                  1e-14);
  check::absolute("SI number", value("7", 0., Dimensions::pressure), 7., 0.);
  check::absolute("variables", value("x+10*y+100*z+1000*t"), 1032., 0.);
  check::relative("constants", value("pi*e"), 8.539734222673567, 1e-15);
  check::relative("sine in time", value("1e3*sin(pi*t)"), 1000., 1e-15);
  check::absolute("power before sign", value("-2^2"), -4., 0.);
  check::absolute("if", value("if(t<1, 3, 4)"), 3., 0.);
  check::absolute("if else", value("if(t<1 && x>2, 3, 4)"), 4., 0.);
  check::absolute("if with a pole", value("if(x==2, 1, 1/(x-2))"), 1., 0.);
  check::absolute("conditional operator", value("t >= 0.5 ? x : y"), 2., 0.);
  check::absolute("min and max", value("min(x,y,z) + 10*max(x,y)"), 32., 0.);
  check::absolute("floor and ceil", value("floor(-1.5) + 10*ceil(1.2)"), 18., 0.);
  check::absolute("step below", value("step(t-0.6)"), 0., 0.);
  check::absolute("step at zero", value("step(t-0.5)"), 1., 0.);
  check::absolute("sign and abs", value("sign(-x)*abs(-y)"), -3., 0.);
  check::relative("natural logarithm", value("log(10)"), 2.302585092994046, 1e-15);
  check::relative("decimal logarithm", value("log10(1000)"), 3., 1e-15);
  check::relative("pow and sqrt", value("pow(x,y)*sqrt(16)"), 32., 1e-15);
  check::relative("atan2", value("atan2(1,-1)"), 2.356194490192345, 1e-15);
  check::relative("hyperbolic", value("cosh(1)+sinh(1)"), 2.718281828459045, 1e-15);
  check::relative("error function", value("erf(0.5)"), 0.5204998778130465, 1e-14);
  check::relative("complement", value("erfc(0.5)"), 0.4795001221869535, 1e-14);
  check::relative("Bessel of order zero", value("j0(1)"), 0.7651976865579666, 1e-14);
  check::relative("Bessel of order one", value("j1(1)"), 0.4400505857449335, 1e-14);
}

/// Quantities as factors of terms.
void test_quantities()
{
  const auto flow_rate = [](const std::string &text, const double time = 0.5)
  { return value(text, time, Dimensions::flow_rate); };
  const auto pressure = [](const std::string &text, const double time = 0.5)
  { return value(text, time, Dimensions::pressure); };
  // 1 + sin(2 pi 0.2/0.8) = 2.
  check::relative("a quantity as a factor", flow_rate("1 ml/s*(1 + sin(2*pi*t/0.8))", 0.2), 2e-6,
                  1e-14);
  check::relative("with blanks", flow_rate("-3 l / min * 2*t"), -5e-5, 1e-14);
  check::relative("in two terms", pressure("80 mmHg + 40 mmHg*sin(pi*t)"), 120. * 133.322387415,
                  1e-9);
  check::relative("behind a factor", pressure("2*t*3 kPa/4 - t*1 Pa"), 749.5, 1e-14);
  check::relative("a sign in a term", pressure("2 kPa*-t"), -1000., 1e-14);
  check::relative("time is no tonne", value("4 kg/m^3*t", 0.5, Dimensions::density), 2., 1e-14);
  check::relative("a product of units", value("4 mPa s*(1 + x)", 0., Dimensions::viscosity), 12e-3,
                  1e-14);
  check::relative("a minute is no minimum", flow_rate("6 l/min*min(t, 2)"), 5e-5, 1e-14);
  check::relative("Euler's number", pressure("2 kPa*e^(-t)", 1.), 2000. * std::exp(-1.), 1e-14);
  check::relative("without variables", pressure("10 kPa*2"), 20000., 1e-14);
  check::relative("of no dimension", value("1 + 50 %*t", 1.), 1.5, 1e-14);
  const Expression time("1 kPa*sin(t)", Dimensions::pressure), copy(time);
  check::is_true("of time", copy.depends_on_time() && !copy.depends_on_space());
  check::relative("copy", copy(point, 2.), 1000. * std::sin(2.), 1e-14);
  check::equal("its text", copy.text(), "1 kPa*sin(t)");

  refused("another dimension", "1 ml/s*(1 + t)", "'1 ml/s' with the wrong unit.*m\\^3/s.*Pa");
  refused("a rate", "5 Pa/s*t", "'5 Pa/s' with the wrong unit");
  refused("inside brackets", "2*(1 kPa + 3*t)", "'1 kPa' inside brackets");
  refused("in a function", "if(t < 10 ms, 1, 0)", "'10 ms' inside brackets");
  refused("in a divisor", "1 kPa*t/0.8 s", "second quantity, '0.8 s'");
  refused("as a divisor", "t/2 kPa", "'2 kPa' behind '/'");
  refused("a term without a unit", "80 mmHg + 40*sin(t)", "a term without a unit beside");
  refused("two in a term", "2 kPa*3 kPa*t", "second quantity");
  refused("a choice", "t < 1 ? 1 kPa : 2 kPa", "comparison or a choice|behind");
  refused("no operator", "1 kPa (1 + t)", "needs '\\*'");
  refused("no operator behind a unit", "1 kPa t", "needs '\\*'");
}

void test_dependence()
{
  const Expression constant("2*pi", Dimensions::none);
  check::is_true("constant", !constant.depends_on_time() && !constant.depends_on_space());
  const Expression time("sin(t)", Dimensions::none);
  check::is_true("of time", time.depends_on_time() && !time.depends_on_space());
  const Expression space("y^2 + exp(2)", Dimensions::none);
  check::is_true("of space", !space.depends_on_time() && space.depends_on_space());
  check::is_true("zero", Expression("0 Pa", Dimensions::pressure).is_zero());
  check::is_true("zero by formula", Expression("2-2", Dimensions::pressure).is_zero());
  check::is_true("default is zero", Expression().is_zero());
  check::is_true("not zero", !constant.is_zero() && !Expression("0*t", Dimensions::none).is_zero());
  check::equal("text", time.text(), "sin(t)");
  check::equal("text of a number", Expression(0.1).text(), "0.1");
}

void test_copies()
{
  auto original = std::make_unique<Expression>("x+t", Dimensions::none);
  const Expression copy(*original);
  Expression assigned;
  assigned = *original;
  original.reset();
  check::absolute("copy", copy(point, 1.), 3., 0.);
  check::absolute("assigned", assigned(point, 2.), 4., 0.);
  check::absolute("copy again", copy(point, 1.), 3., 0.);
  assigned = Expression(6.);
  check::is_true("assigned constant", assigned(point, 2.) == 6. && !assigned.depends_on_time() &&
                                          !assigned.depends_on_space());
}

void test_refusals()
{
  refused("unknown symbol", "3*r + 1",
          "unknown symbol 'r' in '3\\*r \\+ 1'.*variables are x, y, z, t");
  refused("unknown function", "foo(t)", "unknown symbol 'foo'");
  refused("wrong dimension", "10 mm", "mm.*Pa");
  refused("unknown unit", "10 foo", "foo");
  refused("missing product", "1e3 sin(t)", "needs '\\*'");
  refused("syntax", "2*(t+1", "no expression.*variables are x, y, z, t");
  refused("decimal comma", "1,5*t", "several values.*point");
  refused("assignment", "t=3", "assigns");
  refused("empty", " ", "empty");
  refused("infinite constant", "1/0", "not finite");
  refused("infinite number", "inf", "");
  refused("wrong number of arguments", "if(t,1)", "no expression");
  refused("nested too deep", std::string(100000, '(') + "t" + std::string(100000, ')'),
          "characters");
  refused("if of another language", "if (t < 1) 2 else 3", "if\\(CONDITION, A, B\\) or");
}

void test_sections()
{
  const std::string path = "expression-test.prm";
  std::ofstream(path) << "subsection Load\n  set Pressure = 1 kPa\n  set Bad = 3*q\n"
                         "  set Velocity = if(t<1, t, 1), 0.5 mm/s\n  set Short = 1, 2, 3\nend\n";
  ParameterFile file(path);
  ParameterSection section = file.root().subsection("Load");

  Expression pressure, other(4.);
  add_expression(section, "Pressure", pressure, Dimensions::pressure, "A pressure.");
  check::absolute("entry", pressure(point, 0.), 1000., 0.);
  add_expression(section, "Other", other, Dimensions::pressure, "Not given.");
  check::absolute("default entry", other(point, 0.), 4., 0.);
  check::throws<InputError>(
      "bad entry", [&]() { add_expression(section, "Bad", other, Dimensions::pressure, "Bad."); },
      "expression-test.prm:3: .*Bad.*unknown symbol 'q'.*Pa");

  std::vector<Expression> velocity, defaults{Expression(1.)};
  add_expressions(section, "Velocity", velocity, 2, Dimensions::velocity, "A velocity.");
  check::is_true("two components", velocity.size() == 2);
  check::absolute("first component", velocity[0](point, 0.25), 0.25, 0.);
  check::relative("second component", velocity[1](point, 0.25), 5e-4, 1e-14);
  add_expressions(section, "Not given", defaults, 3, Dimensions::velocity, "Not given.");
  check::is_true("components left alone", defaults.size() == 1);
  check::throws<InputError>(
      "number of components",
      [&]() { add_expressions(section, "Short", velocity, 2, Dimensions::velocity, "Short."); },
      "expression-test.prm:5: .*Short.*3 components.*2");

  // The place of an entry stands in the message about its values; the first one counts.
  check::equal("all finite", Expression::value_not_finite(), "");
  std::ofstream(path) << "set Pressure = 1/(t-0.5)\n";
  ParameterFile with_pole(path);
  ParameterSection root = with_pole.root();
  add_expression(root, "Pressure", pressure, Dimensions::pressure, "A pressure.");
  const Expression copy = pressure;
  check::absolute("beside the pole", copy(point, 1.), 2., 0.);
  check::equal("still finite", Expression::value_not_finite(), "");
  copy(point, 0.5);
  Expression("0/x*y/0*t", Dimensions::none)(point, 0.);
  check::equal("at the pole", Expression::value_not_finite(),
               "expression-test.prm:1: 'Pressure': '1/(t-0.5)' is inf at x = 2, y = 3, z = 5 m, "
               "t = 0.5 s");
  std::filesystem::remove(path);
}
} // namespace

UNIT_TEST(expression)
{
  test_values();
  test_quantities();
  test_dependence();
  test_copies();
  test_refusals();
  test_sections();
}
} // namespace test_of_expression
