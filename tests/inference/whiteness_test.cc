#include "../unit_test.h"
#include "random_noise.h"

#include <continua/inference/whiteness_test.h>

#include <cmath>

namespace test_of_whiteness_test
{
using namespace Continua;

UNIT_TEST(whiteness_test)
{
  // By hand: squares 44; products at the lags 1 ... 4: -17, -3, 3, -5; with four degrees of freedom
  // the probability is exp(-Q/2) (1 + Q/2).
  const std::vector<double> values{1., -2., 3., 1., -4., 2., 0., 3.};
  const double q = 8. * 10. / (44. * 44.) * (289. / 7. + 9. / 6. + 9. / 5. + 25. / 4.);
  const WhitenessTest test = ljung_box_test(values, 0, 4);
  check::relative("lag 1", autocorrelation(values, 4)[1], -17. / 44., 1e-14);
  check::relative("statistic", test.statistic, q, 1e-13);
  check::relative("probability", test.probability, std::exp(-q / 2.) * (1. + q / 2.), 1e-12);
  const WhitenessTest fitted = ljung_box_test(values, 2, 4);
  check::is_true("degrees of freedom",
                 test.degrees_of_freedom == 4 && fitted.degrees_of_freedom == 2);
  check::relative("probability with two", fitted.probability, std::exp(-q / 2.), 1e-12);
  check::is_true("too few", std::isnan(ljung_box_test({1., 2., 1.}).probability));
  check::is_true("lags", ljung_box_test(std::vector<double>(50, 1.)).n_lags == 10 &&
                             ljung_box_test(std::vector<double>(500, 1.)).n_lags == 10 &&
                             ljung_box_test(std::vector<double>(50, 1.), 9).n_lags == 12);

  // Of 1000 white records 5 % are refused at 5 % (standard error 0.7 %), of correlated ones most.
  RandomNoise noise(7);
  unsigned int n_refused = 0;
  unsigned int n_of_correlated = 0;
  for (unsigned int i = 0; i < 1000; ++i)
    n_refused += ljung_box_test(noise.white(200)).probability < 0.05 ? 1 : 0;
  for (unsigned int i = 0; i < 100; ++i)
    n_of_correlated += ljung_box_test(noise.autoregressive({0.4}, 200)).probability < 0.05 ? 1 : 0;
  check::absolute("refused white ones", n_refused / 1000., 0.05, 0.02);
  check::is_true("refused correlated ones", n_of_correlated > 90);
}
} // namespace test_of_whiteness_test
