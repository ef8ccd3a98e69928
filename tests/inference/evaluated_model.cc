#include "../unit_test.h"
#include "function_model.h"

#include <continua/inference/evaluated_model.h>

#include <cmath>
#include <stdexcept>

namespace test_of_evaluated_model
{
using namespace Continua;

UNIT_TEST(evaluated_model)
{
  FunctionModel function(
      [](const std::vector<double> &set) -> std::vector<double>
      {
        if (set[0] > 9.)
          throw std::runtime_error("too large");
        if (set[0] < 0.)
          return {std::sqrt(set[0]), 1.};
        if (set[0] == 0.)
          return {1.};
        return {set[0], 2. * set[0]};
      });
  std::vector<Evaluation> seen;
  EvaluatedModel model(function, 2, {},
                       [&](const Evaluation &evaluation) { seen.push_back(evaluation); });
  model.set_misfit([](const std::vector<double> &set, const std::vector<double> &values)
                   { return set[0] + values[1]; });
  const auto predictions = model.predict({{1.}, {2.}, {1.}, {10.}}, "step");
  check::is_true("predictions", predictions[0].values[1] == 2. && predictions[1].values[1] == 4. &&
                                    predictions[2].values[1] == 2.);
  check::equal("failure", predictions[3].failure, "too large");
  check::is_true("one call, no set twice", function.n_calls == 1 && function.n_sets == 3);
  model.predict({{2.}, {10.}}, "step");
  check::is_true("kept",
                 function.n_calls == 1 && model.n_evaluations() == 3 && model.n_failures() == 1);
  check::is_true("observed", seen.size() == 3 && seen[1].misfit == 6. &&
                                 std::isnan(seen[2].misfit) && seen[0].purpose == "step");
  check::equal("not finite", model.predict_one({-1.}, "step").failure,
               "the model predicted a value that is not finite");
  check::equal("number of values", model.predict_one({0.}, "step").failure,
               "the model predicted 1 values for 2 of data");
  check::equal("last failure", model.last_failure(), "the model predicted 1 values for 2 of data");

  EvaluatedModel again(function, 2, seen);
  const unsigned int n_before = function.n_sets;
  check::is_true("replayed", again.predict_one({2.}, "step").values[1] == 4. &&
                                 again.predict_one({10.}, "step").failure == "too large" &&
                                 function.n_sets == n_before);
  EvaluatedModel longer(function, 3, seen);
  longer.predict_one({2.}, "step");
  check::is_true("other records are not replayed", function.n_sets == n_before + 1);
}
} // namespace test_of_evaluated_model
