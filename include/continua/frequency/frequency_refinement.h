#ifndef continua_frequency_frequency_refinement_h
#define continua_frequency_frequency_refinement_h

#include <continua/frequency/rational_approximation.h>

#include <complex>
#include <functional>
#include <memory>
#include <vector>

namespace Continua
{
struct FrequencyRefinementOptions
{
  /// Of the responses between the frequencies: the largest difference from the rational
  /// approximation at a check, over the largest sample of the response [1].
  double tolerance = 1e-3;
  unsigned int first_frequencies = 7;
  unsigned int most_frequencies = 200;
  /// The responses are those at s = 2 pi f (i + tilt): 0 at real frequencies; with more, narrow
  /// resonances are wide [1].
  double tilt = 0.;
  /// Checks of a round where approximations differ, beside the one in the widest gap [1].
  unsigned int checks = 2;
};

/**
 * Chooses the frequencies of a band at which responses are computed, until a rational approximation
 * of them (RationalApproximation, in s) is known to hold between the frequencies. The
 * first ones are equidistant on a linear or logarithmic scale. Each round computes the responses
 * where the present approximation differs most from the one of the round before, and in the middle
 * of the widest gap. These are checks first, of the present approximation, and samples then. The
 * refinement ends when two rounds in a row have checks within the tolerance.
 */
class FrequencyRefinement
{
public:
  using Complex = std::complex<double>;
  /// The responses at some frequencies [Hz]: by frequency, a value for each response.
  using Responses =
      std::function<std::vector<std::vector<Complex>>(const std::vector<double> &frequencies)>;

  /// From `lowest` to `highest` frequency [Hz]. Throws std::invalid_argument unless 0 <= lowest <
  /// highest, 0 < lowest on a logarithmic scale, the tolerance is positive, and there are at least
  /// three first frequencies and a check.
  FrequencyRefinement(double lowest,
                      double highest,
                      bool is_logarithmic,
                      const Responses &responses,
                      const FrequencyRefinementOptions &options = {});

  /// [Hz], increasing.
  const std::vector<double> &frequencies() const { return places; }
  /// By frequency, a value for each response.
  const std::vector<std::vector<Complex>> &responses() const { return samples; }
  const RationalApproximation &approximation() const { return *present; }
  /// The largest difference at the checks of the last two rounds [1].
  double difference_at_checks() const { return last_difference; }
  bool has_converged() const { return converged; }

private:
  void compute(const std::vector<double> &frequencies, const Responses &compute_responses);
  void approximate(double tolerance);
  std::vector<double> choose_checks(unsigned int n_checks) const;
  double difference(const RationalApproximation &other, double frequency) const;
  double between(double from, double to, double part) const;
  /// s of a frequency [rad/s].
  Complex laplace_point(double frequency) const;

  bool is_logarithmic;
  double tilt;
  std::vector<double> places;
  std::vector<std::vector<Complex>> samples;
  std::unique_ptr<RationalApproximation> previous, present;
  double last_difference = 0.;
  bool converged = false;
};
} // namespace Continua

#endif
