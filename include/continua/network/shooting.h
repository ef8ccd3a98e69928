#ifndef continua_network_shooting_h
#define continua_network_shooting_h

#include <functional>
#include <vector>

namespace Continua
{
/**
 * Newton's method for a state x that a period P leaves as it is, P(x) = x (shooting). The
 * linear equations of an iteration have GMRES without a matrix (Y. Saad, M. H. Schultz, SIAM J.
 * Sci. Stat. Comput. 7 (1986) 856): a product with the derivative of P is a difference of two
 * periods. What dies away within a period costs nothing; each slow time of the system costs about
 * one product.
 */
class Shooting
{
public:
  /// The state after a period. May throw StepFailure.
  using Period = std::function<std::vector<double>(const std::vector<double> &)>;

  /// `scales`: of each number of the state, in which a change of it counts as 1. 0: it stays.
  explicit Shooting(const std::vector<double> &scales) : scales(scales) {}

  /// The next state from x and P(x). `n_periods` counts the periods that were made.
  std::vector<double> next(const std::vector<double> &x,
                           const std::vector<double> &after,
                           const Period &period,
                           unsigned int &n_periods) const;

private:
  std::vector<double> scales;

  std::vector<double> scaled_difference(const std::vector<double> &a,
                                        const std::vector<double> &b) const;
};
} // namespace Continua

#endif
