#include <continua/base/formula_text.h>
#include <continua/base/is_unit.h>
#include <continua/signal/expression.h>
#include <continua/signal/formula_quantities.h>

#include <deal.II/base/numbers.h>

#include <muParser.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
const std::string symbols = "the variables are x, y, z, t, the constants pi, e";

double if_function(const double condition, const double a, const double b)
{
  return condition != 0. ? a : b;
}

double power(const double base, const double exponent)
{
  return std::pow(base, exponent);
}

double step(const double x)
{
  return x < 0. ? 0. : 1.;
}

/// Of all expressions of this process, the first value that was not finite, in words.
std::string &first_value_not_finite()
{
  static std::string text;
  return text;
}

/// What follows the number at the start of `text`, without leading blanks; empty if there is no
/// number.
std::string after_number(const std::string &text)
{
  std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos)
    return "";
  if (text[begin] == '+' || text[begin] == '-')
    ++begin;
  double number;
  const char *const end = text.data() + text.size();
  const auto result = std::from_chars(text.data() + begin, end, number);
  if (result.ec != std::errc())
    return "";
  const std::string rest(result.ptr, end);
  const std::size_t first = rest.find_first_not_of(" \t");
  return first == std::string::npos ? "" : rest.substr(first);
}

/// Whether `text` is a number with something after it that can only be meant as a unit.
bool looks_like_quantity(const std::string &text)
{
  const std::string rest = after_number(text);
  if (rest.empty())
    return false;
  // Letters right after a number are no expression; bytes above 127 belong to the micro or degree
  // sign.
  if (std::isalpha(static_cast<unsigned char>(rest[0])) || (rest[0] & 0x80) != 0 || rest == "%")
    return true;
  return std::isdigit(static_cast<unsigned char>(rest[0])) != 0 && is_unit(rest);
}

/// muParser appends a blank to its text, which gets into its tokens.
std::string trim(const std::string &text)
{
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

std::string shortest(const double value)
{
  char buffer[40];
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
  return std::string(buffer, result.ptr);
}
} // namespace

struct Expression::Parser
{
  explicit Parser(const std::string &text, const std::string &place = "") : place(place)
  {
    parser.DefineVar("x", &variables[0]);
    parser.DefineVar("y", &variables[1]);
    parser.DefineVar("z", &variables[2]);
    parser.DefineVar("t", &variables[3]);
    parser.DefineConst("pi", PI);
    parser.DefineConst("e", M_E);
    parser.DefineFun("if", if_function);
    parser.DefineFun("pow", power);
    parser.DefineFun("step", step);
    parser.DefineFun("floor", static_cast<double (*)(double)>(std::floor));
    parser.DefineFun("ceil", static_cast<double (*)(double)>(std::ceil));
    parser.DefineFun("log", static_cast<double (*)(double)>(std::log));
    parser.DefineFun("erf", static_cast<double (*)(double)>(std::erf));
    parser.DefineFun("erfc", static_cast<double (*)(double)>(std::erfc));
    parser.DefineFun("j0", static_cast<double (*)(double)>(::j0));
    parser.DefineFun("j1", static_cast<double (*)(double)>(::j1));
    parser.SetExpr(text);
  }

  mu::Parser parser;
  double variables[4] = {0., 0., 0., 0.};
  std::string place; ///< of the entry; empty where there is none
};

Expression::Expression(const double constant) : source(shortest(constant)), constant(constant) {}

Expression::Expression(const std::string &text, const Dimension &dimension)
    : source(text), constant(0.)
{
  if (text.find_first_not_of(" \t") == std::string::npos)
    throw std::invalid_argument("the expression is empty");

  const std::string rest = after_number(text);
  const bool begins_with_operator =
      !rest.empty() && std::string("+-*/^<>=!&|?,()").find(rest[0]) != std::string::npos;
  std::string quantity_problem;
  if (!begins_with_operator)
    try
    {
      constant = parse_quantity(text, dimension);
      if (!std::isfinite(constant))
        throw std::invalid_argument("'" + text + "' is not finite");
      return;
    }
    catch (const std::invalid_argument &exception)
    {
      quantity_problem = exception.what();
    }
  try
  {
    formula = formula_in_si(text, dimension);
  }
  catch (const std::invalid_argument &)
  {
    // Nothing but a quantity.
    if (rest.find_first_of("*( ") == std::string::npos && is_unit(rest))
      throw std::invalid_argument(quantity_problem);
    throw;
  }
  if (formula == text && looks_like_quantity(text))
  {
    const bool may_be_product =
        rest.find('(') != std::string::npos ||
        (std::string("xyzte").find(rest[0]) != std::string::npos &&
         (rest.size() == 1 || !std::isalpha(static_cast<unsigned char>(rest[1]))));
    throw std::invalid_argument(quantity_problem + (may_be_product ? "; a product needs '*'" : ""));
  }
  check_formula_text(formula);

  try
  {
    parser = std::make_unique<Parser>(formula);
    const double value = parser->parser.Eval();
    if (parser->parser.GetNumResults() != 1)
      throw std::invalid_argument("'" + text +
                                  "' has several values separated by commas, expected is one; "
                                  "the decimal separator is a point");
    for (const auto &variable : parser->parser.GetUsedVar())
      (variable.first == "t" ? time_dependent : space_dependent) = true;
    if (!time_dependent && !space_dependent)
    {
      if (!std::isfinite(value))
        throw std::invalid_argument("the constant '" + text + "' is not finite");
      constant = value;
      parser.reset();
    }
  }
  catch (const mu::Parser::exception_type &error)
  {
    if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN)
      throw std::invalid_argument("unknown symbol '" + trim(error.GetToken()) + "' in '" + text +
                                  "'; " + symbols + formula_hint(text));
    throw std::invalid_argument("'" + text + "' is no expression: " + trim(error.GetMsg()) + "; " +
                                symbols + formula_hint(text));
  }
}

