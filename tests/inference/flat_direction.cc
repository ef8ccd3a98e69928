#include "../unit_test.h"
#include "records.h"

#include <continua/inference/flat_direction.h>

#include <cmath>

namespace test_of_flat_direction
{
using namespace Continua;

namespace
{
using Columns = std::vector<std::vector<double>>;

std::vector<FitParameter> logarithmic(const std::vector<std::string> &names)
{
  std::vector<FitParameter> parameters;
  parameters.reserve(names.size());
  for (const std::string &name : names)
    parameters.push_back(parameter_of(name, 2., FitParameter::Scale::logarithmic));
  return parameters;
}

std::string sentence(const std::vector<FitParameter> &parameters, const Columns &columns)
{
  const auto directions = flat_directions(parameters, columns, 2.);
  std::string text = std::to_string(directions.size()) + ":";
  for (const FlatDirection &direction : directions)
    text += " " + direction.sentence;
  return text;
}

void matches(const std::string &name, const std::string &text, const std::string &pattern)
{
  check::is_true(name, check::matches(text, pattern));
  if (!check::matches(text, pattern))
    std::cout << text << std::endl;
}

void test_powers()
{
  const auto two = logarithmic({"E", "h"});
  matches("product", sentence(two, {{3., 5., 7.}, {3., 5., 7.}}),
          "^1: 'E' and 'h': the data see only their product. Give one of them");
  matches("ratio", sentence(two, {{3., 5., 7.}, {-3., -5., -7.}}), "^1: .*only their ratio");
  matches("power", sentence(two, {{3., 5., 7.}, {1.5, 2.5, 3.5}}), "to the power 0.5\\. ");
  matches("one", sentence(two, {{3., 5., 7.}, {0., 0., 0.}}),
          "^1: 'h': the data do not see it\\. Give it");
  check::equal("none", sentence(two, {{3., 5., 7.}, {3., 5., -7.}}), "0:");
  const auto direction = flat_directions(two, {{3., 5., 7.}, {1.5, 2.5, 3.5}}, 2.)[0];
  check::absolute("exponents",
                  std::abs(direction.components[0] + 0.5) + std::abs(direction.components[1] - 1.),
                  0., 1e-9);
  // Seen, but badly: 1 standard deviation for a factor e along (1, -1), a product that is well
  // known.
  const Columns bad{{100., 0.5}, {100., -0.5}};
  const auto weak = flat_directions(two, bad, 2.);
  check::relative("standard error along it", weak.at(0).standard_error, 1., 1e-9);
  matches(
      "factor", weak[0].sentence,
      "only their product \\(one standard error along this direction: 'E' by a factor of 2.72\\)");
  check::is_true("another threshold", flat_directions(two, bad, 4.).empty());
  matches("three",
          sentence(logarithmic({"E", "h", "r"}), {{300., 500.}, {100., 400.}, {400., 900.}}),
          "^1: 'E', 'h' and 'r': .*'E' grows by .?1 %, 'h' grows by .?1 % and 'r' grows by .?1 % "
          "together");
  // Two directions that the singular vectors would mix: E h, and r alone.
  matches("two directions",
          sentence(logarithmic({"E", "h", "r"}), {{3., 5., 2.}, {3., 5., 2.}, {0., 0., 0.}}),
          "^2: ('r': the data do not see it.*'E' and 'h': .*product|'E' and 'h': .*product.*'r': "
          "the data do not see it)");
}

void test_sums()
{
  FitParameter first = parameter_of("first", 10.);
  FitParameter second = parameter_of("second", 2.);
  matches("sum", sentence({first, second}, {{1., 2.}, {1., 2.}}), "^1: .*only their sum");
  matches("difference", sentence({first, second}, {{1., 2.}, {-1., -2.}}), "only their difference");
  matches("weighted sum", sentence({first, second}, {{1., 2.}, {3., 6.}}),
          "sum of the first and of 3 times the second");
  second.unit = "s";
  matches("units", sentence({first, second}, {{1., 2.}, {3., 6.}}),
          "of 3 1/\\(s\\) times the second");
  second.scale = FitParameter::Scale::logarithmic;
  matches("mixed", sentence({first, second}, {{1., 2.}, {3., 6.}}),
          "one combination, since 'second' larger by 1 % and 'first' larger by -0.03 1 change "
          "nothing together");
  // A held parameter has no column.
  const auto direction =
      flat_directions({held_parameter("held", 1.), first, second}, {{}, {1., 2.}, {0., 0.}}, 2.);
  check::is_true("held", direction.size() == 1 &&
                             direction[0].components == std::vector<double>({0., 0., 1.}));
}
} // namespace

UNIT_TEST(flat_direction)
{
  test_powers();
  test_sums();
}
} // namespace test_of_flat_direction
