#ifndef continua_frequency_rational_approximation_h
#define continua_frequency_rational_approximation_h

#include <complex>
#include <cstddef>
#include <vector>

namespace Continua
{
struct RationalOptions
{
  /// Largest difference from the samples of a response, over the largest sample of this response
  /// [1]. It should be one to five times the noise of the samples: poles of the noise appear below.
  double tolerance = 1e-10;
  unsigned int most_poles = 100;
  /// Whether the samples are those of a real system: then those at the conjugate points, with
  /// conjugate values, count beside them, and poles come in conjugate pairs.
  bool is_real = true;
  /// Poles whose residue over their distance from the samples is below this part of the geometric
  /// mean of the samples [1] are doublets of M. Froissart, a pole and a zero on each other; they
  /// are removed. Zero: no pole is removed.
  double doublet = 1e-13;
};

/**
 * One rational function for each of several responses, all with the same poles, that agrees with
 * their samples: the method AAA of Y. Nakatsukasa, O. Sete and L. N. Trefethen (SIAM J. Sci.
 * Comput. 40, 2018), in barycentric form
 *
 *   r(s) = (sum_k w_k f_k/(s - z_k)) / (sum_k w_k/(s - z_k)).
 *
 * The support points z_k are the samples with the largest difference so far, and the weights w_k
 * have the smallest linearised difference at the others. Several responses share z_k and w_k, each
 * over its largest sample. Poles follow from the generalised eigenvalues of the arrowhead matrix
 * (LAPACK's zggev).
 *
 * A function that is not rational, such as one with a branch cut, gets poles along its cut: a pole
 * is a candidate of a resonance and no more.
 */
class RationalApproximation
{
public:
  using Complex = std::complex<double>;

  /// `points`: s [rad/s], different from each other. `responses`: by response, a value for each
  /// point, in any unit. Throws std::invalid_argument for fewer than two points, points that are
  /// equal, responses of other lengths, or values that are no numbers.
  RationalApproximation(const std::vector<Complex> &points,
                        const std::vector<std::vector<Complex>> &responses,
                        const RationalOptions &options = {});

  std::size_t n_responses() const { return scales.size(); }
  Complex value(std::size_t response, Complex s) const;
  /// [rad/s], the smallest magnitude first.
  const std::vector<Complex> &poles() const { return pole_places; }
  /// Of a response at each pole [unit of the response times rad/s].
  std::vector<Complex> residues(std::size_t response) const;
  /// The largest difference from the samples over the largest sample of their response [1].
  double error() const { return largest_error; }
  /// Whether this is within the tolerance.
  bool has_converged() const { return converged; }

private:
  void seek_support(const RationalOptions &options);
  void find_weights();
  void find_poles();
  void remove_doublets(double doublet);
  void measure();
  Complex scaled_value(std::size_t response, Complex s) const;
  Complex scaled_residue(std::size_t response, Complex pole) const;

  bool is_real;
  /// Points over their largest magnitude `unit` [rad/s], responses over their largest sample.
  double unit = 1.;
  std::vector<double> scales;
  std::vector<Complex> samples;
  std::vector<std::vector<Complex>> values;
  std::vector<std::size_t> mirror; ///< of a sample that at the conjugate point

  std::vector<std::size_t> support; ///< numbers of samples
  std::vector<bool> is_support;
  std::vector<Complex> weights;
  std::vector<Complex> pole_places;
  double largest_error = 0.;
  bool converged = false;
};

/// -Re s/|s| of a pole: the damping over the critical damping [1].
double damping_ratio(std::complex<double> s);
} // namespace Continua

#endif
