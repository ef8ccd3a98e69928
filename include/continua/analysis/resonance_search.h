#ifndef continua_analysis_resonance_search_h
#define continua_analysis_resonance_search_h

#include <continua/base/log.h>
#include <continua/case/resonance_parameters.h>
#include <continua/continuum/harmonic_system.h>

#include <mpi.h>

#include <complex>
#include <cstddef>
#include <vector>

namespace Continua
{
/// A free motion exp(s t) of the body.
struct Resonance
{
  std::complex<double> s; ///< [1/s]
  /// Forces that are left over those of s times the derivative of the system to s [1].
  double residual = 0.;
  unsigned int corrections = 0; ///< of Newton's method
  HarmonicSolution shape;

  double natural_frequency() const; ///< |s|/(2 pi) [Hz]
  double frequency() const;         ///< Im s/(2 pi) [Hz]
  double damping_ratio() const;     ///< -Re s/|s| [1]
  double quality_factor() const;    ///< 1/(2 damping ratio) [1]
};

/**
 * Resonances of a linear body whose matrix A(s) depends on s in any way: s with A(s) u = 0.
 *
 * Candidates are the poles of a rational approximation (RationalApproximation) of the responses
 * b_i.u_j to loads b_j, at frequencies of the band that FrequencyRefinement chooses. The loads are
 * random ones in each region, which one solution in the middle of the band makes smooth, and unit
 * loads at boundaries. Most poles are not those of the body. Each candidate is therefore corrected
 * by Newton's method on b.u(s)^-1, with A(s) u = b and the symmetry of A,
 *
 *   s - (b.u)/(u.A'(s) u),
 *
 * where A' is a central difference and b becomes A'(s) u, as in inverse iteration. What converges
 * into the band, below the largest damping ratio, is a resonance.
 */
template <int dim>
class ResonanceSearch
{
public:
  using Complex = std::complex<double>;

  /// `unit_loads`: the numbers of boundary conditions that may have a unit load.
  ResonanceSearch(HarmonicSystem<dim> &system,
                  const ResonanceParameters &parameters,
                  const std::vector<unsigned int> &unit_loads,
                  MPI_Comm communicator,
                  Log &log);

  /// By increasing natural frequency. Collective; throws Interrupted if a signal asks for it.
  std::vector<Resonance> find();

  std::size_t n_frequencies() const { return frequencies_used; }
  std::size_t n_candidates() const { return candidates_tried; }
  /// Difference at the last checks of the rational approximation [1].
  double difference() const { return difference_at_checks; }
  bool responses_are_known() const { return has_converged; }

private:
  HarmonicSystem<dim> &system;
  const ResonanceParameters &parameters;
  const std::vector<unsigned int> unit_loads;
  const MPI_Comm communicator;
  Log &log;
  std::vector<HarmonicLoad> loads; ///< with real numbers
  std::size_t frequencies_used = 0, candidates_tried = 0;
  double difference_at_checks = 0.;
  bool has_converged = false;

  void make_loads();
  std::vector<Complex> find_candidates();
  /// The factor at s, or next to it where there is none; s is then that place.
  void factor_beside(Complex &s);
  /// Whether it converges.
  bool correct(Resonance &resonance, HarmonicLoad load);
  bool is_sought(const Resonance &resonance) const;
  /// Forces and dilatations of A'(s) u.
  HarmonicSolution derivative(Complex s, const HarmonicSolution &u);
  Complex product(const HarmonicLoad &load, const HarmonicSolution &solution) const;
  Complex product(const HarmonicSolution &forces, const HarmonicSolution &solution) const;
  double size(const std::vector<Complex> &values) const;
  void stop_if_asked() const;
};
} // namespace Continua

#endif
