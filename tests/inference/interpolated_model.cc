// A model by polynomials in a box: exact for polynomials, and for others within the error of the
// nodes.

#include <continua/base/input_error.h>
#include <continua/inference/interpolated_model.h>

#include "../unit_test.h"

#include <cmath>

namespace test_of_interpolated_model
{
using namespace Continua;

namespace
{
/// a^2 b + ln c at one place, exp(a) at the other; fails for b > 2.5.
class Formula : public FitModel
{
public:
  std::vector<Prediction> predict(const std::vector<std::vector<double>> &sets) override
  {
    std::vector<Prediction> result;
    for (const auto &set : sets)
      if (set[1] > 2.5)
        result.push_back({{}, "too large"});
      else
        result.push_back({{set[0] * set[0] * set[1] + std::log(set[2]), std::exp(set[0])}, ""});
    n_asked += sets.size();
    return result;
  }
  std::size_t n_asked = 0;
};
} // namespace

UNIT_TEST(interpolated_model)
{
  std::vector<FitParameter> parameters(3);
  for (unsigned int j = 0; j < 3; ++j)
  {
    parameters[j].name = std::string(1, static_cast<char>('a' + j));
    parameters[j].start = 1.;
  }
  parameters[2].scale = FitParameter::Scale::logarithmic;
  Formula formula;
  const std::vector<double> centre = {1., 2., 3.};
  InterpolatedModel model(formula, parameters, centre, {0.5, 0.4, 0.1}, 3);
  check::is_true("three nodes a number", formula.n_asked == 27 && model.n_evaluations() == 27);
  check::relative("lower end", model.lower()[0], 0.5, 1e-14);
  check::relative("upper end on a logarithmic scale", model.upper()[2], 3. * std::exp(0.1), 1e-14);
  const std::vector<double> place = {1.3, 1.7, 2.9};
  const std::vector<double> found = model.predict({place})[0].values;
  check::relative("polynomial, and linear in the logarithm", found[0], 1.69 * 1.7 + std::log(2.9),
                  1e-13);
  // The error of the nodes: at most max|f'''| h^3/(3! 2^2).
  check::absolute("exponential", found[1], std::exp(1.3), std::exp(1.5) * 0.125 / 24.);
  check::is_true("not exact", std::abs(found[1] - std::exp(1.3)) > 1e-6);
  InterpolatedModel finer(formula, parameters, centre, {0.5, 0., 0.}, 6);
  check::absolute("more nodes of one number", finer.predict({{1.3, 2., 3.}})[0].values[1],
                  std::exp(1.3), std::exp(1.5) * std::pow(0.5, 6) / (720. * 32.));
  check::throws<RunError>(
      "a box where the model fails",
      [&]() {
        InterpolatedModel(formula, parameters, centre, {0.1, 1., 0.1}, 3);
      },
      "too large");
}
} // namespace test_of_interpolated_model
