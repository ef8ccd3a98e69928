#include "../unit_test.h"
#include "random_noise.h"

#include <continua/inference/autoregressive_model.h>

#include <cmath>
#include <stdexcept>

namespace test_of_autoregressive_model
{
using namespace Continua;

UNIT_TEST(autoregressive_model)
{
  // Three values by hand: k = 2 (2*1 + 3*2)/(2^2 + 1^2 + 3^2 + 2^2) = 16/18.
  const AutoregressiveModel small = fit_autoregressive_model({1., 2., 3.}, 1, false);
  check::relative("Burg by hand", small.coefficients[0], 8. / 9., 1e-15);
  check::relative("innovations by hand", small.innovation_deviation,
                  std::sqrt(14. / 3. * (1. - 64. / 81.)), 1e-14);
  const AutoregressiveModel about_mean = fit_autoregressive_model({1., 2., 3.}, 1, true);
  check::absolute("Burg about the mean", about_mean.coefficients[0], 0., 1e-15);

  // Order 2 with variance (1 - b)/((1 + b) ((1 - b)^2 - a^2)) and errors of the coefficients
  // sqrt((1 - b^2)/n) (Box and Jenkins).
  const double a = 1.2;
  const double b = -0.6;
  const unsigned int n = 20000;
  const std::vector<double> values = RandomNoise(1).autoregressive({a, b}, n);
  const double variance = (1. - b) / ((1. + b) * ((1. - b) * (1. - b) - a * a));
  for (const OrderCriterion criterion :
       {OrderCriterion::bayesian, OrderCriterion::corrected_akaike})
  {
    const AutoregressiveModel model =
        fit_autoregressive_model_of_best_order(values, criterion, true);
    const std::string name = criterion == OrderCriterion::bayesian ? "BIC" : "AICc";
    const std::size_t order = model.coefficients.size();
    check::is_true("order by " + name,
                   criterion == OrderCriterion::bayesian ? order == 2 : order >= 2 && order <= 12);
  }
  const AutoregressiveModel model = fit_autoregressive_model(values, 2, true);
  const double error = std::sqrt((1. - b * b) / n);
  check::absolute("first coefficient", model.coefficients[0], a, 3. * error);
  check::absolute("second coefficient", model.coefficients[1], b, 3. * error);
  check::relative("innovations", model.innovation_deviation, 1., 0.02);
  check::relative("standard deviation", model.standard_deviation, std::sqrt(variance), 0.04);
  const AutoregressiveModel long_model = fit_autoregressive_model(values, 6, true);
  check::absolute("a coefficient too many", long_model.coefficients[5], 0., 3. / std::sqrt(n));

  // Largest spectral density of order 1: (1 + phi)/(1 - phi) at frequency 0, or with -phi at the
  // highest one.
  const double deviation = std::sqrt(1. / (1. - 0.49));
  check::relative("spectrum of order 1",
                  AutoregressiveModel{{0.7}, 1., deviation}.largest_spectral_ratio(), 1.7 / 0.3,
                  1e-12);
  check::relative("spectrum of order 1, negative",
                  AutoregressiveModel{{-0.7}, 1., deviation}.largest_spectral_ratio(), 1.7 / 0.3,
                  1e-12);
  // Of order 2 at cos(w) = -a (1 - b)/(4 b): 1/(variance |1 - a z - b z^2|^2).
  const double cosine = -a * (1. - b) / (4. * b);
  const double sine = std::sqrt(1. - cosine * cosine);
  const double real = 1. - a * cosine - b * (2. * cosine * cosine - 1.);
  const double imaginary = a * sine + b * 2. * sine * cosine;
  check::relative("spectrum of order 2",
                  AutoregressiveModel{{a, b}, 1., std::sqrt(variance)}.largest_spectral_ratio(),
                  1. / (variance * (real * real + imaginary * imaginary)), 1e-5);

  unsigned int n_white = 0;
  for (unsigned int seed = 0; seed < 40; ++seed)
    if (fit_autoregressive_model_of_best_order(RandomNoise(seed).white(300),
                                               OrderCriterion::bayesian, false)
            .coefficients.empty())
      ++n_white;
  check::is_true("white noise needs no coefficient", n_white >= 36);
  check::throws<std::invalid_argument>(
      "too few",
      [&]() {
        fit_autoregressive_model({1., 2.}, 1, false);
      },
      "more than 2 values");
  check::throws<std::invalid_argument>(
      "all equal",
      [&]() {
        fit_autoregressive_model({2., 2., 2., 2.}, 1, true);
      },
      "differ");
}
} // namespace test_of_autoregressive_model
