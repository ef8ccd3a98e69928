#ifndef continua_linear_algebra_factor_estimate_h
#define continua_linear_algebra_factor_estimate_h

namespace Continua
{
/// What an analysis says of the factor, over all ranks.
struct FactorEstimate
{
  double n_entries; ///< hardly depends on the number of ranks
  double memory;    ///< with the working space that it takes to make it [bytes]
};
} // namespace Continua

#endif
