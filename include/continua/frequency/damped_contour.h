#ifndef continua_frequency_damped_contour_h
#define continua_frequency_damped_contour_h

#include <complex>
#include <cstddef>
#include <vector>

namespace Continua
{
/**
 * Histories of a linear system without time steps: its response at the points
 *
 *   s_k = a + 2 pi i k/T,   a = ln(e^(a T))/T,   k = 0 ... n/2,
 *
 * of the plane of Laplace's transform. The n samples of a load at t_j = j T/n are multiplied by
 * e^(-a t) and transformed; the transform of a response, load times transfer function at s_k, is
 * transformed back and multiplied by e^(a t). At real frequencies (a = 0) what is left of a
 * response at T comes back at 0; here it comes back with the part e^(-a T), and a load may be
 * anything at T. A system whose memory fades as slowly as a power law needs no longer T.
 *
 * Three errors remain: what comes back, at most e^(-a T) times the response after T; round-off and
 * the tolerance of a solver, which e^(a t) enlarges; and what n samples leave out of the load,
 * which falls fast with n where the load is smooth and starts from zero. The first is seen by a
 * second contour of twice T and the same a, whose growth is the square.
 *
 * H. Dubner and J. Abate, J. ACM 15, 1968; the choice of a: J. Wilcox, Int. J. Electr. Eng. Educ.
 * 15, 1978.
 */
class DampedContour
{
public:
  using Complex = std::complex<double>;

  /// `duration`: T [s]; `n_samples`: n; `growth`: e^(a T) [1]. Throws std::invalid_argument unless
  /// T > 0, n > 1 and e^(a T) >= 1.
  DampedContour(double duration, std::size_t n_samples, double growth = 1e4);

  /// a [1/s]
  double damping() const { return decay; }
  /// t_j [s]
  const std::vector<double> &times() const { return sample_times; }
  /// s_k [rad/s]
  const std::vector<Complex> &points() const { return contour; }
  /// Of a load's samples at `times` a value at each of `points`, in the unit of the load times
  /// samples. Throws std::invalid_argument for another number of samples.
  std::vector<Complex> transform(const std::vector<double> &samples) const;
  /// The samples of a response at `times`. Throws std::invalid_argument for another number of
  /// values.
  std::vector<double> history(const std::vector<Complex> &transformed) const;

private:
  double decay;
  std::vector<double> sample_times;
  std::vector<Complex> contour;
};
} // namespace Continua

#endif
