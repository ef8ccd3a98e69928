#ifndef continua_theory_impedance_fit_h
#define continua_theory_impedance_fit_h

#include <continua/theory/impedance.h>

#include <complex>
#include <vector>

namespace Continua
{
/// What a fit has to meet at one frequency.
// NOLINTNEXTLINE(bugprone-exception-escape): deal.II's matrix may throw when it is moved
struct ImpedanceSample
{
  std::complex<double> s;                         ///< [1/s], Re s >= 0
  dealii::FullMatrix<std::complex<double>> value; ///< Z [Pa s/m^3], symmetric
  double weight = 1.;                             ///< of the relative error there
};

// NOLINTNEXTLINE(bugprone-exception-escape): deal.II's matrix may throw when it is moved
struct ImpedanceFit
{
  Impedance impedance;
  /// Largest of weight |difference of Z_ij| / sqrt(|Z_ii Z_jj|) over samples and entries. A wave
  /// that meets it comes back with half of that, relative to what arrived.
  double error = 0.;
};

/**
 * A sum of few first-order responses for an impedance that is none (see Impedance): the rates lie
 * evenly in their logarithm, `direct` and the residues follow by linear least squares, and the two
 * ends of the rates are moved (Nelder and Mead) to where the largest error is least. As many terms
 * as it takes to come below `tolerance`, at most sixteen, no rate above `highest_rate` [1/s]. The
 * result is passive: Re Z(i omega) is positive definite at all frequencies; among those that are,
 * the best one is returned if none meets the tolerance.
 */
ImpedanceFit
fit_impedance(const std::vector<ImpedanceSample> &samples, double tolerance, double highest_rate);

/// Smallest eigenvalue of Re Z_ij(i omega) / sqrt(scale_i scale_j) over all frequencies, zero and
/// infinity among them [1]; `scales` [Pa s/m^3]. Negative: the impedance gives energy away.
double smallest_resistance(const Impedance &impedance, const std::vector<double> &scales);
} // namespace Continua

#endif
