#ifndef continua_network_junction_h
#define continua_network_junction_h

#include <continua/network/end_wave.h>

#include <vector>

namespace Continua
{
/**
 * A place where the ends of two or more vessels meet: no liquid is lost, and all ends have the same
 * head p + rho alpha U^2/2 (with alpha = 1 the total pressure). The state on each end lies on the
 * wave of its vessel (EndWave). Solved by Newton's method for the areas of the ends and the head.
 */
class Junction
{
public:
  explicit Junction(const std::vector<std::pair<Vessel *, Vessel::End>> &ends);

  /// After Vessel::reconstruct() of all vessels. Throws std::domain_error if no state was found.
  void solve();

private:
  std::vector<EndWave> waves;
  std::vector<double> areas;
  std::vector<EndWave::Values> values;

  [[noreturn]] void fail() const;
};
} // namespace Continua

#endif
