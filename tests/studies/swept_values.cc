// Lists and ranges of a sweep, as texts for an entry, and what is refused.

#include <continua/studies/swept_values.h>

#include "../unit_test.h"

#include <stdexcept>

namespace test_of_swept_values
{
using namespace Continua;

namespace
{
std::string values_of(const std::string &text)
{
  std::string result;
  for (const std::string &value : swept_values(text))
    result += (result.empty() ? "" : " | ") + value;
  return result;
}

void refuses(const std::string &text, const std::string &pattern)
{
  check::throws<std::invalid_argument>(
      "refused: " + text, [&text] { swept_values(text); }, pattern);
}
} // namespace

UNIT_TEST(swept_values)
{
  check::equal("a list", values_of("1 MPa,  2.50 MPa , 3e6 Pa"), "1 MPa | 2.50 MPa | 3e6 Pa");
  check::equal("one unit for all", values_of("1, 2, 3 MPa"), "1 MPa | 2 MPa | 3 MPa");
  check::equal("a range", values_of("1 MPa to 3 MPa in 5"),
               "1 MPa | 1.5 MPa | 2 MPa | 2.5 MPa | 3 MPa");
  check::equal("its unit behind it", values_of("1 to 2 MPa in 3"), "1 MPa | 1.5 MPa | 2 MPa");
  check::equal("ends in two units", values_of("500 kPa to 2 MPa in 4"),
               "500 kPa | 1000 kPa | 1500 kPa | 2 MPa");
  check::equal("a logarithmic one", values_of("1 Hz to 100 Hz in 5 logarithmic"),
               "1 Hz | 3.16228 Hz | 10 Hz | 31.6228 Hz | 100 Hz");
  check::equal("without a unit", values_of("0 to 1 in 4 linear"), "0 | 0.333333 | 0.666667 | 1");
  check::equal("ranges and values", values_of("0.1 to 0.2 in 2, 1 mm"), "0.1 mm | 0.2 mm | 1 mm");
  check::equal("below zero", values_of("-1 kPa to 1 kPa in 3"), "-1 kPa | 0 kPa | 1 kPa");
  check::equal("words", values_of("crank nicolson, backward differencing"),
               "crank nicolson | backward differencing");
  check::equal("values with commas", values_of("(4, 2), (8, 4)"), "4, 2 | 8, 4");
  check::equal("an expression", values_of("(1+x)*sin(t, 2), max(1, 2)"),
               "(1+x)*sin(t, 2) | max(1, 2)");
  check::equal("quotes stay", values_of("\"a, b.msh\", from a to b.msh, \"a#b.msh\""),
               "\"a, b.msh\" | from a to b.msh | \"a#b.msh\"");
  check::equal("also in a list", values_of("(\"probe, 1\", x), (\"b)\", y)"),
               "\"probe, 1\", x | \"b)\", y");
  check::equal("as many digits as are needed", values_of("1000000 to 1000002 in 3"),
               "1000000 | 1000001 | 1000002");
  check::equal("also for equal distances", values_of("1000000 Pa to 1000030 Pa in 3"),
               "1000000 Pa | 1000015 Pa | 1000030 Pa");
  check::equal("zero needs no unit", values_of("0, 1 kPa"), "0 kPa | 1 kPa");

  refuses("", "it lists no value");
  refuses("1 MPa,", "nothing between two commas or at an end");
  refuses("1 MPa,, 2 MPa", "nothing between two commas");
  refuses("3 MPa to 1 MPa in 3", "'3 MPa to 1 MPa in 3' does not end above its beginning");
  refuses("1 MPa to 1 MPa in 3", "does not end above");
  refuses("1 MPa to 2 MPa", "does not say how many values");
  refuses("1 MPa to 2 MPa in 1", "two values at least");
  refuses("1 MPa to 2 MPa in many", "'many' of the range .* is no number of values");
  refuses("1 MPa to 2 MPa in 2.5", "is no number of values");
  refuses("1 MPa to 2 MPa in 1000000", "from 2 to 10000");
  refuses("1 MPa to 2 MPa in 3 squared", "neither linear nor logarithmic");
  refuses("1 MPa to 2 mm in 3", "different dimensions");
  refuses("1 MPa to high in 3", "'high' of the range");
  refuses("0 Hz to 1 Hz in 3 logarithmic", "does not begin above zero");
  refuses("1 MPa, 2 MPa, 1 MPa", "'1 MPa' stands there twice");
  refuses("1 MPa, 1000 kPa", "'1000 kPa' stands there twice, first as '1 MPa'");
  refuses("0.1 mm, 100 um", "'100 um' stands there twice");
  refuses("a, \"a\"", "stands there twice");
  refuses("30 kPa, 25", "'25' has no unit");
}
} // namespace test_of_swept_values
