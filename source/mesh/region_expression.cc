#include <continua/base/formula_text.h>
#include <continua/mesh/region_expression.h>

#include <deal.II/base/numbers.h>

#include <muParser.h>

#include <cmath>
#include <stdexcept>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
double if_function(const double condition, const double a, const double b)
{
  return condition != 0. ? a : b;
}

double power(const double base, const double exponent)
{
  return std::pow(base, exponent);
}
} // namespace

struct RegionExpression::Parser
{
  mu::Parser parser;
  double x = 0.;
  double y = 0.;
  double z = 0.;
};

RegionExpression::RegionExpression(const std::string &text) : parser(std::make_unique<Parser>())
{
  check_formula_text(text);
  try
  {
    mu::Parser &expression = parser->parser;
    expression.DefineVar("x", &parser->x);
    expression.DefineVar("y", &parser->y);
    expression.DefineVar("z", &parser->z);
    expression.DefineConst("pi", PI);
    expression.DefineConst("e", M_E);
    expression.DefineFun("if", if_function);
    expression.DefineFun("pow", power);
    expression.SetExpr(text);
    expression.Eval();
    if (expression.GetNumResults() != 1)
      throw std::invalid_argument("it has several values separated by commas");
  }
  catch (const mu::Parser::exception_type &error)
  {
    throw std::invalid_argument(error.GetMsg() + formula_hint(text));
  }
}

RegionExpression::~RegionExpression() = default;
RegionExpression::RegionExpression(RegionExpression &&) noexcept = default;

double RegionExpression::value(const double x, const double y, const double z) const
{
  parser->x = x;
  parser->y = y;
  parser->z = z;
  return parser->parser.Eval();
}
} // namespace Continua
