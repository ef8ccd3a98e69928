#ifndef continua_continuum_power_balance_h
#define continua_continuum_power_balance_h

#include <numeric>
#include <vector>

namespace Continua
{
/// The power that one material takes, at the level at which the scheme balances it [W].
struct Power
{
  std::vector<double> terms; ///< in the order of equation_terms()
  /// The part of it that relaxation turns into heat; only where it was asked for.
  double relaxation = 0.;
  double sum() const { return std::accumulate(terms.begin(), terms.end(), 0.); }
};

/// The power of one outlet [W].
struct OutletPower
{
  double leaving = 0.; ///< sum of p Q over its ports: what the body gives to it
  double stored = 0.;  ///< the part of it that the outlet stores (a windkessel's compliance)
};

/// The power balance of one step.
struct PowerBalance
{
  double time = 0.;                 ///< [s] at which the scheme balances
  double external = 0.;             ///< of loads and prescribed velocities
  std::vector<Power> materials;     ///< by material id
  std::vector<OutletPower> outlets; ///< as in the problem
  /// external - sum of the materials' and of what leaves by outlets (equation 4.21 of the thesis)
  double residual = 0.;
  double exchanged = 0.; ///< sum of the absolute values, to which the residual compares
};

/// The energy held by the body [J].
struct Energy
{
  /// By term, in the order of equation_terms(), and material id; zero of a term that stores none.
  std::vector<std::vector<double>> terms;
  double outlets = 0.; ///< stored in outlets; no part of the body

  double of_term(const unsigned int term) const
  {
    return std::accumulate(terms[term].begin(), terms[term].end(), 0.);
  }
  double sum() const
  {
    double sum = 0.;
    for (unsigned int term = 0; term < terms.size(); ++term)
      sum += of_term(term);
    return sum;
  }
};
} // namespace Continua

#endif