Expression::~Expression() = default;

Expression::Expression(const Expression &other)
    : source(other.source),
      formula(other.formula),
      constant(other.constant),
      parser(other.parser ? std::make_unique<Parser>(other.formula, other.parser->place) : nullptr),
      time_dependent(other.time_dependent),
      space_dependent(other.space_dependent)
{
}

Expression &Expression::operator=(const Expression &other)
{
  if (this != &other)
  {
    source = other.source;
    formula = other.formula;
    constant = other.constant;
    parser = other.parser ? std::make_unique<Parser>(other.formula, other.parser->place) : nullptr;
    time_dependent = other.time_dependent;
    space_dependent = other.space_dependent;
  }
  return *this;
}

double Expression::operator()(const double *point, const double time) const
{
  if (!parser)
    return constant;
  parser->variables[0] = point[0];
  parser->variables[1] = point[1];
  parser->variables[2] = point[2];
  parser->variables[3] = time;
  const double value = parser->parser.Eval();
  if (!std::isfinite(value))
    note_not_finite(point, time, value);
  return value;
}

void Expression::note_not_finite(const double *point, const double time, const double value) const
{
  std::string &text = first_value_not_finite();
  if (!text.empty())
    return;
  std::ostringstream words;
  words << (parser->place.empty() ? "an expression" : parser->place) << ": '" << source << "' is "
        << value << " at x = " << point[0] << ", y = " << point[1] << ", z = " << point[2]
        << " m, t = " << time << " s";
  text = words.str();
}

void Expression::set_place(const std::string &name)
{
  // A constant is finite.
  if (parser)
    parser->place = name;
}

const std::string &Expression::value_not_finite()
{
  return first_value_not_finite();
}

bool Expression::depends_on_time() const
{
  return time_dependent;
}

bool Expression::depends_on_space() const
{
  return space_dependent;
}

bool Expression::is_zero() const
{
  return !parser && constant == 0.;
}

const std::string &Expression::text() const
{
  return source;
}

namespace
{
std::string documentation(const std::string &text, const Dimension &dimension)
{
  return text + " [" + dimension.unit() +
         "] A quantity with its unit, an expression of x, y, z, t in SI, or a sum of quantities "
         "times such expressions.";
}

Expression parse(const ParameterSection &section,
                 const std::string &key,
                 const std::string &text,
                 const Dimension &dimension)
{
  try
  {
    Expression expression(text, dimension);
    const Origin origin = section.origin(key);
    expression.set_place(origin.file + (origin.line > 0 ? ":" + std::to_string(origin.line) : "") +
                         ": '" + section.path() + (section.path().empty() ? "" : "/") + key + "'");
    return expression;
  }
  catch (const std::invalid_argument &exception)
  {
    section.refuse(key, exception.what(),
                   "Give a quantity in " + dimension.unit() +
                       " or an expression of x, y, z, t in SI");
  }
}
} // namespace

void add_expression(ParameterSection &section,
                    const std::string &key,
                    Expression &expression,
                    const Dimension &dimension,
                    const std::string &text)
{
  std::string value = expression.text();
  section.add(key, value, documentation(text, dimension));
  if (section.given(key))
    expression = parse(section, key, value, dimension);
}

void add_expressions(ParameterSection &section,
                     const std::string &key,
                     std::vector<Expression> &expressions,
                     const unsigned int n_components,
                     const Dimension &dimension,
                     const std::string &text)
{
  std::vector<std::string> values;
  for (const Expression &expression : expressions)
    values.push_back(expression.text());
  section.add(key, values, documentation(text, dimension) + " One per component.");
  if (!section.given(key) || values.empty())
    return;
  if (values.size() != n_components)
    section.refuse(key, "has " + std::to_string(values.size()) + " components",
                   "Give " + std::to_string(n_components) + ", separated by commas");
  std::vector<Expression> parsed;
  for (const std::string &value : values)
    parsed.push_back(parse(section, key, value, dimension));
  expressions = parsed;
}
} // namespace Continua
