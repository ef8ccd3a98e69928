#ifndef continua_theory_bar_law_start_h
#define continua_theory_bar_law_start_h

#include <continua/theory/bar_law.h>
#include <continua/theory/bar_record.h>

#include <memory>
#include <utility>
#include <vector>

namespace Continua
{
/// Where the search for a law begins.
struct BarLawStart
{
  std::shared_ptr<const BarLaw> law;
  std::vector<double> constants; ///< in SI, in the order of BarLaw::constants()
};

/// Shortest and longest time that records tell of [s]: of relaxation from half a loading time
/// before the first row on, of frequencies 1/(2 pi f).
std::pair<double, double> times_of(const std::vector<BarRecord> &records);

/// Constants of a law with one time or one exponent at most (no branches): these are scanned, the
/// modulus is the one of least squares of the logarithms.
BarLawStart start_of_scan(const std::shared_ptr<const BarLaw> &law,
                          const std::vector<BarRecord> &records);

/**
 * Prony series of 0 (hookean), 1, 2, ... branches, `most_branches` at most. Moduli of as many as
 * eight relaxation times a decade are found without negative values (nonnegative_least_squares.h);
 * this is the only regularisation: of nearly dependent exponentials it keeps few. Neighbours become
 * one branch. Series of fewer branches follow by leaving out one branch, or by making one of two
 * neighbours, whichever misses least. Creep is used where there is nothing else: the same is done
 * with compliances, whose exact inverse is the series.
 */
std::vector<BarLawStart> starts_of_prony(double poissons_ratio,
                                         const std::vector<BarRecord> &records,
                                         unsigned int most_branches);
} // namespace Continua

#endif
