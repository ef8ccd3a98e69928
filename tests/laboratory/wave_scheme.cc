// The schemes' eigenvalues against characteristic polynomials derived by hand, and what runs of a
// bar do against the eigenvalues.

#include <continua/laboratory/wave_bar.h>
#include <continua/signal/linear_recurrence.h>

#include <deal.II/base/mpi.h>

#include <cmath>

#include "../unit_test.h"

namespace test_of_wave_scheme
{
using namespace Continua;

namespace
{
void expect_factor(const WaveScheme scheme, const double theta, const Complex expected)
{
  const Amplification amplification = amplification_of(scheme, theta);
  double nearest = 1.;
  for (const Complex &factor : amplification.factors())
    nearest = std::min(nearest, std::abs(factor - expected));
  check::absolute(word_of(wave_scheme_words(), scheme) + ", " + std::to_string(theta), nearest, 0.,
                  1e-10);
}

void expect_eigenvalues(const WaveScheme scheme,
                        const double theta,
                        const std::vector<double> &polynomial)
{
  for (const Complex &root : polynomial_roots(polynomial))
    expect_factor(scheme, theta, root);
}
} // namespace

UNIT_TEST(wave_scheme)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const double theta : {0.1, 1., 3., 6.})
  {
    const double square = theta * theta;
    // (3.95): (D_n - 2 D_(n-1) + D_(n-2)) + theta^2 D_n = 0 has 1/(1 -+ i theta).
    for (const double sign : {-1., 1.})
      for (const WaveScheme scheme :
           {WaveScheme::displacement_euler, WaveScheme::velocity_euler_implicit})
        expect_factor(scheme, theta, 1. / Complex(1., sign * theta));
    // Four levels, (2 - 5/G + 4/G^2 - 1/G^3) + theta^2 = 0.
    const Amplification four_levels = amplification_of(WaveScheme::displacement_four_levels, theta);
    for (const Complex factor : four_levels.factors())
      check::absolute("four levels, " + std::to_string(theta),
                      std::abs(2. - 5. / factor + 4. / (factor * factor) -
                               1. / (factor * factor * factor) + square),
                      0., 1e-9 * (1. + square));
    // (3.110), the last term of which must have a plus.
    expect_eigenvalues(WaveScheme::velocity_euler, theta,
                       {1., -2. + 0.5 * square, 1. + 0.5 * square});
    expect_eigenvalues(WaveScheme::velocity_crank_nicolson, theta,
                       {1. + 0.25 * square, -2. + 0.5 * square, 1. + 0.25 * square});
    // (3 G^2 - 4 G + 1)^2/4 + theta^2 G^4 = 0.
    expect_eigenvalues(WaveScheme::velocity_backward_differencing, theta,
                       {0.25, -2., 5.5, -6., 2.25 + square});
    // (3 G^2 - 4 G + 1)(G - 1) + theta^2 G^2 (G + 1) = 0.
    expect_eigenvalues(WaveScheme::velocity_backward_differencing_trapezoidal, theta,
                       {-1., 5., square - 7., square + 3.});
  }
  check::relative("the velocity form rings from 4 on",
                  ringing_angle(WaveScheme::velocity_euler).value_or(0.), 4., 1e-6);
  check::is_true("the displacement form does not",
                 !ringing_angle(WaveScheme::displacement_euler).has_value());

  // Beyond the angle of 4, too: 2 Co sin(pi/N) is 11.8 for 5 cells.
  for (const auto &[word, scheme] : wave_scheme_words())
    for (const double courant_number : {0.5, 10.})
    {
      const WaveBar bar(scheme, 5, courant_number);
      const Complex factor = amplification_of(scheme, bar.theta()).of_wave();
      check::absolute(word + ", Courant number " + std::to_string(courant_number),
                      std::abs(bar.measured(factor).value() - factor), 0., 1e-6);
    }
  // What round-off hides is not measured; at 300 one factor is near 1 and the others are small.
  for (const auto &[word, scheme] : wave_scheme_words())
    for (const double courant_number : {1e-3, 300., 1e6})
    {
      const WaveBar bar(scheme, 2, courant_number);
      const Complex factor = amplification_of(scheme, bar.theta()).of_wave();
      const std::optional<Complex> measured = bar.measured(factor);
      check::is_true(word + ", Courant number " + std::to_string(courant_number) +
                         ": right or not measured",
                     !measured || std::abs(*measured - factor) < 1e-3);
    }
  const WaveBar bar(WaveScheme::velocity_crank_nicolson, 8, 0.5);
  check::relative("angle", bar.theta(), std::sin(M_PI / 8.), 1e-14);
  // Crank-Nicolson: tan(arg/2) = theta/2.
  check::relative(
      "speed",
      bar.speed_ratio(amplification_of(WaveScheme::velocity_crank_nicolson, bar.theta()).of_wave()),
      2. * std::atan(0.5 * bar.theta()) / (2. * M_PI * 0.5 / 8.), 1e-12);
}
} // namespace test_of_wave_scheme
