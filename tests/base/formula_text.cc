// Formulas that muParser must not see, and the hint for those that it refuses.

#include <continua/base/formula_text.h>

#include "../unit_test.h"

#include <stdexcept>

namespace test_of_formula_text
{
using namespace Continua;

namespace
{
void refused(const std::string &name, const std::string &text, const std::string &pattern)
{
  check::throws<std::invalid_argument>(
      name, [&] { check_formula_text(text); }, pattern);
}

std::string in_brackets(const std::size_t n)
{
  return std::string(n, '(') + "x" + std::string(n, ')');
}
} // namespace

UNIT_TEST(formula_text)
{
  check_formula_text(in_brackets(100));
  check_formula_text("a <= b && c >= d || e == f || g != h");
  refused("too deep", in_brackets(101), "more than 100 brackets");
  refused("far too deep", in_brackets(9000), "more than 100 brackets");
  check_formula_text("(a)" + std::string(300, ')') + "(b)");
  refused("too long", std::string(20001, '1'), "20001 characters, more than 20000");
  refused("assignment", "x = 1", "'x = 1' assigns with '='; a comparison is '=='");
  refused("assignment at the beginning", "= 1", "assigns");
  for (const char *const text : {"0.5 < t < 0.9", "if(0.5<t<=0.9, 1, 0)", "x*(1 >= y >= 0)",
                                 "a == b == c", "a && b < c != d", "(a < b) < c > d"})
    refused(text, text, "compares twice in a row.*Write a < t && t < b, or brackets");
  // Each comparison has a place of its own.
  for (const char *const text :
       {"0.5 < t && t < 0.9", "a < b || c > d", "(a < b) == (c < d)", "if(a < b, c > d, e != f)",
        "a < b ? c < d : e < f", "(a < b)*(b < c)", "max(a < b, c) < d"})
    check_formula_text(text);

  check::equal("no hint", formula_hint("iff(x) + then_y"), "");
  for (const char *const text : {"if (x) 1 else 2", "1 if x", "x then 2", "a else b"})
    check::is_true(text, formula_hint(text).find("(CONDITION ? A : B)") != std::string::npos);
}
} // namespace test_of_formula_text
